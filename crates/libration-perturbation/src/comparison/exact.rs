//! Values of periodic motions, computed without series.

use super::SeriesQuantity;
use super::enclosed::other_equilibrium;
use crate::perturbation::{Expansion, is_pendulum};
use libration_kernels::elementary::count;
use libration_motion::oscillator::{Kind, Oscillator};
use libration_motion::{
    internals::orbit::ReleasePlace,
    orbit::{Orbit, OrbitError},
};
use libration_numbers::algebra::Rational;
use libration_numbers::expression::Expression;
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;
use libration_numbers::quantity::{Angle, Displacement};
use libration_pendulum::pendulum::{Amplitude, Pendulum};
use std::f64::consts::TAU;

/// A value found without the series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExactValue {
    /// The value.
    pub value: f64,
    /// Bound on the error of the value.
    pub uncertainty: f64,
    /// Method of computation.
    pub method: Method,
    /// Another equilibrium that the motion encloses, if there is one: the motion is then not of the family of series about
    /// the equilibrium.
    pub encloses: Option<f64>,
}

/// The method by which an exact value is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Elliptic integrals and theta functions.
    Elliptic,
    /// The equation of motion, integrated by its Taylor series.
    Integration,
}

/// The reason why there is no exact value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ExactValueError {
    /// A displacement that cannot be.
    #[error("the amplitude is {0:?}: give a finite number above zero")]
    Amplitude(f64),
    /// A release on the separatrix.
    #[error(
        "the period is infinite: a motion released at the displacement {0:?} is on the separatrix: it approaches an unstable equilibrium for ever, or stays at it"
    )]
    Infinite(f64),
    /// A release beyond the equilibrium's own well.
    #[error(
        "at the displacement {0:?} from the equilibrium the force does not point back: give a smaller amplitude"
    )]
    NotRestoring(f64),
    /// A motion that does not return.
    #[error(
        "a release at the displacement {0:?} from the equilibrium does not come to rest on the other side and return: give a smaller amplitude"
    )]
    NoReturn(f64),
    /// A strength of no excitation.
    #[error("the strength of the excitation is {0:?}: give a finite number other than zero")]
    Strength(f64),
    /// A motion that cannot be followed.
    #[error(transparent)]
    Orbit(#[from] OrbitError),
}

/// Error bound of a closed form in units in the last place: for the period ratio, which is promised to 0.56, with the rounding of the reference,
/// and for harmonics.
const ULP_OF_PERIOD: f64 = 2.0;
const ULP_OF_HARMONICS: f64 = 18.0;
/// Size of harmonics below which the error no longer falls.
const SMALL_HARMONIC: f64 = 1e-12;
/// Roundings of Ω0, of the ratio and of its inverse.
const ROUNDINGS: f64 = 4.0 * f64::EPSILON;

/// The pendulum's value at an amplitude.
pub(super) fn of_pendulum(
    quantity: SeriesQuantity,
    displacement: &Displacement,
) -> Result<ExactValue, ExactValueError> {
    let radians = displacement.to_f64();
    let angle =
        displacement.to_angle().filter(|_| radians > 0.0).ok_or(ExactValueError::Amplitude(radians))?;
    let amplitude = Amplitude::new(angle).map_err(|_| match (angle.turns(), angle.complement() == 0.0) {
        (0, true) => ExactValueError::Infinite(radians),
        _ => ExactValueError::NotRestoring(radians),
    })?;
    let ratio = amplitude.period_ratio();
    let (value, uncertainty) = match quantity {
        SeriesQuantity::Period => (ratio, ULP_OF_PERIOD * f64::EPSILON * ratio),
        SeriesQuantity::Frequency => (1.0 / ratio, ULP_OF_PERIOD * f64::EPSILON / ratio),
        SeriesQuantity::Cosine(k) => {
            let value = pendulum_harmonic(angle, k);
            (value, ULP_OF_HARMONICS * f64::EPSILON * value.abs().max(SMALL_HARMONIC))
        }
    };
    Ok(ExactValue { value, uncertainty, method: Method::Elliptic, encloses: None })
}

