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
        let mut part = |a: &Expression| Box::new(self.taken_out(a));
        match formula {
            Expression::Number(_) | Expression::Pi | Expression::Symbol(_) => formula.clone(),
            Expression::Negate(a) => Expression::Negate(part(a)),
            Expression::Add(a, b) => Expression::Add(part(a), part(b)),
            Expression::Subtract(a, b) => Expression::Subtract(part(a), part(b)),
            Expression::Multiply(a, b) => Expression::Multiply(part(a), part(b)),
            Expression::Divide(a, b) => Expression::Divide(part(a), part(b)),
            Expression::Power(a, b) => Expression::Power(part(a), part(b)),
            Expression::Call(Function::Abs, a) => {
                let argument = part(a);
                Expression::Multiply(Box::new(self.sign_of(&argument)), argument)
            }
            Expression::Call(Function::Sign, a) => {
                let argument = part(a);
                self.sign_of(&argument)
            }
            Expression::Call(function, a) => Expression::Call(*function, part(a)),
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
