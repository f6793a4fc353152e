//! Fractions written with some decimal digits.

use dashu::integer::UBig;

use super::Rational;

impl Rational {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn rational(text: &str) -> Rational {
        text.parse().unwrap()
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
}
