//! Errors of each state component, along the steps of its motion.
//!
//! # Method
//! Errors are propagated with the steps: the rounding errors of a step, as in `ending.rs`, and the truncation error of its series, estimated
//! from the sizes of the last terms (`sizes_of_terms.rs`). Each error is propagated by the linearised equations, whose flow over a step is the
//! exponential of Magnus's series at three Gauss nodes (`propagator.rs`). The covariance of all errors (`spread.rs`) times the number of steps
//! bounds a sum of errors of the same sign. At a jump of a force, deviations change by a saltation matrix; if that is not valid, by differences
//! of neighbouring motions (`pieces.rs`). The cost is two to ten microseconds per step.

use std::sync::Arc;

use super::crossing::Crossing;
use super::matrix::Matrix;
use super::pieces::{Middle, Pieces, Transition};
use super::propagator::Propagator;
use super::roundings_of_steps::{add_forces, add_unseen, terms, underflow};
use super::spread::Spread;
use crate::taylor::drivers::gradients::Gradients;
use crate::taylor::drivers::stepper::Stepper;
use crate::taylor::program::linearised::{ROUNDING, half_ulp};
use crate::taylor::step::sizes_of_terms::SizesOfTerms;
use crate::taylor::{AcceptedStep, Contact, Effort, Moment, StateLayout, Step, System};
use libration_numbers::expression::Expression;

/// The errors of a motion, updated with each of its steps.
///
/// # Accuracy
/// An estimate, not a proven bound. Two errors of each step are added up: the truncation error of its series, estimated from the last terms, and
/// the rounding errors, bounded from the terms and from each operation of the forces. They are propagated like small deviations, by the
/// linearised equations of motion, or next to jumps and bends of a force by motions that begin a small distance apart. The sum is that of errors
/// of the same sign: by the inequality of Cauchy and Schwarz the square root of the number of steps times the sum of squares. In 60 chaotic and
/// regular motions the actual error of every sample is below the estimate, which is some hundred times as large in the median. Motions that pass
/// next to a saddle again and again have larger estimates, since errors of the same sign are never assumed to cancel there.
///
/// If the error of a component exceeds a tenth of its largest size so far, the
/// motion is no longer determined, and no errors are given from that time on.
///
/// # Examples
/// ```
/// # extern crate libration_motion as libration;
/// use libration::taylor::{Effort, Start, StateErrors, System, integrate_from};
/// use std::ops::ControlFlow;
/// let system = System::new(&"x'' = -x".parse()?)?;
/// let (start, effort) = (system.start(&[("x", 1.0)])?, Effort::to_tolerance(1e-12));
/// let mut errors = StateErrors::new(&system, &start, &effort);
/// let end = integrate_from(&system, &Start::State(start), &[50.0], &effort, |step| {
///     errors.follow(step);
///     ControlFlow::Continue(())
/// })?.end;
/// let error = errors.at(&end).unwrap()[0];
/// assert!((end.state[0] - 50f64.cos()).abs() < error && error < 1e-11);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct StateErrors {
    pub(in crate::taylor) start: Moment,
    tolerance: f64,
    /// Layout of the present equations; they change when a component comes to rest.
    layout: Arc<StateLayout>,
    propagator: Propagator,
    /// `true` if steps may pass positions at which a force has no series.
    passes: bool,
    /// Forces with jumps and bends.
    pub(in crate::taylor) pieces: Option<Pieces>,
    pub(in crate::taylor) crossings: Vec<(usize, Contact, Vec<Crossing>)>,
    /// Formulas whose errors are estimated as well.
    pub(in crate::taylor) formulas: Option<Gradients>,
    /// Number of steps that have added to the errors.
    pub(in crate::taylor) steps: f64,
    /// The spreads at the start of the last step, and at its end.
    pub(in crate::taylor) spreads: [Spread; 2],
    bounds: [Vec<f64>; 2],
    /// Errors that the last step has added.
    added: Vec<f64>,
    /// Buffer for the derivatives of the state.
    flow: Matrix,
    /// The component that is the rate of change of each: its velocity, or v in the equations x' = v; v' = ….
    rates: Vec<Option<usize>>,
    /// The largest size of each component so far.
    pub(in crate::taylor) scales: Vec<f64>,
    /// The time of the last state that is determined.
    pub(in crate::taylor) reached: f64,
    pub(in crate::taylor) is_lost: bool,
}

impl StateErrors {
    /// Maximum number of state components for which errors are computed; the time of this computation grows with the third power of the number.
    pub const MOST_COMPONENTS: usize = 64;

    /// The errors of a motion that begins exactly in this state.
    #[must_use]
    pub fn new(system: &System, start: &Moment, effort: &Effort) -> Self {
        let numbers = system.layout().numbers();
        let mut errors = Self {
            start: start.clone(),
            tolerance: effort.relative,
            layout: Arc::clone(system.shared_layout()),
            propagator: Propagator::new(system),
            passes: system.passage().is_some(),
            pieces: None,
            crossings: vec![],
            formulas: None,
            steps: 0.0,
            spreads: [Spread::none(numbers), Spread::none(numbers)],
            bounds: [vec![0.0; numbers], vec![0.0; numbers]],
            added: vec![0.0; numbers],
            flow: Matrix::zero(numbers),
            rates: rates(system),
            scales: start.state.iter().map(|value| value.abs()).collect(),
            reached: start.time,
            is_lost: false,
        };
        errors.pieces = Pieces::of(system);
        errors
    }

