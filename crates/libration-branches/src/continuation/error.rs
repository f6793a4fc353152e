//! Errors of the search for branches of periodic orbits.

use libration_motion::orbit::OrbitError;
use libration_numbers::expression::{EquationError, WithoutValue};
use libration_numbers::progress::Interrupted;

/// Reason why branches of periodic orbits were not found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BranchError {
    /// A value that the equations cannot have.
    #[error(transparent)]
    Equation(#[from] EquationError),
    /// A further parameter without a value.
    #[error(transparent)]
    WithoutValue(#[from] WithoutValue),
    /// Equations without a periodic drive.
    #[error(
        "the equations have no drive with a known period: the time may stand in sines and cosines only, in simple proportions"
    )]
    NotDriven,
    /// An order for equations of more than one coordinate.
    #[error(
        "sub- and superharmonic responses are searched from the free oscillations of one second-order equation: these equations have another form"
    )]
    NotOneOscillator,
    /// A rotation of a coordinate that is not an angle.
    #[error(
        "the coordinate {0} does not rotate: it is not an angle, after whose full turn the equations repeat"
    )]
    NotAnAngle(String),
    /// No rotating solution to begin with.
    #[error(
        "no rotating solution was found at the ends of the range or at the given value (turns: {turns}, periods of the drive: \
         {drive_periods}): give a value within the range, or a stronger drive"
    )]
    NoRotation {
        /// The number of turns.
        turns: i32,
        /// The number of drive periods.
        drive_periods: u32,
    },
    /// Free motions that form a continuous family.
    #[error(
        "at one value of the parameter there is a family of periodic motions, as where energy is conserved: follow it in the amplitude instead"
    )]
    Family,
    /// A range without a width, or with ends that are not finite.
    #[error("the range from {from:?} to {to:?} has no width: give two different finite numbers")]
    Range {
        /// The first end.
        from: f64,
        /// The second end.
        to: f64,
    },
    /// A value outside the range.
    #[error("the value {at:?} at which solutions are searched is outside the range from {from:?} to {to:?}")]
    Outside {
        /// The value at which motions are searched.
        at: f64,
        /// The first end.
        from: f64,
        /// The second end.
        to: f64,
    },
    /// No motion to begin with, at either end.
    #[error("no periodic solution was found at the ends of the range or at the given value: {0}")]
    NoStart(OrbitError),
    /// A periodic solution of a driven system next to which no other one was found.
    #[error(
        "the periodic solution that was found cannot be followed: Newton's method finds none next to it, as where a force jumps; give another \
         start"
    )]
    NoNeighbour,
    /// A periodic solution without a drive that cannot be followed.
    #[error(
        "the periodic solution that was found cannot be followed: without a drive it begins at a turning point of the first coordinate; \
         write the equation of one that oscillates first, or give another start"
    )]
    NotFollowed,
    /// Cancellation before the first point.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}
