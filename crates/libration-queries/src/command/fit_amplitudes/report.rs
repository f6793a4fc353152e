//! The report of falling amplitudes.

use super::fields::{self, FitAmplitudesResult};
use crate::command::fit_report::{self, FitReport};
use crate::document::{Block, Document};
use crate::figure;
use crate::output::number::{rounded, short};
use libration_lab::fit::amplitudes::Position;

/// The whole report.
pub(super) fn document(answer: &FitAmplitudesResult<'_>, file: &str) -> Document {
    let headline = match answer.fit.quality {
        Some(quality) => fit_report::doubled("Q", quality.factor, ""),
        None => {
            fit_report::doubled("time of the decay by a factor of e", answer.fit.decay, position_unit(answer))
        }
    };
    let report = FitReport {
        headline,
        warnings: answer.warnings().into_iter().map(|(_, text)| text).collect(),
        facts: answer.lines(),
        picture: fit_report::picture(
            "amplitudes",
            "The amplitudes on a logarithmic scale with the fitted law and others that the rows do not exclude, and below the residuals",
            figure::amplitudes::fitted(&answer.file.measured, answer.fit),
        ),
        laws: fit_report::of_columns(
            "The laws of damping that were compared, simpler ones first. ΔAICc is Akaike's criterion above that of the best",
            fields::of_law().columns(),
            fields::of_law().rows(&answer.fit.laws),
        ),
        method: [
            "The amplitude falls because friction takes energy: dry friction makes it fall along a straight line, linear drag as an \
             exponential, quadratic drag as 1/(t + constant).",
            "Each law was integrated at the pendulum's own energy, fitted by least squares, and the simplest one was taken that the rows do \
             not exclude.",
            "The quality factor is Q = 2π times the energy over its loss in a cycle; for linear drag it is ω₀/c, the same at every amplitude.",
        ],
        rows: rows(answer),
        ..FitReport::default()
    };
    report.document("Damping of a pendulum", file)
}

fn position_unit(answer: &FitAmplitudesResult<'_>) -> &'static str {
    match answer.against() {
        Position::Time => "s",
        Position::Swings => "swings",
    }
}

/// Every row with its residual.
fn rows(answer: &FitAmplitudesResult<'_>) -> Vec<Block> {
    let measured = &answer.file.measured;
    let is_angle = answer.unit() == "rad";
    let scale = if is_angle { 1_f64.to_degrees() } else { 1.0 };
    let of_reading = if is_angle && !measured.is_horizontal { scale } else { 1.0 };
    let unit = if is_angle { "°" } else { answer.unit() };
    let reading = if measured.is_horizontal { "m" } else { unit };
    let law = answer.fit.law();
    let positions = measured.table.positions();
    let cells = |((position, residual), amplitude): ((f64, &f64), &f64)| {
        vec![short(position, 7), short(scale * amplitude, 5), rounded(of_reading * residual, 2)]
    };
    let titles = [
        format!("position / {}", position_unit(answer)),
        format!("amplitude by the law / {unit}"),
        format!("residual of the reading / {reading}"),
    ];
    fit_report::table(
        "The rows that were fitted, with the amplitude that the law gives",
        &[],
        &titles.each_ref().map(String::as_str),
        positions.zip(&law.residuals).zip(&law.amplitudes).map(cells).collect(),
    )
}
