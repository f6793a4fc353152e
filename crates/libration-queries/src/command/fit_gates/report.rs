//! The report of the times of a photogate.

use super::fields::FitGatesResult;
use crate::command::fit_report::{self, FitReport};
use crate::document::Document;
use crate::figure;
use crate::output::number::short;
use libration_lab::fit::gates::GateCycle;
use std::f64::consts::SQRT_2;

/// The whole report.
pub(super) fn document(answer: &FitGatesResult<'_>, file: &str) -> Document {
    let headline = match (answer.budget, answer.fit.t0) {
        (Some((budget, _)), _) => fit_report::gravity(budget.g, &budget.combined),
        (None, Some(t0)) => fit_report::doubled("T₀", t0, "s"),
        (None, None) => fit_report::doubled("mean period", answer.fit.mean_period, "s"),
    };
    let read = answer.findings.iter().map(|finding| ("detected", finding.clone()));
    // A period is the difference of two times.
    let (of_time, of_period) = (answer.fit.timing, answer.fit.timing.map(|timing| SQRT_2 * timing));
    let value = |value: f64, error: Option<f64>| fit_report::to_known_digits(value, error).swap_remove(0);
    let cells = |cycle: &GateCycle| {
        let amplitude =
            cycle.amplitude.map_or("–".to_owned(), |amplitude| short(amplitude.to_degrees(), 5));
        vec![value(cycle.time, of_time), cycle.side.to_string(), value(cycle.period, of_period), amplitude]
    };
    let report = FitReport {
        headline,
        normal: answer.normal,
        warnings: answer.warnings().into_iter().map(|(_, text)| text).collect(),
        facts: answer.lines().into_iter().chain(read).collect(),
        picture: fit_report::picture(
            "periods",
            "Every period, from one passage of the gate to the next in the same direction, against time",
            figure::gates::periods(answer.fit),
        ),
        budget: answer
            .budget
            .map(|(budget, _)| fit_report::uncertainty(&budget.rows, &budget.combined))
            .unwrap_or_default(),
        method: [
            "Each period is the time from one passage of the gate to the next in the same direction, so that the position of the gate \
             does not matter in the mean.",
            "With the width of the bob its speed at the gate gives the amplitude of every swing, or the amplitude of the release is \
             used, and T = T₀·R(A) of the exact law gives the period T₀ of small swings.",
            "Gravity is g = 4π²L/T₀² with the corrections of the budget, whose uncertainties add in quadrature.",
        ],
        rows: fit_report::table(
            "Every period; those of side 0 begin with a passage in the direction of the first one",
            &[],
            &["time t / s", "side", "period T / s", "amplitude / °"],
            answer.fit.cycles.iter().map(cells).collect(),
        ),
        ..FitReport::default()
    };
    report.document("Periods of a pendulum at a photogate", file)
}
