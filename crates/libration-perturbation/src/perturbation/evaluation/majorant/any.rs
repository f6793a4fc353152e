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
use libration_kernels::elementary::count;

/// The well with −|cₘ| in place of each cₘ, in units of the position x of its separatrix.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct AnyWell {
    /// The length that is the unit.
    unit: f64,
    /// |w|.
    weights: Vec<Weight>,
    /// S² of its separatrix, between 1/3 and 1.
    critical: f64,
    /// The amplitude at which A²(1 + |w|(A)) is as large.
    limit: f64,
    /// The terms of T/T0 at the separatrix.
    of_energy: Vec<f64>,
    /// Bounds of the terms that are not summed.
    beyond: Vec<Beyond>,
}

/// A term of w, of which few have high powers.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Weight {
    power: usize,
    coefficient: f64,
}

/// S² at a position, in units of that of the separatrix, with dx/ds there, which is the largest up to there.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Beyond {
    energy: f64,
    slope: f64,
}

/// Terms of the series in the energy that are summed; the others are bounded, by less than 1e-23 up to 0.95 of the limit in four wells.
const TERMS: usize = 512;

impl AnyWell {
    /// The majorant from |c₂|, |c₃|, …; [`place_of_one`] finds its separatrix.
    pub(super) fn new(factors: &[f64]) -> Option<Self> {
        let sum = |x: f64| factors.iter().rev().fold(0.0, |sum, factor| (sum + factor) * x);
        let unit = place_of_one(sum)?;
        let weight = |(power, factor): (usize, &f64)| Weight {
            power,
            coefficient: 2.0 * factor * libm::pow(unit, count(power)) / count(power + 2),
        };
        let weights: Vec<Weight> =
            (1..).zip(factors).map(weight).filter(|term| term.coefficient > 0.0).collect();
        let critical = 1.0 - value(&weights, 1.0);
        let limit = place_of_one(|x| x * x * (1.0 + value(&weights, x)) / critical)?;
        let powers = std::iter::successors(Some(1.0), |power| Some(power * critical));
        let of_energy = of_energy(&weights, TERMS).into_iter().zip(powers).map(|(term, power)| term * power);
        Some(Self {
            unit,
            critical,
            limit,
            of_energy: of_energy.collect(),
            beyond: beyond(&weights, critical),
            weights,
        })
    }

    pub(super) fn limit(&self) -> f64 {
        self.unit * self.limit
    }

    /// T/T0, or more, the amplitude in units of the limit.
    pub(super) fn period(&self, amplitude: f64) -> f64 {
        let x = amplitude * self.limit;
        let energy = x * x * (1.0 + value(&self.weights, x)) / self.critical;
        let sum = self.of_energy.iter().rev().fold(0.0, |sum, term| sum * energy + term);
        // At a larger energy those beyond are together less than the largest dx/ds.
        let larger = self.beyond.iter().filter(|point| point.energy > energy);
        let beyond = larger.map(|larger| larger.slope * libm::pow(energy / larger.energy, count(TERMS)));
        sum + beyond.fold(f64::INFINITY, f64::min)
    }

    /// The series of T/T0 by powers of the amplitude in units of the limit.
    pub(super) fn period_series(&self, order: usize) -> Vec<f64> {
        let mut series = vec![0.0; order + 1];
        // (1 + w)ᵏ.
        let mut growth = vec![0.0; order + 1];
        growth[0] = 1.0;
        for (k, term) in of_energy(&self.weights, order / 2 + 1).into_iter().enumerate() {
            series.iter_mut().skip(2 * k).zip(&growth).for_each(|(sum, growth)| *sum += term * growth);
            for n in (0..=order).rev() {
                growth[n] += weighted(&self.weights, n, |power| growth[n - power]);
            }
        }
        let powers = std::iter::successors(Some(1.0), |power| Some(power * self.limit));
        series.iter().zip(powers).map(|(coefficient, power)| coefficient * power).collect()
    }
}

/// w(x).
fn value(weights: &[Weight], x: f64) -> f64 {
    weights.iter().map(|weight| weight.coefficient * libm::pow(x, count(weight.power))).sum()
}

/// Σ wⱼ f(j) over the powers up to one.
fn weighted(weights: &[Weight], up_to: usize, of: impl Fn(usize) -> f64) -> f64 {
    let terms = weights.iter().take_while(|weight| weight.power <= up_to);
    terms.map(|weight| weight.coefficient * of(weight.power)).sum()
}

/// Positions that approach the separatrix, at which energy and slope keep enough digits.
fn beyond(weights: &[Weight], critical: f64) -> Vec<Beyond> {
    const PLACES: u32 = 48;
    let at = |step: u32| {
        let x = 1.0 - libm::exp2(-0.5 * f64::from(step));
        let square = x * x * (1.0 - value(weights, x));
        // Of the force x − Σ |cₘ| xᵐ, where cₘ = (m + 1)/2 of the weight.
        let force = |weight: &Weight| {
            0.5 * count(weight.power + 2) * weight.coefficient * libm::pow(x, count(weight.power))
        };
        let slope = libm::sqrt(square) / (x - x * weights.iter().map(force).sum::<f64>());
        Beyond { energy: square / critical, slope }
    };
    (1..PLACES).map(at).collect()
}

/// The coefficients of T/T0 by powers of S².
fn of_energy(weights: &[Weight], terms: usize) -> Vec<f64> {
    let coefficient = |k: usize| inverse_power(weights, count(k) + 0.5, 2 * k);
    (0..terms).zip(means_of_sines()).map(|(k, mean)| mean * coefficient(k)).collect()
}

/// The coefficient of xⁿ in (1 − w)^(−exponent): n yₙ = Σ ((exponent − 1)·j + n) wⱼ yₙ₋ⱼ.
fn inverse_power(weights: &[Weight], exponent: f64, n: usize) -> f64 {
    let mut series = vec![1.0];
    for n in 1..=n {
        let sum = weighted(weights, n, |j| ((exponent - 1.0) * count(j) + count(n)) * series[n - j]);
        series.push(sum / count(n));
    }
    series[n]
}
