//! The distance of a limit cycle of a series from the orbit found by Newton's method from it.

use super::exact::ExactValueError;
use super::{SeriesComparison, SeriesQuantity};
use libration_kernels::elementary::count;
use libration_motion::orbit::{Orbit, OrbitGuess};
use libration_numbers::algebra::Rational;
use libration_numbers::expression::Expression;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;
use libration_numbers::quantity::Displacement;
use std::f64::consts::TAU;

/// The distance of a limit cycle from the orbit of the equation next to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CycleDistance {
    /// The largest difference of the displacements at the same phase, which is zero where the fundamental has no sine.
    pub distance: f64,
    /// The error of the orbit's displacement.
    pub uncertainty: f64,
    /// Half of the orbit's swing.
    pub half_swing: f64,
}

impl CycleDistance {
    /// `true` if the series and the orbit are the same cycle, at most a quarter of its half swing apart.
    #[must_use]
    pub fn is_near(&self) -> bool {
        /// Largest distance relative to half the swing: on a circle about the equilibrium, the error of the phase is then a quarter of a
        /// radian.
        const NEAR: f64 = 0.25;
        self.distance <= NEAR * self.half_swing
    }
}

impl SeriesComparison<'_> {
    /// The distance of the limit cycle at a strength of its excitation from the orbit found by Newton's method from the series, to the order of the
    /// expansion; `None` for series in an amplitude.
    ///
    /// # Errors
    /// A strength of zero, and no orbit to which Newton's method comes.
    pub fn cycle_distance(
        &self,
        strength: &Displacement,
        progress: &dyn Progress,
    ) -> Option<Result<CycleDistance, ExactValueError>> {
        self.expansion()
            .variable
            .is_strength()
            .then(|| self.distance_from_orbit(strength, &Watch::new(progress)))
    }

    fn distance_from_orbit(
        &self,
        strength: &Displacement,
        watch: &Watch<'_>,
    ) -> Result<CycleDistance, ExactValueError> {
        let refusal = || ExactValueError::Strength(strength.to_f64());
        let fraction = strength.fraction().map(|(n, d)| Rational::from_parts(n, d));
        let value = fraction.filter(|value| !value.is_zero()).ok_or_else(refusal)?;
        let parameter = self.expansion().variable.name();
        let equation = self.oscillator().equation().with(&[(parameter, Expression::Number(value))]);
        let equation = equation.map_err(|_| refusal())?;
        let small_period = TAU / libm::sqrt(self.oscillator().omega0_squared().to_f64());
        let of_period = Self::new(self.oscillator(), self.expansion(), SeriesQuantity::Period);
        let period = small_period * of_period.evaluation_at(strength.to_f64()).value();
        let waves = self.waves(strength.to_f64());
        let [x, slope] = displacement(&waves, 0.0);
        let equilibrium = self.oscillator().equilibrium().to_f64();
        let guess = OrbitGuess { state: vec![equilibrium + x, slope * TAU / period], period };
        let orbit = Orbit::near(&equation, &guess, &[1], watch)?;
        let (low, high) = orbit.range(0);
        let uncertainty = orbit.state_errors().first().copied().unwrap_or(f64::NAN);
        Ok(CycleDistance {
            distance: largest_difference(&orbit, &waves, equilibrium),
            uncertainty,
            half_swing: 0.5 * (high - low),
        })
    }

    /// The coefficients of cos kτ and sin kτ by k at a strength.
    fn waves(&self, strength: f64) -> Vec<(usize, [f64; 2])> {
        let unit = libm::sqrt(self.expansion().unit_squared.to_f64());
        let value = |series: &[Rational]| {
            unit * series.iter().rev().fold(0.0, |sum, coefficient| sum * strength + coefficient.to_f64())
        };
        let harmonics = self.expansion().harmonics.iter();
        harmonics.map(|harmonic| (harmonic.k, [value(&harmonic.cos), value(&harmonic.sin)])).collect()
    }
}

/// The sum of harmonics at a phase, and its derivative by the phase.
fn displacement(waves: &[(usize, [f64; 2])], phase: f64) -> [f64; 2] {
    waves.iter().fold([0.0; 2], |[x, slope], (k, [cosine, sine])| {
        let (c, s) = (libm::cos(count(*k) * phase), libm::sin(count(*k) * phase));
        [x + cosine * c + sine * s, slope + count(*k) * (sine * c - cosine * s)]
    })
}

/// The largest difference in a period, with the time measured so that the fundamental of the orbit has no sine either.
fn largest_difference(orbit: &Orbit, waves: &[(usize, [f64; 2])], equilibrium: f64) -> f64 {
    /// The number of phases in a period: between two of them a difference with harmonics up to 32 falls by 2 % at most from its maximum.
    const PHASES: u32 = 512;
    let fundamental = orbit.harmonics(0).terms.get(1).copied().unwrap_or_default();
    let turn = libm::atan2(fundamental.sine, fundamental.cosine);
    let differences = (0..PHASES).map(|number| {
        let phase = TAU * f64::from(number) / f64::from(PHASES);
        let [x, _] = displacement(waves, phase);
        let time = (phase + turn) / TAU * orbit.period();
        (orbit.state_at(time)[0] - equilibrium - x).abs()
    });
    differences.fold(0.0, f64::max)
}
