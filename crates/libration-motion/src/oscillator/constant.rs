//! Constants that are fractions, or are known to a limited number of digits.

use std::fmt;

use libration_numbers::algebra::{BigFloat, Rational};
use libration_numbers::expression::Expression;

/// Precision in bits of constants that are not fractions.
pub(super) const PRECISION: usize = 512;
/// Number of decimal digits with which such constants are printed.
const DIGITS: usize = 30;

/// A constant of an oscillator.
#[derive(Clone, Debug, PartialEq)]
pub enum Constant {
    /// The number itself.
    Exact(Rational),
    /// A number that was not recognised as a fraction.
    Approximate(Approximation),
}

/// A number known to a limited number of digits.
#[derive(Clone, Debug, PartialEq)]
pub struct Approximation(pub(super) BigFloat);

impl Constant {
    /// The fraction, if the constant is known to be one.
    #[must_use]
    pub fn exact(&self) -> Option<&Rational> {
        if let Self::Exact(value) = self { Some(value) } else { None }
    }

    /// The nearest `f64`.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        match self {
            Self::Exact(value) => value.to_f64(),
            Self::Approximate(Approximation(value)) => value.to_f64(),
        }
    }

    /// The constant rounded to [`PRECISION`] bits.
    #[doc(hidden)]
    pub fn digits(&self) -> BigFloat {
        match self {
            Self::Exact(value) => BigFloat::from_rational(value, PRECISION),
            Self::Approximate(Approximation(value)) => value.clone(),
        }
    }

    pub(super) fn is_positive(&self) -> bool {
        match self {
            Self::Exact(value) => !value.is_negative() && !value.is_zero(),
            Self::Approximate(Approximation(value)) => *value > BigFloat::from_integer(0, 1),
        }
    }
}

/// Writes a fraction as in formulas, and other numbers with 30 digits and `…`.
impl fmt::Display for Constant {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exact(value) => Expression::Number(value.clone()).fmt(formatter),
            Self::Approximate(Approximation(value)) => {
                write!(formatter, "{}…", Expression::Number(value.to_rational().rounded_to_digits(DIGITS)))
            }
        }
    }
}
