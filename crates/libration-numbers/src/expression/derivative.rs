//! The derivative of a formula.

use super::simplify::{call, difference, negative, power, product, quotient, sum};
use super::{Expression, Function, Symbol};
use crate::algebra::{Divisor, Pair, Rule, Slope};

impl Expression {
    /// The partial derivative with respect to a symbol, in the form of [`simplified`](Self::simplified). A symbol and its time derivatives count
    /// as independent. The derivative of |u| is sign(u)·u′ and that of sign(u) is zero, even where u vanishes and neither is differentiable.
    #[must_use]
    pub fn derivative(&self, by: &Symbol) -> Self {
        self.simplified().derivative_of_simplified(by)
    }

    fn derivative_of_simplified(&self, by: &Symbol) -> Self {
        match self {
            Self::Number(_) | Self::Pi => Self::from(0),
            Self::Symbol(symbol) => Self::from(i64::from(symbol == by)),
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
    let square = power(b.clone(), Expression::from(2));
    difference(first, quotient(product(a.clone(), lower), square))
}

/// (aᵇ)′ = b·aᵇ⁻¹·a′ + aᵇ·ln a·b′.
fn of_power(a: &Expression, b: &Expression, by: &Symbol) -> Expression {
    let (base, exponent) = (a.derivative_of_simplified(by), b.derivative_of_simplified(by));
    let lowered = power(a.clone(), difference(b.clone(), Expression::from(1)));
    let first = product(product(b.clone(), lowered), base);
    if exponent.is_zero() {
        return first;
    }
    let logarithm = call(Function::Ln, a.clone());
    sum(first, product(product(power(a.clone(), b.clone()), logarithm), exponent))
}

/// f(u)′ for a nonzero inner derivative u′.
fn of_call(function: Function, u: &Expression, inner: Expression) -> Expression {
    let of = |function| call(function, u.clone());
    let square = |a: Expression| power(a, Expression::from(2));
    match function.rule() {
        Rule::Itself => product(of(function), inner),
        Rule::Paired(Pair { functions: [first, second], .. }) if function == first => {
            product(of(second), inner)
        }
        Rule::Paired(Pair { functions: [first, _], slope }) => signed(slope, product(of(first), inner)),
        Rule::Quotient(Pair { functions: [_, second], .. }) => quotient(inner, square(of(second))),
        Rule::Root => quotient(inner, product(Expression::from(2), of(function))),
        Rule::Modulus => product(of(Function::Sign), inner),
        Rule::Step => Expression::from(0),
        Rule::Inverse(slope, divisor) => {
            let divisor = match divisor {
                Divisor::Argument => u.clone(),
                Divisor::OneAndSquare => sum(Expression::from(1), square(u.clone())),
                Divisor::RootOfOneLessSquare => {
                    call(Function::Sqrt, difference(Expression::from(1), square(u.clone())))
                }
            };
            signed(slope, quotient(inner, divisor))
        }
    }
}

fn signed(slope: Slope, tree: Expression) -> Expression {
    if slope == Slope::Plus { tree } else { negative(tree) }
}
