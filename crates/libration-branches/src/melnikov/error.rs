//! Errors of Melnikov's method.

use libration_motion::taylor::IntegrationError;
use libration_numbers::expression::{SecondOrderError, WithoutValue};
use libration_numbers::progress::Interrupted;

/// Reason why an equation has no Melnikov function or no threshold.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MelnikovError {
    /// Several coordinates.
    #[error(
        "the equations are for {0} coordinates: give one, such as \"x'' + sin(x) = -0.1 x' + 0.3 cos(t)\""
    )]
    Coordinates(usize),
    /// An equation of first order.
    #[error(transparent)]
    NotSecondOrder(#[from] SecondOrderError),
    /// A parameter without a value.
    #[error("`{0}` has no value: give it one")]
    Open(String),
    /// No restoring force.
    #[error(
        "the acceleration has neither the sine nor the cosine of the angle alone: give a pendulum, such as x'' = -sin(x), without products of half \
         angles"
    )]
    NoPendulum,
    /// A force of the angle alone that is not a polynomial of sine and cosine.
    #[error(
        "the acceleration {0} is not a polynomial in the angle's sine and cosine: the unperturbed motion must be that of a pendulum"
    )]
    NoAngle(String),
    /// A time dependence other than sines and cosines of commensurate frequencies.
    #[error(
        "the drive is not periodic: the time may stand only in sines and cosines, whose frequencies are in simple proportions"
    )]
    NotPeriodic,
    /// A formula that cannot be evaluated.
    #[error(transparent)]
    WithoutValue(#[from] WithoutValue),
    /// An empty range of a parameter.
    #[error("the range from {from:?} to {to:?} is empty: give two different finite numbers")]
    Range {
        /// The first end.
        from: f64,
        /// The second end.
        to: f64,
    },
    /// The equation cannot be evaluated at a value of a parameter.
    #[error("at {parameter} = {value:?}: {reason}")]
    At {
        /// The parameter.
        parameter: String,
        /// The value of the parameter.
        value: f64,
        /// Reason why the value is rejected.
        reason: String,
    },
    /// Cancellation by the caller.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}

/// Reason why no tangency of the manifolds was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TangencyError {
    /// An equation without a Melnikov function.
    #[error(transparent)]
    NoMelnikov(#[from] MelnikovError),
    /// A perturbation so strong that the upright position is no longer a saddle orbit.
    #[error("no periodic motion stays near the upright position: the perturbation is too strong")]
    NoSaddle,
    /// A manifold that turns back before it reaches the bottom.
    #[error(
        "the motions that leave the upright position do not pass the bottom: the perturbation is too strong"
    )]
    NoPassage,
    /// No tangency near the threshold.
    #[error(
        "no tangency near the threshold: the perturbation is too strong for its first order to lead there"
    )]
    NoConvergence,
    /// A failed integration.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
}

impl From<WithoutValue> for TangencyError {
    fn from(error: WithoutValue) -> Self {
        Self::NoMelnikov(error.into())
    }
}