    /// The same errors, and those of formulas of the state.
    #[must_use]
    pub fn with_formulas(self, formulas: Gradients) -> Self {
        Self { formulas: Some(formulas), ..self }
    }

    /// The error of each state component at a time of the last step, or at the start; `None` if the motion is not determined.
    #[must_use]
    pub fn at(&self, moment: &Moment) -> Option<Vec<f64>> {
        if self.is_lost {
            return None;
        }
        if (moment.time - self.start.time).abs() <= 0.0 {
            return Some(vec![0.0; self.scales.len()]);
        }
        // Inside a step, errors hardly exceed the errors at its ends.
        let [before, after] = &self.bounds;
        let bounds = before.iter().zip(after).zip(&moment.state);
        Some(bounds.map(|((a, b), value)| a.max(*b) + ROUNDING * value.abs()).collect())
    }

    /// The time of the last state that is determined in double precision; `None` as long as all are.
    #[must_use]
    pub fn determined_until(&self) -> Option<f64> {
        self.is_lost.then_some(self.reached)
    }

    /// The change of the last state that is determined, due to half a unit in the last place of each component of the start.
    #[must_use]
    pub fn effect_of_start(&self) -> Moment {
        let half_ulps: Vec<f64> = self.start.state.iter().map(|value| half_ulp(*value)).collect();
        let [before, after] = &self.spreads;
        let flow = if self.is_lost { &before.flow } else { &after.flow };
        let effect =
            |row: usize| flow.row(row).iter().zip(&half_ulps).map(|(slope, half)| (slope * half).abs()).sum();
        Moment { time: self.reached, state: (0..flow.size).map(effect).collect() }
    }

    /// Updates the errors with the next step.
    pub fn follow(&mut self, accepted: &AcceptedStep<'_>) {
        let (stepper, step) = (accepted.stepper(), accepted.step());
        let end = accepted.ended_at().unwrap_or(step.end());
        let is_short = (end - step.start()).abs() == 0.0;
        if self.is_lost || is_short {
            return;
        }
        let system = stepper.expander.system;
        let is_new = !Arc::ptr_eq(&self.layout, system.shared_layout());
        if is_new {
            self.change_equations(system);
        }
        self.steps += 1.0;
        let [before, after] = &mut self.spreads;
        before.clone_from(after);
        match self.pieces.take() {
            Some(mut pieces) => {
                self.go_by_halves(&mut pieces, accepted, end, is_new);
                self.pieces = Some(pieces);
            }
            None => self.go(stepper, step, end),
        }
        self.settle(stepper, step, end);
    }

    /// The spread at a time of the last step; at its start, that before a velocity comes to rest or a force jumps there.
    pub(in crate::taylor) fn spread_at(
        &mut self,
        stepper: &Stepper<'_, 1>,
        step: &Step<'_>,
        time: f64,
    ) -> Spread {
        let middle = self.pieces.as_ref().and_then(|pieces| pieces.last.as_ref());
        let middle = middle.filter(|_| (time - step.start()).abs() > 0.0);
        let start = (step.start(), &self.spreads[0]);
        let (from, spread) = middle.map_or(start, |middle| (middle.step.middle.time, &middle.spread));
        let mut spread = spread.clone();
        self.propagator.between(stepper, step, [from, time], &mut self.flow);
        spread.pass(&self.flow);
        spread.blur(&self.added);
        spread
    }

    fn change_equations(&mut self, system: &System) {
        self.layout = Arc::clone(system.shared_layout());
        self.propagator = Propagator::new(system);
        self.crossings.clear();
        let before = self.pieces.take();
        self.pieces = Pieces::of(system).map(|pieces| pieces.after(before));
    }

    /// Propagates the errors over a step of smooth forces.
    fn go(&mut self, stepper: &Stepper<'_, 1>, step: &Step<'_>, end: f64) {
        let length = end - step.start();
        self.propagator.between(stepper, step, [step.start(), end], &mut self.flow);
        self.set_added(step, length, ROUNDING);
        self.add_unseen(step, length);
        add_forces(step, length, &self.propagator.lost, &mut self.added);
        self.spreads[1].pass(&self.flow);
        self.spreads[1].blur(&self.added);
    }

