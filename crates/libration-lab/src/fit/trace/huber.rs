//! Huber's weights, which turn outliers down.

use crate::statistics::count;
use crate::statistics::deviation_by_median;

/// Huber's bound in standard deviations, at which 5 % of the precision is lost if there are no outliers.
const BOUND: f64 = 1.345;
/// Rows beyond so many robust standard deviations are called outliers: among normal errors one in 1.7 million. Of twelve
/// recordings (`search.rs`) with linear damping a strongly damped one had some with 4 and none with 5, one near the top some with 5 and none
/// with 6.5.
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

/// The residuals of a least squares problem whose answer scatters as the robust one does: bounded, over the part of rows that
/// are not (*Robust Statistics*, as below, section 7.6).
pub(super) fn bounded(residuals: &[f64]) -> Vec<f64> {
    let bound = BOUND * scale(residuals);
    let part = count(residuals.iter().filter(|residual| residual.abs() <= bound).count());
    let part = part / count(residuals.len());
    residuals.iter().map(|residual| residual.clamp(-bound, bound) / part).collect()
}

/// What the covariance of least squares is multiplied by: the mean square of the bounded residuals over the square of the
/// part of rows that are not bounded, with Huber's correction for p parameters of n rows (*Robust Statistics*, Wiley 1981,
/// doi:10.1002/0471725250, section 7.6).
pub(super) fn variance(residuals: &[f64], parameters: usize) -> f64 {
    let scale = scale(residuals);
    let (rows, parameters) = (count(residuals.len()), count(parameters));
    let bounded = |residual: &f64| residual.clamp(-BOUND * scale, BOUND * scale);
    let squares: f64 = residuals.iter().map(|residual| bounded(residual) * bounded(residual)).sum();
    let inside = residuals.iter().filter(|residual| residual.abs() <= BOUND * scale).count();
    let part = count(inside) / rows;
    let correction = 1.0 + parameters / rows * (1.0 - part) / part;
    correction * correction * squares / (rows - parameters) / (part * part)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At the bound and one ulp beside it.
    #[test]
    fn rows_count_in_full_up_to_the_bound() {
        let bound = 2.0 * BOUND;
        assert!([0.0, -1.0, bound, -bound].iter().all(|&x| factor(x, 2.0).to_bits() == 1.0_f64.to_bits()));
        assert!(factor(bound.next_up(), 2.0) <= 1.0);
        // The square of the factor times the residual is the bound.
        assert!((factor(8.0 * bound, 2.0) - 0.125_f64.sqrt()).abs() < 1e-15);
    }

    #[test]
    fn the_loss_is_half_the_square_and_beyond_the_bound_its_tangent() {
        assert!((loss(&[2.0, -2.0], 2.0) - 1.0).abs() < 1e-15);
        // 1.345·(3 − 0.6725) by hand.
        assert!((loss(&[6.0], 2.0) - 3.1304875).abs() < 1e-12);
        let step = 1e-6;
        let slope = (loss(&[BOUND + step], 1.0) - loss(&[BOUND - step], 1.0)) / (2.0 * step);
        assert!((slope - BOUND).abs() < 1e-6);
    }

    /// Residuals ±1 eight times and ±3 twice, of two parameters: by hand with scale 1.4826, bound 1.9941, part 0.8,
    /// correction 1 + 0.2·0.25, squares 8 + 2·3.9765.
    #[test]
    fn the_variance_has_the_correction_for_the_parameters() {
        let residuals = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 3.0, -3.0];
        let bound = 1.345 * 1.482602218505602;
        let expected = 1.05 * 1.05 * (8.0 + 2.0 * bound * bound) / 8.0 / 0.64;
        assert!((variance(&residuals, 2) - expected).abs() < 1e-12);
    }

    #[test]
    fn outliers_answer_as_if_they_were_at_the_bound() {
        let found = bounded(&[1.0, -1.0, 1.0, -100.0]);
        let bound = BOUND * scale(&[1.0, -1.0, 1.0, -100.0]);
        assert!(
            (found[0] - 1.0 / 0.75).abs() < 1e-15 && (found[3] + bound / 0.75).abs() < 1e-15,
            "{found:?}"
        );
    }

    #[test]
    fn outliers_begin_at_five_deviations() {
        assert!(!is_outlier(10.0, 2.0) && is_outlier(10.0_f64.next_up(), 2.0) && is_outlier(-10.1, 2.0));
        assert!(!is_outlier(1.0, 0.0), "without a scale there is none");
    }
}
