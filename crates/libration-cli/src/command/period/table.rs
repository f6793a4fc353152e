//! Many amplitudes: one row each, with the errors of the formulas asked for.

use super::fields::{self, DIGITS, SMALL_ANGLE_PERIOD, Swing};
use super::{Period, estimates};
use crate::arguments::Amplitudes;
use crate::output::progress::watched;
use crate::output::table::{self, Column, Table};
use crate::output::{csv, number};
use libration::pendulum::Pendulum;
use libration::period_formulas::fractional_errors;
use std::io::{self, Write};

pub(super) fn write(
    out: &mut dyn Write,
    question: &Period,
    amplitudes: &Amplitudes,
    pendulum: &Pendulum,
) -> io::Result<()> {
    let period = (SMALL_ANGLE_PERIOD, number::seconds(pendulum.small_angle_period(), DIGITS));
    table::sheet(out, &[question.pendulum.lines(), vec![period]].concat())?;
    writeln!(out)?;
    let formulas = question.formulas.chosen();
    let exact = fields::of_swing();
    let errors = formulas.iter().map(|formula| Column::numbers(format!("error of {}", formula.key())));
    let mut table = Table::new(exact.columns().into_iter().chain(errors).collect());
    for amplitude in watched(amplitudes.iter(), amplitudes.len(), "amplitudes") {
        let errors = fractional_errors(formulas, &amplitude.angle());
        let errors = errors.into_iter().map(|error| number::rounded(error, 3));
        let swing = Swing { amplitude, pendulum: *pendulum };
        table.row(out, exact.cells(&swing).into_iter().chain(errors).collect())?;
    }
    table.finish(out)
}

pub(super) fn write_csv(
    out: &mut dyn Write,
    question: &Period,
    amplitudes: &Amplitudes,
    pendulum: &Pendulum,
) -> io::Result<()> {
    let formulas = question.formulas.chosen_or_all();
    let (exact, of_formula) = (fields::of_swing(), fields::of_formula());
    let more = formulas.iter().flat_map(|formula| of_formula.csv_names_for(formula.key()));
    csv::line(out, &exact.csv_names().into_iter().chain(more).collect::<Vec<_>>())?;
    for amplitude in watched(amplitudes.iter(), amplitudes.len(), "amplitudes") {
        let swing = Swing { amplitude, pendulum: *pendulum };
        let estimates = estimates(&swing, formulas);
        let more = estimates.iter().flat_map(|estimate| of_formula.csv_cells(estimate));
        csv::line(out, &exact.csv_cells(&swing).into_iter().chain(more).collect::<Vec<_>>())?;
    }
    Ok(())
}
