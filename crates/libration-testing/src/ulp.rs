//! Errors in units in the last place of a true value known to more than twice the digits of an `f64`.

use dashu_base::Sign;
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

/// A true value in two words: `hi` is the nearest `f64` and `lo` the remainder, so that hi + lo has about 32 digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Truth {
    /// The nearest `f64`.
    pub hi: f64,
    /// The remainder.
    pub lo: f64,
}

impl Truth {
    /// The sum of two words.
    pub fn from_words(hi: f64, lo: f64) -> Self {
        Self { hi, lo }
    }

    /// The value of a decimal of any length, such as `0.1772e-2` or `inf`.
    pub fn from_decimal(text: &str) -> Self {
        let hi: f64 = text.parse().unwrap();
        let lo = if hi.is_finite() { rest(text, hi) } else { 0.0 };
        Self { hi, lo }
    }

    /// The distance of `got` from the truth in ulp of the truth; infinite for a wrong NaN or infinity.
    pub fn error(self, got: f64) -> f64 {
        self.error_beyond(got, 0.0)
    }

    /// The part of the distance, in ulp, that exceeds an absolute allowance.
    pub fn error_beyond(self, got: f64, allowance: f64) -> f64 {
        if got.to_bits() == self.hi.to_bits() && !got.is_finite() {
            return 0.0;
        }
        let distance = ((got - self.hi) - self.lo).abs() - allowance;
        if distance.is_finite() { distance.max(0.0) / ulp(self.hi) } else { f64::INFINITY }
    }
}

/// The gap between neighbouring `f64` at `x`.
pub fn ulp(x: f64) -> f64 {
    let magnitude = x.abs();
    if magnitude < f64::MAX { magnitude.next_up() - magnitude } else { magnitude - magnitude.next_down() }
}

/// `text` − `hi`, subtracted exactly and rounded once.
fn rest(text: &str, hi: f64) -> f64 {
    let exact = RBig::try_from(hi).unwrap();
    (exact_decimal(text) - exact).to_f64().value()
}

fn exact_decimal(text: &str) -> RBig {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: IBig = format!("{whole}{fraction}").parse().unwrap();
    let scale = exponent.parse::<i64>().unwrap() - i64::try_from(fraction.len()).unwrap();
    let power = UBig::from(10_u8).pow(usize::try_from(scale.unsigned_abs()).unwrap());
    if scale < 0 {
        RBig::from_parts(digits, power)
    } else {
        RBig::from(digits * IBig::from_parts(Sign::Positive, power))
    }
}

/// The exact `f64` in the hexadecimal notation of C's `%a` and Python's `float.hex`.
pub fn from_hex(text: &str) -> f64 {
    let (sign, magnitude) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
    let (mantissa, exponent) = magnitude.strip_prefix("0x").unwrap().split_once('p').unwrap();
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = u64::from_str_radix(&format!("{whole}{fraction}"), 16).unwrap();
    let scale = exponent.parse::<i32>().unwrap() - 4 * i32::try_from(fraction.len()).unwrap();
    #[expect(clippy::cast_precision_loss, reason = "53 bits at most")]
    let digits = digits as f64;
    sign * libm::scalbn(digits, scale)
}

#[test]
fn a_decimal_keeps_its_digits_beyond_the_first_word() {
    let tenth = Truth::from_decimal("0.1000000000000000055511151231257827021181583404541015625");
    assert_eq!((tenth.hi, tenth.lo), (0.1, 0.0));
    let third = Truth::from_decimal("33.33333333333333333333333333333333333333e-2");
    assert_eq!(third, Truth::from_words(1.0 / 3.0, 1.850371707708594e-17));
}

#[test]
fn an_error_resolves_a_hundredth_of_an_ulp() {
    let truth = Truth::from_decimal("1.0000000000000000022204460492503130808472633361816");
    assert!((truth.error(1.0) - 0.01).abs() < 1e-12);
    assert!((truth.error(1.0_f64.next_up()) - 0.99).abs() < 1e-12);
    assert!(truth.error(f64::NAN).is_infinite());
}

#[test]
#[expect(clippy::float_cmp, reason = "reading is exact")]
fn hexadecimal_floats_are_read_exactly() {
    for x in [0.1, -core::f64::consts::PI, 1e-300, 0.0, 5e300] {
        let bits = x.to_bits();
        let exponent = i32::try_from((bits >> 52) & 0x7ff).unwrap() - 1023;
        let sign = if x < 0.0 { "-" } else { "" };
        let lead = u8::from(x != 0.0);
        let text = format!("{sign}0x{lead}.{:013x}p{exponent:+}", bits & ((1 << 52) - 1));
        assert_eq!(from_hex(&text), x, "{text}");
    }
}
