//! What the steps of a motion lose by rounding.

use std::ops::ControlFlow;

use super::roundings::{ROUNDING, Rounded, rounded_values};
use super::{AcceptedStep, Effort, Moment, Start, Step, System, integrate_from};
use crate::expression::Tape;

/// A step of a motion.
#[derive(Clone, Debug)]
pub(super) struct RoundedStep {
    /// The state halfway.
    pub(super) middle: Moment,
    /// By how much each number may be wrong that was right before, had the forces seen the whole state at the start.
    pub(super) errors: Vec<f64>,
    /// What the forces do not see of the state at the start: its second words.
    pub(super) unseen: Vec<f64>,
    /// How fast each number changes halfway.
    pub(super) speeds: Vec<f64>,
    /// By how much the time is wrong at which a force bends or jumps at the end.
    pub(super) late: f64,
}

/// So many steps from a start on, or as many as there are.
pub(super) fn rounded_steps(
    system: &System,
    start: &Start,
    last: f64,
    effort: &Effort,
    most: usize,
) -> Vec<RoundedStep> {
    let accelerations = system.accelerations();
    let mut steps: Vec<RoundedStep> = vec![];
    let mut signs: Vec<f64> = vec![];
    // Broken off or not, these are the steps that were taken before.
    let _ = integrate_from(system, start, &[last], effort, |accepted| {
        let now = accepted.signs();
        if let Some(before) = steps.last_mut().filter(|_| now != signs) {
            before.late = ROUNDING * accepted.step().start().abs();
        }
        signs = now;
        steps.push(rounded_step(accepted, accelerations.as_ref()));
        if steps.len() < most { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    steps
}

fn rounded_step(accepted: &AcceptedStep<'_>, accelerations: Option<&Tape>) -> RoundedStep {
    let step = accepted.step();
    let length = accepted.ended_at().unwrap_or(step.end()) - step.start();
    let at = |time: f64| Moment { time, state: step.state_at(time) };
    let middle = at(step.start() + 0.5 * length);
    let lost = [at(step.start()), middle.clone()].map(|moment| lost_in_forces(accelerations, &moment));
    let forces: Vec<f64> = lost[0].iter().zip(&lost[1]).map(|(a, b)| f64::max(*a, *b)).collect();
    let unseen = (0..step.numbers()).map(|number| step.low(number).abs()).collect();
    let speeds = (0..step.numbers()).map(|number| step.slope_at(number, middle.time)).collect();
    RoundedStep { middle, errors: errors(step, length, &forces), unseen, speeds, late: 0.0 }
}

/// What rounding does to the accelerations and rates of change, each in its unit.
fn lost_in_forces(accelerations: Option<&Tape>, moment: &Moment) -> Vec<f64> {
    let inputs = [&moment.state[..], &[moment.time]].concat();
    let values: Option<Vec<Rounded>> = accelerations.and_then(|tape| rounded_values(tape, &inputs));
    let values = values.into_iter().flatten();
    values.map(|value| if value.error.is_finite() { ROUNDING * value.error } else { 0.0 }).collect()
}

fn errors(step: &Step<'_>, length: f64, forces: &[f64]) -> Vec<f64> {
    let layout = step.layout;
    // The first power is exact but for the force in it, and that of a coordinate is its velocity, which is known in two words.
    let first = |number: usize| if layout.velocity(number).is_some() { 3 } else { 2 };
    let mut errors: Vec<f64> =
        (0..step.numbers()).map(|number| ROUNDING * terms(step, number, first(number), length)).collect();
    for (coordinate, force) in forces.iter().enumerate() {
        let driven = layout.driven(coordinate);
        errors[driven] += force * length.abs();
        if driven != coordinate {
            errors[coordinate] += 0.5 * force * length * length;
        }
    }
    errors
}

/// The sum of the sizes of the terms of a number from a power on, so far from the start of the step.
pub(super) fn terms(step: &Step<'_>, number: usize, first: usize, length: f64) -> f64 {
    let h = (length / step.unit).abs();
    let horner = |sum: f64, n: usize| sum * h + step.coefficient(number, n).abs();
    let sum = (first..step.terms).rev().fold(0.0, horner);
    (0..first).fold(sum, |sum, _| sum * h)
}
