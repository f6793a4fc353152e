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
        !operations.into_iter().any(|(place, operation)| kink(operation) && !self.tape.is_constant(place))
    }

    /// The acceleration at a state; NaN if it has no value.
    pub(super) fn at(&self, state: &[f64]) -> f64 {
        Jet::new(&Doubles, &self.tape, state).map_or(f64::NAN, |jet| jet.result(0)[0])
    }

    /// Returns `true` if the acceleration has a value that double precision cannot represent.
    pub(super) fn is_too_large(&self, state: &[f64]) -> bool {
        self.tape.overflows_at(state)
    }

    /// The largest acceleration on a path, and the largest relative error of it from rounding of the position and of the operations.
    pub(super) fn largest_and_rounding(&self, path: &Path) -> [f64; 2] {
        let states: Vec<Vec<f64>> = path.states().collect();
        let largest = states.iter().map(|state| self.at(state).abs()).fold(0.0, f64::max);
        let some = states.iter().step_by(states.len().div_ceil(LOOKS));
        let errors = some.map(|state| self.error(state).unwrap_or(f64::INFINITY));
        [largest, errors.fold(0.0, f64::max) / largest]
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
        let own = BigFloat::from_f64(self.at(state), PRECISION)?;
        Some((above.result(0)[0].clone() - own).to_f64().abs())
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
