//! The best parameters of a model.

use libration::watch::Watch;

use super::TraceFitError;
use super::data::Data;
use super::layout::Layout;
use super::model::Model;
use super::weights::Weights;
use crate::measurement::Trace;
use crate::statistics::levenberg_marquardt::{self, Effort, Linearised, NoResiduals};
use nalgebra::DVector;

/// The relative change of the sum of squares, or of the parameters, that is none: ten times what motions are followed to.
const TOLERANCE: f64 = 1e-11;

/// Where a search begins, and what it may do.
#[derive(Clone, Debug)]
pub(super) struct Start {
    /// Of all parameters.
    pub(super) parameters: Vec<f64>,
    /// The places of those that are varied.
    pub(super) free: Vec<usize>,
    /// The number of rows of each trace that count.
    pub(super) rows: Vec<usize>,
    /// Evaluations for each free parameter and one more.
    pub(super) patience: usize,
}

/// The best parameters, and what is known there.
#[derive(Clone, Debug)]
pub(super) struct Minimum {
    /// All of them.
    pub(super) parameters: Vec<f64>,
    /// By the free parameters, of all rows that count.
    pub(super) linearised: Linearised,
    /// Of all rows, also of those that do not count.
    pub(super) weights: Weights,
    pub(super) converged: bool,
}

impl Minimum {
    /// The sum of the squares of the residuals.
    pub(super) fn sum_of_squares(&self) -> f64 {
        self.linearised.residuals.norm_squared()
    }

    /// Residuals in units of the stated uncertainties, outliers at their full size.
    pub(super) fn standard_residuals(&self, traces: &[Trace]) -> Vec<f64> {
        let residuals = self.linearised.residuals.iter().zip(self.weights.parts(traces));
        residuals.map(|(residual, part)| residual / part).collect()
    }
}

/// The minimum next to where the search starts, with these weights. `watch` is asked before each evaluation of the motion.
pub(super) fn minimum(
    data: Data<'_>,
    model: &Model,
    weights: Weights,
    start: Start,
    watch: &Watch<'_>,
) -> Result<Minimum, TraceFitError> {
    let Start { mut parameters, free, rows, patience } = start;
    let omega0 = parameters[Layout::OMEGA0];
    let varied = DVector::from_iterator(free.len(), free.iter().map(|&place| parameters[place]));
    let found = levenberg_marquardt::minimum(varied, Effort { tolerance: TOLERANCE, patience }, |values| {
        if watch.go_on().is_err() {
            return Err(NoResiduals::Stopped);
        }
        for (&place, &value) in free.iter().zip(values) {
            parameters[place] = value;
        }
        model.linearised(data, &rows, &weights, &parameters, &free).ok_or(NoResiduals::OutOfDomain)
    });
    let found = found.map_err(|reason| match reason {
        NoResiduals::Stopped => TraceFitError::Interrupted,
        NoResiduals::OutOfDomain => TraceFitError::NoMotion { omega0 },
    })?;
    for (&place, &value) in free.iter().zip(&found.parameters) {
        parameters[place] = value;
    }
    Ok(Minimum { parameters, linearised: found.linearised, weights, converged: found.converged })
}

/// The deeper of two minima, or the one there is.
pub(super) fn deeper(
    one: Result<Minimum, TraceFitError>,
    other: Result<Minimum, TraceFitError>,
) -> Result<Minimum, TraceFitError> {
    match (one, other) {
        (Err(TraceFitError::Interrupted), _) | (_, Err(TraceFitError::Interrupted)) => {
            Err(TraceFitError::Interrupted)
        }
        (Ok(one), Ok(other)) if other.sum_of_squares() < one.sum_of_squares() => Ok(other),
        (Err(_), other) => other,
        (one, _) => one,
    }
}
