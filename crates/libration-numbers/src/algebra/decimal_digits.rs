//! Fractions as decimals with a given number of digits.

use dashu_base::BitTest;
use dashu_int::{IBig, UBig};

use super::Rational;

impl Rational {
    /// The number rounded to this many significant decimal digits, such as `-1.0833e-7`; without a power of ten from 0.0001 up to integers that
    /// have as many digits as requested.
    #[must_use]
    pub fn to_decimal(&self, digits: usize) -> String {
        let digits = digits.max(1);
        if self.is_zero() {
            return "0".to_owned();
        }
        let (figures, exponent) = self.leading_figures(digits);
        let sign = if self.is_negative() { "-" } else { "" };
        format!("{sign}{}", placed(figures.to_string().trim_end_matches('0'), exponent))
    }

    /// The nearest decimal with a number of significant digits.
    #[doc(hidden)]
    pub fn rounded_to_digits(&self, digits: usize) -> Self {
        if self.is_zero() {
            return self.clone();
        }
        let (figures, exponent) = self.leading_figures(digits.max(1));
        let shift = exponent + 1 - isize::try_from(digits.max(1)).unwrap_or(isize::MAX);
        let figures = if self.is_negative() { -IBig::from(figures) } else { figures.into() };
        match shift {
            0.. => Self::from_parts(figures * IBig::from(ten_to(shift)), UBig::ONE),
            _ => Self::from_parts(figures, ten_to(shift)),
        }
    }

    /// The leading digits of |a|, rounded, and the power of ten of the first of them.
    fn leading_figures(&self, digits: usize) -> (UBig, isize) {
        let end = ten_to(isize::try_from(digits).unwrap_or(isize::MAX));
        let mut exponent = self.decimal_exponent();
        let mut figures = self.figures(digits, exponent);
        // The estimate may be low, and rounding may carry into a new digit.
        while figures >= end {
            exponent += 1;
            figures = self.figures(digits, exponent);
        }
        (figures, exponent)
    }

    /// The power of ten of the first digit, or at most two less. The estimate uses the numbers of bits, since writing out numbers of a million
    /// bits is slow.
    fn decimal_exponent(&self) -> isize {
        let (numerator, denominator) = self.parts();
        let bits = |length: usize| i128::try_from(length).unwrap_or(i128::MAX);
        // |a| is larger than 2 to this power.
        let power = bits(numerator.bit_len()) - bits(denominator.bit_len()) - 1;
        // Bounds of log₁₀ 2.
        let log10_of_two = if power < 0 { 301_029_995_663_982 } else { 301_029_995_663_981 };
        let exponent = (power * log10_of_two).div_euclid(1_000_000_000_000_000);
        isize::try_from(exponent).unwrap_or(isize::MAX)
    }

    /// The integer nearest to |a|·10^(digits − 1 − exponent).
    fn figures(&self, digits: usize, exponent: isize) -> UBig {
        let (numerator, denominator) = self.parts();
        let (_, magnitude) = numerator.clone().into_parts();
        let shift = isize::try_from(digits).unwrap_or(isize::MAX) - 1 - exponent;
        let (upper, lower) = if shift >= 0 {
            (magnitude * ten_to(shift), denominator.clone())
        } else {
            (magnitude, denominator * ten_to(shift))
        };
        (upper * 2_u8 + &lower) / (lower * 2_u8)
    }
}

/// Ten to the absolute value of a power.
fn ten_to(power: isize) -> UBig {
    UBig::from(10_u8).pow(power.unsigned_abs())
}

/// Significant digits, the first of which stands at 10^exponent, as a decimal.
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
