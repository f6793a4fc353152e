//! Weights that depend on the result: effective variances depend on the change of the period with the amplitude.

use super::error::FitError;
use super::law::Point;
use super::period_table::Weighting;

/// The weights settle by a factor of (σ of T0)/T0 or so each time.
const MOST_ROUNDS: usize = 100;

/// Results of a fit with weights.
pub trait Weighted {
    /// Factor of the slope of the law: T0, or T0β.
    fn scale(&self) -> f64;

    /// The largest change of the scale that is negligible: rounding errors are smaller, and recur in each round.
    fn negligible(&self) -> f64;
}

/// Solves with the weights that belong to the result, one over standard deviations, and returns it with the variances; without uncertainties
/// with unit weights, and without variances.
///
/// # Errors
/// Fails with [`FitError::NoConvergence`] of these parameters, and with the errors of `solve`.
pub fn settled<S: Weighted>(
    points: &[Point],
    weighting: Weighting,
    parameters: &'static str,
    solve: impl Fn(&[f64]) -> Result<S, FitError>,
) -> Result<(S, Option<Vec<f64>>), FitError> {
    let mut solution = solve(&vec![1.0; points.len()])?;
    if weighting == Weighting::Scatter {
        return Ok((solution, None));
    }
    for _ in 0..MOST_ROUNDS {
        let variances: Vec<f64> = points.iter().map(|point| point.variance(solution.scale())).collect();
        let weights: Vec<f64> = variances.iter().map(|variance| 1.0 / variance.sqrt()).collect();
        let renewed = solve(&weights)?;
        if (renewed.scale() - solution.scale()).abs() <= renewed.negligible() {
            return Ok((renewed, Some(variances)));
        }
        solution = renewed;
    }
    Err(FitError::NoConvergence(parameters))
}
