//! Huber's weights, which turn outliers down.

use crate::fit::robust::deviation_by_median;

/// Huber's bound in standard deviations, at which 5 % of the precision is lost if there are no outliers.
const BOUND: f64 = 1.345;
/// Rows beyond so many robust standard deviations are called outliers.
const OUTLIER: f64 = 5.0;

/// The standard deviation of residuals, by their median size.
pub(super) fn scale(residuals: &[f64]) -> f64 {
    deviation_by_median(residuals).unwrap_or(0.0)
}

/// The part of a residual by which a row is multiplied: the square of it is the weight.
pub(super) fn factor(residual: f64, scale: f64) -> f64 {
    let size = residual.abs();
    if size > BOUND * scale { (BOUND * scale / size).sqrt() } else { 1.0 }
}

/// Half the squares of residuals in units of the scale, beyond the bound only as much as they grow.
pub(super) fn loss(residuals: &[f64], scale: f64) -> f64 {
    let one = |residual: &f64| match residual.abs() / scale {
        size if size > BOUND => BOUND * (size - 0.5 * BOUND),
        size => 0.5 * size * size,
    };
    residuals.iter().map(one).sum()
}

/// Whether a residual is one of an outlier.
pub(super) fn is_outlier(residual: f64, scale: f64) -> bool {
    scale > 0.0 && residual.abs() > OUTLIER * scale
}

/// What the covariance of least squares is multiplied by: the mean square of the bounded residuals over the square of the
/// part of rows that are not bounded, with Huber's correction for p parameters of n rows (*Robust Statistics*, Wiley 1981,
/// doi:10.1002/0471725250, section 7.6).
pub(super) fn variance(residuals: &[f64], parameters: usize) -> f64 {
    let scale = scale(residuals);
    let (rows, parameters) = (super::count(residuals.len()), super::count(parameters));
    let bounded = |residual: &f64| residual.clamp(-BOUND * scale, BOUND * scale);
    let squares: f64 = residuals.iter().map(|residual| bounded(residual) * bounded(residual)).sum();
    let inside = residuals.iter().filter(|residual| residual.abs() <= BOUND * scale).count();
    let part = super::count(inside) / rows;
    let correction = 1.0 + parameters / rows * (1.0 - part) / part;
    correction * correction * squares / (rows - parameters) / (part * part)
}
