//! Probability that chance makes a ratio of variances as large as this.

use super::count;

/// The probability that F is at least this large; degrees of freedom of the numerator and of the denominator, one or more.
///
/// The continued fraction of the incomplete beta function, Abramowitz and Stegun 26.5.8, by Lentz's method.
///
/// # Accuracy
/// 1e-12 absolute up to a thousand degrees of freedom.
pub fn probability_beyond(ratio: f64, above: usize, below: usize) -> f64 {
    probability_beyond_any(ratio, count(above), count(below))
}

/// The same probability for degrees of freedom that need not be whole.
pub(crate) fn probability_beyond_any(ratio: f64, above: f64, below: f64) -> f64 {
    if ratio <= 0.0 {
        return 1.0;
    }
    let (above, below) = (0.5 * above, 0.5 * below);
    let x = below / (below + above * ratio);
    // The fraction converges fast on the side of the mean.
    match x < (below + 1.0) / (above + below + 2.0) {
        true => incomplete_beta(x, below, above),
        false => 1.0 - incomplete_beta(1.0 - x, above, below),
    }
    .clamp(0.0, 1.0)
}

/// The regularised incomplete beta function.
fn incomplete_beta(x: f64, a: f64, b: f64) -> f64 {
    /// Terms after which the fraction has converged up to a thousand degrees of freedom.
    const TERMS: usize = 500;
    /// The number that replaces a vanishing denominator in Lentz's method.
    const SMALL: f64 = 1e-300;
    let away = |value: f64| if value.abs() < SMALL { SMALL } else { value };
    let mut d = 1.0 / away(1.0 - (a + b) * x / (a + 1.0));
    let (mut c, mut fraction) = (1.0, d);
    for term in 1..TERMS {
        let m = count(term);
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        for step in [even, odd] {
            d = 1.0 / away(1.0 + step * d);
            c = away(1.0 + step / c);
            fraction *= c * d;
        }
        // A few rounding errors: a factor of the continued fraction changes nothing more.
        if (c * d - 1.0).abs() < 1e-15 {
            break;
        }
    }
    let scale = libm::lgamma(a + b) - libm::lgamma(a) - libm::lgamma(b);
    libm::exp(scale + a * libm::log(x) + b * libm::log1p(-x)) / a * fraction
}
