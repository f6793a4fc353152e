//! Constants that are fractions, or are known to some digits.

use std::fmt;

use libration_numbers::algebra::{BigFloat, Rational};
use libration_numbers::expression::Expression;

/// Bits in which constants that are no fractions are held.
pub(super) const PRECISION: usize = 512;
/// Decimal digits of them that are written.
const DIGITS: usize = 30;

/// A constant of an oscillator.
#[derive(Clone, Debug, PartialEq)]
pub enum Constant {
    /// The number itself.
    Exact(Rational),
    /// A number that was not found to be a fraction.
    Approximate(Approximation),
}

/// A number in digits.
#[derive(Clone, Debug, PartialEq)]
pub struct Approximation(pub(super) BigFloat);

impl Constant {
    /// The fraction, when it is known to be one.
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

    /// The constant to [`PRECISION`] bits.
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

/// A fraction as it is written in formulas, other numbers by 30 digits and `…`.
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
