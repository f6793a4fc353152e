//! Errors of a motion at jumps and bends of forces.
//!
//! If a force jumps when a formula g passes zero, deviations before and after differ by the factor 1 + Δf·∇g/ġ, where Δf is the jump of the rate
//! of change of the state: R. I. Leine, H. Nijmeijer, *Dynamics and Bifurcations of Non-Smooth Mechanical Systems*, Springer 2004, section 7.

use super::growth::{distance, growths};
use super::matrix::Matrix;
use super::roundings_of_steps::{Formulas, RoundedStep, terms};
use super::spread::Spread;
use crate::taylor::program::linearised::Linearised;
use crate::taylor::{AcceptedStep, System};

/// The formulas and the last step, from which errors are propagated over jumps and bends of forces.
#[derive(Debug)]
pub(in crate::taylor) struct Pieces {
    pub(in crate::taylor) formulas: Formulas,
    /// Arguments of each |…|, with derivatives.
    arguments: Linearised,
    coordinates: usize,
    /// The system without events.
    plain: Option<System>,
    /// The step before.
    pub(in crate::taylor) last: Option<Middle>,
}

/// A step, in the middle of which no force jumps.
#[derive(Debug)]
pub(in crate::taylor) struct Middle {
    pub(in crate::taylor) step: RoundedStep,
    /// The spread in the middle of the step.
    pub(in crate::taylor) spread: Spread,
    /// Errors that the step has added.
    pub(in crate::taylor) added: Vec<f64>,
    /// Components that friction keeps at zero.
    pub(in crate::taylor) stuck: Vec<usize>,
    pub(in crate::taylor) signs: Vec<f64>,
    /// Rates of change of each component at the start and at the end.
    pub(in crate::taylor) rates: [Vec<f64>; 2],
    /// Distance that each component covers, with all turns.
    pub(in crate::taylor) ways: Vec<f64>,
}

/// The kind of transition between two steps.
#[derive(Debug)]
pub(in crate::taylor) enum Transition {
    /// Forces are continuous, possibly with a bend.
    Smooth,
    /// A force jumps, at a time that is rounded.
    Jump { flow: Matrix, late: Vec<f64> },
    /// Jumps whose effect is not known: of several forces, or of one whose argument hardly passes zero.
    Unknown,
}

impl Middle {
    pub(in crate::taylor) fn new(formulas: &mut Formulas, accepted: &AcceptedStep<'_>, end: f64) -> Self {
        let (stepper, step) = (accepted.stepper(), accepted.step());
        let (system, numbers) = (stepper.expander.system, 0..step.numbers());
        let signs = stepper.signs(0);
        let rates = |time: f64| numbers.clone().map(|number| step.slope_at(number, time)).collect();
        let length = end - step.start();
        Self {
            spread: Spread::none(numbers.len()),
            added: vec![],
            stuck: Self::stuck(system, &signs),
            rates: [rates(step.start()), rates(end)],
            ways: numbers.clone().map(|number| terms(step, number, 1, length)).collect(),
            step: RoundedStep::new(formulas, accepted),
            signs,
        }
    }

    /// The components that friction keeps at zero: the signs in their forces are between −1 and 1.
    pub(in crate::taylor) fn stuck(system: &System, signs: &[f64]) -> Vec<usize> {
        let stuck =
            |(modulus, sign): (usize, &f64)| system.driven_in_modulus(modulus).filter(|_| sign.abs() < 1.0);
        signs.iter().enumerate().filter_map(stuck).collect()
    }

    /// Sets the errors of components that stick to zero.
    pub(in crate::taylor) fn keep_zero(&self, spread: &mut Spread) {
        for &number in &self.stuck {
            for matrix in [&mut spread.squares, &mut spread.flow] {
                matrix.row_mut(number).fill(0.0);
            }
            (0..spread.squares.size).for_each(|row| spread.squares.row_mut(row)[number] = 0.0);
        }
    }
}

impl Pieces {
    /// The data for a system; `None` if its forces are smooth.
    pub(in crate::taylor) fn of(system: &System) -> Option<Self> {
        let (coordinates, moduli) = (system.coordinates(), system.moduli());
        if moduli == 0 && system.passage().is_none() && !system.rests() {
            return None;
        }
        let plain = || system.clone().with_events(&[]).ok()?.with_tolerances(&[]).ok();
        let inputs = system.layout().numbers() + 1;
        Some(Self {
            formulas: Formulas::new(system),
            arguments: Linearised::new(system.tape(), coordinates..coordinates + moduli, inputs),
            coordinates,
            plain: plain(),
            last: None,
        })
    }

