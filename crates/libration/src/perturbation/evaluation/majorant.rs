//! The proven remainder of the period's series for a force that is an odd polynomial.
//!
//! With the restoring force ω0²(x + c₂x³ + c₃x⁵ + …) and the amplitude A, energy gives
//!
//! T/T0 = (2/π) ∫ Q^(−1/2) dφ over [0, π/2], with Q = 1 + Σ cₘ A^(2m−2) (1 + s² + … + s^(2m−2))/m and s = sin φ.
//!
//! The power series of Q^(−1/2) − 1 in its terms has coefficients whose size is largest where all of these terms are negative, and then all
//! are positive. So no coefficient of T/T0 is larger than that of the oscillator with −|cₘ| in the place of cₘ, and no remainder is
//! larger than its remainder.

use crate::algebra::Rational;
use crate::elementary::count;
use std::f64::consts::PI;

/// The period of the oscillator with −|cₘ| in the place of each cₘ, as a bound for that with cₘ.
///
/// # Examples
/// ```
/// use libration::perturbation::PeriodMajorant;
/// // x″ = −x + x³: here the bound is what is missing.
/// let force = ["1", "0", "-1"].map(|text| text.parse().unwrap());
/// let majorant = PeriodMajorant::new(&force, 4).ok_or("no odd polynomial")?;
/// let bound = majorant.at(0.6);
/// // T/T0 = (2/π)·K(m)/√(1 − A²/2) with m = (A²/2)/(1 − A²/2), by mpmath.
/// let missing = 1.173_775_132_086_487_5 - (1.0 + 3.0 / 8.0 * 0.36 + 57.0 / 256.0 * 0.36 * 0.36);
/// assert!(missing <= bound.after(4) && bound.after(4) < 1.001 * missing);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodMajorant {
    /// The amplitude at which the bounding oscillator has an equilibrium, and no period.
    limit: f64,
    /// |cₘ| for m = 2, 3, …, in units of the limit: their sum is one.
    factors: Vec<f64>,
    /// The coefficients of its series of T/T0, by even powers of the amplitude in the same units.
    coefficients: Vec<f64>,
}

/// The bound at one amplitude.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodMajorantAt<'a> {
    majorant: &'a PeriodMajorant,
    amplitude: f64,
    /// Larger amplitudes in units of the limit, with the bounding period there.
    larger: Vec<(f64, f64)>,
}

/// What the sums below may lose by rounding, far more than they do: each has less than 1e5 terms, all positive.
const ROUNDING: f64 = 1e-10;

impl PeriodMajorant {
    /// For the restoring force g₁x + g₂x² + … and series up to a power; `None` where the force has an even power, is linear, or drives
    /// away.
    #[must_use]
    pub fn new(force: &[Rational], order: usize) -> Option<Self> {
        let first = force.first().filter(|first| **first > Rational::from(0))?;
        if force.iter().skip(1).step_by(2).any(|even| !even.is_zero()) {
            return None;
        }
        let factor = |odd: &Rational| Some(odd.checked_div(first)?.to_f64().abs());
        let factors: Vec<f64> = force.iter().step_by(2).skip(1).map(factor).collect::<Option<_>>()?;
        let limit = limit(&factors).filter(|limit| (1e-100..1e100).contains(limit))?;
        let scaled = (1..).zip(&factors).map(|(k, factor)| factor * libm::pow(limit * limit, count(k)));
        let factors: Vec<f64> = scaled.collect();
        Some(Self { limit, coefficients: coefficients(&factors, order / 2), factors })
    }

