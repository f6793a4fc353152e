//! Many amplitudes: one row each, with the errors of the formulas asked for.

use super::Period;
use crate::arguments::Amplitudes;
use crate::output::progress::watched;
use crate::output::table::{self, Column, Table};
use crate::output::{csv, number};
use libration::pendulum::{Amplitude, Pendulum};
use libration::period_formulas::fractional_errors;
use std::io::{self, Write};

pub(super) fn write(
    out: &mut dyn Write,
    question: &Period,
    amplitudes: &Amplitudes,
    pendulum: &Pendulum,
) -> io::Result<()> {
    let [length, gravity] = question.pendulum.lines();
    let period = ("small-angle period T₀", number::seconds(pendulum.small_angle_period(), 15));
    table::sheet(out, &[length, gravity, period])?;
    writeln!(out)?;
    let formulas = question.formulas.chosen();
    let exact = ["θ₀ / °", "π − θ₀ / rad", "T / s", "T/T₀", "T/T₀ − 1"].map(String::from);
    let errors = formulas.iter().map(|formula| format!("error of {}", formula.key()));
    let mut table = Table::new(exact.into_iter().chain(errors).map(Column::numbers).collect());
    for amplitude in watched(amplitudes.iter(), amplitudes.len(), "amplitudes") {
        let errors = fractional_errors(formulas, &amplitude.angle());
        let errors = errors.into_iter().map(|error| number::rounded(error, 3));
        table.row(out, cells(&amplitude, pendulum).into_iter().chain(errors).collect())?;
    }
    table.finish(out)
}

fn cells(amplitude: &Amplitude, pendulum: &Pendulum) -> [String; 5] {
    [
        number::short(amplitude.angle().degrees(), 12),
        number::rounded(amplitude.complement(), 8),
        number::rounded(pendulum.period(amplitude), 12),
        number::rounded(amplitude.period_ratio(), 12),
        number::rounded(amplitude.period_excess(), 12),
    ]
}

pub(super) fn write_csv(
    out: &mut dyn Write,
    question: &Period,
    amplitudes: &Amplitudes,
    pendulum: &Pendulum,
) -> io::Result<()> {
    let formulas = question.formulas.chosen_or_all();
    let exact = [
        "amplitude_rad",
        "complement_rad",
        "small_angle_period_s",
        "period_s",
        "ratio",
        "excess",
        "nome",
        "condition",
    ];
    let more =
        formulas.iter().flat_map(|f| [format!("{}_ratio", f.key()), format!("{}_fractional_error", f.key())]);
    csv::line(out, &exact.map(String::from).into_iter().chain(more).collect::<Vec<_>>())?;
    for amplitude in watched(amplitudes.iter(), amplitudes.len(), "amplitudes") {
        let exact = [
            amplitude.radians(),
            amplitude.complement(),
            pendulum.small_angle_period(),
            pendulum.period(&amplitude),
            amplitude.period_ratio(),
            amplitude.period_excess(),
            amplitude.nome(),
            amplitude.condition(),
        ];
        let errors = fractional_errors(formulas, &amplitude.angle());
        let more =
            formulas.iter().zip(errors).flat_map(|(f, error)| [f.period_ratio(&amplitude.angle()), error]);
        csv::numbers(out, &exact.into_iter().chain(more).collect::<Vec<_>>())?;
    }
    Ok(())
}
