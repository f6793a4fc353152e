//! Reasons why a periodic orbit does not exist or was not found.

use crate::taylor::{Cause, IntegrationError};
use libration_numbers::expression::{SecondOrderError, WithoutValue};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Interrupted;
use libration_numbers::quantity::short;

/// The reason why there is no periodic orbit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OrbitError {
    /// A parameter without a value.
    #[error(transparent)]
    WithoutValue(#[from] WithoutValue),
    /// A release from rest of a variable without a velocity.
    #[error(transparent)]
    NotSecondOrder(#[from] SecondOrderError),
    /// A release from rest in several coordinates.
    #[error("a release from rest is for one coordinate, and there are {0}: give a guess of the whole orbit")]
    SeveralCoordinates(usize),
    /// A release from rest under a time-dependent force.
    #[error("the force depends on the time t: look for the orbit with the period of the drive instead")]
    DependsOnTime,
    /// A driven orbit under a force that does not depend on the time.
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
    /// An invalid period.
    #[error("the period is {0:?}: give a finite number above zero")]
    Period(f64),
    /// A period after which the drive is not what it was.
    #[error("the force does not repeat after {0:?}: give the period of the drive, or a multiple of it")]
    NotOfDrive(f64),
    /// A missing period.
    #[error("no period is known: give the period of the drive, or a guess of that of the orbit")]
    NoPeriod,
    /// A start at an equilibrium.
    #[error("the accelerations vanish at {0:?}: a body released there stays there")]
    AtRest(Vec<f64>),
    /// A release at which the acceleration, or a part of its formula, is beyond double precision.
    #[error(
        "at {0:?} the acceleration, or a part of its formula, is beyond 1.8e308, the range of numbers: give a smaller amplitude, or \
         measure in other units"
    )]
    TooLarge(f64),
    /// A release for which squares of displacements and velocities are at the limits of the range of numbers.
    #[error(
        "released at {0:?} squares of the displacement and the velocity are below 1e-292, the end of the range of numbers with all \
         digits: give a larger amplitude, or measure in other units"
    )]
    TooSmall(f64),
    /// A release at which the acceleration has no value.
    #[error("the acceleration has no value at {0:?}: give another amplitude")]
    NoValue(f64),
    /// A motion that does not come to rest again.
    #[error("from {start:?} the motion does not return: {why}")]
    NoReturn {
        /// The position at the start.
        start: f64,
        /// The behaviour of the motion.
        why: Lost,
    },
    /// A motion that conserves energy but comes to rest elsewhere than it began.
    #[error(
        "released at {0:?} the motion comes so near an unstable equilibrium that rounding errors decide where it goes from \
         there: the release is on the separatrix to all digits"
    )]
    Separatrix(f64),
    /// An oscillation about another equilibrium than the requested one.
    #[error(
        "released at {start:?} the motion goes to {other_side:?} and back, about another equilibrium than the one at {centre:?}"
    )]
    Elsewhere {
        /// The position of the release.
        start: f64,
        /// The turning point on the other side.
        other_side: f64,
        /// The requested equilibrium.
        centre: f64,
    },
    /// A motion that comes to rest elsewhere than it began.
    #[error(
        "released at {start:?} the motion comes to rest at {end:?} after one oscillation: it is damped or excited and has \
         no period"
    )]
    NotClosed {
        /// The position of the release.
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
        /// The position of the release.
        start: f64,
        /// The computed period.
        period: f64,
        /// The uncertainty of the period.
        uncertainty: f64,
    },
    /// A motion that does not settle.
    #[error("the motion does not settle on a limit cycle: {0}")]
    NoCycle(Lost),
    /// Newton's method reached its limit.
    #[error(
        "no periodic orbit is found near the start: after {rounds} iterations of Newton's method it fails to close by {defect:.1e} of its size; give a better guess"
    )]
    NoConvergence {
        /// Number of iterations of Newton's method.
        rounds: usize,
        /// The distance between start and end, relative to the size of the orbit.
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
        "closed orbits near the start cannot be distinguished in double precision: neighbouring motions close as well, and the start or the \
         period is {}",
        if .0.is_finite() { format!("known to {:.0e} of its size only", .0) } else { "not determined".to_owned() }
    )]
    Undetermined(f64),
    /// An orbit that cannot be integrated to its end.
    #[error(transparent)]
    Integration(IntegrationError),
    /// Cancellation by the caller.
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

/// Digits of a time in a message: it says how far a search went.
const DIGITS: usize = 6;

/// The behaviour of a motion that does not return.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Lost {
    /// A singularity, or infinity in a finite time.
    #[error("{0}")]
    Stopped(IntegrationError),
    /// Rest that is approached for ever, or motion without end.
    #[error("it has no turning point before t = {}", short(*.0, DIGITS))]
    OneWay(f64),
    /// Motion in one direction after oscillations, such as that of a pendulum that goes round.
    #[error(
        "after t = {} it no longer turns, as a pendulum that goes round: give a start nearer to an orbit that closes",
        short(*.0, DIGITS)
    )]
    GoesRound(f64),
    /// An equilibrium.
    #[error("it comes to rest at an equilibrium")]
    Rest,
    /// An unstable equilibrium, at which the motion rests or which it passes.
    #[error(
        "it comes to rest at an unstable equilibrium, or passes it nearer than double precision can follow"
    )]
    Saddle,
    /// Motion along a jump of the force, towards which the force points from both sides, such as that of a mass that sticks to a moving belt.
    #[error("it sticks or slides at a jump of the force from t = {} on, which is not computed", short(*.0, DIGITS))]
    Sticks(f64),
    /// An equilibrium found by Newton's method to which the motion does not settle.
    #[error(
        "Newton's method leads from there to an equilibrium that does not attract the motion: give a start nearer to the orbit, or a guess of its period"
    )]
    UnstableRest,
    /// A motion whose settling was not observed in the available time.
    #[error(
        "after {steps} steps of the integration, at t = {}, it still moves: give a start nearer to the orbit, or a guess of its period",
        short(*time, DIGITS)
    )]
    Slow {
        /// The time up to which the motion was followed.
        time: f64,
        /// The number of integration steps taken.
        steps: usize,
    },
    /// A motion that neither settles nor repeats itself.
    #[error("it does not repeat itself up to t = {}", short(*.0, DIGITS))]
    Irregular(f64),
}

/// Returns the outcome of a search; the outcome of a cancelled search is discarded.
pub(super) fn finished<T>(outcome: Result<T, OrbitError>, watch: &Watch<'_>) -> Result<T, OrbitError> {
    if watch.is_stopped() { Err(Interrupted.into()) } else { outcome }
}
