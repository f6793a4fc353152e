//! Formulas on one side of a state at which absolute values have a kink and signs a jump.

use super::{Expression, Function, Jet, Symbol, Tape};
use crate::algebra::Doubles;

/// Largest change of the components of a state, relative to the largest one, by which a formula that vanishes at the exact state may have another
/// value at the numerical one.
const ZERO: f64 = 1e-12;

/// A state and one side of it.
#[derive(Debug)]
pub struct Side<'a> {
    pub symbols: &'a [Symbol],
    pub state: &'a [f64],
    /// The sign, on this side, of the formulas that vanish at the state.
    pub sign: i64,
}

impl Side<'_> {
    /// The formula on this side: s·u and s in place of |u| and sign(u) if u vanishes at the state.
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
        let at_state = |formula: &Expression| {
            let tape = Tape::new(&[formula], self.symbols).ok()?;
            let jet = Jet::new(&Doubles, &tape, self.state).ok()?;
            jet.result(0).first().map(|value| value.abs())
        };
        let change = || {
            let slopes = self.symbols.iter().map(|symbol| at_state(&formula.derivative(symbol)));
            let largest = self.state.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            Some(ZERO * largest * slopes.sum::<Option<f64>>()?)
        };
        at_state(formula).is_some_and(|value| value <= 0.0 || change().is_some_and(|change| value < change))
    }
}
