//! The acceleration of one coordinate, and its rounding errors.

use super::path::Path;
use libration_kernels::double_double::DoubleDouble;
use libration_numbers::algebra::{BigFloat, Doubles, Floats, Ring};
use libration_numbers::{
    expression::{Equation, Expression, Symbol, WithoutValue},
    internals::expression::{Jet, Operation, Tape},
};

/// The acceleration as a function of position and velocity.
#[derive(Debug)]
pub struct Acceleration {
    pub tape: Tape,
    /// `true` if the acceleration depends on the position only, so that an energy is conserved.
    pub(super) is_free_of_velocity: bool,
    /// `true` if the acceleration is the same for the opposite velocity, so that motions retrace their paths.
    pub(super) is_reversible: bool,
}

/// The rounding errors of the acceleration on a closed path.
pub(super) struct Roundings {
    /// The largest error, relative to the largest acceleration.
    pub(super) relative: f64,
    /// The change of the energy by errors of the acceleration on half of the path, or by the rounding of a position.
    pub(super) energy: f64,
}

/// Number of states at which the rounding error is measured.
const LOOKS: usize = 8;
/// Precision in bits that resolves the rounding of double precision.
const PRECISION: usize = 128;

impl Acceleration {
    /// The acceleration of the only coordinate.
    pub fn new(equation: &Equation) -> Result<Self, WithoutValue> {
        let name = equation.variables().first().map_or("", String::as_str);
        let velocity = Symbol::plain(name).with_primes(1);
        let formula = &equation.accelerations()[0];
        let tape = Tape::new(&[formula], &[Symbol::plain(name), velocity.clone()])?;
        let is_free_of_velocity = !formula.contains(&velocity);
        let is_reversible = is_free_of_velocity || is_even(formula, &velocity);
        Ok(Self { tape, is_free_of_velocity, is_reversible })
    }

    /// Returns `true` if the formula contains neither |…| nor sign(…), which have no derivative at zero.
    pub(super) fn is_smooth(&self) -> bool {
        let kink = |operation: &Operation| matches!(operation, Operation::Abs(_) | Operation::Sign(_));
        let operations = self.tape.operations().iter().enumerate();
        !operations.into_iter().any(|(slot, operation)| kink(operation) && !self.tape.is_constant(slot))
    }

    /// The acceleration at a state; NaN if it has no value.
    pub(super) fn at(&self, state: &[f64]) -> f64 {
        Jet::new(&Doubles, &self.tape, state).map_or(f64::NAN, |jet| jet.result(0)[0])
    }

    /// Returns `true` if the acceleration has a value that double precision cannot represent.
    pub(super) fn is_too_large(&self, state: &[f64]) -> bool {
        self.tape.overflows_at(state)
    }

    /// The rounding errors of the acceleration on a closed path.
    pub(super) fn roundings(&self, path: &Path) -> Roundings {
        let states: Vec<Vec<f64>> = path.states().collect();
        let accelerations: Vec<f64> = states.iter().map(|state| self.at(state).abs()).collect();
        let apart = states.len().div_ceil(LOOKS);
        let some = states.iter().step_by(apart);
        let errors: Vec<f64> =
            some.map(|state| self.error(state).unwrap_or_else(|| self.noise(state))).collect();
        let [largest, error] =
            [&accelerations, &errors].map(|numbers| numbers.iter().copied().fold(0.0, f64::max));
        let number = states.len();
        let of_step = |i: usize| {
            // The step that ends at this state begins at the previous one, the first at the last.
            let before = (i + number - 1) % number;
            let way = (states[i][0] - states[before][0]).abs();
            let round = f64::EPSILON * accelerations[i].max(accelerations[before]);
            let measured = [i, before]
                .map(|index| errors[index / apart].max(errors[(index / apart + 1) % errors.len()]));
            way * round.max(measured[0]).max(measured[1])
        };
        let of_place = |i: usize| f64::EPSILON * (states[i][0] * accelerations[i]).abs();
        let energy = 0.5 * (0..number).map(of_step).sum::<f64>();
        let energy = (0..number).map(of_place).fold(energy, f64::max);
        Roundings { relative: error / largest, energy }
    }

    /// The difference between the acceleration in double precision and that at a position which
    /// rounds to this one. Zero if a |…| or a sign changes its branch between these positions: over
    /// so short a distance a jump changes the energy no more than rounding of the position does.
    fn error(&self, state: &[f64]) -> Option<f64> {
        let ring = Floats { precision: PRECISION };
        let exact: Vec<BigFloat> =
            state.iter().map(|x| BigFloat::from_f64(*x, PRECISION)).collect::<Option<_>>()?;
        let beside = |units: f64| {
            let part = BigFloat::from_words(DoubleDouble::new(1.0, units * f64::EPSILON), PRECISION);
            let mut beside = exact.clone();
            beside[0] = ring.multiply(&beside[0], &part);
            Jet::new(&ring, &self.tape, &beside).ok()
        };
        let [above, below] = [beside(0.5)?, beside(-0.5)?];
        if self.changes_branch(&above, &below) {
            return Some(0.0);
        }
        let value = BigFloat::from_f64(self.at(state), PRECISION)?;
        Some((above.result(0)[0].clone() - value).to_f64().abs())
    }

    /// The change of the acceleration in double precision by a unit in the last place of the position and by rounding, where
    /// numbers of many bits have no value, as an exponential of a million; infinite if a value is missing.
    fn noise(&self, state: &[f64]) -> f64 {
        let value = self.at(state);
        let change =
            |units: f64| (self.at(&[state[0] * (1.0 + units * f64::EPSILON), state[1]]) - value).abs();
        let noise = f64::EPSILON * value.abs() + change(1.0) + change(-1.0);
        if noise.is_finite() { noise } else { f64::INFINITY }
    }

    /// Returns `true` if the argument of a |…| or a sign is zero in one of two states, or has opposite signs in them.
    fn changes_branch(&self, state: &Jet<'_, Floats>, other: &Jet<'_, Floats>) -> bool {
        let values = |jet: &Jet<'_, Floats>| -> Vec<f64> { jet.values().map(BigFloat::to_f64).collect() };
        let states = [values(state), values(other)];
        self.tape.operations().iter().any(|operation| match *operation {
            Operation::Abs(of) | Operation::Sign(of) => {
                let is_above = states.iter().all(|values| values[of] > 0.0);
                let is_below = states.iter().all(|values| values[of] < 0.0);
                !is_above && !is_below
            }
            _ => false,
        })
    }
}

/// Returns `true` if a formula is proved to be even in a symbol.
fn is_even(formula: &Expression, symbol: &Symbol) -> bool {
    let opposite = Expression::Negate(Box::new(Expression::Symbol(symbol.clone())));
    let mirrored = formula.substitute(symbol, &opposite);
    Expression::Subtract(Box::new(mirrored), Box::new(formula.clone())).vanishes()
}
