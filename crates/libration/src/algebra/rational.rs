//! Exact fractions: the coefficients of series and of leading errors.

use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};
use std::str::FromStr;

use dashu::base::{BitTest, Gcd, Sign};
use dashu::integer::{IBig, UBig};
use dashu::rational::RBig;

use super::{Function, Ring, product};

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

    /// The number rounded to this many significant decimal digits, such as `-1.0833e-7`; in plain digits from 0.0001
    /// up to the digits asked for.
    #[must_use]
    pub fn to_decimal(&self, digits: usize) -> String {
        let digits = digits.max(1);
        if self.is_zero() {
            return "0".to_owned();
        }
        let mut exponent = self.decimal_exponent();
        let mut figures = self.figures(digits, exponent);
        // The estimate may be low by one, and rounding may carry into a new digit.
        while figures.len() > digits {
            exponent += 1;
            figures = self.figures(digits, exponent);
        }
        let sign = if self.is_negative() { "-" } else { "" };
        format!("{sign}{}", placed(figures.trim_end_matches('0'), exponent))
    }

    /// The power of ten of the first digit, or less.
    fn decimal_exponent(&self) -> isize {
        let (numerator, denominator) = self.parts();
        let length = |text: String| isize::try_from(text.trim_start_matches('-').len()).unwrap_or(isize::MAX);
        length(numerator.to_string()) - length(denominator.to_string()) - 1
    }

    /// The integer nearest to |a|·10^(digits − 1 − exponent), in digits.
    fn figures(&self, digits: usize, exponent: isize) -> String {
        let (numerator, denominator) = self.parts();
        let (_, magnitude) = numerator.clone().into_parts();
        let shift = isize::try_from(digits).unwrap_or(isize::MAX) - 1 - exponent;
        let ten = |power: isize| UBig::from(10_u8).pow(power.unsigned_abs());
        let (upper, lower) = if shift >= 0 {
            (magnitude * ten(shift), denominator.clone())
        } else {
            (magnitude, denominator * ten(shift))
        };
        ((upper * 2_u8 + &lower) / (lower * 2_u8)).to_string()
    }

    /// `numerator / denominator`, the latter not zero.
    pub(crate) fn from_parts(numerator: IBig, denominator: UBig) -> Self {
        Self(RBig::from_parts(numerator, denominator))
    }

    /// |a|.
    #[must_use]
    pub fn magnitude(&self) -> Self {
        if self.is_negative() { self.clone().neg() } else { self.clone() }
    }

    /// Whether this is below zero.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        self.parts().0.sign() == Sign::Negative
    }

    /// Bits of the numerator or the denominator, whichever is longer.
    pub(crate) fn bits(&self) -> usize {
        self.parts().0.bit_len().max(self.parts().1.bit_len())
    }

    /// Whether this is a whole number.
    #[must_use]
    pub fn is_integer(&self) -> bool {
        self.parts().1.is_one()
    }

    /// The number as a natural one, when it is that and fits.
    pub(crate) fn to_natural(&self) -> Option<u64> {
        self.is_integer().then(|| u64::try_from(self.parts().0).ok()).flatten()
    }

    /// The root, when it is a fraction.
    #[must_use]
    pub fn square_root(&self) -> Option<Self> {
        self.root(2)
    }

    /// The n-th root, when it is a fraction; not negative for even n.
    fn root(&self, n: usize) -> Option<Self> {
        let exact = |whole: &UBig| Some(whole.nth_root(n)).filter(|root| root.pow(n) == *whole);
        let (numerator, denominator) = self.parts();
        let (sign, magnitude) = numerator.clone().into_parts();
        if n == 0 || (sign == Sign::Negative && n.is_multiple_of(2)) {
            return None;
        }
        Some(Self::from_parts(sign * IBig::from(exact(&magnitude)?), exact(denominator)?))
    }

    /// The fraction of least denominator strictly between two others.
    pub(crate) fn simplest_between(low: &Self, high: &Self) -> Self {
        Self(RBig::simplest_in(low.0.clone(), high.0.clone()))
    }

    /// The nearest whole number.
    pub(crate) fn rounded(&self) -> Self {
        Self(RBig::from(self.0.round()))
    }

    /// A fraction of few digits, smaller by at most 1/1024 of this positive one.
    pub(crate) fn coarsened(&self) -> Self {
        let below = Rationals.multiply(self, &Self(RBig::from_parts(1023.into(), 1024_u32.into())));
        Self::simplest_between(&below, self)
    }

    /// aⁿ; `None` for a negative power of zero, or more bits than 2¹⁶.
    pub(crate) fn integer_power(&self, n: isize) -> Option<Self> {
        const BITS: usize = 1 << 16;
        let (numerator, denominator) = self.parts();
        let size = numerator.bit_len().max(denominator.bit_len());
        if (n < 0 && self.is_zero()) || (size > 1 && size.saturating_mul(n.unsigned_abs()) > BITS) {
            return None;
        }
        let power = Self::from_parts(numerator.pow(n.unsigned_abs()), denominator.pow(n.unsigned_abs()));
        if n < 0 { Self::from(1).checked_div(&power) } else { Some(power) }
    }

    pub(crate) fn divided_by_power_of_two(&self, exponent: usize) -> Self {
        Self(&self.0 / RBig::from(UBig::ONE << exponent))
    }

    /// Numerator and denominator modulo a prime, both between 0 and p − 1.
    pub(crate) fn residues(&self, prime: u64) -> (u64, u64) {
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

/// Significant digits, the first at 10^exponent, as a decimal.
fn placed(figures: &str, exponent: isize) -> String {
    let (first, rest) = figures.split_at(1);
    let whole = usize::try_from(exponent).unwrap_or(0) + 1;
    match exponent {
        0.. if figures.len() > whole => format!("{}.{}", &figures[..whole], &figures[whole..]),
        0..=20 => format!("{figures:0<whole$}"),
        -4..0 => format!("0.{}{figures}", "0".repeat(exponent.unsigned_abs() - 1)),
        _ if rest.is_empty() => format!("{first}e{exponent}"),
        _ => format!("{first}.{rest}e{exponent}"),
    }
}

/// The field of all fractions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rationals;

impl Ring for Rationals {
    type Element = Rational;

    fn zero(&self) -> Rational {
        Rational(RBig::ZERO)
    }

    fn is_zero(&self, a: &Rational) -> bool {
        a.is_zero()
    }

    fn rational(&self, value: &Rational) -> Option<Rational> {
        Some(value.clone())
    }

    fn add(&self, a: &Rational, b: &Rational) -> Rational {
        Rational(&a.0 + &b.0)
    }

    fn subtract(&self, a: &Rational, b: &Rational) -> Rational {
        Rational(&a.0 - &b.0)
    }

    fn negate(&self, a: &Rational) -> Rational {
        Rational(-&a.0)
    }

    fn multiply(&self, a: &Rational, b: &Rational) -> Rational {
        Rational(&a.0 * &b.0)
    }

    fn times_integer(&self, a: &Rational, factor: i64) -> Rational {
        Rational(&a.0 * IBig::from(factor))
    }

    fn divide(&self, a: &Rational, divisor: &Rational) -> Option<Rational> {
        a.checked_div(divisor)
    }

    fn over_integer(&self, a: &Rational, divisor: u64) -> Option<Rational> {
        (divisor != 0).then(|| Rational(&a.0 / IBig::from(divisor)))
    }

    /// The rational values at rational places: those at zero, ln 1, and the roots of squares.
    fn value(&self, function: Function, at: &Rational) -> Option<Rational> {
        let one = Rational::from(1);
        match function {
            Function::Sqrt => at.square_root(),
            Function::Abs => Some(at.magnitude()),
            Function::Cos | Function::Cosh | Function::Exp => at.is_zero().then_some(one),
            Function::Ln | Function::Acos => (*at == one).then(|| self.zero()),
            Function::Sin
            | Function::Tan
            | Function::Asin
            | Function::Atan
            | Function::Sinh
            | Function::Tanh => at.is_zero().then(|| self.zero()),
        }
    }

    fn power(&self, a: &Rational, exponent: &Rational) -> Option<Rational> {
        let (numerator, denominator) = exponent.parts();
        let root = a.root(usize::try_from(denominator).ok()?)?;
        root.integer_power(isize::try_from(numerator).ok()?)
    }

    fn pi(&self) -> Option<Rational> {
        None
    }

    /// Over common denominators, so that one greatest common divisor is taken for each coefficient.
    fn series_product(&self, a: &[Rational], b: &[Rational], length: usize) -> Vec<Rational> {
        let ((a, under_a), (b, under_b)) = (over_common(a, length), over_common(b, length));
        let denominator = under_a * under_b;
        let mut products = product(&a, &b);
        products.resize(length, IBig::ZERO);
        products.into_iter().map(|sum| Rational::from_parts(sum, denominator.clone())).collect()
    }
}

/// The first numerators over the least common denominator, and the latter.
fn over_common(series: &[Rational], length: usize) -> (Vec<IBig>, UBig) {
    let series = &series[..series.len().min(length)];
    let common = series.iter().fold(UBig::ONE, |common, fraction| {
        let denominator = fraction.parts().1;
        if (&common % denominator).is_zero() {
            common
        } else {
            let gcd = (&common).gcd(denominator);
            common / gcd * denominator
        }
    });
    let numerator = |fraction: &Rational| {
        let (numerator, denominator) = fraction.parts();
        numerator * IBig::from(&common / denominator)
    };
    (series.iter().map(numerator).collect(), common)
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
    fn decimals_have_the_digits_asked_for() {
        for (text, digits, decimal) in [
            ("1/3", 5, "0.33333"),
            ("-2/3", 3, "-0.667"),
            ("999999/1000", 3, "1000"),
            ("1/80000", 4, "1.25e-5"),
            ("123456789", 3, "123000000"),
            ("355/113", 10, "3.14159292"),
            ("0", 7, "0"),
            ("1/1024", 20, "0.0009765625"),
        ] {
            assert_eq!(rational(text).to_decimal(digits), decimal);
        }
        let power = rational("7").integer_power(100).unwrap();
        assert_eq!(power.to_decimal(6), "3.23448e84");
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
