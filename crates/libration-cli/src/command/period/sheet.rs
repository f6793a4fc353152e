//! One amplitude, to read: the exact answer, then the formulas.

use super::{Order, Period};
use crate::output::number;
use crate::output::table::{self, Column, Table};
use libration::pendulum::{Amplitude, Pendulum};
use std::io::{self, Write};

pub(super) fn write(
    out: &mut dyn Write,
    question: &Period,
    amplitude: &Amplitude,
    pendulum: &Pendulum,
) -> io::Result<()> {
    table::sheet(out, &lines(question, amplitude, pendulum))?;
    let order = match question.sort {
        Order::Error => "best first",
        Order::Catalogue => "in the order of the catalogue",
    };
    writeln!(out, "\nFormulas, {order} (error = T / T exact − 1):\n")?;
    formulas(out, question, amplitude, pendulum)
}

fn lines(question: &Period, amplitude: &Amplitude, pendulum: &Pendulum) -> Vec<(&'static str, String)> {
    let [length, gravity] = question.pendulum.lines();
    let period = pendulum.period(amplitude);
    let digits = |value| number::rounded(value, 15);
    let degrees = number::short(amplitude.angle().degrees(), 12);
    vec![
        ("amplitude θ₀", format!("{} rad = {degrees}°", digits(amplitude.radians()))),
        ("π − θ₀", format!("{} rad", digits(amplitude.complement()))),
        length,
        gravity,
        ("small-angle period T₀", number::seconds(pendulum.small_angle_period(), 15)),
        ("exact period T", number::seconds(period, 15)),
        ("frequency 1/T", format!("{} Hz", digits(period.recip()))),
        ("T/T₀", digits(amplitude.period_ratio())),
        ("excess T/T₀ − 1", digits(amplitude.period_excess())),
        ("nome q", digits(amplitude.nome())),
        (
            "condition",
            format!(
                "{} (relative change of T per relative change of θ₀)",
                number::rounded(amplitude.condition(), 6)
            ),
        ),
    ]
}

fn formulas(
    out: &mut dyn Write,
    question: &Period,
    amplitude: &Amplitude,
    pendulum: &Pendulum,
) -> io::Result<()> {
    let formulas = question.formulas.chosen_or_all();
    let mut table = Table::new(vec![
        Column::words("key"),
        Column::numbers("T / s"),
        Column::numbers("error"),
        Column::words("formula"),
    ]);
    for estimate in question.estimates(amplitude, formulas) {
        let cells = vec![
            estimate.formula.key().to_string(),
            number::rounded(pendulum.small_angle_period() * estimate.ratio, 12),
            number::rounded(estimate.fractional_error, 3),
            estimate.formula.name().to_string(),
        ];
        table.row(out, cells)?;
    }
    table.finish(out)
}
