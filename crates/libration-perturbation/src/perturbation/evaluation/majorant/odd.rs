//! The bound for a force that is an odd polynomial.
//!
//! With the restoring force ω0²(x + c₂x³ + c₃x⁵ + …) and the amplitude A, energy gives
//!
//! T/T0 = (2/π) ∫ Q^(−1/2) dφ over [0, π/2], with Q = 1 + Σ cₘ A^(2m−2) (1 + s² + … + s^(2m−2))/m and s = sin φ.
//!
//! The power series of Q^(−1/2) − 1 in its terms has coefficients whose size is largest where all of these terms are negative, and then all
//! are positive. So no coefficient of T/T0 is larger than that of the oscillator with −|cₘ| in the place of cₘ, and no remainder is
//! larger than its remainder.

use super::place_of_one;
use libration_kernels::elementary::count;
use std::f64::consts::PI;

/// The oscillator with −|cₘ| in place of each cₘ.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct OddWell {
    /// The amplitude at which it has an equilibrium, and no period.
    limit: f64,
    /// |cₘ| for m = 2, 3, …, in units of the limit: their sum is one.
    factors: Vec<f64>,
}

impl OddWell {
    /// The majorant from |c₂|, |c₃|, …; [`place_of_one`] finds its limit.
    pub(super) fn new(factors: &[f64]) -> Option<Self> {
        let sum = |amplitude: f64| {
            factors.iter().rev().fold(0.0, |sum, factor| (sum + factor) * amplitude * amplitude)
        };
        let limit = place_of_one(sum)?;
        let scaled = (1..).zip(factors).map(|(k, factor)| factor * libm::pow(limit * limit, count(k)));
        Some(Self { limit, factors: scaled.collect() })
    }

    pub(super) const fn limit(&self) -> f64 {
        self.limit
    }

    /// T/T0, or more. The trapezoidal rule with an even number of intervals is never below the integral: for
    /// each power of sin² φ all that it adds has a positive sign.
    pub(super) fn period(&self, amplitude: f64) -> f64 {
        const INTERVALS: u32 = 512;
        let at = |interval: u32| {
            let sine = libm::sin(PI * f64::from(interval) / f64::from(2 * INTERVALS));
            let (mut power, mut sum) = (1.0, 0.0);
            for (m, factor) in (2..).zip(&self.factors) {
                power *= amplitude * amplitude;
                let terms = (0..m).fold(0.0, |sum, _| sum * sine * sine + 1.0);
                sum += factor * power * terms / count(m);
            }
            1.0 / libm::sqrt(1.0 - sum)
        };
        let inner: f64 = (1..INTERVALS).map(at).sum();
        let whole = (inner + 0.5 * (at(0) + at(INTERVALS))) / f64::from(INTERVALS);
        if whole.is_nan() { f64::INFINITY } else { whole }
    }

    /// The series of T/T0 by powers of the amplitude: each coefficient the mean over φ of a polynomial in sin² φ.
    pub(super) fn period_series(&self, order: usize) -> Vec<f64> {
        // y = (1 − u)^(−1/2): n yₙ = Σ (k/2 + n − k) uₖ yₙ₋ₖ.
        let mut series: Vec<Vec<f64>> = vec![vec![1.0]];
        for n in 1..=order / 2 {
            let mut sum = vec![];
            for (k, factor) in (1..=n).zip(&self.factors) {
                let weight = factor / count(k + 1) * (0.5 * count(k) + count(n - k)) / count(n);
                let earlier = &series[n - k];
                sum.resize(sum.len().max(earlier.len() + k), 0.0);
                for (power, coefficient) in earlier.iter().enumerate() {
                    // 1 + s² + … + s^(2k).
                    sum[power..=power + k].iter_mut().for_each(|entry| *entry += weight * coefficient);
                }
            }
            series.push(sum);
        }
        series.iter().flat_map(|polynomial| [mean(polynomial), 0.0]).collect()
    }
}

/// The mean over φ of a polynomial in sin² φ.
fn mean(polynomial: &[f64]) -> f64 {
    polynomial.iter().zip(means_of_sines()).map(|(coefficient, mean)| coefficient * mean).sum()
}

/// The means of sin^(2k) φ, (2k − 1)!!/(2k)!!.
pub(super) fn means_of_sines() -> impl Iterator<Item = f64> {
    (1..).scan(1.0, |mean, k| {
        let now = *mean;
        *mean *= (2.0 * count(k) - 1.0) / (2.0 * count(k));
        Some(now)
    })
}
