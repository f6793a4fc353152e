//! The Melnikov function: the distance by which a perturbation separates the manifolds of the upright position.

use super::MelnikovError;
use super::perturbation::PerturbedPendulum;
use super::separatrix::integrals;
use libration_kernels::elementary::count;
use libration_numbers::algebra::Complex;
use libration_numbers::expression::Equation;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::{Interrupted, Progress, Stage};
use libration_numbers::roots::{Tolerance, zero_between};
use std::f64::consts::TAU;

/// M(t0) = ∫ θ′(t)·g(θ(t), θ′(t), t + t0) dt over the separatrix of the pendulum: to first order of the
/// perturbation, the energy per m·l² that separates the stable and the unstable manifold of the upright
/// position. At simple zeros of M the manifolds cross, and there are chaotic motions between them.
///
/// # Accuracy
/// By residues, with all digits, if the perturbation is a polynomial in θ′, sin θ, cos θ and waves. Otherwise by quadrature, with the same
/// absolute accuracy and a lower relative accuracy if fast drives make M exponentially small.
///
/// # Examples
/// ```
/// # extern crate libration_branches as libration;
/// use libration::melnikov::{Melnikov, PerturbedPendulum};
/// use libration::progress::Quiet;
/// use std::f64::consts::{PI, FRAC_PI_2};
/// let driven = PerturbedPendulum::new(&"x'' + 0.1 x' + sin(x) = 0.3 cos(t)".parse()?)?;
/// let [upper, _] = Melnikov::both(&driven, &Quiet)?;
/// // Damping removes 8c; a drive of (4c/π) cosh(πΩ/2) compensates it.
/// assert!((upper.mean + 0.8).abs() < 1e-15);
/// let threshold = 0.4 / PI * FRAC_PI_2.cosh();
/// assert!((upper.threshold_factor() * 0.3 / threshold - 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # References
/// V. K. Melnikov, Trans. Moscow Math. Soc. 12 (1963) 1; J. Guckenheimer, P. Holmes, *Nonlinear Oscillations, Dynamical Systems, and
/// Bifurcations of Vector Fields*, Springer 1983, section 4.5.
#[derive(Clone, Debug, PartialEq)]
pub struct Melnikov {
    /// 1 on the separatrix with growing angle, −1 on the other.
    pub direction: f64,
    /// Ω in rad/s, zero without a drive.
    pub frequency: f64,
    /// Part of M that does not depend on t0.
    pub mean: f64,
    /// Bound on the error of the mean.
    pub mean_error: f64,
    /// c₁, c₂, … in M(t0) = mean + Σ Re(cₖ·e^{ikΩt0}).
    pub harmonics: Vec<Complex>,
    /// Bound on the error of each harmonic.
    pub harmonic_errors: Vec<f64>,
}

/// Number of phases, per period of the fastest harmonic, at which extremes and zeros are searched.
const PLACES: usize = 16;

impl Melnikov {
    /// Returns the functions of the separatrix with growing angle and of the other one.
    ///
    /// # Errors
    /// The call is cancelled.
    pub fn both(pendulum: &PerturbedPendulum, progress: &dyn Progress) -> Result<[Self; 2], Interrupted> {
        let watch = &Watch::new(progress);
        let on = |direction: f64| {
            Ok::<_, Interrupted>(Self::new(pendulum, direction, integrals(pendulum, direction, watch)?))
        };
        Ok([on(1.0)?, on(-1.0)?])
    }

    fn new(pendulum: &PerturbedPendulum, direction: f64, mean_and_harmonics: Vec<(Complex, f64)>) -> Self {
        let mut coefficients = mean_and_harmonics.into_iter();
        let (mean, mean_error) = coefficients.next().unwrap_or_default();
        // e^{−ikΩt} has the conjugate coefficient.
        let mut harmonics: Vec<(Complex, f64)> =
            coefficients.map(|(value, error)| (value.scaled(2.0), 2.0 * error)).collect();
        while harmonics.last().is_some_and(|(value, error)| value.abs() <= *error) {
            harmonics.pop();
        }
        let (harmonics, harmonic_errors) = harmonics.into_iter().unzip();
        let frequency = pendulum.frequency().unwrap_or(0.0);
        Self { direction, frequency, mean: mean.re, mean_error, harmonics, harmonic_errors }
    }

