//! The reasons why an integration cannot begin, or does not reach its end.

use super::Solution;
use libration_numbers::quantity::short;

/// The reason why there is no solution, or only a part of it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum IntegrationError {
    /// A state that does not fit the system.
    #[error("a state of {got} numbers was given: give {wanted}, the coordinates and then the velocities")]
    StateLength {
        /// The number of components given.
        got: usize,
        /// The number of components required.
        wanted: usize,
    },
    /// Values that do not fit the open parameters.
    #[error("{got} values of parameters were given, but {wanted} parameters were left open")]
    ParameterCount {
        /// The number of values given.
        got: usize,
        /// The number of values required.
        wanted: usize,
    },
    /// An initial state or time that is infinite or not a number.
    #[error("the initial state contains {0:?}: give finite numbers")]
    StartNotFinite(f64),
    /// Times that are not finite.
    #[error("the times contain {0:?}: give finite ones")]
    TimeNotFinite(f64),
    /// Times that are neither ascending nor descending.
    #[error(
        "the time {after:?} follows {before:?}: times must lead away from the start, all forward or all backward"
    )]
    TimesNotInOrder {
        /// The time before, or the start.
        before: f64,
        /// The time that breaks the order.
        after: f64,
    },
    /// A tolerance that cannot be met.
    #[error(
        "the tolerances are {relative:?} relative and {absolute:?} absolute: give a relative one from 1e-18 to 0.1 and \
         an absolute one of zero or more"
    )]
    Tolerance {
        /// The relative tolerance.
        relative: f64,
        /// The absolute tolerance.
        absolute: f64,
    },
    /// A checkpoint that cannot belong to the system.
    #[error("the checkpoint belongs to another system or other events: give both as they were")]
    OtherCheckpoint,
    /// A motion that has no derivative by its start, or none that is computed.
    #[error("{cause} at t = {time:?}: the derivatives of the motion are not known")]
    NoDerivative {
        /// The cause.
        cause: NoDerivative,
        /// The time.
        time: f64,
    },
    /// An integration that began and stopped.
    #[error("{cause} at t = {}: the motion is known up to there", cause.time(solution.end.time))]
    Stopped {
        /// The cause of the stop.
        cause: Cause,
        /// The solution until the stop.
        solution: Box<Solution>,
    },
}

/// The reason why a motion across a jump of a force has no derivative by its start, or none that is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NoDerivative {
    /// A motion that only touches a surface at which a force jumps, within the errors of the motion.
    #[error("the motion only touches a surface at which a force jumps")]
    Grazing,
    /// Two surfaces that are passed together, and whose order changes the motion.
    #[error("the motion passes two surfaces together, at both of which a force jumps,")]
    Together,
    /// A sliding motion whose force is not linear in the sign of friction.
    #[error("the motion slides along a surface, where a force is not linear in its sign,")]
    Sliding,
    /// A jump in equations with powers that have no series at zero.
    #[error("a force jumps, and the equations contain a power without a series at zero,")]
    Power,
}

/// The cause of a stop of an integration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Cause {
    /// A state in which the accelerations or rates of change, or their time derivatives, have no finite value.
    #[error("the accelerations or rates of change have no finite value, or no derivative,")]
    Singularity,
    /// A formula some part of which overflows in double precision, though the formula has a value.
    #[error("a part of the equations of motion is beyond 1.8e308, the range of numbers,")]
    Overflow,
    /// Steps that become shorter than the resolution of times, as before a singularity.
    #[error("the steps become too short, as they do before a singularity,")]
    StepUnderflow,
    /// A state that will overflow an `f64` soon, as that of an escaping motion.
    #[error("the motion diverges, beyond the range of numbers,")]
    OutOfRange,
    /// The step limit is reached.
    #[error("the step limit is reached")]
    StepLimit,
    /// An absolute value at zero that the motion can leave to neither side, as in dry friction at rest.
    #[error("an absolute value is zero and the motion can leave it to neither side")]
    NoWayOn,
    /// A state at which a root or a jump allows the motion to stay or to leave at any time, as x′ = √|x| and x″ = sign(x) do at zero.
    #[error("the motion can stay where it is or leave at any time, which the equations do not decide,")]
    Undecided,
    /// Cancellation by the caller.
    #[error("the integration was interrupted")]
    Interrupted,
}

impl Cause {
    /// The time of the stop as text. Where a diverging motion leaves the range of numbers depends on the steps: six digits.
    #[must_use]
    pub fn time(self, time: f64) -> String {
        match self {
            Self::OutOfRange => short(time, 6),
            _ => format!("{time:?}"),
        }
    }
}
