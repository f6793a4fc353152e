//! Weights of the rows.

use super::huber;
use crate::measurement::Trace;

/// Factors of the residuals of all rows, trace by trace: one over the standard deviation, less for outliers.
#[derive(Clone, Debug, PartialEq)]
pub struct Weights(Vec<Vec<f64>>);

impl Weights {
    /// Returns one over the stated uncertainty of each row, or one.
    pub fn stated(traces: &[Trace]) -> Self {
        let weights = |trace: &Trace| match trace.uncertainties() {
            Some(uncertainties) => uncertainties.iter().map(|uncertainty| 1.0 / uncertainty).collect(),
            None => vec![1.0; trace.len()],
        };
        Self(traces.iter().map(weights).collect())
    }

    /// Returns weights with outliers down-weighted, by residuals in units of the stated uncertainties.
    pub(super) fn robust(traces: &[Trace], residuals: &[f64]) -> Self {
        let scale = huber::scale(residuals);
        let mut weights = Self::stated(traces);
        for (weight, residual) in weights.0.iter_mut().flatten().zip(residuals) {
            *weight *= huber::factor(*residual, scale);
        }
        weights
    }

    /// Weights of each trace.
    pub(super) fn traces(&self) -> impl Iterator<Item = &[f64]> {
        self.0.iter().map(Vec::as_slice)
    }

    /// Weights of all rows.
    pub(super) fn rows(&self) -> impl Iterator<Item = f64> {
        self.0.iter().flatten().copied()
    }

    /// Ratio of each row's weight to its stated one.
    pub(super) fn parts<'a>(&'a self, traces: &[Trace]) -> impl Iterator<Item = f64> + use<'a> {
        self.rows().zip(Self::stated(traces).0.into_iter().flatten()).map(|(weight, stated)| weight / stated)
    }
}
