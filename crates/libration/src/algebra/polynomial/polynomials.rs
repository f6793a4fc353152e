//! The ring of polynomials with rational coefficients.

use super::{Polynomial, product};
use crate::algebra::{Function, Rational, Ring};

/// The ring of all [`Polynomial`]s, for series whose coefficients keep symbols open.
#[derive(Clone, Copy, Debug, Default)]
pub struct Polynomials;

impl Ring for Polynomials {
    type Element = Polynomial;

    fn zero(&self) -> Polynomial {
        Polynomial::zero()
    }

    fn is_zero(&self, a: &Polynomial) -> bool {
        a.is_zero()
    }

    fn rational(&self, value: &Rational) -> Option<Polynomial> {
        Some(Polynomial::constant(value.clone()))
    }

    fn add(&self, a: &Polynomial, b: &Polynomial) -> Polynomial {
        a.clone() + b.clone()
    }

    fn subtract(&self, a: &Polynomial, b: &Polynomial) -> Polynomial {
        a.clone() - b.clone()
    }

    fn negate(&self, a: &Polynomial) -> Polynomial {
        -a.clone()
    }

    fn multiply(&self, a: &Polynomial, b: &Polynomial) -> Polynomial {
        product(a, b)
    }

    fn times_integer(&self, a: &Polynomial, factor: i64) -> Polynomial {
        a.scaled(&Rational::from(factor))
    }

    fn divide(&self, a: &Polynomial, divisor: &Polynomial) -> Option<Polynomial> {
        a.divide_exactly(divisor)
    }

    fn over_integer(&self, a: &Polynomial, divisor: u64) -> Option<Polynomial> {
        let inverse = Rational::from(1).checked_div(&Rational::from(i64::try_from(divisor).ok()?))?;
        Some(a.scaled(&inverse))
    }

    /// Only at 0, and the logarithm at 1: elsewhere no value is a polynomial, or it is irrational.
    fn value(&self, function: Function, at: &Polynomial) -> Option<Polynomial> {
        let at = at.to_constant()?;
        let value = match function {
            Function::Ln => (at == Rational::from(1)).then_some(0),
            _ if !at.is_zero() => None,
            Function::Cos | Function::Cosh | Function::Exp => Some(1),
            Function::Acos => None,
            _ => Some(0),
        };
        value.map(|value| Polynomial::constant(Rational::from(value)))
    }

    /// Natural exponents only.
    fn power(&self, a: &Polynomial, exponent: &Rational) -> Option<Polynomial> {
        let natural = exponent.to_string().parse::<u32>().ok()?;
        Some(a.pow(natural))
    }

    fn pi(&self) -> Option<Polynomial> {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_polynomial_is_refused() {
        let x = Polynomial::variable("x");
        let half = Rational::new(1, 2).unwrap();
        assert_eq!(Polynomials.value(Function::Sin, &x), None);
        assert_eq!(Polynomials.power(&x, &half), None);
        assert_eq!(Polynomials.over_integer(&x, 0), None);
        assert_eq!(Polynomials.divide(&x, &x.pow(2)), None);
    }

    #[test]
    fn functions_have_their_values_at_the_origin() {
        let constant = |n: i64| Polynomial::constant(Rational::from(n));
        assert_eq!(Polynomials.value(Function::Sin, &constant(0)), Some(constant(0)));
        assert_eq!(Polynomials.value(Function::Cosh, &constant(0)), Some(constant(1)));
        assert_eq!(Polynomials.value(Function::Ln, &constant(1)), Some(constant(0)));
        assert_eq!(Polynomials.value(Function::Acos, &constant(0)), None);
    }
}