    /// M at the phase Ωt0 of the drive.
    #[must_use]
    pub fn at_phase(&self, phase: f64) -> f64 {
        self.mean + self.wave(phase, 0)
    }

    /// The part that depends on the phase, or a derivative of it with respect to the phase.
    fn wave(&self, phase: f64, derivatives: u32) -> f64 {
        let term = |(k, value): (u32, &Complex)| {
            let number = f64::from(k);
            let turned = (0..derivatives).fold(*value, |c, _| c * Complex::new(0.0, number));
            (turned * Complex::unit(number * phase)).re
        };
        (1..).zip(&self.harmonics).map(term).sum()
    }

    /// The least and the greatest value of M(t0) − mean.
    #[must_use]
    pub fn extremes(&self) -> [f64; 2] {
        if let [only] = &self.harmonics[..] {
            return [-only.abs(), only.abs()];
        }
        let phases = self.zeros_of(&|phase| self.wave(phase, 1));
        let values = phases.into_iter().map(|phase| self.wave(phase, 0));
        values.fold([0.0, 0.0], |[least, most], value| [least.min(value), most.max(value)])
    }

    /// Factor by which the part that depends on the phase must be multiplied for simple zeros to appear:
    /// below 1 they exist already, 0 if the mean is zero, infinite if nothing depends on the phase.
    #[must_use]
    pub fn threshold_factor(&self) -> f64 {
        let [least, most] = self.extremes();
        let reach = if self.mean < 0.0 { most } else { -least };
        if reach == 0.0 { f64::INFINITY } else { self.mean.abs() / reach }
    }

    /// Returns `true` if M has simple zeros, so that the manifolds cross; `None` if the errors leave it undecided.
    #[must_use]
    pub fn has_simple_zeros(&self) -> Option<bool> {
        let margin = self.margin();
        (margin.abs() > self.error()).then_some(margin > 0.0)
    }

    /// The smaller of the maxima of M and −M over the phase: positive if M changes its sign.
    pub(super) fn margin(&self) -> f64 {
        let [least, most] = self.extremes();
        (most + self.mean).min(-(least + self.mean))
    }

    /// Bound on the error of M at any phase.
    #[must_use]
    pub fn error(&self) -> f64 {
        self.mean_error + self.harmonic_errors.iter().sum::<f64>()
    }

    /// The phases Ωt0 within 0 … 2π at which M vanishes, each with the derivative of M with respect to the phase.
    #[must_use]
    pub fn zeros(&self) -> Vec<(f64, f64)> {
        let phases = self.zeros_of(&|phase| self.at_phase(phase));
        phases.into_iter().map(|phase| (phase, self.wave(phase, 1))).collect()
    }

    fn zeros_of(&self, f: &dyn Fn(f64) -> f64) -> Vec<f64> {
        let intervals = PLACES * self.harmonics.len();
        let time = |j: usize| TAU * count(j) / count(intervals);
        // The last end is the first one, with its value: rounding must not hide a zero between the two.
        let value = |j: usize| f(if j < intervals { time(j) } else { 0.0 });
        let ends: Vec<(f64, f64)> = (0..=intervals).map(|j| (time(j), value(j))).collect();
        // A zero at an end belongs to the interval that begins there.
        let zero = |pair: &[(f64, f64)]| {
            let zero = (pair[1].1 != 0.0).then(|| zero_between([pair[0], pair[1]], Tolerance::LAST_BIT, f));
            zero.flatten().map(|phase| phase.rem_euclid(TAU))
        };
        ends.windows(2).filter_map(zero).collect()
    }
}

/// Number of values at which a parameter range is sampled.
const LOOKS: u32 = 128;

