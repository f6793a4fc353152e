//! The ring of polynomials with rational coefficients.

use super::{Polynomial, product};
use crate::algebra::{Function, Rational, Rationals, Ring};

/// The ring of all [`Polynomial`]s, for series with symbolic coefficients.
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

    /// Values at constants, if the value is a fraction.
    fn value(&self, function: Function, at: &Polynomial) -> Option<Polynomial> {
        Rationals.value(function, &at.to_constant()?).map(Polynomial::constant)
    }

    /// Powers with natural exponents; for constants every power that is a fraction.
    fn power(&self, a: &Polynomial, exponent: &Rational) -> Option<Polynomial> {
        match a.to_constant() {
            Some(number) => Rationals.power(&number, exponent).map(Polynomial::constant),
            None => Some(a.pow(exponent.to_string().parse().ok()?)),
        }
    }

    fn pi(&self) -> Option<Polynomial> {
        None
    }
}
