//! All solutions of the truncated system by continuation: a system of the same shape whose solutions are known is
//! deformed into the one to be solved, and the solutions are followed.
//!
//! In −n²Δ²aₙ + gₙ(a₁, a₃, …) = 0 the projection gₙ of the force is replaced by cₙaₙᵈ with complex cₙ. Those
//! equations say that each aₙ is zero or a (d − 1)-th root, and the amplitude fixes the common factor. For almost all
//! cₙ no two paths meet before the end.
//!
//! Reference: A. J. Sommese and C. W. Wampler, *The Numerical Solution of Systems of Polynomials* (2005), chapters
//! 2 and 7.

use std::f64::consts::TAU;

use super::collocation::{Collocation, harmonic_squared};
use super::newton::{Linearization, newton, refine, target};
use libration_kernels::elementary::count;
use libration_numbers::algebra::Complex;
use libration_numbers::internals::linear::solve_complex;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::{Interrupted, Stage};

/// a₁, a₃, … and Δ².
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Root {
    pub(super) amplitudes: Vec<Complex>,
    pub(super) frequency_ratio_squared: Complex,
}

/// The different solutions found; all if their number is the expected one.
pub(super) fn all_roots(
    equations: &Collocation,
    amplitude: f64,
    expected: usize,
    watch: &Watch<'_>,
) -> Result<Vec<Root>, Interrupted> {
    let mut roots: Vec<Root> = Vec::new();
    watch.begin(Stage::Whole, Some(expected));
    // Another way through the complex plane for each attempt, and smaller steps.
    for attempt in 1..=3 {
        let homotopy = Homotopy::new(equations, amplitude, f64::from(attempt));
        for start in homotopy.starts() {
            watch.reached(roots.len())?;
            let root = homotopy.follow(start);
            roots.extend(root.filter(|root| !roots.iter().any(|other| coincide(root, other))));
        }
        if roots.len() >= expected {
            break;
        }
    }
    Ok(roots)
}

impl Root {
    pub(super) fn from_point(mut point: Vec<Complex>) -> Option<Self> {
        let frequency_ratio_squared = point.pop()?;
        Some(Self { amplitudes: point, frequency_ratio_squared })
    }

    fn distance(&self, other: &Self) -> f64 {
        let amplitudes = self.amplitudes.iter().zip(&other.amplitudes).map(|(a, b)| (*a - *b).abs());
        amplitudes.fold((self.frequency_ratio_squared - other.frequency_ratio_squared).abs(), f64::max)
    }

    fn size(&self) -> f64 {
        self.amplitudes.iter().map(|a| a.abs()).fold(self.frequency_ratio_squared.abs(), f64::max)
    }
}

fn coincide(a: &Root, b: &Root) -> bool {
    // Newton's method leaves some rounding errors.
    a.distance(b) < 1e-9 * a.size()
}

/// (1 − s)·γ·(known equations) + s·(equations to be solved).
struct Homotopy<'a> {
    equations: &'a Collocation,
    amplitude: f64,
    /// cₙ.
    factors: Vec<Complex>,
    /// The sum of the known amplitudes.
    start: Complex,
    gamma: Complex,
    /// The longest Newton step that a prediction may need, relative to the size of the point.
    reach: f64,
}

impl<'a> Homotopy<'a> {
    fn new(equations: &'a Collocation, amplitude: f64, attempt: f64) -> Self {
        // Any directions will do that have nothing to do with one another.
        let direction = |i: f64| Complex::unit(TAU * (0.618_033_988_749_895 * (i + 1.0) * attempt + 0.137));
        // At this size the force is nonlinear, and its known stand-in as large as a linear one.
        let size = f64::max(amplitude, equations.nonlinear_size());
        let scale = (1..equations.degree()).fold(1.0, |power, _| power / size);
        Self {
            equations,
            amplitude,
            factors: (0..equations.harmonics())
                .map(|i| direction(harmonic_squared(i)).scaled(scale))
                .collect(),
            start: direction(0.2).scaled(size),
            gamma: direction(0.5),
            reach: libm::pow(10.0, -1.0 - attempt),
        }
    }

    /// The solutions of the known equations: for every choice of amplitudes that are not zero, and of their roots
    /// of unity up to a common one.
    fn starts(&self) -> Vec<Vec<Complex>> {
        let (k, roots) = (self.factors.len(), self.equations.degree() - 1);
        let mut ratios = vec![vec![]];
        for i in 0..k {
            // aₙ^(d−1) = n²Δ²/cₙ, here with Δ = 1.
            let power = Complex::from(harmonic_squared(i)) / self.factors[i];
            ratios = ratios.iter().flat_map(|begun| extended(begun, power, roots)).collect();
        }
        ratios.iter().filter_map(|ratio| self.start(ratio)).collect()
    }