    /// The bound at an amplitude.
    #[must_use]
    pub fn at(&self, amplitude: f64) -> PeriodMajorantAt<'_> {
        let amplitude = amplitude.abs() / self.limit;
        // All coefficients being positive, the remainder at A is at most (A/B)^next of that at a larger B. At A itself rounding would
        // hide a remainder that is small, near the limit the period is large: the best of some is taken.
        // With so many it is within 2 % of the remainder, where that is the bound itself, up to 0.9999 of the limit
        // (tests/suite/period_majorants.rs).
        const PLACES: u32 = 24;
        let larger = |place: u32| amplitude + (1.0 - amplitude) * (1.0 - libm::exp2(-f64::from(place) / 2.0));
        let larger = match amplitude < 1.0 {
            true => (0..PLACES).map(larger).map(|place| (place, self.period(place))).collect(),
            false => vec![],
        };
        PeriodMajorantAt { majorant: self, amplitude, larger }
    }

    /// T/T0 of the bounding oscillator, or more. The trapezoidal rule with an even number of intervals is never below the integral: for
    /// each power of sin² φ all that it adds has a positive sign.
    fn period(&self, amplitude: f64) -> f64 {
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
        if whole.is_nan() { f64::INFINITY } else { whole * (1.0 + ROUNDING) }
    }
}

impl PeriodMajorantAt<'_> {
    /// A bound of what is missing when the series of T/T0 in powers of the amplitude ends with this power. Infinite where the
    /// bounding oscillator has no period.
    #[must_use]
    pub fn after(&self, power: usize) -> f64 {
        if self.amplitude.is_nan() {
            return f64::NAN;
        }
        let next = count(power - power % 2 + 2);
        let known = self.majorant.coefficients.iter().take(power / 2 + 1);
        let bound = |(larger, period): &(f64, f64)| {
            let sum = known.clone().rev().fold(0.0, |sum, coefficient| sum * larger * larger + coefficient);
            let share = libm::pow(self.amplitude / larger, next) * (1.0 + ROUNDING);
            share * (period - sum * (1.0 - ROUNDING))
        };
        let bounds = self.larger.iter().filter(|(larger, _)| *larger > 0.0).map(bound);
        if self.amplitude > 0.0 { bounds.fold(f64::INFINITY, f64::min) } else { 0.0 }
    }
}

/// Where Σ |cₘ| A^(2m−2) is one; `None` where there is no such place.
fn limit(factors: &[f64]) -> Option<f64> {
    let sum =
        |amplitude: f64| factors.iter().rev().fold(0.0, |sum, factor| (sum + factor) * amplitude * amplitude);
    let mut high = 1.0;
    while sum(high) < 1.0 && high < 1e150 {
        high *= 2.0;
    }
    let mut low = 0.0;
    if sum(high) < 1.0 || sum(high).is_nan() {
        return None;
    }
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return Some(low);
        }
        if sum(middle) < 1.0 { low = middle } else { high = middle }
    }
}

/// The series of the bounding T/T0: each coefficient the mean over φ of a polynomial in sin² φ.
fn coefficients(factors: &[f64], corrections: usize) -> Vec<f64> {
    // y = (1 − u)^(−1/2): n yₙ = Σ (k/2 + n − k) uₖ yₙ₋ₖ.
    let mut series: Vec<Vec<f64>> = vec![vec![1.0]];
    for n in 1..=corrections {
        let mut sum = vec![];
        for (k, factor) in (1..=n).zip(factors) {
            let weight = factor / count(k + 1) * (0.5 * count(k) + count(n - k)) / count(n);
            let earlier = &series[n - k];
            sum.resize(sum.len().max(earlier.len() + k), 0.0);
            for (power, coefficient) in earlier.iter().enumerate() {
                // 1 + s² + … + s^(2k).
                sum[power..=power + k].iter_mut().for_each(|it| *it += weight * coefficient);
            }
        }
        series.push(sum);
    }
    series.iter().map(|polynomial| mean(polynomial)).collect()
}

/// The mean over φ of a polynomial in sin² φ: that of sin^(2k) φ is (2k − 1)!!/(2k)!!.
fn mean(polynomial: &[f64]) -> f64 {
    let (mut weight, mut sum) = (1.0, 0.0);
    for (k, coefficient) in polynomial.iter().enumerate() {
        if k > 0 {
            weight *= (2.0 * count(k) - 1.0) / (2.0 * count(k));
        }
        sum += coefficient * weight;
    }
    sum
}
