//! Rounding errors of the steps of a motion.

use std::ops::ControlFlow;

use super::matrix::Matrix;
use crate::taylor::program::linearised::{Linearised, ROUNDING};
use crate::taylor::step::larger::larger_or_nan;
use crate::taylor::{AcceptedStep, Effort, Moment, Start, StateLayout, Step, System, integrate_from};
use libration_kernels::elementary::count;

/// A step of a motion.
#[derive(Clone, Debug)]
pub(in crate::taylor) struct RoundedStep {
    /// The state in the middle of the step.
    pub(in crate::taylor) middle: Moment,
    /// Error of each component at the end after an exact start, if the forces were
    /// evaluated with the whole state at the start; NaN if a formula has no value.
    pub(in crate::taylor) errors: Vec<f64>,
    /// Second words of the state at the start, which do not enter the forces.
    pub(in crate::taylor) unseen: Vec<f64>,
    pub(in crate::taylor) length: f64,
    /// Rates of change of the components at the end.
    pub(in crate::taylor) rates: Vec<f64>,
    /// Signs of the arguments of each |…|.
    pub(in crate::taylor) signs: Vec<f64>,
}

/// The first `most` steps from a start, or all if there are fewer.
pub(in crate::taylor) fn rounded_steps(
    system: &System,
    start: &Start,
    last: f64,
    effort: &Effort,
    most: usize,
) -> Vec<RoundedStep> {
    let (mut steps, mut formulas): (Vec<RoundedStep>, _) = (vec![], Formulas::new(system));
    // If the integration stops with an error, the steps before it are used all the same.
    let _ = integrate_from(system, start, &[last], effort, |accepted| {
        let step = RoundedStep::new(&mut formulas, accepted);
        if let Some(before) = steps.last_mut() {
            before.jump(&mut formulas, accepted.step(), &step.signs);
        }
        steps.push(step);
        if steps.len() < most { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    steps
}

impl RoundedStep {
    pub(in crate::taylor) fn new(formulas: &mut Formulas, accepted: &AcceptedStep<'_>) -> Self {
        let step = accepted.step();
        let length = accepted.ended_at().unwrap_or(step.end()) - step.start();
        let [start, middle, end] = [0.0, 0.5, 1.0].map(|part| moment(step, step.start() + part * length));
        let signs = formulas.signs_at(&middle);
        let lost = [&start, &middle].map(|moment| formulas.lost_in_forces(&signs, moment));
        let forces: Vec<f64> = lost[0].iter().zip(&lost[1]).map(|(a, b)| larger_or_nan(*a, *b)).collect();
        let numbers = 0..step.numbers();
        let unseen = numbers.clone().map(|number| step.low(number).abs()).collect();
        let rates = numbers.map(|number| step.slope_at(number, end.time)).collect();
        Self { middle, errors: errors(step, length, &forces), unseen, length, rates, signs }
    }

    /// Adds the error due to a change of signs in the next step, at which forces and rates of change jump or bend at a time that is rounded.
    pub(in crate::taylor) fn jump(&mut self, formulas: &mut Formulas, next: &Step<'_>, signs: &[f64]) {
        if self.signs != signs {
            let late = self.late(formulas, next, signs);
            for (number, error) in self.errors.iter_mut().enumerate() {
                *error += late * (next.slope_at(number, next.start()) - self.rates[number]).abs();
            }
        }
    }

    /// The error of the time at which the arguments of the signs are zero: the time is computed to the last bit of the step, and rounded, and a
    /// rounding error of an argument shifts it by the time in which the argument changes by this error. The zero of an argument that bends there,
    /// as x − sin x does, is known to a root of the remaining value.
    fn late(&self, formulas: &mut Formulas, next: &Step<'_>, signs: &[f64]) -> f64 {
        const PART: f64 = 1.0 / 64.0;
        /// The largest order at which a zero is taken for one that is passed with a rate of change.
        const SIMPLE: f64 = 1.5;
        let apart = PART * (next.end() - next.start());
        let [here, nearer, near] = [0.0, 0.5 * apart, apart].map(|after| {
            formulas.evaluate(signs, &moment(next, next.start() + after));
            (0..signs.len()).map(|modulus| formulas.argument(modulus)).collect::<Vec<_>>()
        });
        let other = (0..signs.len()).filter(|&modulus| (signs[modulus] - self.signs[modulus]).abs() > 0.0);
        let lost = other.map(|modulus| {
            let [value, error] = here[modulus];
            let change = (near[modulus][0] - value).abs();
            let order = libm::log2(change / (nearer[modulus][0] - value).abs());
            match error > 0.0 {
                true if order > SIMPLE => {
                    apart.abs() * libm::pow((value.abs() + error) / change, 1.0 / order)
                }
                true => error * (apart / change).abs(),
                false => 0.0,
            }
        });
        ROUNDING * next.start().abs() + f64::EPSILON * self.length.abs() + lost.sum::<f64>()
    }
}

fn moment(step: &Step<'_>, time: f64) -> Moment {
    Moment { time, state: step.state_at(time) }
}

/// The accelerations and rates of change of a system, and the argument of each |…|.
#[derive(Debug)]
pub(in crate::taylor) struct Formulas {
    formulas: Linearised,
    coordinates: usize,
    moduli: usize,
}

impl Formulas {
    pub(in crate::taylor) fn new(system: &System) -> Self {
        let (coordinates, moduli) = (system.coordinates(), system.moduli());
        let formulas = Linearised::new(system.tape(), 0..coordinates + moduli, 0);
        Self { formulas, coordinates, moduli }
    }

    fn evaluate(&mut self, signs: &[f64], moment: &Moment) {
        self.formulas.evaluate(&[&moment.state[..], &[moment.time], signs].concat());
    }

    /// The value of the argument of a |…|, and its rounding error.
    fn argument(&self, modulus: usize) -> [f64; 2] {
        let formula = self.coordinates + modulus;
        [self.formulas.value(formula), self.formulas.error(formula)]
    }

    /// The signs of the arguments of each |…|, which may be nested.
    fn signs_at(&mut self, moment: &Moment) -> Vec<f64> {
        let mut signs = vec![1.0; self.moduli];
        for _ in 0..signs.len() {
            self.evaluate(&signs, moment);
            let arguments = (0..self.moduli).map(|modulus| self.argument(modulus)[0].signum());
            signs = arguments.collect();
        }
        signs
    }

    /// The rounding errors of the accelerations and rates of change, each in its unit.
    fn lost_in_forces(&mut self, signs: &[f64], moment: &Moment) -> Vec<f64> {
        self.evaluate(signs, moment);
        (0..self.coordinates).map(|coordinate| self.formulas.error(coordinate)).collect()
    }
}

/// The rounding error of a step in each state component, given those of the forces.
fn errors(step: &Step<'_>, length: f64, forces: &[f64]) -> Vec<f64> {
    // The first power has no other error than that of the force; for a coordinate it is the velocity, which is known in two words.
    let first = |number: usize| if step.layout.velocity(number).is_some() { 3 } else { 2 };
    let mut errors: Vec<f64> = (0..step.numbers())
        .map(|number| ROUNDING * terms(step, number, first(number), length) + underflow(step, number))
        .collect();
    add_forces(step, length, forces, &mut errors);
    errors
}

/// The error of a component in a step whose terms are below the range of numbers with all digits: 16 units in the last place of each, since
/// the roundings of a term grow with the terms after it. In steps of an oscillator from 1e-320 the error is up to two units for each term.
pub(in crate::taylor) fn underflow(step: &Step<'_>, number: usize) -> f64 {
    let changes = (0..2).any(|n| step.coefficient(number, n) != 0.0);
    if changes { libm::ldexp(count(step.terms), -1070) } else { 0.0 }
}

/// Adds the effect of rounding errors of the forces.
pub(in crate::taylor) fn add_forces(step: &Step<'_>, length: f64, forces: &[f64], errors: &mut [f64]) {
    for (coordinate, force) in forces.iter().enumerate() {
        let driven = step.layout.driven(coordinate);
        errors[driven] += force * length.abs();
        if driven != coordinate {
            errors[coordinate] += 0.5 * force * length * length;
        }
    }
}

/// The sum of the sizes of the terms of a component from a power on, at a distance from the start of the step.
pub(in crate::taylor) fn terms(step: &Step<'_>, number: usize, first: usize, length: f64) -> f64 {
    let h = (length / step.unit).abs();
    let horner = |sum: f64, n: usize| sum * h + step.coefficient(number, n).abs();
    let sum = (first..step.terms).rev().fold(0.0, horner);
    (0..first).fold(sum, |sum, _| sum * h)
}

/// Adds the effect of a deviation of each state component that does not enter
/// the forces: the whole effect of the deviation except its own propagation.
pub(in crate::taylor) fn add_unseen(
    layout: &StateLayout,
    unseen: impl Fn(usize) -> f64,
    growth: &Matrix,
    length: f64,
    errors: &mut [f64],
) {
    for (row, error) in errors.iter_mut().enumerate() {
        let velocity = layout.velocity(row);
        for (column, growth) in growth.row(row).iter().enumerate() {
            let by_itself = match velocity {
                _ if row == column => 1.0,
                Some(velocity) if velocity == column => length,
                _ => 0.0,
            };
            *error += (growth - by_itself).abs() * unseen(column);
        }
    }
}
