//! An integration that can be resumed, and the results of each of its steps.

use std::ops::ControlFlow;

use super::batch::{Batch, LaneStep, Observer};
use super::stepper::Stepper;
use crate::taylor::{
    Checkpoint, Effort, IntegrationError, Moment, Occurrence, Solution, Step, System, Trajectory,
};

/// The beginning of an integration.
#[derive(Clone, Debug, PartialEq)]
pub enum Start {
    /// A state.
    State(Moment),
    /// The start of a step of an earlier integration.
    Checkpoint(Checkpoint),
}

/// A step of an integration with its samples and events.
#[derive(Clone, Copy, Debug)]
pub struct AcceptedStep<'a> {
    taken: LaneStep<'a, 1>,
}

impl<'a> AcceptedStep<'a> {
    /// The step.
    #[must_use]
    pub fn step(&self) -> &Step<'a> {
        &self.taken.step
    }

    /// The events in the step, in the order of the integration.
    #[must_use]
    pub fn events(&self) -> &'a [Occurrence] {
        self.taken.solution.new_events()
    }

    /// The time at which an event in this step ended the integration; `None` if none did.
    #[must_use]
    pub fn ended_at(&self) -> Option<f64> {
        self.taken.solution.ended_at()
    }

    /// The stepper, whose only lane contains the motion.
    pub(in crate::taylor) fn stepper(&self) -> &'a Stepper<'a, 1> {
        self.taken.stepper
    }

    /// The checkpoint at the end of the step; `None` if this or an earlier step was shortened only because the last of the times is near, so
    /// that with later times it would have ended elsewhere, and if an event ended the step.
    #[must_use]
    pub fn checkpoint(&self) -> Option<Checkpoint> {
        if self.ended_at().is_some() {
            return None;
        }
        let LaneStep { stepper, solution, lane, .. } = self.taken;
        let checkpoint = stepper.checkpoint(lane)?;
        Some(Checkpoint { events: solution.checkpoints(), steps: solution.steps(), ..checkpoint })
    }
}

/// Integrates like [`integrate`](crate::taylor::integrate), from a state or from a checkpoint; after a
/// checkpoint the results are the same, bit for bit. The function `each` is called with each accepted step.
///
/// # Errors
/// As [`integrate`](crate::taylor::integrate), or a checkpoint of another system.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::taylor::{Start, Effort, Moment, System, integrate_from};
/// use std::ops::ControlFlow;
/// let system = System::new(&"theta'' + sin(theta) = 0".parse()?)?;
/// let start = Start::State(Moment { time: 0.0, state: vec![1.0, 0.0] });
/// let effort = Effort::to_tolerance(1e-12);
/// let mut last = None;
/// integrate_from(&system, &start, &[10.0], &effort, |step| {
///     last = step.checkpoint().or(last.take());
///     ControlFlow::Continue(())
/// })?;
/// let resumed = integrate_from(&system, &Start::Checkpoint(last.unwrap()), &[20.0], &effort, |_| ControlFlow::Continue(()))?;
/// let whole = integrate_from(&system, &start, &[20.0], &effort, |_| ControlFlow::Continue(()))?;
/// assert_eq!(resumed.end, whole.end);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn integrate_from(
    system: &System,
    start: &Start,
    times: &[f64],
    effort: &Effort,
    mut each: impl FnMut(&AcceptedStep<'_>) -> ControlFlow<()>,
) -> Result<Solution, IntegrationError> {
    resumed(system, start, times, effort, &mut each)
}

fn resumed(
    system: &System,
    start: &Start,
    times: &[f64],
    effort: &Effort,
    each: &mut dyn FnMut(&AcceptedStep<'_>) -> ControlFlow<()>,
) -> Result<Solution, IntegrationError> {
    let (start, checkpoint) = match start {
        Start::State(moment) => (moment.clone(), None),
        Start::Checkpoint(checkpoint) => {
            let start = Moment { time: checkpoint.time, state: checkpoint.rounded_state() };
            (start, Some(checkpoint))
        }
    };
    if checkpoint.is_some_and(|checkpoint| !checkpoint.fits(system)) {
        return Err(IntegrationError::OtherCheckpoint);
    }
    let trajectory = Trajectory { start, parameters: vec![], times };
    let mut batch = Batch::<1>::new(system, effort).resumed_from(checkpoint);
    let outcomes = batch.integrate(
        std::slice::from_ref(&trajectory),
        Observer::Steps(&mut |_, taken| each(&AcceptedStep { taken: *taken })),
    );
    outcomes.into_iter().next().expect("one motion has one outcome")
}
