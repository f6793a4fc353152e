//! The phases of a motion: stretches of time in which each |…| and sign keeps its side of zero, or is kept at zero by friction.

use std::ops::ControlFlow;

use super::batch::{Batch, Observer};
use super::stepper::Stepper;
use crate::taylor::step::sign_change::{first_sign_change, scaled};
use crate::taylor::{Effort, IntegrationError, System, Trajectory};
use libration_kernels::elementary::count;

/// The side of zero on which the argument of a |…| or a sign is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Side {
    Below,
    /// Kept at zero by friction.
    Zero,
    Above,
}

impl Side {
    /// The sign of an argument on this side.
    pub(crate) fn sign(self) -> f64 {
        match self {
            Self::Below => -1.0,
            Self::Zero => 0.0,
            Self::Above => 1.0,
        }
    }
}

/// An argument at the end of a phase.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Approach {
    pub(crate) value: f64,
    /// First and second derivative by the time.
    pub(crate) slopes: [f64; 2],
    /// The sum of the sizes of the terms of the value.
    pub(crate) size: f64,
}

/// A stretch of a motion.
#[derive(Clone, Debug)]
pub(crate) struct Phase {
    pub(crate) end: f64,
    /// The side of each argument.
    pub(crate) sides: Vec<Side>,
    /// Each argument at the end.
    pub(crate) ending: Vec<Approach>,
    /// Arguments that come to zero and turn back, with the time.
    pub(crate) touching: Vec<(usize, f64)>,
}

/// Largest value that counts as zero, relative to the sizes of its terms: 1e4 rounding errors of a state.
pub(crate) const NEAR_ZERO: f64 = 1e-12;

/// The phases of a motion to the last of its times.
///
/// # Errors
/// As those of the integration.
pub(crate) fn phases(
    system: &System,
    trajectory: &Trajectory<'_>,
    effort: &Effort,
    each: &mut dyn FnMut() -> ControlFlow<()>,
) -> Result<Vec<Phase>, IntegrationError> {
    let mut phases: Vec<Phase> = vec![];
    let mut record = |stepper: &Stepper<'_, 1>| {
        if (stepper.block.end[0] - stepper.block.start[0]).abs() > 0.0 {
            add(&mut phases, stepper);
        }
        each()
    };
    let outcomes = Batch::<1>::new(system, effort)
        .integrate(std::slice::from_ref(trajectory), Observer::Steps(&mut |_, taken| record(taken.stepper)));
    outcomes.into_iter().next().expect("one motion has one outcome")?;
    Ok(phases)
}

/// Adds a step to the phases.
fn add(phases: &mut Vec<Phase>, stepper: &Stepper<'_, 1>) {
    let moduli = 0..stepper.expander.system.moduli();
    let sides: Vec<Side> = moduli.clone().map(|modulus| side(stepper, modulus)).collect();
    let arguments: Vec<Vec<f64>> = moduli.clone().map(|modulus| argument(stepper, modulus)).collect();
    let (start, end) = (stepper.block.start[0], stepper.block.end[0]);
    let before = phases.last().map(|last| last.sides.clone());
    let goes_on = |modulus: usize| before.as_ref().is_some_and(|before| before[modulus] == sides[modulus]);
    let touching = moduli.clone().filter(|&modulus| sides[modulus] != Side::Zero).filter_map(|modulus| {
        let part = touches(&arguments[modulus], goes_on(modulus))?;
        Some((modulus, start + part * (end - start)))
    });
    let touching: Vec<(usize, f64)> = touching.collect();
    let ending: Vec<Approach> = arguments.iter().map(|terms| approach(terms, end - start)).collect();
    match phases.last_mut() {
        Some(last) if last.sides == sides => {
            (last.end, last.ending) = (end, ending);
            last.touching.extend(touching);
        }
        _ => phases.push(Phase { end, sides, ending, touching }),
    }
}

/// The side in a step; the sign of an argument at zero is between −1 and 1, or varies.
fn side(stepper: &Stepper<'_, 1>, modulus: usize) -> Side {
    let series = &stepper.block[stepper.expander.sign(&stepper.block, modulus)];
    let varies = series[1..].iter().any(|c| c[0].abs() > 0.0);
    match series[0][0] {
        sign if varies || sign.abs() < 1.0 => Side::Zero,
        sign if sign > 0.0 => Side::Above,
        _ => Side::Below,
    }
}

/// The terms of an argument at the end of a step.
fn argument(stepper: &Stepper<'_, 1>, modulus: usize) -> Vec<f64> {
    let block = &stepper.block;
    let series = block[stepper.expander.argument(modulus)].iter().map(|c| c[0]);
    scaled(series, (block.end[0] - block.start[0]) / block.unit[0])
}

/// The terms of the derivative, in powers of the fraction of the step.
fn derivative(terms: &[f64]) -> Vec<f64> {
    terms.iter().enumerate().skip(1).map(|(n, term)| count(n) * term).collect()
}

fn size(terms: &[f64]) -> f64 {
    terms.iter().map(|term| term.abs()).sum()
}

fn approach(terms: &[f64], length: f64) -> Approach {
    let first = derivative(terms);
    let slope = first.iter().sum::<f64>() / length;
    let bend = derivative(&first).iter().sum::<f64>() / (length * length);
    Approach { value: terms.iter().sum(), slopes: [slope, bend], size: size(terms) }
}

/// The fraction of a step after which its argument turns back at zero; `goes_on` if the argument had the same side in the step before.
fn touches(terms: &[f64], goes_on: bool) -> Option<f64> {
    /// Fraction of a step that begins at zero in which a turn is due to the rounding of its first terms.
    const BEGINNING: f64 = 1e-6;
    let near = NEAR_ZERO * size(terms);
    let begins_at_zero = terms.first()?.abs() <= near;
    if begins_at_zero && goes_on {
        return Some(0.0);
    }
    let turn = first_sign_change(&derivative(terms))?;
    let value = terms.iter().rev().fold(0.0, |sum, term| sum * turn + term);
    let counts = value.abs() <= near && !(begins_at_zero && turn <= BEGINNING);
    counts.then_some(turn)
}
