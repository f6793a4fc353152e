//! Warnings about a fitted response.

use libration::internals::InOrder;
use std::fmt;

use super::required_drive::OneHarmonic;
use super::table::ResponseRow;
use super::{FittedAnswer, ResponseFit, ResponseFitError, ResponseModel, ResponseTable, ResponsesFit};
use crate::fit::scatter::ScatterWarning;
use crate::statistics::count;

/// Correlation of neighbouring residuals, in standard deviations, that is more than chance.
const RUNS: f64 = 3.5;
/// Number of uncertainties below which a parameter may as well be zero.
const SURE: f64 = 2.0;

/// A warning about a fitted response.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ResponseWarning {
    /// Rows, counted from one, between the folds of the curve, where no response is stable: by more than three standard deviations.
    BetweenFolds(Vec<usize>),
    /// Rows, counted from one, with frequencies beyond the fold at which their branch ends: by more than three standard deviations.
    BeyondFold(Vec<usize>),
    /// The rows scatter more or less than stated.
    Scatter(ScatterWarning),
    /// The damping is less than two of its uncertainties.
    DampingOpen,
    /// All frequencies are on one side of the resonance.
    OneSided,
    /// Neighbours in the table or along the curve deviate to the same side far more often than by chance: three and a half standard deviations.
    Systematic,
    /// Models without a fit, against which the rows are therefore not evidence.
    NotFitted(Vec<ResponseModel>),
}

impl ResponseWarning {
    /// A stable name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::BetweenFolds(_) => "rows_between_folds",
            Self::BeyondFold(_) => "rows_beyond_fold",
            Self::Scatter(warning) => warning.name(),
            Self::DampingOpen => "damping_open",
            Self::OneSided => "one_sided",
            Self::Systematic => "residuals_not_random",
            Self::NotFitted(_) => "models_not_fitted",
        }
    }
}

impl fmt::Display for ResponseWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BetweenFolds(rows) => write!(
                f,
                "{} between the folds of the curve, where no response is stable: a transient was measured, or the model does not hold",
                counted(rows)
            ),
            Self::BeyondFold(rows) => write!(
                f,
                "{} at a frequency beyond the fold where its branch ends: the sweep was too fast, or the model does not hold",
                counted(rows)
            ),
            Self::Scatter(warning) => warning.fmt(f),
            Self::DampingOpen => f.write_str(
                "the damping is less than two of its uncertainties: measure closer to the resonance, or phases too",
            ),
            Self::OneSided => f.write_str(
                "all frequencies are on one side of the resonance: its frequency and the drive are known by extrapolation alone",
            ),
            Self::Systematic => f.write_str(
                "neighbouring rows deviate to the same side: the model does not hold, and the uncertainties are too small",
            ),
            Self::NotFitted(models) => {
                let names: Vec<&str> = models.iter().map(|model| model.name()).collect();
                write!(f, "no fit of the model {} was found: the rows do not rule it out", names.join(", "))
            }
        }
    }
}

/// `rows 3, 4 and 9 are`.
fn counted(rows: &[usize]) -> String {
    let mut words: Vec<String> = rows.iter().map(ToString::to_string).collect();
    let last = words.pop().unwrap_or_default();
    match words.len() {
        0 => format!("row {last} is"),
        _ => format!("rows {} and {last} are", words.join(", ")),
    }
}

/// Warnings about the preferred fit.
pub(super) fn warnings(table: &ResponseTable, fit: &ResponsesFit) -> Vec<ResponseWarning> {
    let best = fit.best();
    let where_rows = |is_so: &dyn Fn(&FittedAnswer) -> bool| -> Option<Vec<usize>> {
        let rows: Vec<usize> =
            (1..).zip(&best.rows).filter(|(_, row)| is_so(row)).map(|(row, _)| row).collect();
        (!rows.is_empty()).then_some(rows)
    };
    let damping = best.damping;
    [
        where_rows(&|row| row.between_folds).map(ResponseWarning::BetweenFolds),
        where_rows(&|row| row.beyond_fold.is_some()).map(ResponseWarning::BeyondFold),
        best.scatter().and_then(|scatter| scatter.warning("the drive")).map(ResponseWarning::Scatter),
        (damping.value < SURE * damping.uncertainty).then_some(ResponseWarning::DampingOpen),
        is_one_sided(table, best).then_some(ResponseWarning::OneSided),
        (serial_correlation(best) > RUNS).then_some(ResponseWarning::Systematic),
        not_fitted(fit),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Returns `true` if the phases of all responses are on one side of a right angle.
fn is_one_sided(table: &ResponseTable, fit: &ResponseFit) -> bool {
    let (parameters, law) = (fit.parameters(), OneHarmonic(fit.model));
    let coefficients = &parameters[..parameters.len() - 1];
    let above = |(row, answer): (&ResponseRow, &FittedAnswer)| {
        row.frequency * row.frequency > law.resonance_squared(answer.amplitude, coefficients)
    };
    let rows = || table.rows.iter().zip(&fit.rows).map(above);
    rows().all(|above| above) || rows().all(|above| !above)
}

/// The correlation of neighbouring residuals in its standard deviations 1/√n: for neighbours in the table, and along the fitted curve, which is
/// ordered through its jumps by the phase. A wrong model may have one branch where the rows have two.
fn serial_correlation(fit: &ResponseFit) -> f64 {
    let in_table: Vec<&FittedAnswer> = fit.rows.iter().collect();
    let mut on_curve = in_table.clone();
    on_curve.put_in_order(|a, b| a.phase.total_cmp(&b.phase));
    let squares: f64 = fit.rows.iter().map(|row| row.residual * row.residual).sum();
    let of_order = |rows: &[&FittedAnswer]| {
        let products: f64 = rows.windows(2).map(|pair| pair[0].residual * pair[1].residual).sum();
        products / squares * count(rows.len()).sqrt()
    };
    if squares > 0.0 { of_order(&in_table).max(of_order(&on_curve)) } else { 0.0 }
}

fn not_fitted(fit: &ResponsesFit) -> Option<ResponseWarning> {
    let models = fit.left_out.iter().filter_map(|reason| match reason {
        ResponseFitError::NoConvergence(model) => Some(*model),
        _ => None,
    });
    let models: Vec<ResponseModel> = models.collect();
    (!models.is_empty()).then_some(ResponseWarning::NotFitted(models))
}