    /// The amplitudes in these ratios with the given sum, and Δ² for them.
    fn start(&self, ratios: &[Complex]) -> Option<Vec<Complex>> {
        let sum: Complex = ratios.iter().copied().sum();
        let factor = self.start / sum;
        let mut z: Vec<Complex> = ratios.iter().map(|ratio| *ratio * factor).collect();
        z.push(factor.powi(u32::try_from(self.equations.degree() - 1).ok()?));
        z.iter().all(|value| value.is_finite()).then_some(z)
    }

    /// Follows a solution from s = 0 to s = 1; `None` when it is lost.
    fn follow(&self, start: Vec<Complex>) -> Option<Root> {
        /// A path that needs shorter steps goes to infinity or meets another one.
        const SMALLEST_STEP: f64 = 1e-12;
        let (mut s, mut step, mut z) = (0.0, 0.01, start);
        while s < 1.0 {
            let next = f64::min(s + step, 1.0);
            if let Some(arrived) = self.predict(s, next, &z).and_then(|guess| self.correct(next, guess)) {
                (s, z) = (next, arrived);
                step *= 1.6;
            } else {
                step *= 0.4;
            }
            if step < SMALLEST_STEP {
                return None;
            }
        }
        Root::from_point(refine(self.equations, self.amplitude, z)?)
    }

    /// The midpoint rule along the direction in which the solution moves.
    fn predict(&self, s: f64, next: f64, z: &[Complex]) -> Option<Vec<Complex>> {
        let step = next - s;
        let halfway = moved(z, &self.direction(s, z)?, 0.5 * step);
        Some(moved(z, &self.direction(s + 0.5 * step, &halfway)?, step))
    }

    /// Newton's method, which must need only a short first step and then converge fast.
    fn correct(&self, s: f64, guess: Vec<Complex>) -> Option<Vec<Complex>> {
        let (z, first) = newton(&self.linearization(s, &guess), guess)?;
        let (z, second) = newton(&self.linearization(s, &z), z)?;
        (first < self.reach && second < 1e-2 * self.reach).then_some(z)
    }

    /// dz/ds.
    fn direction(&self, s: f64, z: &[Complex]) -> Option<Vec<Complex>> {
        let (start, sought) = (self.start_system(z), target(self.equations, self.amplitude, z));
        let change = start.values.iter().zip(&sought.values).map(|(a, b)| self.gamma * *a - *b);
        solve_complex(&self.mixed(s, &start, &sought).derivatives, &change.collect::<Vec<_>>())
    }

    fn linearization(&self, s: f64, z: &[Complex]) -> Linearization {
        self.mixed(s, &self.start_system(z), &target(self.equations, self.amplitude, z))
    }

    fn mixed(&self, s: f64, start: &Linearization, sought: &Linearization) -> Linearization {
        let weight = self.gamma.scaled(1.0 - s);
        let mix = |a: &[Complex], b: &[Complex]| -> Vec<Complex> {
            a.iter().zip(b).map(|(a, b)| weight * *a + b.scaled(s)).collect()
        };
        let rows = start.derivatives.iter().zip(&sought.derivatives).map(|(a, b)| mix(a, b));
        Linearization { values: mix(&start.values, &sought.values), derivatives: rows.collect() }
    }

    /// −n²Δ²aₙ + cₙaₙᵈ, and the difference of Σ aₙ from its value at the start.
    fn start_system(&self, z: &[Complex]) -> Linearization {
        let k = self.factors.len();
        let degree = u32::try_from(self.equations.degree()).unwrap_or(u32::MAX);
        let mut derivatives = vec![vec![Complex::default(); k + 1]; k + 1];
        let mut values = Vec::with_capacity(k + 1);
        for i in 0..k {
            let (square, power) = (harmonic_squared(i), self.factors[i] * z[i].powi(degree - 1));
            values.push(power * z[i] - (z[k] * z[i]).scaled(square));
            derivatives[i][i] = power.scaled(f64::from(degree)) - z[k].scaled(square);
            derivatives[i][k] = -z[i].scaled(square);
            derivatives[k][i] = Complex::from(1.0);
        }
        values.push(z[..k].iter().copied().sum::<Complex>() - self.start);
        Linearization { values, derivatives }
    }
}

fn moved(z: &[Complex], direction: &[Complex], step: f64) -> Vec<Complex> {
    z.iter().zip(direction).map(|(a, b)| *a + b.scaled(step)).collect()
}

/// A list of ratios with one more: zero, or each root of `power`; of the first that is not zero one root is enough.
fn extended(begun: &[Complex], power: Complex, roots: usize) -> Vec<Vec<Complex>> {
    let first = begun.iter().all(|ratio| ratio.abs() == 0.0);
    let exponent = 1.0 / count(roots);
    let phase = libm::atan2(power.im, power.re) * exponent;
    let root = |j| Complex::unit(phase + TAU * count(j) * exponent).scaled(libm::pow(power.abs(), exponent));
    let choices = (0..if first { 1 } else { roots }).map(root);
    std::iter::once(Complex::default()).chain(choices).map(|next| [begun, &[next]].concat()).collect()
}
