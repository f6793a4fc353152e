//! Exact decimal numbers: from text to fraction and back.

use dashu_int::{IBig, UBig};

use crate::algebra::Rational;

/// Limits for a number in a formula: the number of digits, and the power of ten.
pub(super) const LONGEST: usize = 1000;
/// Largest number of zeros that are written out instead of a power of ten.
const ZEROS: usize = 20;

/// digits · 10^exponent for a text of decimal digits; `None` beyond `LONGEST`.
pub fn from_digits(digits: &str, exponent: i64) -> Option<Rational> {
    let significant = digits.trim_start_matches('0').trim_end_matches('0');
    if significant.is_empty() {
        return Some(Rational::from(0));
    }
    let zeros = digits.len() - digits.trim_end_matches('0').len();
    let exponent = exponent.checked_add(i64::try_from(zeros).ok()?)?;
    let power = usize::try_from(exponent.unsigned_abs()).ok()?;
    if significant.len() > LONGEST || power > LONGEST {
        return None;
    }
    let digits = IBig::from_str_radix(significant, 10).ok()?;
    let power = UBig::from(10u8).pow(power);
    Some(match exponent {
        ..0 => Rational::from_parts(digits, power),
        _ => Rational::from_parts(digits * IBig::from(power), UBig::ONE),
    })
}

/// A nonnegative number as a decimal such as `12`, `0.125` or `1e-30`; `None` if the decimals do not end.
pub fn to_decimal(value: &Rational) -> Option<String> {
    let (numerator, denominator) = value.parts();
    let decimals = decimal_places(denominator)?;
    let scaled = numerator * IBig::from(UBig::from(10u8).pow(decimals) / denominator);
    let digits = scaled.to_string();
    let significant = digits.trim_end_matches('0');
    let zeros = digits.len() - significant.len();
    Some(if zeros > ZEROS {
        format!("{significant}e{zeros}")
    } else if decimals > digits.len() + ZEROS {
        format!("{digits}e-{decimals}")
    } else if decimals == 0 {
        digits
    } else {
        let padded = format!("{digits:0>width$}", width = decimals + 1);
        let (whole, fraction) = padded.split_at(padded.len() - decimals);
        format!("{whole}.{fraction}")
    })
}

/// The smallest n for which the denominator divides 10ⁿ, if there is one.
fn decimal_places(denominator: &UBig) -> Option<usize> {
    let twos = denominator.trailing_zeros()?;
    let (mut rest, mut fives) = (denominator >> twos, 0);
    let five = UBig::from(5u8);
    while (&rest % &five).is_zero() {
        rest /= &five;
        fives += 1;
    }
    rest.is_one().then_some(twos.max(fives))
}
