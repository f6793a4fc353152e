//! Exact decimal numbers from text, limited before any arithmetic, so that every text is read quickly.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

/// Maximum length of a number's text.
pub(super) const LONGEST_TEXT: usize = 128;
/// Largest exponent; larger ones are beyond the range of `f64` whatever the digits.
const LARGEST_EXPONENT: i32 = 500;

/// A decimal number: digits · 10^exponent.
#[derive(Clone, Debug, PartialEq)]
pub struct Decimal {
    digits: IBig,
    exponent: i32,
    nearest: f64,
}

impl Decimal {
    /// The whole text as a decimal number such as `-1.25e-3`; `None` if it is not one, is too long, or is beyond the range of `f64`.
    pub fn parse(text: &str) -> Option<Self> {
        let (number, rest) = Self::split_from(text.strip_prefix('-').unwrap_or(text))?;
        let number = if text.starts_with('-') { number.negated() } else { number };
        rest.is_empty().then_some(number)
    }

    /// The `f64` nearest to the whole text, if that is a decimal number accepted by [`Self::parse`].
    pub fn nearest_to(text: &str) -> Option<f64> {
        let unsigned = text.strip_prefix('-').unwrap_or(text);
        let exponent = unsigned.find(['e', 'E']).map_or("0", |mark| &unsigned[mark + 1..]);
        let is_bounded = exponent.parse::<i32>().is_ok_and(|e| e.abs() <= LARGEST_EXPONENT);
        let is_number = !unsigned.is_empty() && number_length(unsigned) == unsigned.len() && is_bounded;
        text.parse::<f64>().ok().filter(|x| is_number && x.is_finite())
    }

    /// The unsigned decimal number at the beginning of the text, and the rest of the text.
    pub fn split_from(text: &str) -> Option<(Self, &str)> {
        let (number, rest) = text.split_at(number_length(text));
        let (mantissa, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits = UBig::from_str_radix(&format!("{whole}{fraction}"), 10).ok()?;
        let exponent = exponent.parse::<i32>().ok().filter(|e| e.abs() <= LARGEST_EXPONENT)?;
        let nearest = number.parse::<f64>().ok().filter(|x| x.is_finite())?;
        let exponent = exponent - i32::try_from(fraction.len()).ok()?;
        Some((Self { digits: digits.into(), exponent, nearest }, rest))
    }

    /// The exact decimal.
    pub fn exact(&self) -> RBig {
        let power = UBig::from(10u8).pow(self.exponent.unsigned_abs() as usize);
        if self.exponent < 0 {
            return RBig::from_parts(self.digits.clone(), power);
        }
        RBig::from(&self.digits * IBig::from(power))
    }

    /// One unit in the last digit as written: 0.001 for `1.200`.
    pub(super) fn last_place(&self) -> RBig {
        Self { digits: IBig::ONE, ..self.clone() }.exact()
    }

    /// The nearest `f64`.
    pub fn nearest(&self) -> f64 {
        self.nearest
    }

    pub(super) fn negated(self) -> Self {
        Self { digits: -self.digits, nearest: -self.nearest, ..self }
    }
}

/// The length of the longest unsigned decimal number at the beginning; zero if there is none or it is longer than [`LONGEST_TEXT`].
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
    let whole = digits(0);
    let point = usize::from(bytes.get(whole) == Some(&b'.'));
    let fraction = if point == 1 { digits(whole + 1) } else { 0 };
    if whole + fraction == 0 || whole + fraction > LONGEST_TEXT {
        return 0;
    }
    let mantissa = whole + point + fraction;
    mantissa + exponent_length(&bytes[mantissa..])
}

/// The length of an exponent such as `e-3` at the beginning of the text; zero if there is none.
pub(super) fn exponent_length(bytes: &[u8]) -> usize {
    if !matches!(bytes.first(), Some(b'e' | b'E')) {
        return 0;
    }
    let sign = usize::from(matches!(bytes.get(1), Some(b'+' | b'-')));
    match bytes[1 + sign..].iter().take_while(|b| b.is_ascii_digit()).count() {
        0 => 0,
        digits => 1 + sign + digits,
    }
}
