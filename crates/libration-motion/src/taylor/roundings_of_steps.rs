//! What the steps of a motion lose by rounding.

use std::ops::ControlFlow;

use super::larger::larger_or_nan;
use super::roundings::{ROUNDING, Rounded, rounded_values};
use super::{AcceptedStep, Effort, Moment, Start, Step, System, integrate_from};

/// A step of a motion.
#[derive(Clone, Debug)]
pub(super) struct RoundedStep {
    /// The state halfway.
    pub(super) middle: Moment,
    /// By how much each number may be wrong at the end that was right before, had the forces seen the whole state at the start; NaN where
    /// a formula does not tell.
    pub(super) errors: Vec<f64>,
    /// What the forces do not see of the state at the start: its second words.
    pub(super) unseen: Vec<f64>,
    length: f64,
    /// How fast each number changes at the end.
    rates: Vec<f64>,
    /// Those of what stands in each |…|.
    signs: Vec<f64>,
}

/// So many steps from a start on, or as many as there are.
pub(super) fn rounded_steps(
    system: &System,
    start: &Start,
    last: f64,
    effort: &Effort,
    most: usize,
) -> Vec<RoundedStep> {
    let mut steps: Vec<RoundedStep> = vec![];
    // Broken off or not, these are the steps that were taken before.
    let _ = integrate_from(system, start, &[last], effort, |accepted| {
        let step = RoundedStep::new(system, accepted);
        if let Some(before) = steps.last_mut() {
            before.jump(system, accepted.step(), &step.signs);
        }
        steps.push(step);
        if steps.len() < most { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    steps
}

impl RoundedStep {
    fn new(system: &System, accepted: &AcceptedStep<'_>) -> Self {
        let step = accepted.step();
        let length = accepted.ended_at().unwrap_or(step.end()) - step.start();
        let [start, middle, end] = [0.0, 0.5, 1.0].map(|part| moment(step, step.start() + part * length));
        let signs = signs_at(system, &middle);
        let lost = [&start, &middle].map(|moment| lost_in_forces(system, &signs, moment));
        let forces: Vec<f64> = lost[0].iter().zip(&lost[1]).map(|(a, b)| larger_or_nan(*a, *b)).collect();
        let numbers = 0..step.numbers();
        let unseen = numbers.clone().map(|number| step.low(number).abs()).collect();
        let rates = numbers.map(|number| step.slope_at(number, end.time)).collect();
        Self { middle, errors: errors(step, length, &forces), unseen, length, rates, signs }
    }

    /// Where the next step has other signs, forces jump or bend, and rates of change with them, at a time that is rounded.
    fn jump(&mut self, system: &System, next: &Step<'_>, signs: &[f64]) {
        if self.signs != signs {
            let late = self.late(system, next, signs);
            for (number, error) in self.errors.iter_mut().enumerate() {
                *error += late * (next.slope_at(number, next.start()) - self.rates[number]).abs();
            }
        }
    }

    /// By how much the time is wrong at which the arguments of the signs are zero: it is found to the last bit of the step, and rounded, and
    /// what an argument loses by rounding takes as long as the argument needs to change by that.
    fn late(&self, system: &System, next: &Step<'_>, signs: &[f64]) -> f64 {
        const PART: f64 = 1.0 / 64.0;
        let apart = PART * (next.end() - next.start());
        let values = [0.0, apart].map(|after| formulas(system, signs, &moment(next, next.start() + after)));
        let [Some(here), Some(near)] = values else { return f64::NAN };
        let other = (0..signs.len()).filter(|&modulus| (signs[modulus] - self.signs[modulus]).abs() > 0.0);
        let lost = other.map(|modulus| system.coordinates() + modulus).map(|argument| {
            let change = (near[argument].value - here[argument].value).abs();
            let error = ROUNDING * here[argument].error;
            if error > 0.0 { error * (apart / change).abs() } else { 0.0 }
        });
        ROUNDING * next.start().abs() + f64::EPSILON * self.length.abs() + lost.sum::<f64>()
    }
}

fn moment(step: &Step<'_>, time: f64) -> Moment {
    Moment { time, state: step.state_at(time) }
}

/// The signs of what stands in each |…|, which may have others in it.
fn signs_at(system: &System, moment: &Moment) -> Vec<f64> {
    let mut signs = vec![1.0; system.moduli()];
    for _ in 0..signs.len() {
        let values = formulas(system, &signs, moment);
        let arguments = values.iter().flatten().skip(system.coordinates());
        signs.iter_mut().zip(arguments).for_each(|(sign, argument)| *sign = argument.value.signum());
    }
    signs
}

/// The accelerations and rates of change, then what stands in each |…|; `None` where a formula has no value.
fn formulas(system: &System, signs: &[f64], moment: &Moment) -> Option<Vec<Rounded>> {
    rounded_values(system.tape(), &[&moment.state[..], &[moment.time], signs].concat())
}

/// What rounding does to the accelerations and rates of change, each in its unit.
fn lost_in_forces(system: &System, signs: &[f64], moment: &Moment) -> Vec<f64> {
    match formulas(system, signs, moment) {
        Some(values) => values[..system.coordinates()].iter().map(|value| ROUNDING * value.error).collect(),
        None => vec![f64::NAN; system.coordinates()],
    }
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
