//! The derivative of a formula.

use super::simplify::{call, difference, negative, power, product, quotient, sum};
use super::{Expression, Function, Symbol};
use crate::algebra::{Divisor, Pair, Rule, Slope};

impl Expression {
    /// The partial derivative with respect to a symbol, in the form of [`simplified`](Self::simplified). A symbol and
    /// its time derivatives are independent of each other. |u| has the derivative sign(u)·u′ and sign(u) has zero, also where
    /// u vanishes and neither is differentiable.
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

/// f(u)′ for an inner derivative u′ that is not zero.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{BigFloat, Floats, Rational, Ring};
    use crate::expression::{Jet, Tape};

    fn formula(text: &str) -> Expression {
        text.parse().unwrap()
    }

    #[test]
    fn derivatives_have_their_closed_forms() {
        for (text, slope) in [
            ("x^3", "3*x^2"),
            ("sin(a*x)", "a*cos(a*x)"),
            ("x'*x''*a", "0"),
            ("a/(1 + x^2)", "-2*a*x/(1 + x^2)^2"),
            ("sqrt(1 + x^2)", "x/sqrt(1 + x^2)"),
            ("2^x", "2^x*ln(2)"),
            ("x^a", "a*x^(a - 1)"),
            ("abs(x)", "sign(x)"),
            ("x*sign(x)", "sign(x)"),
            ("tanh(-x)", "-1/cosh(x)^2"),
        ] {
            let found = formula(text).derivative(&Symbol::plain("x"));
            assert!(difference(found.clone(), formula(slope)).vanishes(), "{text}: {found}");
        }
    }

    /// The value at a place to 300 bits.
    fn value(tree: &Expression, at: &BigFloat) -> BigFloat {
        let tape = Tape::new(&[tree], &[Symbol::plain("x")]).unwrap();
        Jet::new(&Floats { precision: 300 }, &tape, std::slice::from_ref(at)).unwrap().result(0)[0].clone()
    }

    #[test]
    fn derivatives_agree_with_differences() {
        let floats = Floats { precision: 300 };
        let at = floats.rational(&Rational::new(3, 7).unwrap()).unwrap();
        let step = BigFloat::from_integer(1, 300) / BigFloat::from_integer(1 << 60, 300);
        let functions = Function::ALL.map(|function| format!("{}(x*x + x/3)", function.name()));
        let others = ["x^x", "(1 + x)^(x - 2)/x", "exp(-x)^2 - x/(2 - sin(x))", "-x^(2/3)*abs(x - 1)"];
        for text in functions.iter().map(String::as_str).chain(others) {
            let tree = formula(text);
            let slope = value(&tree.derivative(&Symbol::plain("x")), &at);
            let rise =
                value(&tree, &(at.clone() + step.clone())) - value(&tree, &(at.clone() - step.clone()));
            // The third derivative times 2⁻¹²⁰/6 is what the central difference is wrong by.
            let error = (rise.halved() / step.clone() - slope).exponent();
            assert!(error.is_none_or(|exponent| exponent < -100), "{text}: 2^{error:?}");
        }
    }
}
