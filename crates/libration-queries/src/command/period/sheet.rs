//! One amplitude, to read: the exact result, then the formulas.

use super::fields::{self, Swing};
use super::{FormulaOrder, Period, estimates};
use crate::output::table::{self, Table};
use std::io::{self, Write};
use std::slice;

pub(super) fn write(out: &mut dyn Write, question: &Period, swing: &Swing) -> io::Result<()> {
    table::sheet(out, &lines(question, swing))?;
    let order = match question.sort {
        FormulaOrder::Error => "best first",
        FormulaOrder::Catalogue => "in the order of the catalogue",
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

/// The lines of a swing; those of the pendulum come after those of the amplitude.
fn lines(question: &Period, swing: &Swing) -> Vec<(&'static str, String)> {
    let mut lines = fields::of_swing(question.amplitudes.are_of_periods()).lines(swing);
    let index = 2 + usize::from(swing.uncertainty.is_some());
    lines.splice(index..index, question.pendulum.lines());
    lines
}
