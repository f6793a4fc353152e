//! What a reader should know of a fitted response.

use std::fmt;

use super::required_drive::OneHarmonic;
use super::table::Row;
use super::{FittedAnswer, ResponseFit, ResponseTable, ResponsesFit};
use crate::fit::scatter::ScatterWarning;

/// Of a parameter that may as well be zero: less than so many of its uncertainties.
const SURE: f64 = 2.0;

/// What a reader should know of a fitted response.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ResponseWarning {
    /// Rows, counted from one, between the folds of the curve, where no answer lasts: by more than three standard deviations.
    BetweenFolds(Vec<usize>),
    /// Rows, counted from one, with frequencies beyond the fold at which their branch ends: by more than three standard deviations.
    BeyondFold(Vec<usize>),
    /// The rows scatter more or less than stated.
    Scatter(ScatterWarning),
    /// The damping is less than two of its uncertainties.
    DampingOpen,
    /// All frequencies are on one side of the resonance.
    OneSided,
}

impl ResponseWarning {
    /// A name that stays.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::BetweenFolds(_) => "rows_between_folds",
            Self::BeyondFold(_) => "rows_beyond_fold",
            Self::Scatter(warning) => warning.name(),
            Self::DampingOpen => "damping_open",
            Self::OneSided => "one_sided",
        }
    }
}

impl fmt::Display for ResponseWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BetweenFolds(rows) => write!(
                f,
                "{} between the folds of the curve, where no answer lasts: a transient was measured, or the model does not hold",
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
                "all frequencies are on one side of the resonance: its place and the drive are known by extrapolation alone",
            ),
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

/// Of the preferred fit.
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
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Whether all answers are on one side of the phase of a right angle.
fn is_one_sided(table: &ResponseTable, fit: &ResponseFit) -> bool {
    let (parameters, law) = (fit.parameters(), OneHarmonic(fit.model));
    let coefficients = &parameters[..parameters.len() - 1];
    let above = |(row, found): (&Row, &FittedAnswer)| {
        row.frequency * row.frequency > law.resonance_squared(found.amplitude, coefficients)
    };
    let rows = || table.rows.iter().zip(&fit.rows).map(above);
    rows().all(|above| above) || rows().all(|above| !above)
}
