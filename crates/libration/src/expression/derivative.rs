//! The derivative of a formula.

use super::simplify::{call, difference, integer, negative, power, product, quotient, sum};
use super::{Expression, Function, Symbol};

impl Expression {
    /// The partial derivative with respect to a symbol, in the form of [`simplified`](Self::simplified). A symbol and
    /// its time derivatives are independent of each other. |u| has the derivative u·u′/|u|, undefined at zero.
    #[must_use]
    pub fn derivative(&self, by: &Symbol) -> Self {
        self.simplified().derivative_of_simplified(by)
    }

    fn derivative_of_simplified(&self, by: &Symbol) -> Self {
        match self {
            Self::Number(_) | Self::Pi => integer(0),
            Self::Symbol(symbol) => integer(i64::from(symbol == by)),
            Self::Negate(a) => negative(a.derivative_of_simplified(by)),
            Self::Add(a, b) => sum(a.derivative_of_simplified(by), b.derivative_of_simplified(by)),
            Self::Subtract(a, b) => {
                difference(a.derivative_of_simplified(by), b.derivative_of_simplified(by))
            }
            Self::Multiply(a, b) => sum(
                product(a.derivative_of_simplified(by), (**b).clone()),
                product((**a).clone(), b.derivative_of_simplified(by)),
            ),
            Self::Divide(a, b) => of_quotient(a, b, by),
            Self::Power(a, b) => of_power(a, b, by),
            Self::Call(function, a) => {
                let inner = a.derivative_of_simplified(by);
                if inner.is_zero() { inner } else { of_call(*function, a, inner) }
            }
        }
    }
}

/// (a/b)′ = a′/b − a·b′/b².
fn of_quotient(a: &Expression, b: &Expression, by: &Symbol) -> Expression {
    let (upper, lower) = (a.derivative_of_simplified(by), b.derivative_of_simplified(by));
    let first = quotient(upper, b.clone());
    let square = power(b.clone(), integer(2));
    difference(first, quotient(product(a.clone(), lower), square))
}

/// (aᵇ)′ = b·aᵇ⁻¹·a′ + aᵇ·ln a·b′.
fn of_power(a: &Expression, b: &Expression, by: &Symbol) -> Expression {
    let (base, exponent) = (a.derivative_of_simplified(by), b.derivative_of_simplified(by));
    let lowered = power(a.clone(), difference(b.clone(), integer(1)));
    let first = product(product(b.clone(), lowered), base);
    if exponent.is_zero() {
        return first;
    }
    let logarithm = call(Function::Ln, a.clone());
    sum(first, product(product(power(a.clone(), b.clone()), logarithm), exponent))
}

/// f(u)′ for an inner derivative u′ that is not zero.
fn of_call(function: Function, u: &Expression, inner: Expression) -> Expression {
    let of = |function| call(function, u.clone());
    let square = |a: Expression| power(a, integer(2));
    let one_minus_square = || difference(integer(1), square(u.clone()));
    match function {
        Function::Sin => product(of(Function::Cos), inner),
        Function::Cos => negative(product(of(Function::Sin), inner)),
        Function::Sinh => product(of(Function::Cosh), inner),
        Function::Cosh => product(of(Function::Sinh), inner),
        Function::Exp => product(of(Function::Exp), inner),
        Function::Tan => quotient(inner, square(of(Function::Cos))),
        Function::Tanh => quotient(inner, square(of(Function::Cosh))),
        Function::Ln => quotient(inner, u.clone()),
        Function::Sqrt => quotient(inner, product(integer(2), of(Function::Sqrt))),
        Function::Abs => quotient(product(u.clone(), inner), of(Function::Abs)),
        Function::Asin => quotient(inner, call(Function::Sqrt, one_minus_square())),
        Function::Acos => negative(quotient(inner, call(Function::Sqrt, one_minus_square()))),
        Function::Atan => quotient(inner, sum(integer(1), square(u.clone()))),
    }
}
