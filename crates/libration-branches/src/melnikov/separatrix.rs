//! Integrals over the separatrix of the pendulum.
//!
//! In units of 1/ω0, sin θ = 2σ·sech t·tanh t, cos θ = 2 sech² t − 1, θ′ = 2σ·sech t, with σ = ±1 the
//! direction. Every term of a trigonometric polynomial thus becomes sech and tanh times a wave, whose integrals
//!
//! ```text
//! I(n, w) = ∫ sechⁿ t·cos wt dt,    ∫ sechⁿ t·tanh t·sin wt dt = (w/n)·I(n, w),
//! I(1, w) = π sech(πw/2),  I(2, w) = πw csch(πw/2),  I(n + 2, w) = I(n, w)·(n² + w²)/(n(n + 1))
//! ```
//!
//! are the residues at t = iπ/2: they have all their digits, however small they are for large w.

use super::perturbation::{PerturbedPendulum, power};
use super::trigonometric::Monomial;
use libration_numbers::algebra::Complex;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Interrupted;
use std::f64::consts::{FRAC_PI_2, PI};

/// Bound on the rounding error of a sum, relative to the sum of the magnitudes of its terms: about ten operations each.
const ROUNDING: f64 = 2e-15;

/// ∫ θ′(t)·g(θ(t), θ′(t), t + t0) dt as the coefficients of e^{ikΩt0}, from k = 0 on, each with its error.
pub(super) fn integrals(
    pendulum: &PerturbedPendulum,
    direction: f64,
    watch: &Watch<'_>,
) -> Result<Vec<(Complex, f64)>, Interrupted> {
    let mut sums = vec![(Complex::default(), 0.0); pendulum.harmonics() + 1];
    for (monomial, coefficient) in &pendulum.closed.terms {
        let Ok(k) = usize::try_from(monomial.harmonic) else { continue };
        let w = f64::from(monomial.harmonic) * pendulum.frequency().unwrap_or(0.0) / pendulum.omega0();
        let (integral, size) = of_monomial(monomial, pendulum.omega0(), direction, w);
        let (sum, error) = &mut sums[k];
        *sum = *sum + *coefficient * integral;
        *error += ROUNDING * coefficient.abs() * size;
    }
    if pendulum.rest.is_some() {
        sums = by_quadrature(pendulum, direction, sums.len(), watch)?;
    }
    Ok(sums)
}

/// The integral of θ′ times the term, and the sum of the magnitudes of its parts.
fn of_monomial(monomial: &Monomial, omega0: f64, direction: f64, w: f64) -> (Complex, f64) {
    let powers = monomial.velocity + 1;
    let factor = power(2.0 * omega0 * direction, powers) * power(2.0 * direction, monomial.sines) / omega0;
    let lowest = powers + monomial.sines;
    let mut binomial = 1.0;
    let (mut sum, mut size) = (0.0, 0.0);
    for j in 0..=monomial.cosines {
        // (2 sech² − 1)ᵐ.
        let sign = if (monomial.cosines - j).is_multiple_of(2) { 1.0 } else { -1.0 };
        let n = lowest + 2 * j;
        let integral = sech_power(n, w) * if monomial.sines == 1 { w / f64::from(n) } else { 1.0 };
        let term = sign * binomial * power(2.0, j) * integral;
        sum += term;
        size += term.abs();
        binomial *= f64::from(monomial.cosines - j) / f64::from(j + 1);
    }
    let value = factor * sum;
    let value = if monomial.sines == 1 { Complex::new(0.0, value) } else { value.into() };
    (value, factor.abs() * size)
}

/// I(n, w) for n ≥ 1.
pub fn sech_power(n: u32, w: f64) -> f64 {
    let angle = FRAC_PI_2 * w;
    let (first, mut integral) = match n % 2 {
        1 => (1, PI / libm::cosh(angle)),
        _ if angle == 0.0 => (2, 2.0),
        _ => (2, 2.0 * angle / libm::sinh(angle)),
    };
    let mut k = first;
    while k < n {
        let power = f64::from(k);
        integral *= (power * power + w * w) / (power * (power + 1.0));
        k += 2;
    }
    integral
}

/// Largest time from the bottom; sech is below 1e-18 there.
const LONGEST: f64 = 42.0;
/// Maximum number of doublings of the steps per unit of time.
const DOUBLINGS: u32 = 7;

/// A sum over times: its value, the magnitudes of its terms, and the omitted part of the perturbation.
#[derive(Clone, Copy, Debug, Default)]
struct Sum {
    value: Complex,
    size: f64,
    left: f64,
}

impl Sum {
    fn mean(self, other: Self) -> Self {
        let half = |a: f64, b: f64| 0.5 * (a + b);
        Self {
            value: (self.value + other.value).scaled(0.5),
            size: half(self.size, other.size),
            left: half(self.left, other.left),
        }
    }
}

/// The integrals by the trapezoidal rule, whose error for analytic functions is e^{−2πd/h}, with d the
/// distance of the nearest pole from the real axis and h the step, which is halved until nothing changes. Harmonics are known to the rounding of
/// the largest, of which their transform leaves a part in each.
fn by_quadrature(
    pendulum: &PerturbedPendulum,
    direction: f64,
    length: usize,
    watch: &Watch<'_>,
) -> Result<Vec<(Complex, f64)>, Interrupted> {
    let mut step = 0.125;
    let mut sums = trapezoids(pendulum, direction, length, [0.0, step], watch)?;
    let mut changes = vec![f64::INFINITY; length];
    for _ in 0..DOUBLINGS {
        let between = trapezoids(pendulum, direction, length, [0.5 * step, step], watch)?;
        step *= 0.5;
        for ((sum, other), change) in sums.iter_mut().zip(between).zip(&mut changes) {
            let mean = sum.mean(other);
            *change = (mean.value - sum.value).abs();
            *sum = mean;
        }
        if changes.iter().all(|change| *change <= rounding(&sums)) {
            break;
        }
    }
    let rounding = rounding(&sums);
    let error = |(sum, change): (&Sum, f64)| (sum.value, change + rounding + sum.left);
    Ok(sums.iter().zip(changes).map(error).collect())
}

fn rounding(sums: &[Sum]) -> f64 {
    ROUNDING * sums.iter().map(|sum| sum.size).fold(0.0, f64::max)
}

/// Sums over times at whole steps from a first one.
fn trapezoids(
    pendulum: &PerturbedPendulum,
    direction: f64,
    length: usize,
    [first, step]: [f64; 2],
    watch: &Watch<'_>,
) -> Result<Vec<Sum>, Interrupted> {
    let mut sums = vec![Sum::default(); length];
    let omega0 = pendulum.omega0();
    let w = pendulum.frequency().unwrap_or(0.0) / omega0;
    let mut time = first - step * (LONGEST / step).floor();
    while time <= LONGEST {
        watch.go_on()?;
        let velocity = 2.0 * omega0 * direction / libm::cosh(time);
        let angle = direction * 2.0 * libm::atan(libm::sinh(time));
        let weight = velocity * step / omega0;
        let (values, left) = pendulum.harmonics_at(angle, velocity);
        for ((k, value), sum) in (0_u32..).zip(values).zip(&mut sums) {
            let part = (value * Complex::unit(f64::from(k) * w * time)).scaled(weight);
            sum.value = sum.value + part;
            sum.size += part.abs();
            sum.left += left * weight.abs();
        }
        time += step;
    }
    Ok(sums)
}
