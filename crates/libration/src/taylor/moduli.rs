//! Absolute values as products with a sign, which stays what it is during a step; and signs.

use crate::expression::{Expression, Function, Symbol};

/// The arguments of the absolute values and signs met so far, each once.
#[derive(Debug, Default)]
pub(super) struct Moduli {
    arguments: Vec<Expression>,
}

impl Moduli {
    /// The formula with s·u in the place of each |u|, and s in the place of sign(u).
    pub(super) fn taken_out(&mut self, formula: &Expression) -> Expression {
        match formula {
            Expression::Call(Function::Abs, a) => {
                let argument = self.taken_out(a);
                Expression::Multiply(Box::new(self.sign_of(&argument)), Box::new(argument))
            }
            Expression::Call(Function::Sign, a) => {
                let argument = self.taken_out(a);
                self.sign_of(&argument)
            }
            _ => formula.with_parts(|part| self.taken_out(part)),
        }
    }

    /// The sign of an argument, as a symbol.
    fn sign_of(&mut self, argument: &Expression) -> Expression {
        let known = self.arguments.iter().position(|other| other == argument);
        let place = known.unwrap_or_else(|| {
            self.arguments.push(argument.clone());
            self.arguments.len() - 1
        });
        Expression::Symbol(sign(place))
    }

    /// The symbols that stand for the signs.
    pub(super) fn signs(&self) -> impl Iterator<Item = Symbol> {
        (0..self.arguments.len()).map(sign)
    }

    pub(super) fn into_arguments(self) -> Vec<Expression> {
        self.arguments
    }
}

/// A name that no text can have.
fn sign(place: usize) -> Symbol {
    Symbol::plain(&format!("sign of |{place}|"))
}