    /// Propagates the errors from the start of a step to its middle, and on to its end, including a jump or bend of forces at its start.
    fn go_by_halves(&mut self, pieces: &mut Pieces, accepted: &AcceptedStep<'_>, end: f64, is_new: bool) {
        let (stepper, step) = (accepted.stepper(), accepted.step());
        let mut middle = Middle::new(&mut pieces.formulas, accepted, end);
        let time = middle.step.middle.time;
        self.propagator.between(stepper, step, [step.start(), time], &mut self.flow);
        self.set_added(step, end - step.start(), 0.0);
        self.add_unseen(step, time - step.start());
        let is_known = !is_new && self.flow.is_finite();
        let boundary = pieces.boundary(&middle, accepted, &self.spreads[1], (self.steps, &self.scales));
        match if is_known || pieces.last.is_none() { boundary } else { Transition::Unknown } {
            Transition::Smooth => self.spreads[1].pass(&self.flow),
            Transition::Jump { flow, late } => {
                self.spreads[1].pass(&flow);
                self.spreads[1].blur(&late);
                self.spreads[1].pass(&self.flow);
            }
            Transition::Unknown => self.spreads[1] = pieces.grown(&middle, &self.scales),
        }
        middle.keep_zero(&mut self.spreads[1]);
        middle.spread.clone_from(&self.spreads[1]);
        self.propagator.between(stepper, step, [time, end], &mut self.flow);
        self.spreads[1].pass(&self.flow);
        self.add_unseen(step, end - time);
        self.added.iter_mut().zip(&middle.step.errors).for_each(|(added, error)| *added += error);
        middle.stuck.iter().for_each(|&number| self.added[number] = 0.0);
        self.spreads[1].blur(&self.added);
        middle.keep_zero(&mut self.spreads[1]);
        middle.added.clone_from(&self.added);
        pieces.last = Some(middle);
    }

    /// Sets the errors that a step adds: the truncation of its series, and a fraction `rounding` of its terms.
    fn set_added(&mut self, step: &Step<'_>, length: f64, rounding: f64) {
        for (number, added) in self.added.iter_mut().enumerate() {
            let sizes = SizesOfTerms::new(step, number, length);
            // Steps that pass a position without a series have two terms and a separate error.
            let truncation =
                || if self.passes { self.tolerance * terms(step, number, 1, length) } else { 0.0 };
            *added = rounding * sizes.rounded
                + sizes.left_out.unwrap_or_else(truncation)
                + underflow(step, number);
        }
    }

    /// Adds the effect of the second words of the state, which do not enter the forces, in a part of a step.
    fn add_unseen(&mut self, step: &Step<'_>, length: f64) {
        add_unseen(&self.layout, |number| step.low(number).abs(), &self.flow, length, &mut self.added);
    }

    /// Keeps the errors at the end of a step, if the motion is determined there.
    fn settle(&mut self, stepper: &Stepper<'_, 1>, step: &Step<'_>, end: f64) {
        /// Largest error of a component, relative to its largest size, at which the motion is determined.
        const MOST: f64 = 0.1;
        let is_whole = (end - step.end()).abs() == 0.0;
        self.bounds.swap(0, 1);
        self.keep_bounds();
        for (number, size) in self.scales.iter_mut().enumerate() {
            let last = if is_whole { stepper.next[number].high[0] } else { step.number_at(number, end) };
            *size = size.max(step.coefficient(number, 0).abs()).max(last.abs());
        }
        let length = (end - step.start()).abs();
        let is_known = |(number, bound): (usize, &f64)| *bound <= MOST * self.size_of(number, length);
        self.is_lost = !self.bounds[1].iter().enumerate().all(is_known);
        if !self.is_lost {
            self.reached = end;
        }
    }

    /// The largest size of a component so far. A component that has hardly left zero is compared with a billionth of its velocity times the
    /// length of the step or, for a velocity, of its coordinate divided by that length.
    fn size_of(&self, number: usize, length: f64) -> f64 {
        const PART: f64 = 1e-9;
        let of_rate = self.rates[number].map_or(0.0, |rate| self.scales[rate] * length);
        let integral = self.rates.iter().position(|rate| *rate == Some(number));
        let other = integral.map_or(of_rate, |integral| of_rate.max(self.scales[integral] / length));
        // Components that are zero so far, such as derivatives by the stiffness of a spring that is not yet touched, are determined with their
        // errors, and so are numbers below the range of those with all digits.
        let size = self.scales[number].max(PART * other);
        if size == 0.0 { f64::INFINITY } else { size.max(f64::MIN_POSITIVE) }
    }

    /// Stores the errors at the end of the last step.
    pub(in crate::taylor) fn keep_bounds(&mut self) {
        let (scale, spread) = (self.steps.sqrt(), &self.spreads[1]);
        self.bounds[1].iter_mut().enumerate().for_each(|(number, bound)| *bound = scale * spread.of(number));
    }
}

/// The component that equals the rate of change of each, if there is one.
fn rates(system: &System) -> Vec<Option<usize>> {
    let (layout, equation) = (system.layout(), system.equation());
    let symbols = layout.symbols(equation.variables());
    let rate = |number: usize| match (layout.velocity(number), layout.driving(number)) {
        (None, Some(coordinate)) => {
            let formula = &equation.derivatives()[coordinate];
            symbols.iter().position(|symbol| *formula == Expression::Symbol(symbol.clone()))
        }
        (velocity, _) => velocity,
    };
    (0..layout.numbers()).map(rate).collect()
}
