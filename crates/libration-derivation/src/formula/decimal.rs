//! Rounded numbers with their units.

use libration::algebra::Rational;

/// A number rounded to a few digits, with its unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decimal {
    /// The significant digits, with sign and decimal point.
    pub mantissa: String,
    /// The power of ten by which the mantissa is multiplied; zero is not printed.
    pub exponent: i32,
    /// The unit.
    pub unit: DecimalUnit,
}

/// The unit of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DecimalUnit {
    /// A plain number.
    One,
    /// Degrees of angle.
    Degree,
    /// Radians.
    Radian,
    /// Seconds.
    Second,
    /// Metres.
    Metre,
    /// Metres per second squared.
    MetrePerSecondSquared,
    /// Radians per second.
    RadianPerSecond,
}

impl Decimal {
    /// The number rounded to this many significant digits; with a power of ten if very small
    /// or very large. A value that is not finite, which derivations never have, becomes zero.
    #[doc(hidden)]
    pub fn rounded(value: f64, digits: usize, unit: DecimalUnit) -> Self {
        // Adding zero turns minus zero into zero.
        let value = if value.is_finite() { value + 0.0 } else { 0.0 };
        let scientific = format!("{value:.*e}", digits.saturating_sub(1));
        let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
        let exponent: i32 = exponent.parse().unwrap_or(0);
        if !(-4..=8).contains(&exponent) {
            return Self { mantissa: mantissa.to_owned(), exponent, unit };
        }
        let places = i32::try_from(digits).unwrap_or(i32::MAX).saturating_sub(1).saturating_sub(exponent);
        let decimals = usize::try_from(places).unwrap_or(0);
        Self { mantissa: format!("{value:.decimals$}"), exponent: 0, unit }
    }

    /// Rounds like [`rounded`](Self::rounded), without trailing zeros, for a given number.
    #[doc(hidden)]
    pub fn short(value: f64, unit: DecimalUnit) -> Self {
        let rounded = Self::rounded(value, 15, unit);
        let mantissa = match rounded.mantissa.contains('.') {
            true => rounded.mantissa.trim_end_matches('0').trim_end_matches('.').to_owned(),
            false => rounded.mantissa,
        };
        Self { mantissa, ..rounded }
    }

    /// The number as printed, without its unit.
    #[doc(hidden)]
    pub fn value(&self) -> Option<Rational> {
        let (whole, decimals) = self.mantissa.split_once('.').unwrap_or((&self.mantissa, ""));
        let digits: Rational = format!("{whole}{decimals}").parse().ok()?;
        Some(digits * power_of_ten(self.exponent - i32::try_from(decimals.len()).ok()?)?)
    }

    /// One unit of the last digit.
    #[doc(hidden)]
    pub fn last_place(&self) -> Option<Rational> {
        let decimals = self.mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        power_of_ten(self.exponent - i32::try_from(decimals).ok()?)
    }
}

fn power_of_ten(exponent: i32) -> Option<Rational> {
    let zeros = "0".repeat(usize::try_from(exponent.unsigned_abs()).ok()?);
    let text = if exponent < 0 { format!("1/1{zeros}") } else { format!("1{zeros}") };
    text.parse().ok()
}
