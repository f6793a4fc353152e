//! Rates of change of an autonomous state with their derivatives, for the phase condition of orbits and for equilibria.
//!
//! # Method
//! Without a drive the period is an additional unknown, and the turning of the first coordinate at the start an additional equation. The
//! multipliers are those of the return to such turning points: projected along the motion, the map has the multiplier 0 instead of the 1 of
//! every autonomous motion. This 0 is far from all other test values, so that folds are determined as sharply as with a drive. If the start of a
//! cycle lies on a repelling part of the orbit, as in a canard, the cycle begins at another of its turning points.

use super::error::BranchError;
use libration_motion::taylor::StateLayout;
use libration_numbers::algebra::Doubles;
use libration_numbers::{
    expression::{Equation, Expression, Symbol},
    internals::expression::{Jet, Tape},
};

/// The rates of all components of a state, over the symbolic parameters.
#[derive(Clone, Debug)]
pub(super) struct Field {
    /// The rates, then the derivatives of each with respect to the components of the state and to the parameters.
    tape: Tape,
    numbers: usize,
    inputs: usize,
}

/// The rates of a state, and by rows their derivatives with respect to its components and then to the parameters.
pub(super) struct Rates {
    pub(super) rates: Vec<f64>,
    pub(super) slopes: Vec<Vec<f64>>,
}

impl Field {
    pub(super) fn new(equation: &Equation, parameters: &[&str]) -> Result<Self, BranchError> {
        let layout = StateLayout::new(equation);
        let state = layout.symbols(equation.variables());
        let mut rates = vec![Expression::from(0); layout.numbers()];
        for (coordinate, derivative) in equation.derivatives().iter().enumerate() {
            if let Some(velocity) = layout.velocity(coordinate) {
                rates[coordinate] = Expression::Symbol(state[velocity].clone());
            }
            rates[layout.driven(coordinate)] = derivative.clone();
        }
        let inputs: Vec<Symbol> =
            state.into_iter().chain(parameters.iter().map(|name| Symbol::plain(name))).collect();
        let slopes =
            rates.iter().flat_map(|rate| inputs.iter().map(|input| rate.derivative(input).simplified()));
        let formulas: Vec<Expression> = rates.iter().cloned().chain(slopes).collect();
        let tape = Tape::new(&formulas.iter().collect::<Vec<_>>(), &inputs)?;
        Ok(Self { tape, numbers: rates.len(), inputs: inputs.len() })
    }

    pub(super) fn at(&self, state: &[f64], parameters: &[f64]) -> Option<Rates> {
        let inputs: Vec<f64> = state.iter().chain(parameters).copied().collect();
        let jet = Jet::new(&Doubles, &self.tape, &inputs).ok()?;
        let value = |formula: usize| jet.result(formula)[0];
        let row = |i: usize| (0..self.inputs).map(|j| value(self.numbers + i * self.inputs + j)).collect();
        let rates: Vec<f64> = (0..self.numbers).map(value).collect();
        let slopes: Vec<Vec<f64>> = (0..self.numbers).map(row).collect();
        let all = rates.iter().chain(slopes.iter().flatten());
        all.copied().all(f64::is_finite).then_some(Rates { rates, slopes })
    }
}

/// The derivative of the return to a phase condition with these slopes: the result of the map is moved along the motion until it satisfies the
/// condition. Its eigenvalues are those of the map, except that the 1 of a deviation along the motion is a 0.
pub(super) fn returned(map: &[Vec<f64>], rate: &[f64], slopes: &[f64]) -> Option<Vec<Vec<f64>>> {
    let across: f64 = rate.iter().zip(slopes).map(|(a, b)| a * b).sum();
    let column = |j: usize| map.iter().zip(slopes).map(|(row, slope)| row[j] * slope).sum::<f64>() / across;
    let along: Vec<f64> = (0..map.len()).map(column).collect();
    let row = |(row, rate): (&Vec<f64>, &f64)| row.iter().zip(&along).map(|(x, a)| x - rate * a).collect();
    (across.abs() > 0.0).then(|| map.iter().zip(rate).map(row).collect())
}
