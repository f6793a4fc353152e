//! Limit cycles: the amplitudes at which a slow flow stays, as series in the small parameter.

use super::{SlowFlow, SlowSeries};
use libration_kernels::elementary::count;
use libration_numbers::roots::{PolynomialRoot, polynomial_roots};

/// A limit cycle for small values of the parameter ε, all of it by powers of ε.
///
/// # Accuracy That of its root of a₁(A), [`root_error`](Self::root_error); the higher terms lose digits if cycles of a₁ are close to each other.
#[derive(Clone, Debug, PartialEq)]
pub struct SlowLimitCycle {
    /// A, in the gauge of the slow flow; one power less than the others.
    pub amplitude: Vec<f64>,
    /// The angular frequency ψ′.
    pub frequency: Vec<f64>,
    /// The rate at which a distance from the cycle grows: it attracts where this is below zero.
    pub exponent: Vec<f64>,
    /// Error bound of the first amplitude.
    pub root_error: f64,
}

impl SlowLimitCycle {
    /// A at a value of the parameter.
    #[must_use]
    pub fn amplitude_at(&self, parameter: f64) -> f64 {
        sum(&self.amplitude, parameter)
    }

    /// ψ′ at a value of the parameter.
    #[must_use]
    pub fn frequency_at(&self, parameter: f64) -> f64 {
        sum(&self.frequency, parameter)
    }

    /// The exponent at a value of the parameter.
    #[must_use]
    pub fn exponent_at(&self, parameter: f64) -> f64 {
        sum(&self.exponent, parameter)
    }
}

fn sum(series: &[f64], parameter: f64) -> f64 {
    series.iter().rev().fold(0.0, |sum, c| sum * parameter + c)
}

impl SlowFlow {
    /// The limit cycles from simple zeros of a₁(A), up to the power of ε at which the polynomials in A are
    /// [complete](Self::whole_powers); empty if they are not.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_perturbation as libration;
    /// use libration::perturbation::{Gauge, slow_flow};
    /// use libration::progress::Quiet;
    /// let equation = "x'' + x = e1*((1 - x^2)*x' - x^3)".parse()?;
    /// let [cycle] = &slow_flow(&equation, None, 7, 3, &Gauge::Fundamental, &Quiet)?.limit_cycles()[..] else { panic!() };
    /// // A = 2, and 3A²/8 of the force x³; the exponent of the cycle is −ε, as without it.
    /// assert!((cycle.amplitude[0] - 2.0).abs() < 1e-14);
    /// assert!((cycle.frequency[1] - 1.5).abs() < 1e-14);
    /// assert!((cycle.exponent[1] + 1.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn limit_cycles(&self) -> Vec<SlowLimitCycle> {
        let (rates, phases) = (in_digits(&self.amplitude_rate), in_digits(&self.phase_rate));
        let Some(first) = rates.get(1).filter(|_| self.whole_powers > 0) else { return vec![] };
        let roots = polynomial_roots(first).unwrap_or_default();
        let is_amplitude = |root: &&PolynomialRoot| {
            root.multiplicity == 1 && root.value.im.abs() <= root.error && root.value.re > root.error
        };
        let cycle = |root: &PolynomialRoot| self.cycle(&rates, &phases, root);
        roots.iter().filter(is_amplitude).filter_map(cycle).collect()
    }

    fn cycle(
        &self,
        rates: &[Vec<f64>],
        phases: &[Vec<f64>],
        root: &PolynomialRoot,
    ) -> Option<SlowLimitCycle> {
        let last = self.whole_powers;
        let first_slope = derivative(rates.get(1)?).iter().rev().fold(0.0, |sum, c| sum * root.value.re + c);
        let mut amplitude = vec![root.value.re];
        for n in 1..last {
            // With Aₙ left out, Σ εᵏ aₖ(A) misses −a₁′(A₀) Aₙ in the power n + 1.
            amplitude.push(0.0);
            let missed = along(rates, &amplitude, n + 1);
            amplitude[n] = -missed.get(n + 1)? / first_slope;
        }
        let slopes: Vec<Vec<f64>> = rates.iter().map(|list| derivative(list)).collect();
        Some(SlowLimitCycle {
            frequency: along(phases, &amplitude, last),
            exponent: along(&slopes, &amplitude, last),
            amplitude,
            root_error: root.error,
        })
    }
}

fn in_digits(series: &SlowSeries) -> Vec<Vec<f64>> {
    series.iter().map(|list| list.iter().map(super::PiSum::to_f64).collect()).collect()
}

fn derivative(polynomial: &[f64]) -> Vec<f64> {
    polynomial.iter().enumerate().skip(1).map(|(n, c)| count(n) * c).collect()
}

/// Σ εᵏ pₖ(A(ε)) to a power of ε.
fn along(polynomials: &[Vec<f64>], amplitude: &[f64], last: usize) -> Vec<f64> {
    let mut whole = vec![0.0; last + 1];
    for (k, polynomial) in polynomials.iter().enumerate().take(last + 1) {
        let mut value = vec![0.0; last + 1 - k];
        for coefficient in polynomial.iter().rev() {
            value = product(&value, amplitude);
            value[0] += coefficient;
        }
        for (sum, term) in whole[k..].iter_mut().zip(value) {
            *sum += term;
        }
    }
    whole
}

/// The product of two series, as long as the first.
fn product(a: &[f64], b: &[f64]) -> Vec<f64> {
    let term = |n: usize| (0..=n).filter_map(|i| Some(a[n - i] * b.get(i)?)).sum();
    (0..a.len()).map(term).collect()
}
