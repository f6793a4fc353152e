//! The shortest decimal of a number, which is the number that was meant.

use super::decimal::Decimal;
use libration_kernels::double_double::DoubleDouble;

/// The shortest decimal that is read as a given `f64`.
pub(super) struct Shortest {
    /// Text such as `-1.25e-3`.
    text: String,
}

/// Largest power of ten that an `f64` represents exactly.
const LARGEST_POWER: u32 = 22;

impl Shortest {
    /// The shortest decimal of a finite number.
    pub(super) fn new(number: f64) -> Self {
        Self { text: format!("{number:e}") }
    }

    pub(super) fn decimal(&self) -> Option<Decimal> {
        Decimal::parse(&self.text)
    }

    /// The number in two words with a relative error of 2⁻¹⁰⁰, if the digits are few and the exponent is small.
    pub(super) fn in_two_words(&self) -> Option<DoubleDouble> {
        let (mantissa, exponent) = self.text.split_once('e')?;
        let decimals = mantissa.split_once('.').map_or(0, |(_, fraction)| fraction.len());
        let exponent = exponent.parse::<i64>().ok()? - i64::try_from(decimals).ok()?;
        let power = u32::try_from(exponent.unsigned_abs()).ok().filter(|&power| power <= LARGEST_POWER)?;
        let digits = DoubleDouble::from(exactly(mantissa.replace('.', "").parse().ok()?)?);
        let power = DoubleDouble::from((0..power).fold(1.0, |product, _| 10.0 * product));
        Some(if exponent < 0 { digits / power } else { digits * power })
    }
}

/// An integer that an `f64` represents exactly.
#[expect(clippy::cast_precision_loss, reason = "up to 2^53 nothing is lost")]
pub(super) fn exactly(whole: i64) -> Option<f64> {
    (whole.unsigned_abs() <= 1 << f64::MANTISSA_DIGITS).then_some(whole as f64)
}
