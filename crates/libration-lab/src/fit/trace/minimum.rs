//! The best parameters of a model.

use libration::internals::progress::Watch;
use libration::taylor::Effort;

use super::TraceFitError;
use super::autocorrelation::Autocorrelation;
use super::layout::Layout;
use super::model::{Model, ResidualRows};
use super::series::{self, Series};
use super::weights::Weights;
use crate::measurement::Trace;
use crate::statistics::levenberg_marquardt::{self, Linearised, ResidualsError};
use nalgebra::DVector;

/// Start of a search, with its limits.
#[derive(Clone, Debug)]
pub struct Start {
    /// Values of all parameters.
    pub parameters: Vec<f64>,
    /// Indices of the parameters that are varied.
    pub free: Vec<usize>,
    /// Evaluations for each free parameter and one more.
    pub patience: usize,
    /// Accuracy of the search.
    pub care: Care,
}

/// Accuracy of a search.
#[derive(Clone, Copy, Debug)]
pub struct Care {
    /// Tolerances of the motion.
    effort: Effort,
    /// The relative change of the sum of squares that is negligible.
    tolerance: f64,
}

impl Care {
    /// Accuracy of results: ten times the tolerance of the motions.
    pub const FULL: Self = Self { effort: super::swing::EXACT, tolerance: 1e-11 };
    /// Accuracy for the choice of a model: the last digits of the others are irrelevant, and a sum of squares that does not
    /// consist of noise falls slowly.
    pub(super) const COMPARISON: Self = Self { tolerance: 1e-9, ..Self::FULL };
    /// Accuracy for the end of a descent: sums of squares that differ by a thousandth are distinguished.
    pub(super) const SEARCH: Self = Self { effort: super::swing::ROUGH, tolerance: 1e-5 };
    /// Accuracy for the first swings.
    pub(super) const FIRST_SWINGS: Self = Self { tolerance: 1e-9, ..Self::SEARCH };
    /// Accuracy for a slightly longer part of a motion, which only needs to be in phase.
    pub(super) const GROWTH: Self = Self { tolerance: 1e-3, ..Self::SEARCH };
}

/// Unexplained fraction of the scatter above which a fit has failed: 0.2 and 0.8 gave the same results. The motion of another pendulum leaves about
/// one, or two if out of phase.
pub(super) const HOPELESS: f64 = 0.5;

/// The best parameters that a search has found.
#[derive(Clone, Debug)]
pub struct Descent {
    /// Values of all parameters.
    pub parameters: Vec<f64>,
    /// Sum of squares of the residuals, times their weights.
    pub sum_of_squares: f64,
    /// Sum of squares relative to the scatter of the rows that count.
    pub(super) unexplained: f64,
    /// Correlation of the data with the motion, in the worst part of a trace: the cosine of the phase between them.
    pub(super) least_correlation: f64,
    pub(super) converged: bool,
    /// The rows at these parameters, if they are known.
    rows: Option<Vec<ResidualRows>>,
}

/// The best parameters, with the linearised problem.
#[derive(Clone, Debug)]
pub struct TraceMinimum {
    /// Values of all parameters.
    pub parameters: Vec<f64>,
    /// Derivatives of all rows with respect to the free parameters, and residuals.
    pub linearised: Linearised,
    /// Weights of all rows.
    pub weights: Weights,
    pub(super) converged: bool,
}

impl TraceMinimum {
    /// The sum of the squares of the residuals.
    pub fn sum_of_squares(&self) -> f64 {
        self.linearised.residuals.norm_squared()
    }

    /// Returns the end of a descent with this unexplained fraction of the scatter.
    pub(super) fn to_descent(&self, unexplained: f64) -> Descent {
        let (parameters, sum_of_squares) = (self.parameters.clone(), self.sum_of_squares());
        let (converged, rows) = (self.converged, None);
        Descent { parameters, sum_of_squares, unexplained, least_correlation: 0.0, converged, rows }
    }

    /// Residuals in units of the stated uncertainties, outliers at their full size.
    pub(super) fn standard_residuals(&self, traces: &[Trace]) -> Vec<f64> {
        let residuals = self.linearised.residuals.iter().zip(self.weights.parts(traces));
        residuals.map(|(residual, part)| residual / part).collect()
    }
}

