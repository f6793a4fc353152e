//! Integration from a state to the states at given times.

use std::ops::ControlFlow;

use super::batch::{Batch, Observer};
use super::trajectory::Trajectory;
use crate::taylor::solution::{Moment, Solution};
use crate::taylor::{Effort, IntegrationError, Step, System};
use libration_numbers::internals::progress::Watch;
use libration_numbers::progress::Progress;

/// Integrates a system from a state to the states at some times, which are all
/// after the start in ascending order, or all before it in descending order.
///
/// # Accuracy
/// The error of each step is less than the tolerance of [`Effort`]. The propagation of these errors depends on the system: the error of a
/// pendulum's phase grows like the square of the time, near an unstable equilibrium errors grow exponentially. States are carried in two words
/// from step to step, and times are exact, so that sums of many steps lose no digits; but the accelerations are evaluated with each coordinate
/// rounded to one word, by which an angle of a thousand turns loses four digits.
///
/// A step ends where the argument of an absolute value changes its sign, at the nearest `f64`, and the other branch continues. A
/// power of it that is not an integer may have no series there, as |x|^1.5 and √|x′| at zero: one short step, whose end is computed
/// by Picard's iteration, passes the zero. A component that such a force brings to zero and leaves there, as x′ = −√|x|·sign(x) and
/// x″ = −x′/√|x′| do, stays zero. Other formulas that are not analytic, such as √(x²) at zero, stop the integration, and so does
/// the boundary of a formula's domain, such as that of e^(−1/x) at zero, however small the effect on the motion before it; √(x² +
/// ε²) with a tiny ε is integrated around its bend in small steps. A removable singularity, such as that of sin(x)/x, is passed.
///
/// # Errors
/// A start, times or tolerances that are not allowed; a singularity, the step limit or cancellation, with the results until then.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::progress::Quiet;
/// use libration::taylor::{Effort, System, integrate};
/// let system = System::new(&"theta'' + 0.1 theta' + sin(theta) = 0".parse()?)?;
/// let start = system.start(&[("theta", 1.0)])?;
/// let solution = integrate(&system, &start, &[1.0, 20.0], &Effort::to_tolerance(1e-15), &Quiet)?;
/// assert!((solution.samples[0].state[0] - 0.6129128065918317).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn integrate(
    system: &System,
    start: &Moment,
    times: &[f64],
    effort: &Effort,
    progress: &dyn Progress,
) -> Result<Solution, IntegrationError> {
    Trajectory { start: start.clone(), parameters: vec![], times }.integrate(system, effort, progress)
}

/// Integrates like [`integrate`]; the function `each` receives each step, and may end the integration.
///
/// # Errors
/// As [`integrate`]. [`Cause::Interrupted`](crate::taylor::Cause::Interrupted) if `each` ends the integration.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::taylor::{Effort, System, integrate_stepwise};
/// use std::ops::ControlFlow;
/// let system = System::new(&"x'' + x = 0".parse()?)?;
/// let start = system.start(&[("x", 1.0)])?;
/// // Stops at the end of the first step after which x is negative.
/// let stopped = integrate_stepwise(&system, &start, &[100.0], &Effort::to_tolerance(1e-12), |step| {
///     if step.state_at(step.end())[0] < 0.0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
/// });
/// assert!(stopped.is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn integrate_stepwise(
    system: &System,
    start: &Moment,
    times: &[f64],
    effort: &Effort,
    each: impl FnMut(&Step<'_>) -> ControlFlow<()>,
) -> Result<Solution, IntegrationError> {
    let trajectory = Trajectory { start: start.clone(), parameters: vec![], times };
    trajectory.integrate_stepwise(system, effort, each)
}

impl Trajectory<'_> {
    /// The motion of this trajectory, as computed by [`integrate`].
    ///
    /// # Errors
    /// As [`integrate`], or parameters that do not fit the system.
    pub fn integrate(
        &self,
        system: &System,
        effort: &Effort,
        progress: &dyn Progress,
    ) -> Result<Solution, IntegrationError> {
        one(system, self, effort, Observer::Progress(Watch::new(progress)))
    }

    /// The motion of this trajectory, as computed by [`integrate_stepwise`].
    ///
    /// # Errors
    /// As [`integrate_stepwise`], or parameters that do not fit the system.
    pub fn integrate_stepwise(
        &self,
        system: &System,
        effort: &Effort,
        mut each: impl FnMut(&Step<'_>) -> ControlFlow<()>,
    ) -> Result<Solution, IntegrationError> {
        one(system, self, effort, Observer::Steps(&mut |_, taken| each(&taken.step)))
    }
}

/// Integrates many motions of a system, several of them side by side in the lanes of vector registers. Each result is bit for bit that of
/// [`Trajectory::integrate`]. `progress` is called with the number of finished motions.
///
/// # Errors
/// Each motion has its own result, as [`integrate`].
pub fn integrate_many(
    system: &System,
    trajectories: &[Trajectory<'_>],
    effort: &Effort,
    progress: &dyn Progress,
) -> Vec<Result<Solution, IntegrationError>> {
    match trajectories {
        [one] => vec![one.integrate(system, effort, progress)],
        _ => many(system, trajectories, effort, Observer::Progress(Watch::new(progress))),
    }
}

/// Integrates like [`integrate_many`]; the function `each` receives the steps of all motions, with their numbers, and may end all motions.
///
/// # Errors
/// Each motion has its own result, as [`integrate_stepwise`].
pub fn integrate_many_stepwise(
    system: &System,
    trajectories: &[Trajectory<'_>],
    effort: &Effort,
    mut each: impl FnMut(usize, &Step<'_>) -> ControlFlow<()>,
) -> Vec<Result<Solution, IntegrationError>> {
    match trajectories {
        [one] => vec![one.integrate_stepwise(system, effort, |step| each(0, step))],
        _ => many(
            system,
            trajectories,
            effort,
            Observer::Steps(&mut |number, taken| each(number, &taken.step)),
        ),
    }
}

// Loops over steps that do not depend on the type of `each`, so that they are compiled once and in this crate.

fn one(
    system: &System,
    trajectory: &Trajectory<'_>,
    effort: &Effort,
    observer: Observer<'_, 1>,
) -> Result<Solution, IntegrationError> {
    let mut batch = Batch::<1>::new(system, effort);
    let outcomes = batch.integrate(std::slice::from_ref(trajectory), observer);
    outcomes.into_iter().next().expect("one motion has one outcome")
}

fn many(
    system: &System,
    trajectories: &[Trajectory<'_>],
    effort: &Effort,
    observer: Observer<'_, LANES>,
) -> Vec<Result<Solution, IntegrationError>> {
    let mut batch = Batch::<LANES>::new(system, effort);
    batch.integrate(trajectories, observer)
}

/// Number of motions integrated side by side: two vector registers of AVX-512, so that neither waits
/// for the other. Driven pendulums at 1e-9 take 173 µs each with 8, 138 µs with 16 and 168 µs with 24.
pub(in crate::taylor) const LANES: usize = 16;
