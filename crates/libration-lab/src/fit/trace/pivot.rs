//! Uncertainty caused by a fitted pivot, whose error is common to all angles about it and does not show in the residuals.

use nalgebra::{DMatrix, DVector};

use super::minimum::TraceMinimum;
use crate::measurement::{FittedPivot, Trace};

/// The covariance of the parameters by the pivots, as far as they respond linearly to shifted angles. Traces about one pivot
/// share its error.
pub(super) fn covariance(traces: &[Trace], minimum: &TraceMinimum, response: &DMatrix<f64>) -> DMatrix<f64> {
    let mut sum = DMatrix::zeros(response.nrows(), response.nrows());
    for (number, trace) in traces.iter().enumerate() {
        let Some(pivot) = trace.fitted_pivot() else { continue };
        let is_the_same =
            |other: &Trace| other.fitted_pivot().is_some_and(|other| other.is_shared_with(pivot));
        if traces[..number].iter().any(is_the_same) {
            continue;
        }
        for error in 0..2 {
            let shift = response * weighted(traces, minimum, pivot, error);
            sum += &shift * shift.transpose();
        }
    }
    sum
}

/// The changes of all rows by one of the errors of a pivot, times their weights.
fn weighted(traces: &[Trace], minimum: &TraceMinimum, pivot: &FittedPivot, error: usize) -> DVector<f64> {
    let of_trace = |(trace, weights): (&Trace, &[f64])| match trace.fitted_pivot() {
        Some(other) if other.is_shared_with(pivot) => {
            other.errors()[error].iter().zip(weights).map(|(change, weight)| change * weight).collect()
        }
        _ => vec![0.0; trace.len()],
    };
    let rows: Vec<f64> = traces.iter().zip(minimum.weights.traces()).flat_map(of_trace).collect();
    DVector::from_vec(rows)
}