/// Descends from the start of a search.
pub fn descent(
    model: &Model,
    series: &[Series<'_>],
    start: Start,
    watch: &Watch<'_>,
) -> Result<Descent, TraceFitError> {
    let Start { mut parameters, free, patience, care } = start;
    let omega0 = parameters[Layout::OMEGA0];
    let varied = DVector::from_iterator(free.len(), free.iter().map(|&index| parameters[index]));
    let effort = levenberg_marquardt::Effort { tolerance: care.tolerance, patience };
    let mut least = None;
    let outcome = levenberg_marquardt::minimum(varied, effort, |values| {
        if watch.go_on().is_err() {
            return Err(ResidualsError::Stopped);
        }
        for (&index, &value) in free.iter().zip(values) {
            parameters[index] = value;
        }
        let rows = model.rows(series, &parameters, &free, &care.effort).ok_or(ResidualsError::OutOfDomain)?;
        let few = ResidualRows::few(&rows, &free);
        let sum = few.residuals.norm_squared();
        if least.as_ref().is_none_or(|(_, before, _)| sum < *before) {
            least = Some((values.clone(), sum, rows));
        }
        Ok(few)
    });
    let minimum = outcome.map_err(|reason| match reason {
        ResidualsError::Stopped => TraceFitError::Interrupted,
        ResidualsError::OutOfDomain => TraceFitError::NoMotion { omega0 },
    })?;
    for (&index, &value) in free.iter().zip(&minimum.parameters) {
        parameters[index] = value;
    }
    let rows = least.and_then(|(values, _, rows)| (values == minimum.parameters).then_some(rows));
    let sum_of_squares = minimum.linearised.residuals.norm_squared();
    let unexplained = sum_of_squares / series::scatter(series);
    let least = |rows: &Vec<ResidualRows>| {
        let parts = rows.iter().zip(series).map(|(rows, series)| series.least_correlation(&rows.residuals()));
        parts.fold(1.0, f64::min)
    };
    let least_correlation = rows.as_ref().map_or(0.0, least);
    let converged = minimum.converged;
    Ok(Descent { parameters, sum_of_squares, unexplained, least_correlation, converged, rows })
}

/// The sum of squares at a start, and its decrease if the model were linear.
pub(super) fn promised(
    model: &Model,
    series: &[Series<'_>],
    start: &Start,
    watch: &Watch<'_>,
) -> Result<(f64, f64), TraceFitError> {
    watch.go_on().map_err(|_| TraceFitError::Interrupted)?;
    let Start { parameters, free, care, .. } = start;
    let omega0 = parameters[Layout::OMEGA0];
    let rows =
        model.rows(series, parameters, free, &care.effort).ok_or(TraceFitError::NoMotion { omega0 })?;
    let few = ResidualRows::few(&rows, free);
    let sum = few.residuals.norm_squared();
    Ok((sum, if free.is_empty() { 0.0 } else { few.promises() * sum }))
}

/// All rows at the end of a descent.
pub(super) fn linearised(
    model: &Model,
    series: &[Series<'_>],
    free: &[usize],
    descent: &Descent,
) -> Result<Linearised, TraceFitError> {
    if let Some(rows) = &descent.rows {
        return Ok(ResidualRows::whole(rows, free));
    }
    let rows = model.rows(series, &descent.parameters, free, &Care::FULL.effort);
    let omega0 = descent.parameters[Layout::OMEGA0];
    rows.map(|rows| ResidualRows::whole(&rows, free)).ok_or(TraceFitError::NoMotion { omega0 })
}

impl Descent {
    /// Returns `true` if the motion has lost the data: that of another pendulum leaves about all of their scatter unexplained.
    pub(super) fn is_lost(&self) -> bool {
        self.unexplained > HOPELESS
    }

    /// The error for data with this unexplained fraction.
    pub(super) fn unexplained_data(&self) -> TraceFitError {
        TraceFitError::Unexplained { percent: 100.0 * self.unexplained }
    }

    /// Returns `true` if the fit is known to leave only noise.
    pub(super) fn leaves_noise(&self) -> bool {
        let residuals =
            |rows: &Vec<ResidualRows>| rows.iter().map(ResidualRows::residuals).collect::<Vec<Vec<f64>>>();
        self.rows.as_ref().is_some_and(|rows| Autocorrelation::of_series(&residuals(rows)).is_noise())
    }
}

/// Returns the deeper of two ends, or the only one.
pub(super) fn deeper(
    one: Result<Descent, TraceFitError>,
    other: Result<Descent, TraceFitError>,
) -> Result<Descent, TraceFitError> {
    match (one, other) {
        (Err(TraceFitError::Interrupted), _) | (_, Err(TraceFitError::Interrupted)) => {
            Err(TraceFitError::Interrupted)
        }
        (Ok(one), Ok(other)) if other.sum_of_squares < one.sum_of_squares => Ok(other),
        (Err(_), other) => other,
        (one, _) => one,
    }
}