/// aₖ of the pendulum.
fn pendulum_harmonic(angle: Angle, k: usize) -> f64 {
    let pendulum = Pendulum::from_angular_frequency(1.0).ok();
    let motion = pendulum.and_then(|pendulum| pendulum.released_from(angle).ok());
    let harmonics = motion.map(|motion| motion.harmonics(f64::MIN_POSITIVE, k / 2 + 1));
    harmonics.map_or(f64::NAN, |series| {
        series.terms.iter().find(|term| term.n == k).map_or(0.0, |term| term.angle)
    })
}

/// A periodic motion that is known without the series, for several of its quantities.
#[derive(Clone, Debug)]
pub struct ExactMotion {
    method: Known,
    small_period: f64,
    unit: f64,
}

#[derive(Clone, Debug)]
enum Known {
    Pendulum(Displacement),
    Orbit(OrbitMotion),
}

impl ExactMotion {
    /// The motion of an oscillator at an amplitude, or at a strength of self-excitation, in the units of its expansion.
    ///
    /// # Errors
    /// There is no such motion, it is not found, or its period is infinite.
    /// [`OrbitError::Interrupted`] if the call is cancelled.
    pub fn new(
        oscillator: &Oscillator,
        expansion: &Expansion,
        amplitude: &Displacement,
        progress: &dyn Progress,
    ) -> Result<Self, ExactValueError> {
        let unit = libm::sqrt(expansion.unit_squared.to_f64());
        let near = expansion.x_max.first().map_or(0.0, Rational::to_f64) * unit;
        let method = match is_pendulum(oscillator) {
            true => Known::Pendulum(amplitude.clone()),
            false => Known::Orbit(OrbitMotion::by_kind(oscillator, amplitude, near, &Watch::new(progress))?),
        };
        Ok(Self { method, small_period: TAU / libm::sqrt(oscillator.omega0_squared().to_f64()), unit })
    }

    /// One of its quantities. Harmonics of limit cycles are in the expansion's units.
    ///
    /// # Accuracy
    /// As [`ExactValue::uncertainty`] says.
    ///
    /// # Errors
    /// A pendulum that is not released below its top.
    pub fn value(&self, quantity: SeriesQuantity) -> Result<ExactValue, ExactValueError> {
        match &self.method {
            Known::Pendulum(amplitude) => of_pendulum(quantity, amplitude),
            Known::Orbit(orbit) => Ok(orbit.value(quantity, self.small_period, self.unit)),
        }
    }
}

/// A motion about the equilibrium, or a limit cycle.
#[derive(Clone, Debug)]
pub(super) struct OrbitMotion {
    orbit: Orbit,
    equilibrium: f64,
    encloses: Option<f64>,
    /// `true` if harmonics are sines of a phase that begins at the equilibrium.
    is_mirrored: bool,
}

/// The motion that is released from rest at a displacement.
pub(super) fn released(
    oscillator: &Oscillator,
    displacement: &Displacement,
    watch: &Watch<'_>,
) -> Result<OrbitMotion, ExactValueError> {
    let amplitude = displacement.to_f64();
    if !(amplitude > 0.0 && amplitude.is_finite()) {
        return Err(ExactValueError::Amplitude(amplitude));
    }
    let release = ReleasePlace::new(oscillator.equilibrium().digits(), displacement.clone());
    let orbit =
        Orbit::released_from(oscillator.equation(), &release, 0.0, watch).map_err(|error| match error {
            OrbitError::Separatrix(_) | OrbitError::AtRest(_) => ExactValueError::Infinite(amplitude),
            OrbitError::NoReturn { .. } => ExactValueError::NoReturn(amplitude),
            other => other.into(),
        })?;
    let equilibrium = oscillator.equilibrium().to_f64();
    let other_side = orbit.state_at(0.5 * orbit.period())[0];
    if other_side >= equilibrium {
        return Err(ExactValueError::NotRestoring(amplitude));
    }
    let encloses = other_equilibrium(oscillator.equation(), equilibrium, [other_side, orbit.start()[0]]);
    let is_mirrored = *oscillator.kind() == Kind::Mirrored;
    Ok(OrbitMotion { orbit, equilibrium, encloses, is_mirrored })
}

