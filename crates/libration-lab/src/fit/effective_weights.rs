//! Weights that belong to what they are to find: effective variances depend on by how much the period changes with the amplitude.

use super::law::Point;
use super::{FitError, Weighting};

/// The weights settle by a factor of (σ of T0)/T0 or so each time.
const MOST_ROUNDS: usize = 100;

/// What is found with weights.
pub trait Weighted {
    /// By what the slope of the law is multiplied: T0, or T0β.
    fn scale(&self) -> f64;

    /// A change of the scale that is none: rounding makes less of one, and so would the next round.
    fn negligible(&self) -> f64;
}

/// What `solve` finds with the weights that belong to it, one over standard deviations, and the variances; with unit weights, and no
/// variances, without uncertainties.
///
/// # Errors
/// [`FitError::NoConvergence`] of these parameters, or what `solve` says.
pub fn settled<S: Weighted>(
    points: &[Point],
    weighting: Weighting,
    parameters: &'static str,
    solve: impl Fn(&[f64]) -> Result<S, FitError>,
) -> Result<(S, Option<Vec<f64>>), FitError> {
    let mut found = solve(&vec![1.0; points.len()])?;
    if weighting == Weighting::Scatter {
        return Ok((found, None));
    }
    for _ in 0..MOST_ROUNDS {
        let variances: Vec<f64> = points.iter().map(|point| point.variance(found.scale())).collect();
        let weights: Vec<f64> = variances.iter().map(|variance| 1.0 / variance.sqrt()).collect();
        let renewed = solve(&weights)?;
        if (renewed.scale() - found.scale()).abs() <= renewed.negligible() {
            return Ok((renewed, Some(variances)));
        }
        found = renewed;
    }
    Err(FitError::NoConvergence(parameters))
}
