//! One amplitude, to read: the exact answer, then the formulas.

use super::fields::{self, Swing};
use super::{Order, Period, estimates};
use crate::output::table::{self, Table};
use std::io::{self, Write};
use std::slice;

pub(super) fn write(out: &mut dyn Write, question: &Period, swing: &Swing) -> io::Result<()> {
    table::sheet(out, &lines(question, swing))?;
    let order = match question.sort {
        Order::Error => "best first",
        Order::Catalogue => "in the order of the catalogue",
    };
    writeln!(out, "\nFormulas, {order} (error = T / T exact − 1):\n")?;
    let fields = fields::of_formula();
    let mut table = Table::new(fields.columns());
    let estimates = estimates(slice::from_ref(swing), question.formulas.chosen_or_all()).concat();
    for estimate in question.sorted(estimates) {
        table.row(out, fields.cells(&estimate))?;
    }
    table.finish(out)
}

/// The pendulum stands behind the amplitude and its complement.
fn lines(question: &Period, swing: &Swing) -> Vec<(&'static str, String)> {
    let mut lines = fields::of_swing().lines(swing);
    lines.splice(2..2, question.pendulum.lines());
    lines
}
