//! The bound for any polynomial force.
//!
//! Let the restoring force be ω0²(x + c₂x² + c₃x³ + …), w(x) = Σ 2cₘ x^(m−1)/(m + 1), and s²= x²(1 + w(x)), twice the potential energy in
//! units of ω0². Then x = s(1 + w(x))^(−1/2), whose power series in s is Lagrange's, and the mean of dx/ds over s = S sin φ is
//!
//! T/T0 = Σ (2k − 1)!!/(2k)!! · S^(2k) · [x^(2k)] (1 + w)^(−k−1/2), with S² = A²(1 + w(A)).
//!
//! With −|cₘ| in the place of cₘ in the first factor and |cₘ| in S² all coefficients are positive, and none is smaller in magnitude.

use super::odd::means_of_sines;
use super::place_of_one;
use crate::elementary::count;

/// The well with −|cₘ| in the place of each cₘ, in units of the place x of its separatrix.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct AnyWell {
    /// The length that is the unit.
    unit: f64,
    /// |cₘ| for m = 2, 3, …: their sum is one.
    factors: Vec<f64>,
    /// S² of its separatrix, between 1/3 and 1.
    critical: f64,
    /// The amplitude at which A²(1 + Σ |2cₘ| A^(m−1)/(m + 1)) is as large.
    limit: f64,
    /// The terms of T/T0 at the separatrix.
    of_energy: Vec<f64>,
}

/// Terms of the series in the energy that are summed; the others are bounded, by less than 1e-23 up to 0.95 of the limit in four wells.
const TERMS: usize = 512;

impl AnyWell {
    /// From |c₂|, |c₃|, …, as [`place_of_one`] finds the separatrix.
    pub(super) fn new(factors: &[f64]) -> Option<Self> {
        let sum = |x: f64| factors.iter().rev().fold(0.0, |sum, factor| (sum + factor) * x);
        let unit = place_of_one(sum)?;
        let factors: Vec<f64> =
            (1..).zip(factors).map(|(k, factor)| factor * libm::pow(unit, count(k))).collect();
        let weights = weights(&factors);
        let critical = 1.0 - horner(&weights, 1.0);
        let limit =
            place_of_one(|amplitude| amplitude * amplitude * (1.0 + horner(&weights, amplitude)) / critical)?;
        let of_energy = of_energy(&weights, TERMS);
        let scaled = of_energy.iter().scan(1.0, |power, term| {
            let now = *power * term;
            *power *= critical;
            Some(now)
        });
        Some(Self { unit, critical, limit, of_energy: scaled.collect(), factors })
    }

    pub(super) fn limit(&self) -> f64 {
        self.unit * self.limit
    }

    /// T/T0, or more, the amplitude in units of the limit.
    pub(super) fn period(&self, amplitude: f64) -> f64 {
        let amplitude = amplitude * self.limit;
        let energy =
            amplitude * amplitude * (1.0 + horner(&weights(&self.factors), amplitude)) / self.critical;
        let sum = self.of_energy.iter().rev().fold(0.0, |sum, term| sum * energy + term);
        sum + self.beyond(energy)
    }

    /// A bound of the terms that are not summed, the energy in units of the separatrix's: at a larger energy they are together less than the
    /// largest dx/ds.
    fn beyond(&self, energy: f64) -> f64 {
        const PLACES: u32 = 48;
        let at = |place: u32| {
            let x = 1.0 - libm::exp2(-0.5 * f64::from(place));
            let square = x * x * (1.0 - horner(&weights(&self.factors), x));
            let slope = libm::sqrt(square) / (x - x * horner(&self.factors, x));
            let share = energy * self.critical / square;
            if share < 1.0 { slope * libm::pow(share, count(TERMS)) } else { f64::INFINITY }
        };
        (1..PLACES).map(at).fold(f64::INFINITY, f64::min)
    }

    /// The series of T/T0 by powers of the amplitude in units of the limit.
    pub(super) fn period_series(&self, order: usize) -> Vec<f64> {
        let weights = weights(&self.factors);
        let mut series = vec![0.0; order + 1];
        // (1 + w)ᵏ.
        let mut growth = vec![0.0; order + 1];
        growth[0] = 1.0;
        for (k, term) in of_energy(&weights, order / 2 + 1).into_iter().enumerate() {
            series.iter_mut().skip(2 * k).zip(&growth).for_each(|(sum, growth)| *sum += term * growth);
            for n in (0..=order).rev() {
                growth[n] += (1..=n).zip(&weights).map(|(j, weight)| weight * growth[n - j]).sum::<f64>();
            }
        }
        let powers = std::iter::successors(Some(1.0), |power| Some(power * self.limit));
        series.iter().zip(powers).map(|(coefficient, power)| coefficient * power).collect()
    }
}

/// The coefficients of w, from the first power.
fn weights(factors: &[f64]) -> Vec<f64> {
    (2..).zip(factors).map(|(m, factor)| 2.0 * factor / count(m + 1)).collect()
}

/// A polynomial that begins with the first power.
fn horner(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| (sum + coefficient) * x)
}

/// The coefficients of T/T0 by powers of S².
fn of_energy(weights: &[f64], terms: usize) -> Vec<f64> {
    let coefficient = |k: usize| inverse_power(weights, count(k) + 0.5, 2 * k);
    (0..terms).zip(means_of_sines()).map(|(k, mean)| mean * coefficient(k)).collect()
}

/// The coefficient of xⁿ in (1 − w)^(−exponent): n yₙ = Σ ((exponent − 1)·j + n) wⱼ yₙ₋ⱼ.
fn inverse_power(weights: &[f64], exponent: f64, n: usize) -> f64 {
    let mut series = vec![1.0];
    for n in 1..=n {
        let term =
            |(j, weight): (usize, &f64)| ((exponent - 1.0) * count(j) + count(n)) * weight * series[n - j];
        series.push((1..=n).zip(weights).map(term).sum::<f64>() / count(n));
    }
    series[n]
}
