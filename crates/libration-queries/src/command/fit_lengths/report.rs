//! The report of periods against lengths.

use super::fields::{self, FitLengthsResult};
use crate::command::fit_report::{self, FitReport, to_known_digits};
use crate::document::{Block, Document};
use crate::figure;
use crate::output::number::rounded;
use libration_lab::fit::LengthModel;

/// The whole report.
pub(super) fn document(answer: &FitLengthsResult<'_>, file: &str, radius: Option<f64>) -> Document {
    let best = answer.fit.best();
    let caption = if best.model == LengthModel::Reversible {
        "The periods about both knife edges"
    } else if best.model.is_of_bars() {
        "T₀²h against h² of every row with the fitted line, and below the residuals of the periods"
    } else {
        "T₀² of every row against the length with the fitted line, and below the residuals of the periods"
    };
    let picture = figure::lengths::fitted(&answer.table.measured, best, radius);
    let report = FitReport {
        headline: fit_report::gravity(best.g.value, &answer.fit.combined),
        normal: answer.normal,
        warnings: answer.warnings().into_iter().map(|(_, text)| text).collect(),
        facts: answer.lines(),
        picture: fit_report::picture("line", caption, picture),
        groups: fit_report::groups(answer.groups),
        laws: fit_report::of_columns(
            "The laws that the rows determine, simpler ones first; the chance of the last parameter is that of a value as large if \
             it is zero",
            fields::of_law().columns(),
            fields::of_law().rows(&answer.fit.fits),
        ),
        budget: fit_report::uncertainty(&answer.fit.budget, &answer.fit.combined),
        method: method(best.model),
        rows: rows(answer),
    };
    report.document("Period and length of a pendulum", file)
}

fn method(model: LengthModel) -> [&'static str; 3] {
    let law = match model {
        LengthModel::Reversible => {
            "Bessel's formula 8π²/g = (T₁² + T₂²)/(h₁ + h₂) + (T₁² − T₂²)/(h₁ − h₂) gives g from the periods about two knife edges, \
             without the moment of inertia."
        }
        model if model.is_of_bars() => {
            "A bar turned about a point at a distance h from its centre of mass has T₀² = 4π²(k² + h²)/(gh), so that T₀²h against h² is a \
             straight line of slope 4π²/g."
        }
        _ => {
            "The period of small swings is T₀ = 2π√(L/g), so that T₀² against the length is a straight line of slope 4π²/g; an error δ that \
             all lengths share moves the line and leaves its slope as it is."
        }
    };
    [
        law,
        "The line was fitted by least squares, each row with the weight that its uncertainties give it, or with equal weights and the \
         scatter about the line as their uncertainty.",
        "The effects of the budget correct the result, and their uncertainties add in quadrature to that of the slope.",
    ]
}

/// Every row with its residual.
fn rows(answer: &FitLengthsResult<'_>) -> Vec<Block> {
    let (measured, best) = (&answer.table.measured, answer.fit.best());
    let of = |column: &Option<Vec<f64>>, row: usize| column.as_ref().map(|column| column[row]);
    let cells = |row: usize| {
        let group = answer.table.groups.as_ref().map(|groups| groups[row].clone());
        let length = to_known_digits(measured.lengths[row], of(&measured.length_uncertainties, row));
        let period = to_known_digits(measured.periods[row], of(&measured.period_uncertainties, row));
        let residual =
            best.residuals.get(row).map_or_else(String::new, |residual| rounded(1e3 * residual, 2));
        [vec![(row + 1).to_string()], group.into_iter().collect(), length, period, vec![residual]].concat()
    };
    let words: &[&str] = if answer.table.groups.is_some() { &["row", "group"] } else { &["row"] };
    fit_report::table(
        "The rows that were fitted; the period of a row is the mean of its repeated readings",
        words,
        &["length L / m", "u(L) / m", "period T / s", "u(T) / s", "residual / ms"],
        (0..measured.lengths.len()).map(cells).collect(),
    )
}
