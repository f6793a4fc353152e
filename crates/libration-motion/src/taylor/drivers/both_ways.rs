//! Motions before and after their start.

use std::ops::ControlFlow;

use crate::taylor::{
    AcceptedStep, Contact, Direction, Effort, Event, IntegrationError, Moment, Solution, Start, System,
    integrate_from,
};
use libration_numbers::expression::WithoutValue;

/// Integrates a system from a state to times on both sides of it, in ascending order: first backward, then forward; the function `each` receives
/// each step. Samples and events are in the order of time, which also defines rising and falling events.
///
/// # Errors
/// As [`integrate`](crate::taylor::integrate()), with the results until then.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::taylor::{Effort, System, integrate_both_ways};
/// use std::ops::ControlFlow;
/// let system = System::new(&"x' = x".parse()?)?;
/// let start = system.start(&[("x", 1.0)])?;
/// let effort = Effort::to_tolerance(1e-15);
/// let motion = integrate_both_ways(&system, &start, &[-1.0, 0.0, 1.0], &effort, |_| ControlFlow::Continue(()))?;
/// let product = motion.samples[0].state[0] * motion.samples[2].state[0];
/// assert!((product - 1.0).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn integrate_both_ways(
    system: &System,
    start: &Moment,
    times: &[f64],
    effort: &Effort,
    mut each: impl FnMut(&AcceptedStep<'_>) -> ControlFlow<()>,
) -> Result<Solution, IntegrationError> {
    if let Some(pair) = times.windows(2).find(|pair| pair[1] < pair[0]) {
        return Err(IntegrationError::TimesNotInOrder { before: pair[0], after: pair[1] });
    }
    let (before, after) = times.split_at(times.partition_point(|time| *time < start.time));
    let before: Vec<f64> = before.iter().rev().copied().collect();
    let beginning = Start::State(start.clone());
    let backward = match seen_backward(system) {
        Ok(backward) => integrate_from(&backward, &beginning, &before, effort, &mut each),
        // The system had values at its creation.
        Err(_) => integrate_from(system, &beginning, &before, effort, &mut each),
    };
    let before = backward.map(reversed).map_err(|error| with_solution(error, reversed))?;
    let forward = integrate_from(system, &beginning, after, effort, &mut each);
    match forward {
        Ok(after) => Ok(joined(before, after)),
        Err(error) => Err(with_solution(error, |after| joined(before, after))),
    }
}

/// The same system, with events whose directions count in the order of time.
fn seen_backward(system: &System) -> Result<System, WithoutValue> {
    let turned = |event: &Event| Event {
        direction: match event.direction {
            Direction::Any => Direction::Any,
            Direction::Rising => Direction::Falling,
            Direction::Falling => Direction::Rising,
        },
        ..event.clone()
    };
    let events: Vec<Event> = system.events().iter().map(turned).collect();
    system.clone().with_events(&events)
}

/// Puts a backward solution into the order of time; events at the start are found by the forward integration.
fn reversed(mut solution: Solution) -> Solution {
    solution.samples.reverse();
    solution.events.retain(|event| event.contact != Contact::Start);
    solution.events.reverse();
    for event in &mut solution.events {
        event.contact = match event.contact {
            Contact::Rising => Contact::Falling,
            Contact::Falling => Contact::Rising,
            same => same,
        };
    }
    solution
}

fn joined(before: Solution, after: Solution) -> Solution {
    Solution {
        samples: [before.samples, after.samples].concat(),
        events: [before.events, after.events].concat(),
        end: after.end,
        steps: before.steps + after.steps,
    }
}

fn with_solution(error: IntegrationError, change: impl FnOnce(Solution) -> Solution) -> IntegrationError {
    match error {
        IntegrationError::Stopped { cause, solution } => {
            IntegrationError::Stopped { cause, solution: Box::new(change(*solution)) }
        }
        other => other,
    }
}
