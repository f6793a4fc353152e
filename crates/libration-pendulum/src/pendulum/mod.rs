//! The pendulum: period, motion in every regime, energy, action, harmonics.
//!
//! ```
//! # extern crate libration_pendulum as libration;
//! use libration::pendulum::Pendulum;
//! use libration::quantity::Angle;
//! let pendulum = Pendulum::new(1.0, 9.80665)?;
//! let motion = pendulum.released_from("60deg".parse::<Angle>()?)?;
//! assert!((motion.period() - 2.1532423518).abs() < 1e-10);
//! let state = motion.state_at(motion.period() / 2.0);
//! assert!((state.angle + std::f64::consts::FRAC_PI_3).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Angles are in radians from the downward vertical, times in seconds, lengths in metres, velocities in rad/s. A batch equals its scalar
//! function bit for bit.

pub(crate) mod period;
mod period_stages;
mod periods;
mod amplitude;
mod initial;
mod inverse;
mod action_angle;
mod motion;
mod start;
mod state;
mod orbit;
mod libration;
mod rotation;
mod separatrix;
mod prepared;
#[doc(hidden)]
pub(crate) mod table;
mod swing_period;
mod swing_period_stages;
mod varying;
mod varying_stages;
pub(crate) mod approximate_motion;
mod display;
mod fourier;

pub use amplitude::Amplitude;
pub use approximate_motion::{ApproximateMotion, ApproximateMotionError};
pub use fourier::{FourierSeries, FourierTerm};
pub use inverse::InferredAmplitude;
pub use libration::Libration;
pub use motion::{Motion, Regime, Rest};
pub use period::{period_excess, period_ratio, period_ratio_near_top};
pub use period_stages::{period_excesses, period_ratios, period_ratios_near_top};
pub use periods::{period, periods};
pub use prepared::PreparedMotion;
pub use rotation::Rotation;
pub use separatrix::Separatrix;
pub use state::State;
pub use swing_period::SwingPeriod;
pub use varying::state;
pub use varying_stages::states;

use libration_kernels::double_double::DoubleDouble;
pub use libration_kernels::elliptic::LengthMismatch;

/// A simple pendulum: a point mass on a massless rod.
///
/// A physical pendulum of moment of inertia I, mass m and distance d from pivot to centre of mass is the
/// simple pendulum of length I/(m·d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pendulum {
    size: Size,
}

/// The quantities by which the pendulum was given.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Size {
    LengthAndGravity { length: f64, gravity: f64 },
    AngularFrequency(f64),
}

/// Angular frequencies whose periods and velocities stay within the range of `f64`, second words included.
const USABLE: std::ops::RangeInclusive<f64> = 1e-290..=1e290;

/// The reason why a pendulum or a motion does not exist.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PendulumError {
    /// A length, gravity, frequency or period that is not a positive finite number.
    #[error("the {name} is {value:?}: give a positive, finite number")]
    NotPositive {
        /// Name of the quantity.
        name: &'static str,
        /// The value of the quantity.
        value: f64,
    },
    /// An angular frequency whose period or velocities would leave the range of `f64`.
    #[error("an angular frequency of {0:?} rad/s is out of range: give 1e-290 to 1e290")]
    FrequencyOutOfRange(f64),
    /// An angular frequency outside 1e-290 … 1e290 rad/s, or a length or gravity that is subnormal and thus has fewer digits.
    #[error(
        "length {length:?} m and gravity {gravity:?} m/s^2 are out of range: give both above 2.3e-308, with an angular frequency of 1e-290 to 1e290 rad/s"
    )]
    OutOfRange {
        /// The length.
        length: f64,
        /// The gravity.
        gravity: f64,
    },
    /// A velocity or an energy that is not finite.
    #[error("the {name} is {value:?}: give a finite number")]
    NotFinite {
        /// Name of the quantity.
        name: &'static str,
        /// The value of the quantity.
        value: f64,
    },
    /// An amplitude at or beyond the upright position.
    #[error(
        "an amplitude of {0:?} rad, {degrees}°, is not below pi: a pendulum released there does not swing; give a smaller angle",
        degrees = (.0.to_degrees() * 1e6).round() / 1e6
    )]
    AmplitudeBeyondTop(f64),
    /// An energy below that of the pendulum at rest.
    #[error("the energy ratio is {0:?}: the least energy, at rest at the bottom, is 0")]
    NegativeEnergy(f64),
    /// A velocity for which the motion leaves the range of `f64`.
    #[error(
        "a velocity of {0:?} rad/s is too fast: its energy is beyond the range of numbers; give at most 2e150 times the angular frequency, and at most 1e307 rad/s"
    )]
    TooFast(f64),
    /// An energy ratio for which the motion leaves the range of `f64`.
    #[error(
        "an energy ratio of {0:?} is too large: its motion is beyond the range of numbers; give at most 1e300, and no velocity above 1e307 rad/s"
    )]
    TooMuchEnergy(f64),
    /// A start so close to the upright position that half its complement is subnormal.
    #[error(
        "a start {0:?} rad from the upright position is closer to it than floating-point numbers resolve: give at least 4.5e-308 rad, or exactly the upright position"
    )]
    TooCloseToTop(f64),
    /// An energy whose difference from that of the separatrix is below the range of `f64`.
    #[error(
        "the motion is closer to the separatrix than floating-point numbers resolve: give another velocity"
    )]
    TooCloseToSeparatrix,
    /// A period ratio that no amplitude has.
    #[error(
        "no amplitude has the period ratio T/T0 = {0:?}: it is 1 for the smallest swings and grows without bound towards the top"
    )]
    NoSuchPeriod(f64),
    /// A period shorter than that of small swings.
    #[error(
        "no amplitude has a period of {period:?} s: small swings of this pendulum take {small:?} s, and larger ones longer; give a longer period, a shorter length or a larger gravity"
    )]
    ShorterThanSmallSwings {
        /// The period, in seconds.
        period: f64,
        /// The period of small swings, in seconds.
        small: f64,
    },
    /// A period ratio whose amplitude is closer to the top than the smallest complement.
    #[error(
        "the amplitude of the period ratio T/T0 = {0:?} is less than 1e-300 rad below the upright position: give at most 441.08, which is an excess of 440.08"
    )]
    PeriodTooLong(f64),
    /// A period whose angular frequency leaves the range of `f64`.
    #[error("a period of {0:?} s gives an angular frequency out of range: it must be 1e-290 to 1e290 rad/s")]
    PeriodOutOfRange(f64),
    /// A period that no length or gravity within the range of `f64` gives.
    #[error(
        "the {name} for a period of {period:?} s is beyond the range of numbers: give a period closer to one second"
    )]
    Unattainable {
        /// Name of the quantity requested.
        name: &'static str,
        /// The period.
        period: f64,
    },
}

