//! Constants that are fractions, or are known to some digits.

use std::fmt;

use crate::algebra::{BigFloat, Rational, Rationals, Ring};
use crate::expression::Expression;

/// Bits in which constants that are no fractions are held.
pub(super) const PRECISION: usize = 512;
/// Decimal digits of them that are written.
const DIGITS: i32 = 30;

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

    /// To [`PRECISION`] bits.
    pub(crate) fn digits(&self) -> BigFloat {
        match self {
            Self::Exact(value) => BigFloat::from_rational(value, PRECISION),
            Self::Approximate(Approximation(value)) => value.clone(),
        }
    }

    pub(super) fn is_positive(&self) -> bool {
        match self {
            Self::Exact(value) => !value.is_negative() && !value.is_zero(),
            Self::Approximate(_) => self.to_f64() > 0.0,
        }
    }
}

/// A fraction as it is written in formulas, other numbers by 30 digits and `…`.
impl fmt::Display for Constant {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exact(value) => Expression::Number(value.clone()).fmt(formatter),
            Self::Approximate(Approximation(value)) => {
                write!(formatter, "{}…", Expression::Number(in_digits(&value.to_rational())))
            }
        }
    }
}

/// The decimal of [`DIGITS`] digits next to a number.
fn in_digits(value: &Rational) -> Rational {
    if value.is_zero() {
        return value.clone();
    }
    #[expect(clippy::cast_possible_truncation, reason = "the logarithm of an f64 is small")]
    let leading = libm::floor(libm::log10(value.to_f64().abs())) as i32;
    let scale = Rationals.power(&Rational::from(10), &Rational::from(i64::from(DIGITS - 1 - leading)));
    let scaled = scale.map(|scale| (Rationals.multiply(value, &scale).rounded(), scale));
    scaled.and_then(|(digits, scale)| digits.checked_div(&scale)).unwrap_or_else(|| value.clone())
}
