//! Probability that chance gives a sum of squares as large as this.

use super::count;

/// The probability that χ² is at least this large; whole degrees of freedom, one or more.
///
/// The finite sums 26.4.4 and 26.4.5 of Abramowitz and Stegun, each term by its logarithm, which does not underflow.
///
/// # Accuracy
/// 1e-12 absolute up to a thousand degrees of freedom.
pub fn probability_beyond(chi2: f64, dof: usize) -> f64 {
    if chi2 <= 0.0 {
        return 1.0;
    }
    let (half, odd) = (0.5 * chi2, dof % 2 == 1);
    let by_pairs = libm::log(half);
    // The first term is e^-y, or 2√(y/π)·e^-y; each next one is y over its place times the one before.
    let first = if odd { 0.5 * (by_pairs - libm::log(std::f64::consts::FRAC_PI_4)) } else { 0.0 };
    let mut logarithm = first - half;
    let mut sum = if odd { libm::erfc(half.sqrt()) } else { 0.0 };
    for pair in 1..=dof / 2 {
        sum += libm::exp(logarithm);
        logarithm += by_pairs - libm::log(count(pair) + if odd { 0.5 } else { 0.0 });
    }
    sum.clamp(0.0, 1.0)
}
