//! Errors common to all rows, which do not show in the scatter and are added to it.
//!
//! # Method
//! Such errors are those of the clock, and of the centre of the circle through positions (`measurement/fitted_pivot.rs`), whose covariance goes
//! with the trace to this fit and to the cycles (`fit/cycles/pivot.rs`).

use nalgebra::DMatrix;

use super::{Parameter, profile};

/// Adds a covariance of the parameters to their uncertainties, intervals and correlations.
pub fn add(parameters: &mut [Parameter], correlations: &mut [Vec<f64>], covariance: &DMatrix<f64>) {
    let by_scatter: Vec<f64> = parameters.iter().map(|parameter| parameter.estimate.uncertainty).collect();
    for (index, parameter) in parameters.iter_mut().enumerate() {
        widen(parameter, covariance[(index, index)].sqrt());
    }
    for (i, row) in correlations.iter_mut().enumerate() {
        for (j, correlation) in row.iter_mut().enumerate().filter(|(j, _)| *j != i) {
            let both = *correlation * by_scatter[i] * by_scatter[j] + covariance[(i, j)];
            let size = parameters[i].estimate.uncertainty * parameters[j].estimate.uncertainty;
            *correlation = if size > 0.0 { both / size } else { *correlation };
        }
    }
}

/// Adds an error of this standard deviation, with infinitely many degrees of freedom: those of the sum are Welch's and
/// Satterthwaite's (Guide to the Expression of Uncertainty in Measurement, G.4.1).
fn widen(parameter: &mut Parameter, deviation: f64) {
    if deviation <= 0.0 {
        return;
    }
    let before = profile::quantiles(parameter.degrees_of_freedom);
    let together = libm::hypot(parameter.estimate.uncertainty, deviation);
    let part = parameter.estimate.uncertainty / together;
    parameter.degrees_of_freedom /= part * part * part * part;
    parameter.estimate.uncertainty = together;
    let after = profile::quantiles(parameter.degrees_of_freedom);
    for (interval, (before, after)) in parameter.intervals.iter_mut().zip(before.into_iter().zip(after)) {
        for (end, side) in interval.iter_mut().zip([-1.0_f64, 1.0]) {
            let half = libm::hypot((*end - parameter.estimate.value) * after / before, after * deviation);
            *end = side.mul_add(half, parameter.estimate.value);
        }
    }
}