/// A value of a parameter at which simple zeros appear or disappear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threshold {
    /// 1 on the separatrix with growing angle, −1 on the other.
    pub direction: f64,
    /// The value of the parameter.
    pub value: f64,
    /// Bound on the error of the value as a zero of the Melnikov function; the error of the first-order theory is not included.
    pub error: f64,
    /// `true` if there are simple zeros above the value.
    pub above: bool,
}

/// Values in a parameter range at which the manifolds begin or cease to cross, to first order of the perturbation, on either separatrix.
///
/// # Errors
/// As for [`PerturbedPendulum::new`], an empty range, or a value at which the
/// equation has no value. [`MelnikovError::Interrupted`] if the call is cancelled.
///
/// # Examples
/// ```
/// # extern crate libration_branches as libration;
/// use libration::melnikov::thresholds;
/// use libration::progress::Quiet;
/// let values = thresholds(&"x'' + 0.1 x' + sin(x) = A cos(t)".parse()?, "A", [0.0, 1.0], &Quiet)?;
/// assert!((values[0].value - 0.319_478_526_382_585_2).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn thresholds(
    equation: &Equation,
    parameter: &str,
    range: [f64; 2],
    progress: &dyn Progress,
) -> Result<Vec<Threshold>, MelnikovError> {
    let watch = &Watch::new(progress);
    let [from, to] = range;
    let width = (to - from).abs();
    if !(width > 0.0 && width.is_finite()) {
        return Err(MelnikovError::Range { from, to });
    }
    let at = |value: f64| at_value(equation, parameter, value, watch);
    let value_at =
        |j: u32| if j == LOOKS { to } else { from + (to - from) * f64::from(j) / f64::from(LOOKS) };
    watch.begin(Stage::Whole, Some(LOOKS as usize + 1));
    let look = |(done, j): (usize, u32)| {
        watch.reached(done)?;
        Ok((value_at(j), at(value_at(j))?))
    };
    let looks = (0..).zip(0..=LOOKS).map(look);
    let looks = looks.collect::<Result<Vec<_>, MelnikovError>>()?;
    let mut thresholds = vec![];
    for side in [0, 1] {
        let margin = |value: f64| at(value).map_or(f64::NAN, |both| both[side].margin());
        for pair in looks.windows(2) {
            let ends = [0, 1].map(|end| (pair[end].0, pair[end].1[side].margin()));
            let zero = zero_between(ends, Tolerance::LAST_BIT, margin);
            watch.go_on()?;
            let Some(value) = zero else { continue };
            let width = ends[1].0 - ends[0].0;
            // Next to its zero the margin exceeds its rounding, be it linear or, where it only touches zero, quadratic.
            let [before, after] = [-1e-4, 1e-4].map(|part| margin(value + part * width));
            if before * after > 0.0 {
                // The manifolds cross on both sides, as those of a pendulum without damping with drives of either sign.
                continue;
            }
            let slope = (after - before) / (2e-4 * width);
            let function = &at(value)?[side];
            let error = function.error() / slope.abs() + f64::EPSILON * value.abs();
            thresholds.push(Threshold { direction: function.direction, value, error, above: slope > 0.0 });
        }
    }
    Ok(thresholds)
}

fn at_value(
    equation: &Equation,
    parameter: &str,
    value: f64,
    watch: &Watch<'_>,
) -> Result<[Melnikov; 2], MelnikovError> {
    let pendulum = PerturbedPendulum::new(&with_value(equation, parameter, value)?)?;
    Ok(Melnikov::both(&pendulum, watch)?)
}

/// The equation with this value of the parameter.
pub(super) fn with_value(
    equation: &Equation,
    parameter: &str,
    value: f64,
) -> Result<Equation, MelnikovError> {
    let failed = |reason: String| MelnikovError::At { parameter: parameter.to_owned(), value, reason };
    let number = format!("{value:?}").parse().map_err(|_| failed("not a finite number".to_owned()))?;
    equation.with(&[(parameter, number)]).map_err(|error| failed(error.to_string()))
}