    /// The same data with the last step of `before`, whose equations hold on both sides of the transition.
    pub(in crate::taylor) fn after(self, before: Option<Self>) -> Self {
        match before {
            Some(Self { plain, last, .. }) => Self { plain, last, ..self },
            None => self,
        }
    }

    /// The kind of transition between the last step and the next, for errors with this spread.
    pub(in crate::taylor) fn boundary(
        &mut self,
        next: &Middle,
        accepted: &AcceptedStep<'_>,
        spread: &Spread,
        (steps, scales): (f64, &[f64]),
    ) -> Transition {
        let Some(last) = &mut self.last else { return Transition::Smooth };
        let jumps: Vec<f64> = last.rates[1].iter().zip(&next.rates[0]).map(|(a, b)| b - a).collect();
        let changes = |modulus: &usize| (last.signs[*modulus] - next.signs[*modulus]).abs() > 0.0;
        let mut changed = (0..next.signs.len()).filter(changes);
        // A motion at rest covers no distance: the differences of its rates are roundings of its largest values.
        let rounding = if changed.clone().next().is_some() { ROUNDED_JUMP } else { SMALLEST_JUMP };
        let is_none = |number: usize| {
            let way = last.ways[number] + next.ways[number];
            let effect = (jumps[number] * next.step.length).abs();
            effect <= (SMALLEST_JUMP * way).max(rounding * scales[number])
        };
        if (0..jumps.len()).all(is_none) {
            return Transition::Smooth;
        }
        let (Some(modulus), None) = (changed.next(), changed.next()) else { return Transition::Unknown };
        let step = accepted.step();
        let inputs = [&step.state_at(step.start())[..], &[step.start()], &last.signs].concat();
        self.arguments.evaluate(&inputs);
        let slopes = self.arguments.slopes(self.coordinates + modulus);
        let (gradient, by_time) = slopes.split_at(jumps.len());
        let along = |rates: &[f64]| {
            by_time[0] + gradient.iter().zip(rates).map(|(slope, rate)| slope * rate).sum::<f64>()
        };
        let rate = along(&last.rates[1]);
        let off = steps.sqrt() * spread.of_sum(gradient) / rate.abs();
        let is_passed = off <= LARGEST_PART * last.step.length.abs().min(next.step.length.abs());
        if !is_passed {
            return Transition::Unknown;
        }
        let mut flow = Matrix::one(jumps.len());
        for (row, jump) in jumps.iter().enumerate() {
            let entries = flow.row_mut(row).iter_mut().zip(gradient);
            entries.for_each(|(entry, slope)| *entry += jump * slope / rate);
        }
        let before = last.step.errors.clone();
        last.step.jump(&mut self.formulas, step, &next.step.signs);
        let late = last.step.errors.iter().zip(before).map(|(after, before)| after - before).collect();
        Transition::Jump { flow, late }
    }

    /// The spread in the middle of the next step, computed from that in the middle of the last step by neighbouring motions.
    pub(in crate::taylor) fn grown(&mut self, next: &Middle, scales: &[f64]) -> Spread {
        let Some(last) = &mut self.last else { return next.spread.clone() };
        let moments = [&last.step.middle, &next.step.middle];
        let way = |number: usize| last.ways[number] + next.ways[number];
        let apart: Vec<f64> = (0..scales.len())
            .map(|number| distance(way(number), at_rest(way(number), scales[number])))
            .collect();
        let growth = self.plain.as_ref().and_then(|plain| growths(plain, &moments, &apart)?.pop());
        let mut spread = last.spread.clone();
        let Some(growth) = growth else {
            spread.forget();
            return spread;
        };
        let mut before = Spread::none(growth.size);
        before.blur(&last.added);
        before.pass(&growth);
        spread.pass(&growth);
        spread.blur(&last.added);
        spread.add(before);
        spread
    }
}

/// The size that sets the distance of neighbouring motions in a component, which is this one where it covers no distance.
fn at_rest(way: f64, scale: f64) -> f64 {
    if way > 0.0 { 0.0 } else { scale }
}

/// Smallest effect of a jump on a step, relative to the distance that a component covers; a smaller one is rounding.
const SMALLEST_JUMP: f64 = 1e-10;

/// Smallest effect of a jump where an argument of a |…| changes its sign, relative to the largest size of the component: four roundings.
const ROUNDED_JUMP: f64 = 4.0 * f64::EPSILON;

/// Largest error of the time of a zero, relative to the adjacent steps, at which the zero counts as passed.
const LARGEST_PART: f64 = 1e-3;
