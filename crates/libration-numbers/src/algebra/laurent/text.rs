//! Laurent polynomials as text.

use std::fmt;

use super::{LaurentPolynomial, LetterPower};
use crate::algebra::Rational;

/// Writes the polynomial as a formula that can be read back, such as `3*b/(8*w^2) - 5*a^2/(12*w^4)`.
impl fmt::Display for LaurentPolynomial {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_beyond_limit() {
            return formatter.write_str("?");
        }
        let mut first = true;
        for (factor, powers) in self.terms() {
            formatter.write_str(match (factor.is_negative(), first) {
                (true, true) => "-",
                (true, false) => " - ",
                (false, true) => "",
                (false, false) => " + ",
            })?;
            formatter.write_str(&term(factor, &powers))?;
            first = false;
        }
        if first { formatter.write_str("0") } else { Ok(()) }
    }
}

/// A term without its sign.
fn term(factor: &Rational, powers: &[LetterPower<'_>]) -> String {
    let (above, below): (Vec<_>, Vec<_>) = powers.iter().partition(|power| !power.exponent.is_negative());
    let above = product(factor.magnitude().numerator(), &above);
    let count = below.len() + usize::from(factor.denominator() != "1");
    let below = product(factor.denominator(), &below);
    match count {
        0 => above,
        1 => format!("{above}/{below}"),
        _ => format!("{above}/({below})"),
    }
}

fn product(number: String, powers: &[&LetterPower<'_>]) -> String {
    let number = (number != "1" || powers.is_empty()).then_some(number);
    let powers = powers.iter().map(|power| {
        let exponent = power.exponent.magnitude();
        match (exponent.to_natural(), exponent.to_string()) {
            (Some(1), _) => power.letter.to_owned(),
            (Some(natural), _) => format!("{}^{natural}", power.letter),
            (None, half) if half == "1/2" => format!("sqrt({})", power.letter),
            (None, fraction) => format!("{}^({fraction})", power.letter),
        }
    });
    number.into_iter().chain(powers).collect::<Vec<_>>().join("*")
}
