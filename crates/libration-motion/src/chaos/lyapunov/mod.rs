//! The largest Lyapunov exponent: the rate at which neighbouring motions diverge.
//!
//! # Method
//! A deviation is advanced by the linearised equations and reset to size one after each interval; its logarithm
//! is recorded. Next to a separatrix, at the distance δ in energy, it grows by 1/δ at each return and shrinks
//! by √δ on the way. Errors ε therefore return as ε/δ and look like chaos in any integration. The depth of the
//! valleys in the record distinguishes the two: if ε·e^(2·depth) is not small, the verdict is undecided.
//!
//! Chaos requires growth by e¹⁰⁰, which a single passage cannot produce, growth in each of ten blocks, a bounded
//! motion, and the same for two neighbours: next to an unstable periodic motion no neighbour stays. Equations
//! with a plane of states, and linear ones, are regular by theorems, which are tried first (`verdict.rs`).

mod schedule;
pub(crate) mod verdict;
mod deviation;
#[doc(hidden)]
pub(crate) mod record;
mod laboratory;

use super::structure::has_jumps;
use crate::taylor::{Cause, Effort, IntegrationError, Moment};
use laboratory::Laboratory;
use libration_numbers::expression::{Equation, WithoutValue};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;

pub use schedule::Schedule;
pub use verdict::{Doubt, LyapunovVerdict, Regularity};

/// The largest Lyapunov exponent of a motion, as far as it was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct LyapunovExponent {
    /// The mean rate at which the logarithm of a deviation grows, in 1/time.
    pub exponent: f64,
    /// The largest of the standard error of the exponent from ten blocks, its change in the second half of the time, and its magnitude if a
    /// deviation that grows like a power of the time explains it.
    pub uncertainty: f64,
    /// Regular, chaotic or undecided.
    pub verdict: LyapunovVerdict,
    /// The estimates over increasing times: `(time since the beginning of the measurement, exponent)`.
    pub convergence: Vec<(f64, f64)>,
}

/// The reason why an exponent cannot be measured.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LyapunovError {
    /// A parameter without a value.
    #[error(transparent)]
    WithoutValue(#[from] WithoutValue),
    /// A start, or a transient, that cannot be integrated.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// Accelerations that jump, or contain sign(…) next to a factor that vanishes with it.
    #[error(
        "where sign(…) jumps the linearised equations do not hold: write x'*abs(x') for sign(x')*x'^2, make dry friction smooth, such as tanh(100*x'), and for abs(x')^1.5*sign(x') write x'*(x'^2 + 1e-12)^0.25"
    )]
    Jumps,
    /// A schedule without any measurement.
    #[error("{} intervals of {:?} after {:?} measure nothing: give a finite time above zero", .0.intervals, .0.interval, .0.transient)]
    Schedule(Schedule),
    /// A motion that stopped before one interval was measured.
    #[error("{0} before anything was measured")]
    Nothing(Cause),
}

/// Measures the largest Lyapunov exponent along the motion from a start.
///
/// A deviation is advanced by the linearised equations. Its components are relative to the
/// extent of the motion in each state component, so that the result does not depend on units.
///
/// `progress` receives the number of intervals measured, as [`Stage::Motion`](libration_numbers::progress::Stage::Motion) 0 for the given
/// motion, and as 1 and 2 for its neighbours. A cancelled call returns the estimates so far, with the verdict [`Doubt::Stopped`].
///
/// # The verdict
/// `Chaotic` requires that the equations do not exclude it, and the following for the motion and for two others that begin a millionth of its
/// extent away: the deviation grows by e¹⁰⁰ or more, and for the motion itself in each of ten blocks of the time; the exponents have the same
/// size; the motion stays bounded, except for angles and coordinates on which no force depends; and the deviation never shrinks so much in
/// between that integration errors take over, as they do next to a separatrix. Motions are `Regular` by a theorem (one coordinate without time;
/// linear equations), if deviations shrink, or if in the second half of the time, and in the second quarter, they grow by at most e^1.5, which
/// exceeds growth in proportion to the time. The last criterion holds for the measured time only: chaos may appear later.
///
/// # Errors
/// A parameter without a value, accelerations with sign(…), a start that does not fit, a schedule without
/// a measurement, or a motion that stops before one interval is measured. [`LyapunovError::Nothing`] or
/// [`IntegrationError::Stopped`] if the call is cancelled before an interval is measured.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::chaos::{Schedule, LyapunovVerdict, lyapunov_exponent};
/// use libration::progress::Quiet;
/// use libration::taylor::{Effort, Moment};
/// let pendulum = "theta'' + theta'/2 + sin(theta) = 1.5*cos(2t/3)".parse()?;
/// let start = Moment { time: 0.0, state: vec![0.2, 0.0] };
/// let effort = Effort::to_tolerance(1e-12);
/// let schedule = Schedule::natural(&pendulum, &start, 400, &effort)?;
/// let exponent = lyapunov_exponent(&pendulum, &start, &schedule, &effort, &Quiet)?;
/// assert_eq!(exponent.verdict, LyapunovVerdict::Chaotic);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # References
/// G. Benettin, L. Galgani, A. Giorgilli and J.-M. Strelcyn, Meccanica 15, 9 (1980), doi:10.1007/BF02128236.
pub fn lyapunov_exponent(
    equation: &Equation,
    start: &Moment,
    schedule: &Schedule,
    effort: &Effort,
    progress: &dyn Progress,
) -> Result<LyapunovExponent, LyapunovError> {
    let watch = &Watch::new(progress);
    if !schedule.is_possible() {
        return Err(LyapunovError::Schedule(*schedule));
    }
    if has_jumps(equation) {
        return Err(LyapunovError::Jumps);
    }
    let laboratory = Laboratory::new(equation, start, schedule, effort, watch)?;
    let evidence = laboratory.measure(watch)?;
    let verdict = laboratory.verdict(&evidence, start, watch);
    let record = &evidence.record;
    Ok(LyapunovExponent {
        exponent: record.exponent(),
        uncertainty: record.uncertainty(),
        verdict,
        convergence: record.convergence().collect(),
    })
}
