//! Many amplitudes: one row each, with the errors of the formulas asked for.

use super::Period;
use crate::arguments::Amplitudes;
use crate::output::table::{self, Column, Table};
use crate::output::{csv, number};
use libration::pendulum::Amplitude;
use libration::period_formulas::fractional_errors;
use std::io::{self, Write};

pub(super) fn write(
    out: &mut dyn Write,
    question: &Period,
    amplitudes: &Amplitudes,
    small_angle_period: f64,
) -> io::Result<()> {
    let [length, gravity] = question.pendulum.lines();
    let period = ("small-angle period T₀", number::seconds(small_angle_period, 15));
    table::sheet(out, &[length, gravity, period])?;
    writeln!(out)?;
    let formulas = question.formulas.chosen();
    let exact = ["θ₀ / °", "π − θ₀ / rad", "T / s", "T/T₀", "T/T₀ − 1"].map(String::from);
    let errors = formulas.iter().map(|formula| format!("error of {}", formula.key()));
    let mut table = Table::new(exact.into_iter().chain(errors).map(Column::numbers).collect());
    for amplitude in amplitudes.iter() {
        let errors = fractional_errors(formulas, &amplitude.angle());
        let errors = errors.into_iter().map(|error| number::rounded(error, 3));
        table.row(out, cells(&amplitude, small_angle_period).into_iter().chain(errors).collect())?;
    }
    table.finish(out)
}

fn cells(amplitude: &Amplitude, small_angle_period: f64) -> [String; 5] {
    let ratio = amplitude.period_ratio();
    [
        number::short(amplitude.angle().degrees(), 12),
        number::rounded(amplitude.complement(), 8),
        number::rounded(small_angle_period * ratio, 12),
        number::rounded(ratio, 12),
        number::rounded(amplitude.period_excess(), 12),
    ]
}

pub(super) fn write_csv(
    out: &mut dyn Write,
    question: &Period,
    amplitudes: &Amplitudes,
    small_angle_period: f64,
) -> io::Result<()> {
    let formulas = question.formulas.chosen();
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
    for amplitude in amplitudes.iter() {
        let ratio = amplitude.period_ratio();
        let exact = [
            amplitude.radians(),
            amplitude.complement(),
            small_angle_period,
            small_angle_period * ratio,
            ratio,
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
