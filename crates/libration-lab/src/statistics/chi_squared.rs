//! How likely chance is to give a sum of squares as large as this.

use super::count;

/// The probability that χ² is at least this large; whole degrees of freedom, one or more.
///
/// The finite sums 26.4.4 and 26.4.5 of Abramowitz and Stegun, each term by its logarithm, which does not underflow.
///
/// # Accuracy
/// 1e-12 absolute up to a thousand degrees of freedom.
pub(crate) fn probability_beyond(chi2: f64, dof: usize) -> f64 {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// mpmath: `gammainc(dof/2, chi2/2, regularized=True)`; the first two are erfc(1) and e^-1.
    #[test]
    fn the_tails_are_those_of_the_tables() {
        for (chi2, dof, expected) in [
            (2.0, 1, 0.157299207050285131),
            (2.0, 2, 0.367879441171442322),
            (7.815, 3, 0.049993902974883887),
            (199.0, 10, 2.60863567141581646e-37),
            (42.380483, 39, 0.327336247259022537),
            (60.0, 99, 0.999319997049848576),
            (1000.0, 1000, 0.494052853829239642),
            (3000.0, 1000, 1.64368458435695434e-198),
            (1e-3, 5, 0.999999998318512281),
        ] {
            let found = probability_beyond(chi2, dof);
            assert!((found - expected).abs() < 1e-12, "{chi2} {dof}: {found}");
        }
        assert!(probability_beyond(0.0, 3) >= 1.0);
    }
}
