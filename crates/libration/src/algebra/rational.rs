//! Exact fractions: the coefficients of series and of leading errors.

use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};
use std::str::FromStr;

use dashu::integer::{IBig, UBig};
use dashu::rational::RBig;

/// An exact fraction of integers of any size, always in lowest terms with a positive denominator.
///
/// # Examples
/// ```
/// use libration::algebra::Rational;
/// let slope: Rational = "1/16".parse()?;
/// assert_eq!((slope.clone() * slope).to_string(), "1/256");
/// # Ok::<(), libration::algebra::NotARational>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Rational(RBig);

impl Rational {
    /// `numerator / denominator` in lowest terms; `None` when the denominator is zero.
    #[must_use]
    pub fn new(numerator: i64, denominator: i64) -> Option<Self> {
        let denominator = IBig::from(denominator);
        if denominator.is_zero() {
            return None;
        }
        Some(Self(RBig::from_parts_signed(IBig::from(numerator), denominator)))
    }

    /// The quotient; `None` when the divisor is zero.
    #[must_use]
    pub fn checked_div(&self, divisor: &Self) -> Option<Self> {
        (!divisor.is_zero()).then(|| Self(&self.0 / &divisor.0))
    }

    /// Whether this is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
    }

    /// Whether this is below zero.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        self.0 < RBig::ZERO
    }

    /// The numerator in decimal digits, with its sign.
    #[must_use]
    pub fn numerator(&self) -> String {
        self.0.numerator().to_string()
    }

    /// The denominator in decimal digits, positive.
    #[must_use]
    pub fn denominator(&self) -> String {
        self.0.denominator().to_string()
    }

    /// The nearest `f64`, ties to even; infinite beyond the largest.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.0.to_f64().value()
    }

    /// `numerator / denominator`, the latter not zero.
    pub(crate) fn from_parts(numerator: IBig, denominator: UBig) -> Self {
        Self(RBig::from_parts(numerator, denominator))
    }

    pub(crate) fn divided_by_power_of_two(&self, exponent: usize) -> Self {
        Self(&self.0 / RBig::from(UBig::ONE << exponent))
    }

    pub(crate) fn parts(&self) -> (&IBig, &UBig) {
        (self.0.numerator(), self.0.denominator())
    }
}

impl From<i64> for Rational {
    fn from(integer: i64) -> Self {
        Self(RBig::from(integer))
    }
}

impl Add for Rational {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Rational {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Rational {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Neg for Rational {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

/// As `-23/737280`, an integer without its denominator.
impl fmt::Display for Rational {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(formatter)
    }
}

/// Reads what [`Display`](fmt::Display) writes: an integer, or two of them about a slash.
impl FromStr for Rational {
    type Err = NotARational;

    fn from_str(text: &str) -> Result<Self, NotARational> {
        let refusal = || NotARational { text: text.to_owned() };
        let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
        let numerator = IBig::from_str_radix(numerator.trim(), 10).map_err(|_| refusal())?;
        let denominator = UBig::from_str_radix(denominator.trim(), 10).map_err(|_| refusal())?;
        if denominator.is_zero() {
            return Err(refusal());
        }
        Ok(Self::from_parts(numerator, denominator))
    }
}

/// A text that is not a fraction of two decimal integers.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{text}` is not a fraction: give an integer such as 7, or two such as -23/737280")]
pub struct NotARational {
    /// What was given.
    pub text: String,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rational(text: &str) -> Rational {
        text.parse().unwrap()
    }

    #[test]
    fn fractions_are_read_reduced_and_written_back() {
        for (text, written) in [("-23/737280", "-23/737280"), ("6/4", "3/2"), ("-8/4", "-2"), ("0/7", "0")] {
            assert_eq!(rational(text).to_string(), written);
        }
        assert_eq!(rational("-46/10").numerator(), "-23");
        assert_eq!(rational("-46/10").denominator(), "5");
        assert_eq!(Rational::new(3, -6), Rational::new(-1, 2));
    }

    #[test]
    fn texts_that_are_no_fractions_are_refused() {
        for text in ["", "/", "1/0", "1/-2", "1.5", "a/2", "1/2/3"] {
            assert!(text.parse::<Rational>().is_err(), "{text}");
        }
        assert_eq!(Rational::new(1, 0), None);
        assert_eq!(rational("1/2").checked_div(&rational("0")), None);
    }

    #[test]
    fn arithmetic_keeps_the_field_laws() {
        let (a, b, c) = (rational("3/7"), rational("-5/11"), rational("22/9"));
        assert_eq!(a.clone() * (b.clone() + c.clone()), a.clone() * b.clone() + a.clone() * c);
        assert_eq!((a.clone() - b.clone()) + b.clone(), a);
        assert_eq!(a.checked_div(&b).unwrap() * b, a);
        assert_eq!(a.clone() + -a, Rational::from(0));
    }

    #[test]
    fn conversion_rounds_to_nearest_even() {
        assert_eq!(rational("1/3").to_f64().to_bits(), (1.0_f64 / 3.0).to_bits());
        // Halfway between 1 and its successor, then just above halfway.
        assert_eq!(rational("9007199254740993/9007199254740992").to_f64().to_bits(), 1.0_f64.to_bits());
        assert_eq!(
            rational("90071992547409930001/90071992547409920000").to_f64().to_bits(),
            1.0_f64.next_up().to_bits()
        );
    }
}
