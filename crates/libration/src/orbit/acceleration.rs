//! The acceleration of one coordinate, and what rounding does to it.

use super::path::Path;
use crate::algebra::{BigFloat, Doubles, Floats, Ring};
use crate::double_double::DoubleDouble;
use crate::expression::{Equation, Jet, Operation, Symbol, Tape, WithoutValue};

/// The acceleration as a function of position and velocity.
#[derive(Debug)]
pub(super) struct Acceleration {
    pub(super) tape: Tape,
    /// Whether it is one of the place only, which conserves an energy.
    pub(super) is_free_of_velocity: bool,
}

/// States at which the rounding is measured.
const LOOKS: usize = 8;
/// Bits in which the rounding of double precision shows.
const PRECISION: usize = 128;

impl Acceleration {
    /// That of the first coordinate, which is the only one.
    pub(super) fn new(equation: &Equation) -> Result<Self, WithoutValue> {
        let name = equation.variables().first().map_or("", String::as_str);
        let velocity = Symbol::plain(name).with_primes(1);
        let formula = &equation.accelerations()[0];
        let tape = Tape::new(&[formula], &[Symbol::plain(name), velocity.clone()])?;
        Ok(Self { tape, is_free_of_velocity: !formula.contains(&velocity) })
    }

    /// Whether no |…| and no sign stands in it, which have no derivative at zero.
    pub(super) fn is_smooth(&self) -> bool {
        let kink = |operation: &Operation| matches!(operation, Operation::Abs(_) | Operation::Sign(_));
        let operations = self.tape.operations().iter().enumerate();
        !operations.into_iter().any(|(place, operation)| kink(operation) && !self.tape.is_constant(place))
    }

    /// NaN where it has no value.
    pub(super) fn at(&self, state: &[f64]) -> f64 {
        Jet::new(&Doubles, &self.tape, state).map_or(f64::NAN, |jet| jet.result(0)[0])
    }

    /// Whether it has a value where double precision has none.
    pub(super) fn is_too_large(&self, state: &[f64]) -> bool {
        self.tape.overflows_at(state)
    }

    /// The largest acceleration on a path, and the largest part of it that rounding the place and the operations makes wrong.
    pub(super) fn largest_and_rounding(&self, path: &Path) -> [f64; 2] {
        let states: Vec<Vec<f64>> = path.states().collect();
        let largest = states.iter().map(|state| self.at(state).abs()).fold(0.0, f64::max);
        let some = states.iter().step_by(states.len().div_ceil(LOOKS));
        let errors = some.map(|state| self.error(state).unwrap_or(f64::INFINITY));
        [largest, errors.fold(0.0, f64::max) / largest]
    }

    /// How far the acceleration in double precision is from that of a place that rounds to this one.
    fn error(&self, state: &[f64]) -> Option<f64> {
        let ring = Floats { precision: PRECISION };
        let mut exact: Vec<BigFloat> =
            state.iter().map(|x| BigFloat::from_f64(*x, PRECISION)).collect::<Option<_>>()?;
        let half_a_unit = BigFloat::from_words(DoubleDouble::new(1.0, 0.5 * f64::EPSILON), PRECISION);
        exact[0] = ring.multiply(&exact[0], &half_a_unit);
        let jet = Jet::new(&ring, &self.tape, &exact).ok()?;
        let own = BigFloat::from_f64(self.at(state), PRECISION)?;
        Some((jet.result(0)[0].clone() - own).to_f64().abs())
    }
}
