//! Formulas on one side of a state at which absolute values and signs have a kink or jump.

use super::{Expression, Function, Jet, Symbol, Tape};
use crate::algebra::Doubles;

/// Largest magnitude that counts as zero at a state that is known in digits.
const ZERO: f64 = 1e-12;

/// A state, and how formulas look on one side of it.
#[derive(Debug)]
pub struct Side<'a> {
    pub symbols: &'a [Symbol],
    pub state: &'a [f64],
    /// The sign of everything that vanishes there.
    pub sign: i64,
}

impl Side<'_> {
    /// The formula with s·u and s in the place of |u| and sign(u), where u vanishes.
    pub fn seen(&self, formula: &Expression) -> Expression {
        match formula {
            Expression::Call(Function::Abs, a) if self.vanishes(a) => {
                Expression::Multiply(Box::new(self.sign.into()), Box::new(self.seen(a)))
            }
            Expression::Call(Function::Sign, a) if self.vanishes(a) => self.sign.into(),
            _ => formula.with_parts(|part| self.seen(part)),
        }
    }

    fn vanishes(&self, formula: &Expression) -> bool {
        let value = Tape::new(&[formula], self.symbols).ok().and_then(|tape| {
            let jet = Jet::new(&Doubles, &tape, self.state).ok()?;
            jet.result(0).first().copied()
        });
        value.is_some_and(|value| value.abs() < ZERO)
    }
}
