//! Reasons why there is no periodic orbit, or why it is not found.

use crate::taylor::{Cause, IntegrationError};
use libration_numbers::expression::{SecondOrderError, WithoutValue};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Interrupted;

/// The reason why there is no periodic orbit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OrbitError {
    /// A parameter that is left open.
    #[error(transparent)]
    WithoutValue(#[from] WithoutValue),
    /// A release from rest of what has no velocity.
    #[error(transparent)]
    NotSecondOrder(#[from] SecondOrderError),
    /// A release of more or less than one coordinate.
    #[error("a release from rest is for one coordinate, and there are {0}: give a guess of the whole orbit")]
    SeveralCoordinates(usize),
    /// A release where the force changes in time.
    #[error("the force depends on the time t: look for the orbit with the period of the drive instead")]
    DependsOnTime,
    /// A cycle of its own where the force sets the beat.
    #[error("the force does not depend on the time t, so there is no drive period")]
    NotDriven,
    /// A state of the wrong length, or with numbers that are not finite.
    #[error(
        "the start {state:?} does not fit: give {wanted} finite numbers, coordinates and then velocities"
    )]
    Start {
        /// The given state.
        state: Vec<f64>,
        /// The number of components that the state should have.
        wanted: usize,
    },
    /// A period that cannot be.
    #[error("the period is {0:?}: give a finite number above zero")]
    Period(f64),
    /// No period where one is needed.
    #[error("no period is known: give the period of the drive, or a guess of that of the orbit")]
    NoPeriod,
    /// A start in equilibrium.
    #[error("the accelerations vanish at {0:?}: a body released there stays there")]
    AtRest(Vec<f64>),
    /// A release where the acceleration, or a part of its formula, is beyond double precision.
    #[error(
        "at {0:?} the acceleration, or a part of its formula, is beyond 1.8e308, the range of numbers: give a smaller amplitude, or \
         measure in other units"
    )]
    TooLarge(f64),
    /// A release where squares of displacements and velocities are at the end of the range of numbers.
    #[error(
        "released at {0:?} squares of the displacement and the velocity are below 1e-292, the end of the range of numbers with all \
         digits: give a larger amplitude, or measure in other units"
    )]
    TooSmall(f64),
    /// A release where there is no acceleration.
    #[error("the acceleration has no value at {0:?}: give another amplitude")]
    NoValue(f64),
    /// A motion that comes to rest no more.
    #[error("released at {start:?}, the motion does not return: {why}")]
    NoReturn {
        /// The place of the release.
        start: f64,
        /// The behaviour of the motion.
        why: Lost,
    },
    /// A motion that conserves energy and yet comes to rest elsewhere than it began.
    #[error(
        "released at {0:?} the motion comes so near an unstable equilibrium that rounding errors decide where it goes from \
         there: the release is on the separatrix to all digits"
    )]
    Separatrix(f64),
    /// An oscillation about another equilibrium than the one that is meant.
    #[error(
        "released at {start:?} the motion goes to {other_side:?} and back, about another equilibrium than the one at {centre:?}"
    )]
    Elsewhere {
        /// The place of the release.
        start: f64,
        /// The other turning point.
        other_side: f64,
        /// The equilibrium that is meant.
        centre: f64,
    },
    /// A motion that comes to rest elsewhere than it began.
    #[error(
        "released at {start:?} the motion comes to rest at {end:?} after one oscillation: it is damped or excited and has \
         no period"
    )]
    NotClosed {
        /// The place of the release.
        start: f64,
        /// The next maximum or minimum on the same side.
        end: f64,
    },
    /// A motion that nearly stops on the way.
    #[error(
        "released at {start:?} the motion comes so near an unstable equilibrium that rounding errors decide its period, \
         {period:.3} or infinite: the release is on the separatrix to all digits"
    )]
    Unsure {
        /// The place of the release.
        start: f64,
        /// The period that was found.
        period: f64,
        /// The uncertainty of the period.
        uncertainty: f64,
    },
    /// A motion that does not settle.
    #[error("the motion does not settle on a limit cycle: {0}")]
    NoCycle(Lost),
    /// Newton's method at its end.
    #[error(
        "no periodic orbit is found near the start: after {rounds} iterations of Newton's method it fails to close by {defect:.1e} of its size; give a better guess"
    )]
    NoConvergence {
        /// Rounds of Newton's method.
        rounds: usize,
        /// The distance between start and end, in sizes of the orbit.
        defect: f64,
    },
    /// An orbit so unstable that rounding errors of its start decide where it ends.
    #[error(
        "no periodic orbit can be confirmed near the start: deviations grow by a factor of {growth:.0e} in one period, so that the last digit of the \
         start changes the end by {:.0e} of its size",
        growth * f64::EPSILON
    )]
    TooUnstable {
        /// The growth of deviations in one period.
        growth: f64,
    },
    /// An orbit whose neighbours close as well, within rounding errors.
    #[error(
        "closed orbits near the start cannot be distinguished in double precision: neighbouring motions close as well, and the start is known to \
         {0:.0e} of its size only"
    )]
    Undetermined(f64),
    /// An orbit that cannot be followed to its end.
    #[error(transparent)]
    Integration(IntegrationError),
    /// Cancelled by the caller.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}

impl From<IntegrationError> for OrbitError {
    fn from(error: IntegrationError) -> Self {
        match error {
            IntegrationError::Stopped { cause: Cause::Interrupted, .. } => Self::Interrupted(Interrupted),
            other => Self::Integration(other),
        }
    }
}

/// The behaviour of a motion that does not return.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Lost {
    /// A singularity, or infinity in a finite time.
    #[error("{0}")]
    Stopped(IntegrationError),
    /// Rest that is approached for ever, or a way out without end.
    #[error("it has no turning point before t = {0:?}")]
    OneWay(f64),
    /// Rest.
    #[error("it comes to rest at an equilibrium")]
    Rest,
    /// Motion along a jump of the force on both sides of which the force leads back, as of a mass that sticks to a moving belt.
    #[error("it sticks or slides at a jump of the force from t = {0:?} on, which is not computed")]
    Sticks(f64),
    /// Newton's method that ends at a rest to which the motion does not come.
    #[error(
        "Newton's method leads from there to an equilibrium that does not attract the motion: give a start nearer to the orbit, or a guess of its period"
    )]
    UnstableRest,
    /// A motion for which there was not time enough.
    #[error(
        "after {steps} steps of the integration, at t = {time:?}, it still moves: give a start nearer to the orbit, or a guess of its period"
    )]
    Slow {
        /// The time up to which the motion was followed.
        time: f64,
        /// The number of integration steps taken.
        steps: usize,
    },
    /// Neither.
    #[error("it does not repeat itself up to t = {0:?}")]
    Irregular(f64),
}

/// Returns the outcome of a search; the outcome of a cancelled search is discarded.
pub(super) fn finished<T>(outcome: Result<T, OrbitError>, watch: &Watch<'_>) -> Result<T, OrbitError> {
    if watch.is_stopped() { Err(Interrupted.into()) } else { outcome }
}
