//! Huber's weights, which reduce the influence of outliers.

use crate::statistics::count;
use crate::statistics::deviation_by_median;

/// Huber's bound in standard deviations, at which 5 % of the precision is lost if there are no outliers.
pub const BOUND: f64 = 1.345;
/// Number of robust standard deviations beyond which rows are called outliers: among normal errors one in 1.7 million. Of twelve
/// recordings (`search.rs`) with linear damping a strongly damped one had some with 4 and none with 5, one near the top some with 5 and none
/// with 6.5.
const OUTLIER: f64 = 5.0;

/// The standard deviation of residuals, by their median size.
pub fn scale(residuals: &[f64]) -> f64 {
    deviation_by_median(residuals).unwrap_or(0.0)
}

/// The factor of a row with this residual: its square is the weight.
pub fn factor(residual: f64, scale: f64) -> f64 {
    let size = residual.abs();
    if size > BOUND * scale { (BOUND * scale / size).sqrt() } else { 1.0 }
}

/// Half the squares of residuals in units of the scale, beyond the bound growing only linearly.
pub fn loss(residuals: &[f64], scale: f64) -> f64 {
    let one = |residual: &f64| match residual.abs() / scale {
        size if size > BOUND => BOUND * (size - 0.5 * BOUND),
        size => 0.5 * size * size,
    };
    residuals.iter().map(one).sum()
}

/// Returns `true` if a residual is that of an outlier.
pub fn is_outlier(residual: f64, scale: f64) -> bool {
    scale > 0.0 && residual.abs() > OUTLIER * scale
}

/// The residuals of a least squares problem whose solution has the scatter of the robust one: bounded, divided by the fraction
/// of rows that are not bounded (*Robust Statistics*, as below, section 7.6).
pub fn bounded(residuals: &[f64]) -> Vec<f64> {
    let bound = BOUND * scale(residuals);
    let part = count(residuals.iter().filter(|residual| residual.abs() <= bound).count());
    let part = part / count(residuals.len());
    residuals.iter().map(|residual| residual.clamp(-bound, bound) / part).collect()
}

/// Factor of the covariance of least squares: the mean square of the bounded residuals over the square of the fraction of
/// rows that are not bounded, with Huber's correction for p parameters of n rows (*Robust Statistics*, Wiley 1981,
/// doi:10.1002/0471725250, section 7.6).
pub fn variance(residuals: &[f64], parameters: usize) -> f64 {
    let scale = scale(residuals);
    let (rows, parameters) = (count(residuals.len()), count(parameters));
    let bounded = |residual: &f64| residual.clamp(-BOUND * scale, BOUND * scale);
    let squares: f64 = residuals.iter().map(|residual| bounded(residual) * bounded(residual)).sum();
    let inside = residuals.iter().filter(|residual| residual.abs() <= BOUND * scale).count();
    let part = count(inside) / rows;
    let correction = 1.0 + parameters / rows * (1.0 - part) / part;
    correction * correction * squares / (rows - parameters) / (part * part)
}
