//! Limits beyond which a difference is more than chance.

use crate::statistics::student::quantile;

/// Number of standard uncertainties above which a difference is not explained by chance: among normal errors one in 370 is as
/// large, so that of about ten comparisons made for one measurement one in some forty is a false alarm.
pub const SIGNIFICANT: f64 = 3.0;

/// The number of standard uncertainties, found from a scatter with these degrees of freedom, that chance exceeds as seldom as a normal error exceeds
/// `deviations`: by Student's distribution.
///
/// # Examples
/// ```
/// use libration_lab::fit::limit_of_chance;
/// assert_eq!(limit_of_chance(3.0, f64::INFINITY), 3.0);
/// assert!((limit_of_chance(3.0, 1.0) - 235.80).abs() < 0.01);
/// ```
#[must_use]
pub fn limit_of_chance(deviations: f64, degrees_of_freedom: f64) -> f64 {
    if degrees_of_freedom.is_finite() {
        quantile(libm::erfc(deviations / std::f64::consts::SQRT_2), degrees_of_freedom)
    } else {
        deviations
    }
}

/// Effective degrees of freedom, after Welch and Satterthwaite, of the sum of independent errors: standard uncertainties with their degrees of freedom.
pub(super) fn combined_degrees_of_freedom(errors: &[(f64, f64)]) -> f64 {
    let square = |x: f64| x * x;
    let total: f64 = errors.iter().map(|(uncertainty, _)| square(*uncertainty)).sum();
    let spread: f64 = errors.iter().map(|(uncertainty, dof)| square(square(*uncertainty)) / dof).sum();
    if spread > 0.0 { square(total) / spread } else { f64::INFINITY }
}
