//! The truncated system in numbers. Projections of a polynomial force are sums over a few phases, and these are
//! exact: over n midpoints of the quarter period every cosine of an even multiple below 4n adds up to zero.

use std::f64::consts::FRAC_PI_2;

use libration_kernels::elementary::count;
use libration_numbers::algebra::{Complex, Rational};

/// The force and the phases at which it is evaluated.
#[derive(Clone, Debug)]
pub(super) struct Collocation {
    /// Cosines of the odd multiples of each phase.
    cosines: Vec<Vec<f64>>,
    /// The coefficients of x, x³, x⁵, ….
    force: Vec<f64>,
}

/// The projections of the force on the harmonics.
pub(super) struct Projections {
    pub(super) values: Vec<Complex>,
    /// Derivatives with respect to each amplitude, a row for each value.
    pub(super) derivatives: Vec<Vec<Complex>>,
}

impl Collocation {
    /// The collocation for the first odd harmonics, and an odd force given by its coefficients of x, x², x³, ….
    pub(super) fn new(harmonics: u32, force: &[Rational]) -> Self {
        // A power of the force times a harmonic.
        Self::exact_to(harmonics, force, (force.len() + 1) * highest(harmonics))
    }

    /// The collocation with the number of phases needed for the square of the residual of the equation of motion.
    pub(super) fn for_residuals(harmonics: u32, force: &[Rational]) -> Self {
        Self::exact_to(harmonics, force, 2 * force.len() * highest(harmonics))
    }

    /// The collocation with sums over the phases that are exact for multiples of τ up to this one.
    fn exact_to(harmonics: u32, force: &[Rational], multiple: usize) -> Self {
        let force: Vec<f64> = force.iter().step_by(2).map(Rational::to_f64).collect();
        let points = multiple / 4 + 1;
        let phase = |m: usize| odd(m) * FRAC_PI_2 / count(2 * points);
        let multiples = |m| (0..harmonics as usize).map(move |i| libm::cos(odd(i) * phase(m)));
        Self { cosines: (0..points).map(|m| multiples(m).collect()).collect(), force }
    }

    pub(super) fn harmonics(&self) -> usize {
        self.cosines[0].len()
    }

    /// The exponent of the last term of the force.
    pub(super) fn degree(&self) -> usize {
        2 * self.force.len() - 1
    }

    /// The displacement at which the last term of the force is as large as the linear one.
    pub(super) fn nonlinear_size(&self) -> f64 {
        let last = self.force.last().map_or(1.0, |factor| factor.abs());
        libm::pow(last, -1.0 / count(self.degree() - 1))
    }

    /// The collocation with x measured in other units: the force g(s·x)/s.
    pub(super) fn in_units_of(&self, scale: f64) -> Self {
        let powers = std::iter::successors(Some(1.0), |power| Some(power * scale * scale));
        let force = self.force.iter().zip(powers).map(|(term, power)| term * power);
        Self { cosines: self.cosines.clone(), force: force.collect() }
    }

    pub(super) fn projections(&self, amplitudes: &[Complex]) -> Projections {
        let k = self.harmonics();
        let mut values = vec![Complex::default(); k];
        let mut derivatives = vec![vec![Complex::default(); k]; k];
        for cosines in &self.cosines {
            let (force, slope) = self.force_and_slope(weighted(cosines, amplitudes));
            for i in 0..k {
                let weight = 2.0 * cosines[i] / self.points();
                values[i] = values[i] + force.scaled(weight);
                for j in 0..k {
                    derivatives[i][j] = derivatives[i][j] + slope.scaled(weight * cosines[j]);
                }
            }
        }
        Projections { values, derivatives }
    }

    /// The root of the mean of |Δ²x″ + g(x)|², of a collocation [for residuals](Self::for_residuals).
    pub(super) fn residual(&self, amplitudes: &[Complex], frequency_ratio_squared: Complex) -> f64 {
        let accelerations: Vec<Complex> =
            (0..).zip(amplitudes).map(|(i, a)| a.scaled(harmonic_squared(i))).collect();
        let square = |cosines: &Vec<f64>| {
            let (force, _) = self.force_and_slope(weighted(cosines, amplitudes));
            let rest = (force - frequency_ratio_squared * weighted(cosines, &accelerations)).abs();
            rest * rest
        };
        libm::sqrt(self.cosines.iter().map(square).sum::<f64>() / self.points())
    }

    fn force_and_slope(&self, x: Complex) -> (Complex, Complex) {
        let square = x * x;
        let start = (Complex::default(), Complex::default());
        let (over_x, slope) = self.force.iter().enumerate().rev().fold(start, |(value, slope), (j, term)| {
            (value * square + Complex::from(*term), slope * square + Complex::from(*term * odd(j)))
        });
        (over_x * x, slope)
    }

    fn points(&self) -> f64 {
        count(self.cosines.len())
    }
}

/// n² of the i-th odd harmonic.
pub(super) fn harmonic_squared(i: usize) -> f64 {
    odd(i) * odd(i)
}

/// The highest of the first odd harmonics.
fn highest(harmonics: u32) -> usize {
    2 * harmonics as usize - 1
}

/// The i-th odd number.
fn odd(i: usize) -> f64 {
    count(2 * i + 1)
}

fn weighted(weights: &[f64], values: &[Complex]) -> Complex {
    weights.iter().zip(values).map(|(weight, value)| value.scaled(*weight)).sum()
}
