//! Exact fractions, the coefficients of series and of leading errors.

use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};
use std::str::FromStr;

use dashu_base::{Approximation, BitTest, Sign};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

/// An exact fraction of integers of any size, always in lowest terms with a positive denominator.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::algebra::Rational;
/// let slope: Rational = "1/16".parse()?;
/// assert_eq!((slope.clone() * slope).to_string(), "1/256");
/// # Ok::<(), libration::algebra::ParseRationalError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Rational(pub(super) RBig);

impl Rational {
    /// `numerator / denominator` in lowest terms; `None` for a denominator of zero.
    #[must_use]
    pub fn new(numerator: i64, denominator: i64) -> Option<Self> {
        let denominator = IBig::from(denominator);
        if denominator.is_zero() {
            return None;
        }
        Some(Self(RBig::from_parts_signed(IBig::from(numerator), denominator)))
    }

    /// The quotient; `None` for a divisor of zero.
    #[must_use]
    pub fn checked_div(&self, divisor: &Self) -> Option<Self> {
        (!divisor.is_zero()).then(|| Self(&self.0 / &divisor.0))
    }

    /// Returns `true` if the number is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
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

    /// Returns `true` if double precision represents the number exactly.
    #[doc(hidden)]
    pub fn is_double(&self) -> bool {
        matches!(self.0.to_f64(), Approximation::Exact(_))
    }

    /// `numerator / denominator` for a nonzero denominator.
    #[doc(hidden)]
    pub fn from_parts(numerator: IBig, denominator: UBig) -> Self {
        Self(RBig::from_parts(numerator, denominator))
    }

    /// |a|.
    #[must_use]
    pub fn magnitude(&self) -> Self {
        if self.is_negative() { self.clone().neg() } else { self.clone() }
    }

    /// Returns `true` if the number is negative.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        self.parts().0.sign() == Sign::Negative
    }

    /// Bits of the numerator or the denominator, whichever is longer.
    #[doc(hidden)]
    pub fn bits(&self) -> usize {
        self.parts().0.bit_len().max(self.parts().1.bit_len())
    }

    /// Returns `true` if the number is an integer.
    #[must_use]
    pub fn is_integer(&self) -> bool {
        self.parts().1.is_one()
    }

    /// The number as a `u64`, if it is a natural number in its range.
    #[must_use]
    pub fn to_natural(&self) -> Option<u64> {
        self.is_integer().then(|| u64::try_from(self.parts().0).ok()).flatten()
    }

    /// The square root, if it is a fraction.
    #[must_use]
    pub fn square_root(&self) -> Option<Self> {
        self.root(2)
    }

    /// The n-th root, if it is a fraction; not negative for even n.
    pub(super) fn root(&self, n: usize) -> Option<Self> {
        let exact = |whole: &UBig| Some(whole.nth_root(n)).filter(|root| root.pow(n) == *whole);
        let (numerator, denominator) = self.parts();
        let (sign, magnitude) = numerator.clone().into_parts();
        if n == 0 || (sign == Sign::Negative && n.is_multiple_of(2)) {
            return None;
        }
        Some(Self::from_parts(sign * IBig::from(exact(&magnitude)?), exact(denominator)?))
    }

    /// The fraction with the smallest denominator strictly between two others.
    #[doc(hidden)]
    pub fn simplest_between(low: &Self, high: &Self) -> Self {
        Self(RBig::simplest_in(low.0.clone(), high.0.clone()))
    }

    /// A fraction with few digits that is smaller than this positive one by at most 1/1024 of it.
    #[doc(hidden)]
    pub fn coarsened(&self) -> Self {
        let below = Self(&self.0 * RBig::from_parts(1023.into(), 1024_u32.into()));
        Self::simplest_between(&below, self)
    }

    /// aⁿ; `None` for a negative power of zero, and for results of more than 2¹⁶ bits.
    #[must_use]
    pub fn integer_power(&self, n: isize) -> Option<Self> {
        const BITS: usize = 1 << 16;
        let (numerator, denominator) = self.parts();
        let size = numerator.bit_len().max(denominator.bit_len());
        if (n < 0 && self.is_zero()) || (size > 1 && size.saturating_mul(n.unsigned_abs()) > BITS) {
            return None;
        }
        let power = Self::from_parts(numerator.pow(n.unsigned_abs()), denominator.pow(n.unsigned_abs()));
        if n < 0 { Self::from(1).checked_div(&power) } else { Some(power) }
    }

    /// The fraction divided by 2ⁿ.
    #[must_use]
    pub fn divided_by_power_of_two(&self, exponent: usize) -> Self {
        Self(&self.0 / RBig::from(UBig::ONE << exponent))
    }

    /// Numerator and denominator modulo a prime, each between 0 and p − 1.
    pub(crate) fn residues(&self, prime: u32) -> (u32, u32) {
        let (numerator, denominator) = self.parts();
        let (sign, magnitude) = numerator.clone().into_parts();
        let residue = magnitude % prime;
        let negative = sign == Sign::Negative && residue > 0;
        (if negative { prime - residue } else { residue }, denominator % prime)
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

/// Writes the fraction as `-23/737280`, an integer without a denominator.
impl fmt::Display for Rational {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(formatter)
    }
}

/// Reads the output of [`Display`](fmt::Display): an integer, or two integers separated by a slash.
impl FromStr for Rational {
    type Err = ParseRationalError;

    fn from_str(text: &str) -> Result<Self, ParseRationalError> {
        let refusal = || ParseRationalError { text: text.to_owned() };
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
pub struct ParseRationalError {
    /// The text given.
    pub text: String,
}
