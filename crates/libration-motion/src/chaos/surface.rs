//! The side of a surface on which a motion is, where that exceeds the errors of the motion.
//!
//! At a level that a motion only touches, its errors carry it across and back. A zero of the formula counts as a crossing if the formula is
//! farther from zero than its error, with opposite signs, before and after it; the error grows with the number of steps.

use crate::taylor::program::linearised::{Linearised, ROUNDING};
use crate::taylor::{AcceptedStep, Contact, Direction, Moment, MomentErrors, StateErrors, Step, System};
use libration_numbers::expression::{Expression, Symbol, WithoutValue};
use libration_numbers::internals::expression::Tape;

/// A point of the motion on the surface.
pub(super) struct SurfaceCrossing {
    pub(super) moment: Moment,
    /// Its errors; `None` if they were not requested or the motion is not determined.
    pub(super) errors: Option<MomentErrors>,
}

/// A surface along a motion.
pub(super) struct Surface {
    formula: Linearised,
    direction: Direction,
    /// The tolerance of a step.
    tolerance: f64,
    /// The number of steps so far.
    steps: f64,
    /// The sign of the formula where it last exceeded its error; zero before.
    side: f64,
    /// The largest magnitude of the formula on this side.
    farthest: f64,
    /// The last zero since then.
    open: Option<SurfaceCrossing>,
}

impl Surface {
    pub(super) fn new(
        system: &System,
        formula: &Expression,
        direction: Direction,
        tolerance: f64,
    ) -> Result<Self, WithoutValue> {
        let equation = system.equation();
        let symbols = system.layout().symbols(equation.variables());
        let inputs: Vec<Symbol> = symbols.into_iter().chain([Symbol::plain("t")]).collect();
        let tape = Tape::new(&[&equation.with_rates(formula)], &inputs)?;
        let formula = Linearised::new(&tape, 0..1, inputs.len());
        let tolerance = tolerance.max(4.0 * f64::EPSILON);
        Ok(Self { formula, direction, tolerance, steps: 0.0, side: 0.0, farthest: 0.0, open: None })
    }

    /// The crossings that are established in a step, with the errors of the motion up to its end.
    pub(super) fn crossings_in(
        &mut self,
        accepted: &AcceptedStep<'_>,
        mut errors: Option<&mut StateErrors>,
    ) -> Vec<SurfaceCrossing> {
        let (step, mut from, mut crossings) = (accepted.step(), accepted.step().start(), vec![]);
        let goes_through = |contact| matches!(contact, Contact::Rising | Contact::Falling);
        for event in accepted.events().iter().filter(|event| goes_through(event.contact)) {
            crossings.extend(self.established_at(step, 0.5 * (from + event.time)));
            let moment = Moment { time: event.time, state: event.state.clone() };
            let errors = errors.as_mut().and_then(|errors| errors.of_event(accepted, event));
            self.open = Some(SurfaceCrossing { moment, errors });
            from = event.time;
        }
        for time in [0.5 * (from + step.end()), step.end()] {
            crossings.extend(self.established_at(step, time));
        }
        self.steps += 1.0;
        crossings
    }

    /// The last zero, if the formula has the other sign since then and exceeds its error at this time.
    fn established_at(&mut self, step: &Step<'_>, time: f64) -> Option<SurfaceCrossing> {
        let inputs = [step.state_at(time), vec![time]].concat();
        self.formula.evaluate(&inputs);
        let value = self.formula.value(0);
        let is_known = value.abs() > self.error(&inputs);
        if !is_known {
            return None;
        }
        let changes = value * self.side < 0.0;
        self.farthest = if changes { value.abs() } else { self.farthest.max(value.abs()) };
        self.side = value.signum();
        let counts = match self.direction {
            Direction::Any => true,
            Direction::Rising => value > 0.0,
            Direction::Falling => value < 0.0,
        };
        self.open.take().filter(|_| changes && counts)
    }

    /// The error of the formula: those of all steps, as a part of its size, and its rounding error in this state.
    fn error(&self, inputs: &[f64]) -> f64 {
        let slopes = self.formula.slopes(0).iter().zip(inputs);
        let of_state: f64 = slopes.map(|(slope, input)| ROUNDING * (slope * input).abs()).sum();
        self.tolerance * self.steps * self.farthest + 2.0 * (self.formula.error(0) + of_state)
    }
}
