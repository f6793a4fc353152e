//! Polynomials as text and as LaTeX.

use std::fmt;

use super::{Monomial, Polynomial, Rational};

/// Writes the polynomial, lower degrees first, so that every algebra system can read it: `-8 + a1^2 + a1*a3/2`.
impl fmt::Display for Polynomial {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&signed_sum(self, plain_term))
    }
}

impl Polynomial {
    /// The polynomial in LaTeX, such as `-8 + a_1^2 + \frac{1}{2} a_1 a_3`.
    #[must_use]
    pub fn to_latex(&self) -> String {
        signed_sum(self, latex_term)
    }
}

/// The terms, separated by their signs; `write` receives a positive coefficient.
fn signed_sum(polynomial: &Polynomial, write: fn(&Monomial, &Rational) -> String) -> String {
    if polynomial.is_zero() {
        return "0".to_owned();
    }
    let mut text = String::new();
    for (monomial, factor) in polynomial.terms() {
        let negative = factor.is_negative();
        text.push_str(match (text.is_empty(), negative) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        });
        text.push_str(&write(monomial, &factor.magnitude()));
    }
    text
}

/// A term in plain text: `3*A1^7/262144`, `a1*a3`, `7/2`.
fn plain_term(monomial: &Monomial, factor: &Rational) -> String {
    let powers = monomial.factors().iter().map(|(variable, exponent)| match exponent {
        1 => variable.to_string(),
        _ => format!("{variable}^{exponent}"),
    });
    let numerator = Some(factor.numerator()).filter(|digits| digits != "1" || monomial.degree() == 0);
    let product = numerator.into_iter().chain(powers).collect::<Vec<_>>().join("*");
    match factor.denominator().as_str() {
        "1" => product,
        denominator => format!("{product}/{denominator}"),
    }
}

/// A term in LaTeX: `\frac{3}{262144} A_1^7`.
fn latex_term(monomial: &Monomial, factor: &Rational) -> String {
    let powers = monomial.factors().iter().map(|(variable, exponent)| match exponent {
        1 => variable.to_latex(),
        2..=9 => format!("{}^{exponent}", variable.to_latex()),
        _ => format!("{}^{{{exponent}}}", variable.to_latex()),
    });
    let factor = match (factor.numerator(), factor.denominator().as_str()) {
        (numerator, "1") if numerator == "1" && monomial.degree() > 0 => None,
        (numerator, "1") => Some(numerator),
        (numerator, denominator) => Some(format!("\\frac{{{numerator}}}{{{denominator}}}")),
    };
    factor.into_iter().chain(powers).collect::<Vec<_>>().join(" ")
}
