//! Errors of decays.

use crate::taylor::IntegrationError;
use libration_pendulum::pendulum::PendulumError;

/// Maximum number of terms of a damping.
pub(super) const MOST_TERMS: usize = 16;

/// The reason why a damping or a damped motion is invalid.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DecayError {
    /// A power of the velocity that is negative or NaN.
    #[error("the damping has the velocity to the power {0:?}: give a power of zero or more")]
    Exponent(f64),
    /// A coefficient that is negative or not finite.
    #[error(
        "a coefficient of {coefficient:?} for the velocity to the power {exponent:?}: give a finite number, zero or more"
    )]
    Coefficient {
        /// The coefficient.
        coefficient: f64,
        /// The power of the velocity that it multiplies.
        exponent: f64,
    },
    /// More powers than are supported.
    #[error("damping with {0} different powers of the velocity: give at most {most}", most = MOST_TERMS)]
    TooManyTerms(usize),
    /// Coefficients that are all zero.
    #[error("there is no damping: give a coefficient above zero")]
    NoDamping,
    /// A coefficient beyond the range of numbers.
    #[error(
        "the damping with the velocity to the power {exponent:?} is {value:?} in units of the pendulum's own time: give a \
         coefficient nearer to one"
    )]
    OutOfRange {
        /// The power of the velocity.
        exponent: f64,
        /// The coefficient with 1/ω0 as the unit of time.
        value: f64,
    },
    /// An amplitude that is too small.
    #[error("an amplitude of {0:?} rad is too small: give at least 1e-100")]
    AtRest(f64),
    /// An amplitude at or beyond the top.
    #[error(transparent)]
    Amplitude(#[from] PendulumError),
    /// An integration that stopped.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
}
