//! Formulas of the state and the time with their gradients, and the errors of their values from those of the state.
//!
//! # Method
//! To first order, the errors of a state change a formula by its gradient; the caller multiplies this by the covariance of the errors, so that
//! errors along a motion do not change its energy. The remaining error is computed with one component displaced by its error: the change of the
//! formula beyond first order, and half the change of its other derivatives. Rounding errors of the formula are bounded operation by operation.

use crate::taylor::program::linearised::{Linearised, ROUNDING};
use crate::taylor::{Moment, Sensitivities};
use libration_numbers::internals::expression::Tape;

/// Formulas of the state and the time with their derivatives, for [`StateErrors`](crate::taylor::StateErrors).
#[derive(Clone, Debug)]
pub struct Gradients {
    linearised: Linearised,
    formulas: usize,
    /// The index in the integrated state of each component that the formulas can contain.
    places: Vec<usize>,
    /// The inputs that occur in the formulas.
    inputs: Vec<usize>,
}

/// The values of all formulas at one point, with the bounds of their rounding errors and their derivatives.
struct Evaluated {
    values: Vec<f64>,
    roundings: Vec<f64>,
    slopes: Vec<Vec<f64>>,
}

impl Gradients {
    /// The formulas of a tape whose inputs are the components of a state, then the time.
    pub(crate) fn new(tape: &Tape, formulas: usize, components: usize) -> Self {
        let linearised = Linearised::new(tape, 0..formulas, components + 1);
        let inputs = linearised.inputs().collect();
        Self { linearised, formulas, places: (0..components).collect(), inputs }
    }

    /// The same formulas for a state that is integrated together with its sensitivities.
    #[must_use]
    pub fn among(self, sensitivities: &Sensitivities) -> Self {
        let slots = (0..self.places.len()).map(|component| sensitivities.index(0, component)).collect();
        Self { places: slots, ..self }
    }

    /// The number of formulas.
    pub(in crate::taylor) fn count(&self) -> usize {
        self.formulas
    }

    /// The bounds of the rounding errors of the formulas at this moment.
    pub(in crate::taylor) fn roundings(&mut self, at: &Moment) -> Vec<f64> {
        let inputs = self.inputs_at(at);
        self.evaluated(&inputs).roundings
    }

    /// The errors of the formulas for these errors of time and state; `first_order` contains the
    /// errors to first order from the derivatives with respect to the state and to the time.
    pub(in crate::taylor) fn errors(
        &mut self,
        at: &Moment,
        of: &Moment,
        first_order: impl Fn(&[f64], f64) -> f64,
    ) -> Vec<f64> {
        let (inputs, off) = (self.inputs_at(at), self.inputs_at(of));
        let here = self.evaluated(&inputs);
        let mut rest = vec![0.0; self.formulas];
        for input in self.inputs.clone() {
            if off[input].abs() > 0.0 {
                let sides = [off[input], -off[input]].map(|off| {
                    let mut beside = inputs.clone();
                    beside[input] += off;
                    self.evaluated(&beside)
                });
                rest.iter_mut().enumerate().for_each(|(formula, rest)| {
                    let [above, below] = &sides;
                    let of_side = |side| here.left_by_first_order(side, formula, input, &inputs, &off);
                    // Next to the boundary of its domain a formula has values on one side only.
                    *rest += of_side(above).max(of_side(below));
                });
            }
        }
        let error = |(formula, rest): (usize, f64)| {
            let mut gradient = vec![0.0; at.state.len()];
            let mut rounded = 0.0;
            for (component, number) in self.places.iter().enumerate() {
                if off[component].abs() > 0.0 {
                    gradient[*number] = here.slopes[formula][component];
                    rounded += ROUNDING * (gradient[*number] * inputs[component]).abs();
                }
            }
            let by_time = here.slopes[formula][self.places.len()];
            first_order(&gradient, by_time) + rest + rounded + here.roundings[formula]
        };
        rest.into_iter().enumerate().map(error).collect()
    }

    fn inputs_at(&self, moment: &Moment) -> Vec<f64> {
        self.places.iter().map(|number| moment.state[*number]).chain([moment.time]).collect()
    }

    fn evaluated(&mut self, inputs: &[f64]) -> Evaluated {
        self.linearised.evaluate(inputs);
        let of = &self.linearised;
        Evaluated {
            values: (0..self.formulas).map(|formula| of.value(formula)).collect(),
            // The library and the series that compute the printed value may differ by a rounding error.
            roundings: (0..self.formulas).map(|formula| 2.0 * of.error(formula)).collect(),
            slopes: (0..self.formulas).map(|formula| of.slopes(formula).to_vec()).collect(),
        }
    }
}

impl Evaluated {
    /// The part of the change of a formula, with one input displaced to one side by its error, that its derivatives do not explain.
    fn left_by_first_order(
        &self,
        side: &Self,
        formula: usize,
        input: usize,
        inputs: &[f64],
        off: &[f64],
    ) -> f64 {
        let [slopes, others] = [self, side].map(|at| &at.slopes[formula]);
        let change = (side.values[formula] - self.values[formula]).abs();
        let explained = slopes[input].abs() * (off[input].abs() + f64::EPSILON * inputs[input].abs());
        let rounded = side.roundings[formula] + self.roundings[formula];
        let cross = |other: usize| 0.5 * ((others[other] - slopes[other]) * off[other]).abs();
        let crossed: f64 =
            (0..off.len()).filter(|other| *other != input && off[*other] > 0.0).map(cross).sum();
        let rest = change - explained - rounded;
        if rest < 0.0 { crossed } else { rest + crossed }
    }
}