impl Pendulum {
    /// A pendulum of this length in metres under this gravity in m/s².
    ///
    /// # Errors
    /// A length or gravity that is not positive and finite or is below 2.3e-308, or whose √(g/l) is outside
    /// 1e-290 … 1e290.
    pub fn new(length: f64, gravity: f64) -> Result<Self, PendulumError> {
        positive("length", length)?;
        positive("gravity", gravity)?;
        let pendulum = Self { size: Size::LengthAndGravity { length, gravity } };
        let full = length.is_normal() && gravity.is_normal();
        if !full || !USABLE.contains(&pendulum.angular_frequency()) {
            return Err(PendulumError::OutOfRange { length, gravity });
        }
        Ok(pendulum)
    }

    /// A pendulum given by ω0 = √(g/l) in rad/s alone.
    ///
    /// # Errors
    /// ω0 not positive and finite, or outside 1e-290 … 1e290.
    pub fn from_angular_frequency(angular_frequency: f64) -> Result<Self, PendulumError> {
        positive("angular frequency", angular_frequency)?;
        if !USABLE.contains(&angular_frequency) {
            return Err(PendulumError::FrequencyOutOfRange(angular_frequency));
        }
        Ok(Self { size: Size::AngularFrequency(angular_frequency) })
    }

    /// The length in metres, if it was given.
    #[must_use]
    pub fn length(&self) -> Option<f64> {
        match self.size {
            Size::LengthAndGravity { length, .. } => Some(length),
            Size::AngularFrequency(_) => None,
        }
    }

    /// The gravity in m/s², if it was given.
    #[must_use]
    pub fn gravity(&self) -> Option<f64> {
        match self.size {
            Size::LengthAndGravity { gravity, .. } => Some(gravity),
            Size::AngularFrequency(_) => None,
        }
    }

    /// ω0 = √(g/l) in rad/s.
    #[must_use]
    pub fn angular_frequency(&self) -> f64 {
        self.angular_frequency_words().to_f64()
    }

    /// T0 = 2π/ω0 in seconds.
    #[must_use]
    pub fn small_angle_period(&self) -> f64 {
        (DoubleDouble::PI.scaled(2.0) / self.angular_frequency_words()).to_f64()
    }

    /// The period in seconds of the libration with this amplitude.
    #[must_use]
    pub fn period(&self, amplitude: &Amplitude) -> f64 {
        amplitude.period_in_units_of(self.angular_frequency_words())
    }

    /// ω0 in two words.
    fn angular_frequency_words(&self) -> DoubleDouble {
        match self.size {
            Size::LengthAndGravity { length, gravity } => root_of_quotient(gravity, length),
            Size::AngularFrequency(angular_frequency) => DoubleDouble::from(angular_frequency),
        }
    }
}

/// √(a/b), with separate powers of two so that the quotient neither overflows nor underflows.
fn root_of_quotient(a: f64, b: f64) -> DoubleDouble {
    let ((a, a_exponent), (b, b_exponent)) = (libm::frexp(a), libm::frexp(b));
    let exponent = a_exponent - b_exponent;
    let a = libm::scalbn(a, exponent.rem_euclid(2));
    (DoubleDouble::from(a) / DoubleDouble::from(b)).sqrt().times_power_of_two(exponent.div_euclid(2))
}

fn positive(name: &'static str, value: f64) -> Result<(), PendulumError> {
    if value > 0.0 && value.is_finite() { Ok(()) } else { Err(PendulumError::NotPositive { name, value }) }
}

fn finite(name: &'static str, value: f64) -> Result<(), PendulumError> {
    if value.is_finite() { Ok(()) } else { Err(PendulumError::NotFinite { name, value }) }
}
