//! Many amplitudes: one row each, with the errors of the formulas asked for.

use super::fields::{self, DIGITS, SMALL_ANGLE_PERIOD, Swing};
use super::{Period, estimates};
use crate::arguments::Amplitudes;
use crate::output::progress::watched;
use crate::output::table::{self, Column, Table};
use crate::output::{csv, number};
use crate::parallel;
use libration::pendulum::{Amplitude, Pendulum};
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
        let swing = Swing::new(amplitude, *pendulum);
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
    let mut amplitudes = watched(amplitudes.iter(), amplitudes.len(), "amplitudes");
    loop {
        let batch: Vec<Amplitude> = amplitudes.by_ref().take(BATCH).collect();
        if batch.is_empty() {
            return Ok(());
        }
        let pieces: Vec<&[Amplitude]> = batch.chunks(PIECE).collect();
        let lines = |piece: &&[Amplitude]| {
            piece.iter().map(|amplitude| Swing::new(*amplitude, *pendulum)).fold(vec![], |mut text, swing| {
                exact.write_csv_cells(&mut text, &swing);
                for estimate in estimates(&swing, formulas) {
                    text.push(b',');
                    of_formula.write_csv_cells(&mut text, &estimate);
                }
                text.push(b'\n');
                text
            })
        };
        parallel::map(&pieces, lines).iter().try_for_each(|text| out.write_all(text))?;
    }
}

/// How many amplitudes are answered between two looks at Ctrl-C: a fraction of a second with every formula.
const BATCH: usize = 1024;
/// How many lines one core makes at a time.
const PIECE: usize = 128;
