//! Absolute values, signs and roots of powers of one base, as powers of its absolute value: sign(u³) is sign(u), √(u²) is |u|.
//!
//! A power of u passes zero where u does, but its zero cannot be located to more than the root of rounding errors.

use super::moduli::root_of_square;
use super::quotients::{Product, with_value_at_zero};
use libration_numbers::algebra::{Rational, Rationals, Ring};
use libration_numbers::expression::{Equation, Expression, Function};

/// The equations with these powers, in which quotients of powers of u and |u| have a value at zero.
pub(in crate::taylor) fn with_values_at_zero(equation: Equation) -> Equation {
    let derivatives: Vec<Expression> = equation
        .derivatives()
        .iter()
        .map(|formula| with_value_at_zero(&with_simple_bases(formula)))
        .collect();
    if derivatives == equation.derivatives() {
        return equation;
    }
    Equation::of_derivatives(equation.variables().to_vec(), equation.orders().to_vec(), derivatives)
}

/// The formula with |u|^p or sign(u) in place of absolute values, signs and roots of products of numbers and powers of u.
fn with_simple_bases(formula: &Expression) -> Expression {
    let formula = formula.with_parts(with_simple_bases);
    let simple = match &formula {
        Expression::Call(Function::Sqrt, base) => root_of_square(base).map(|root| with_simple_bases(&root)),
        Expression::Call(Function::Abs, argument) => {
            Monomial::of(argument).map(|monomial| monomial.absolute_value())
        }
        Expression::Call(Function::Sign, argument) => {
            Monomial::of(argument).and_then(|monomial| monomial.sign())
        }
        Expression::Power(base, exponent) => root_of_power(base, exponent),
        _ => None,
    };
    simple.unwrap_or(formula)
}

/// An even power to a power that is not an integer, as a power of the absolute value.
fn root_of_power(base: &Expression, exponent: &Expression) -> Option<Expression> {
    let exponent = exponent.to_rational().filter(|exponent| !exponent.is_integer())?;
    let whole = Rationals.add(&exponent, &exponent);
    Some(power(root_of_square(base)?, &whole))
}

/// A number times integer powers of one base, its absolute value and its sign, but not the base alone.
struct Monomial {
    factor: Rational,
    base: Expression,
    /// The exponent of the absolute value of the base.
    exponent: Rational,
    /// `true` if the sign of the base is a factor.
    is_odd: bool,
}

impl Monomial {
    fn of(formula: &Expression) -> Option<Self> {
        let product = Product::of(formula);
        let one = Rational::from(1);
        let mut factor = if product.is_negative { Rationals.negate(&one) } else { one.clone() };
        let (mut base, mut exponent, mut is_odd, mut is_base) = (None, Rational::from(0), false, true);
        for (part, times) in &product.factors {
            if let Expression::Number(number) = part {
                let number =
                    if times.is_negative() { Rationals.divide(&one, number)? } else { number.clone() };
                let size = if times.is_negative() { Rationals.negate(times) } else { times.clone() };
                factor = (size == one).then(|| Rationals.multiply(&factor, &number))?;
                continue;
            }
            let (of, has_sign, has_size) = match part {
                Expression::Call(Function::Abs, of) => (&**of, false, true),
                Expression::Call(Function::Sign, of) => (&**of, true, false),
                _ => (*part, true, true),
            };
            if base.is_some_and(|base| base != of) || !times.is_integer() && has_sign {
                return None;
            }
            is_base &= base.is_none() && *part == of && *times == one;
            base = Some(of);
            exponent = if has_size { Rationals.add(&exponent, times) } else { exponent };
            is_odd ^= has_sign && !Rationals.over_integer(times, 2)?.is_integer();
        }
        let base = base.filter(|_| !is_base)?.clone();
        Some(Self { factor, base, exponent, is_odd })
    }

    fn absolute_value(self) -> Expression {
        let factor = if self.factor.is_negative() { Rationals.negate(&self.factor) } else { self.factor };
        let is_even = Rationals.over_integer(&self.exponent, 2).is_some_and(|half| half.is_integer());
        let size = || Expression::Call(Function::Abs, Box::new(self.base.clone()));
        let power = power(if is_even { self.base.clone() } else { size() }, &self.exponent);
        if factor == Rational::from(1) {
            return power;
        }
        Expression::Multiply(Box::new(Expression::Number(factor)), Box::new(power))
    }

    /// The sign, if it is not that of a number, apart from the zero of the base.
    fn sign(self) -> Option<Expression> {
        let sign = self.is_odd.then(|| Expression::Call(Function::Sign, Box::new(self.base)))?;
        match () {
            () if self.factor.is_zero() => None,
            () if self.factor.is_negative() => Some(Expression::Negate(Box::new(sign))),
            () => Some(sign),
        }
    }
}

/// A power of a base, which may be a power itself.
fn power(base: Expression, exponent: &Rational) -> Expression {
    let whole = match &base {
        Expression::Power(of, inner) => {
            inner.to_rational().map(|inner| (Expression::clone(of), Rationals.multiply(&inner, exponent)))
        }
        _ => None,
    };
    let (base, exponent) = whole.unwrap_or((base, exponent.clone()));
    match () {
        () if exponent.is_zero() => Expression::from(1),
        () if exponent == Rational::from(1) => base,
        () => Expression::Power(Box::new(base), Box::new(Expression::Number(exponent))),
    }
}
