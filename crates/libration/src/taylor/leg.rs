//! An integration that can be gone on from: what each step brings.

use std::ops::ControlFlow;

use super::fleet::{Arrived, Fleet};
use super::{Checkpoint, Effort, IntegrationError, Launch, Moment, Occurrence, Solution, Step, System};

/// Where an integration begins.
#[derive(Clone, Debug, PartialEq)]
pub enum Departure {
    /// In a state.
    At(Moment),
    /// Where an earlier one was at the start of one of its steps.
    From(Checkpoint),
}

/// A step of an integration with what was found in it.
#[derive(Clone, Copy, Debug)]
pub struct Leg<'a> {
    arrived: Arrived<'a, 1>,
}

impl<'a> Leg<'a> {
    /// The step.
    #[must_use]
    pub fn step(&self) -> &Step<'a> {
        &self.arrived.step
    }

    /// The events in it, in their order.
    #[must_use]
    pub fn events(&self) -> &'a [Occurrence] {
        self.arrived.record.new_events()
    }

    /// Its end, to be gone on from; `None` when this or an earlier step ended only because the last of the times is so near,
    /// and on the way to later times would have ended elsewhere.
    #[must_use]
    pub fn checkpoint(&self) -> Option<Checkpoint> {
        let Arrived { flight, record, lane, .. } = self.arrived;
        let checkpoint = flight.checkpoint(lane)?;
        Some(Checkpoint { events: record.checkpoints(), steps: record.steps(), ..checkpoint })
    }
}

/// Integrates as [`integrate`](super::integrate) does, from a state or from a checkpoint; the numbers that follow are the same,
/// bit for bit. `watch` sees what each step brings.
///
/// # Errors
/// As [`integrate`](super::integrate), or a checkpoint of another system.
///
/// # Examples
/// ```
/// use libration::taylor::{Departure, Effort, Moment, System, follow};
/// use std::ops::ControlFlow;
/// let system = System::new(&"theta'' + sin(theta) = 0".parse()?)?;
/// let start = Departure::At(Moment { time: 0.0, state: vec![1.0, 0.0] });
/// let effort = Effort::to_tolerance(1e-12);
/// let mut last = None;
/// follow(&system, &start, &[10.0], &effort, |leg| {
///     last = leg.checkpoint().or(last.take());
///     ControlFlow::Continue(())
/// })?;
/// let farther = follow(&system, &Departure::From(last.unwrap()), &[20.0], &effort, |_| ControlFlow::Continue(()))?;
/// let whole = follow(&system, &start, &[20.0], &effort, |_| ControlFlow::Continue(()))?;
/// assert_eq!(farther.end, whole.end);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn follow(
    system: &System,
    departure: &Departure,
    times: &[f64],
    effort: &Effort,
    mut watch: impl FnMut(&Leg<'_>) -> ControlFlow<()>,
) -> Result<Solution, IntegrationError> {
    let (start, checkpoint) = match departure {
        Departure::At(start) => (start.clone(), None),
        Departure::From(checkpoint) => {
            let start = Moment { time: checkpoint.time, state: checkpoint.rounded_state() };
            (start, Some(checkpoint))
        }
    };
    if checkpoint.is_some_and(|checkpoint| !checkpoint.fits(system)) {
        return Err(IntegrationError::OtherCheckpoint);
    }
    let launch = Launch { start, parameters: vec![], times };
    let mut fleet = Fleet::<1>::new(system, effort).going_on_from(checkpoint);
    let outcomes =
        fleet.travel(std::slice::from_ref(&launch), |_, arrived| watch(&Leg { arrived: *arrived }));
    outcomes.into_iter().next().expect("one motion has one outcome")
}