/// The limit cycle at a strength of the excitation, looked for from an amplitude.
pub(super) fn limit_cycle(
    oscillator: &Oscillator,
    parameter: &str,
    strength: &Displacement,
    near: f64,
    watch: &Watch<'_>,
) -> Result<OrbitMotion, ExactValueError> {
    let value = strength.to_f64();
    let refusal = ExactValueError::Strength(value);
    let fraction = strength.fraction().map(|(n, d)| Rational::from_parts(n, d).magnitude());
    let Some(fraction) = fraction.filter(|fraction| !fraction.is_zero()) else { return Err(refusal) };
    // Backwards in time the strength has the other sign, and the cycle attracts.
    let equation = oscillator.equation().with(&[(parameter, Expression::Number(fraction))]);
    let equilibrium = oscillator.equilibrium().to_f64();
    let start = [equilibrium + near, 0.0];
    let orbit = Orbit::limit_cycle(&equation.map_err(|_| refusal)?, &start, watch)?;
    Ok(OrbitMotion { orbit, equilibrium, encloses: None, is_mirrored: false })
}

impl OrbitMotion {
    /// Creates the motion of an oscillator or a limit cycle of this kind.
    pub(super) fn by_kind(
        oscillator: &Oscillator,
        amplitude: &Displacement,
        near: f64,
        watch: &Watch<'_>,
    ) -> Result<Self, ExactValueError> {
        match oscillator.kind() {
            Kind::LimitCycle { parameter } => limit_cycle(oscillator, parameter, amplitude, near, watch),
            _ => released(oscillator, amplitude, watch),
        }
    }

    /// A quantity, given the period of small oscillations and the unit of length.
    pub(super) fn value(&self, quantity: SeriesQuantity, small_period: f64, unit: f64) -> ExactValue {
        let relative = self.orbit.period_uncertainty() / self.orbit.period() + ROUNDINGS;
        let ratio = self.orbit.period() / small_period;
        let (value, uncertainty) = match quantity {
            SeriesQuantity::Period => (ratio, ratio * relative),
            SeriesQuantity::Frequency => (1.0 / ratio, relative / ratio),
            SeriesQuantity::Cosine(k) => self.cosine(k, unit),
        };
        ExactValue { value, uncertainty, method: Method::Integration, encloses: self.encloses }
    }

    /// The amplitude of the harmonic k, with its sign as the coefficient of cos kΩt; of a limit cycle with the time measured so
    /// that there is no sin Ωt, of a mirrored motion as the coefficient of sin kΩt without cos Ωt.
    fn cosine(&self, k: usize, unit: f64) -> (f64, f64) {
        let harmonics = self.orbit.harmonics(0);
        let term = |n: usize| harmonics.terms.get(n).copied().unwrap_or_default();
        let turned = match self.is_mirrored {
            false => {
                let turn = count(k) * libm::atan2(term(1).sine, term(1).cosine);
                term(k).cosine * libm::cos(turn) + term(k).sine * libm::sin(turn)
            }
            true => {
                let turn = count(k) * libm::atan2(term(1).cosine, term(1).sine);
                term(k).cosine * libm::sin(turn) + term(k).sine * libm::cos(turn)
            }
        };
        let mean = if k == 0 { self.equilibrium } else { 0.0 };
        (
            (turned - mean) / unit,
            (self.uncertainty_of_places() * (1.0 + count(k)) + harmonics.remainder) / unit,
        )
    }

    /// Error bound of the position at any time: the velocity times the uncertainty of the period on both sides, the same relative change of
    /// the amplitude, and roundings.
    fn uncertainty_of_places(&self) -> f64 {
        let (low, high) = self.orbit.range(0);
        let (least, greatest) = self.orbit.range(1);
        let late = self.orbit.period_uncertainty() * least.abs().max(greatest.abs());
        let moved = 16.0 * self.orbit.period_uncertainty() / self.orbit.period() * (high - low);
        4.0 * late + moved + 16.0 * f64::EPSILON * low.abs().max(high.abs())
    }
}
