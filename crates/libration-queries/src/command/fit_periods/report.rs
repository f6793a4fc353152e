//! The report of periods against amplitudes.

use super::fields::{self, FitPeriodsResult};
use crate::command::fit_report::{self, FitReport, to_known_digits};
use crate::document::{Block, Document};
use crate::figure;
use crate::output::number::rounded;

/// The whole report; `left_out` are the outliers that were not fitted.
pub(super) fn document(answer: &FitPeriodsResult<'_>, file: &str, left_out: &[usize]) -> Document {
    let exact = &answer.fit.exact;
    let headline = match answer.budget {
        Some(budget) => fit_report::gravity(budget.g, &budget.combined),
        None => fit_report::doubled("T₀", exact.t0, "s"),
    };
    let caption = "The period of every row against its amplitude with the laws, and below the residuals of the exact law";
    let picture = figure::periods::fitted(&answer.measured.without(left_out), answer.fit);
    let report = FitReport {
        headline,
        normal: answer.normal,
        warnings: answer.warnings().into_iter().map(|(_, text)| text).collect(),
        facts: answer.lines(),
        picture: fit_report::picture("periods", caption, picture),
        groups: fit_report::groups(answer.groups),
        laws: fit_report::of_columns(
            "The laws of the period that were compared: the exact one, a constant period, and formulas",
            fields::of_law().columns(),
            fields::of_law().rows(&answer.laws()),
        ),
        budget: answer
            .budget
            .map(|budget| fit_report::uncertainty(&budget.rows, &budget.combined))
            .unwrap_or_default(),
        method: [
            "A pendulum takes longer for large swings, T = T₀·R(A), where R = 1 + A²/16 + … follows exactly from the elliptic integral \
             of the amplitude A.",
            "T₀, the period of small swings, was fitted by least squares to all rows, each with the weight that the uncertainties of its \
             period and amplitude give it, or with equal weights.",
            "Gravity is g = 4π²L/T₀² with the corrections of the budget, whose uncertainties add in quadrature; β = 1 in \
             T = T₀·[1 + β(R − 1)] tests the law itself.",
        ],
        rows: rows(answer, left_out),
    };
    report.document("Period and amplitude of a pendulum", file)
}

/// Every row that was fitted, with its residual.
fn rows(answer: &FitPeriodsResult<'_>, left_out: &[usize]) -> Vec<Block> {
    let fitted = (0..answer.measured.rows.len()).filter(|row| !left_out.contains(row));
    let cells = |(number, row): (usize, usize)| {
        let of = &answer.measured.rows[row];
        let line = answer.measured.lines.get(row).map_or_else(String::new, ToString::to_string);
        let group = answer.measured.groups.as_ref().map(|groups| groups[row].clone());
        let amplitude =
            to_known_digits(of.amplitude.to_degrees(), of.amplitude_uncertainty.map(f64::to_degrees));
        let period = to_known_digits(of.period, of.period_uncertainty);
        let residual = answer.fit.exact.residuals.get(number);
        let residual = residual.map_or_else(String::new, |residual| rounded(1e3 * residual, 2));
        [vec![line], group.into_iter().collect(), amplitude, period, vec![residual]].concat()
    };
    let words: &[&str] = if answer.measured.groups.is_some() { &["line", "group"] } else { &["line"] };
    fit_report::table(
        "The rows that were fitted; the period of a row is the mean of its repeated readings",
        words,
        &["amplitude A / °", "u(A) / °", "period T / s", "u(T) / s", "residual / ms"],
        fitted.enumerate().map(cells).collect(),
    )
}
