//! Errors of the search for branches of periodic orbits.

use libration_motion::orbit::NoOrbit;
use libration_numbers::expression::{EquationError, WithoutValue};
use libration_numbers::progress::Interrupted;

/// Reason why no branch of periodic orbits was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoBranch {
    /// A value that the equations cannot have.
    #[error(transparent)]
    Equation(#[from] EquationError),
    /// Another parameter without a value.
    #[error(transparent)]
    WithoutValue(#[from] WithoutValue),
    /// Equations without a periodic drive.
    #[error(
        "the equations have no drive with a known period: the time may stand in sines and cosines only, in simple proportions"
    )]
    NotDriven,
    /// Free oscillations of anything but one coordinate.
    #[error(
        "orders are looked for from the free oscillations of one coordinate with its second derivative: these equations are others"
    )]
    NotOneOscillator,
    /// A rotation of a coordinate that is not an angle.
    #[error(
        "the coordinate {0} does not go around: it is no angle, after whose turn the equations are the same"
    )]
    NotAnAngle(String),
    /// No rotation to begin with.
    #[error(
        "no answer that goes around is found at the ends of the range, or where it is looked for (turns: {turns}, periods of the drive: \
         {drive_periods}): look within the range, or drive more strongly"
    )]
    NoRotation {
        /// The number of turns.
        turns: i32,
        /// The number of drive periods.
        drive_periods: u32,
    },
    /// Free motions that are not isolated.
    #[error(
        "at one value of the parameter there is a family of periodic motions, as where energy is conserved: follow it in the amplitude instead"
    )]
    Family,
    /// A range without a width, or with ends that are not finite.
    #[error("the range from {from:?} to {to:?} has no width: give two different finite numbers")]
    Range {
        /// One end.
        from: f64,
        /// The other.
        to: f64,
    },
    /// A start outside of the range.
    #[error("the answers are looked for at {at:?}, which is outside of the range from {from:?} to {to:?}")]
    Outside {
        /// The value at which they are looked for.
        at: f64,
        /// One end.
        from: f64,
        /// The other.
        to: f64,
    },
    /// No motion to begin with at either end.
    #[error("no periodic motion is found at the ends of the range, or where it is looked for: {0}")]
    NoStart(NoOrbit),
    /// Cancelled before the first point.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}
