//! The report of a measured response.

use super::fields::{self, FitResponseResult, FittedRow};
use crate::command::fit_report::{self, FitReport};
use crate::document::{Block, Document};
use crate::figure::fitted_response;
use crate::output::number::{rounded, short};
use libration_lab::fit::response::ResponseModel;

/// The whole report.
pub(super) fn document(answer: &FitResponseResult<'_>, file: &str) -> Document {
    let best = answer.fit.best();
    let left_out = answer.fit.left_out.iter().map(|reason| ("left out", reason.to_string()));
    let report = FitReport {
        headline: fit_report::doubled("ω₀", best.natural_frequency, "rad/s"),
        warnings: answer.warnings().into_iter().map(|(_, text)| text).collect(),
        facts: answer.lines().into_iter().chain(left_out).collect(),
        picture: fit_report::picture(
            "response",
            "The measured response and the fitted curve, its unstable part dashed",
            fitted_response::fitted(&answer.file.measured, best, answer.curve),
        ),
        laws: fit_report::of_columns(
            "The oscillators that were compared, simpler ones first. AICc is Akaike's criterion, the best model has the smallest",
            fields::of_model().columns(),
            fields::of_model().rows(&answer.fit.fits),
        ),
        method: [
            equation(best.model),
            "For each row the drive was computed that sustains a motion of the measured amplitude at the measured frequency, with all \
             its harmonics, and compared with the drive A, which all rows share.",
            "On each branch of the curve this drive has one value, so that rows of sweeps up and down are fitted together; the curve jumps \
             where a branch ends or loses its stability.",
        ],
        rows: rows(answer),
        ..FitReport::default()
    };
    report.document("Response of a driven oscillator", file)
}

fn equation(model: ResponseModel) -> &'static str {
    match model {
        ResponseModel::Linear => "The oscillator obeys x″ = −c x′ − ω₀² x + A cos Ωt.",
        ResponseModel::Pendulum => "The pendulum obeys x″ = −c x′ − ω₀² sin x + A cos Ωt.",
        ResponseModel::Duffing => "The oscillator obeys x″ = −c x′ − ω₀² x − κ x³ + A cos Ωt.",
    }
}

/// Every row with the amplitude of the curve.
fn rows(answer: &FitResponseResult<'_>) -> Vec<Block> {
    let is_angle = answer.file.is_angle();
    let (scale, unit) = if is_angle { (1_f64.to_degrees(), "°") } else { (1.0, answer.file.unit) };
    let cells = |row: FittedRow<'_>| {
        vec![
            row.fitted.stability.name().to_owned(),
            short(row.frequency, 6),
            short(scale * row.amplitude, 5),
            short(scale * row.fitted.amplitude, 5),
            rounded(row.fitted.residual, 2),
        ]
    };
    let amplitudes = ["amplitude", "amplitude of the curve"].map(|name| format!("{name} / {unit}"));
    fit_report::table(
        "The rows that were fitted, with the response on the same branch of the curve; residuals are in standard deviations",
        &["stability"],
        &["Ω / (rad/s)", &amplitudes[0], &amplitudes[1], "residual"],
        answer.measurements().into_iter().map(cells).collect(),
    )
}
