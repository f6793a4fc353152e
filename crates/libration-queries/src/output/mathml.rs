//! Names, powers, fractions and sums in MathML.

use libration::algebra::{LaurentPolynomial, LetterPower, Rational};
use libration::expression::greek_letter;

const TIMES: &str = "<mo>&#x2062;</mo>";

/// An element around others.
pub(crate) fn element(tag: &str, parts: &[&str]) -> String {
    format!("<{tag}>{}</{tag}>", parts.concat())
}

pub(crate) fn number(digits: &str) -> String {
    element("mn", &[digits])
}

/// An operator, spaces as its element has them.
pub(crate) fn sign(is_negative: bool) -> String {
    element("mo", &[if is_negative { "−" } else { "+" }])
}

/// A displayed formula.
pub(crate) fn display(content: &str) -> String {
    format!(
        "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"block\"><mrow>{content}</mrow></math>"
    )
}

/// A letter with its index: ω₀ of `omega0`, k₁ of `k_1`.
pub fn name(text: &str) -> String {
    let word = text.trim_end_matches(|c: char| c.is_ascii_digit());
    let (stem, index) = match text.split_once('_') {
        Some((stem, index)) if !stem.is_empty() => (stem, index),
        _ => (word, &text[word.len()..]),
    };
    let letter = element("mi", &[&greek_letter(stem).map_or_else(|| stem.to_owned(), String::from)]);
    match index {
        "" => letter,
        digits if digits.bytes().all(|byte| byte.is_ascii_digit()) => {
            element("msub", &[&letter, &number(digits)])
        }
        word => element("msub", &[&letter, &element("mi", &[word])]),
    }
}

pub(crate) fn power(base: &str, exponent: &str) -> String {
    if exponent == "1" { base.to_owned() } else { element("msup", &[base, &number(exponent)]) }
}

/// The factors side by side, as a product.
pub(crate) fn product(factors: &[String]) -> String {
    factors.join(TIMES)
}

pub(crate) fn bracketed(content: &str) -> String {
    element("mrow", &["<mo>(</mo>", content, "<mo>)</mo>"])
}

/// A fraction that is not negative.
pub(crate) fn fraction(value: &Rational) -> String {
    quotient(&number(&value.numerator()), &value.denominator(), &[])
}

fn quotient(above: &str, denominator: &str, below: &[String]) -> String {
    let digits = (denominator != "1").then(|| number(denominator));
    let below: Vec<String> = digits.into_iter().chain(below.iter().cloned()).collect();
    match below.as_slice() {
        [] => above.to_owned(),
        below => element("mfrac", &[&element("mrow", &[above]), &element("mrow", &[&product(below)])]),
    }
}

/// A sum of fractions of letters, the sign of its first term included.
pub(crate) fn sum(polynomial: &LaurentPolynomial) -> String {
    let mut text = String::new();
    for (factor, powers) in polynomial.terms() {
        if factor.is_negative() || !text.is_empty() {
            text.push_str(&sign(factor.is_negative()));
        }
        text.push_str(&term(factor, &powers));
    }
    if text.is_empty() { number("0") } else { text }
}

/// A term without its sign.
pub(crate) fn term(factor: &Rational, powers: &[LetterPower<'_>]) -> String {
    let (above, below): (Vec<_>, Vec<_>) = powers.iter().partition(|power| !power.exponent.is_negative());
    let above: Vec<String> = above.into_iter().map(raised).collect();
    let below: Vec<String> = below.into_iter().map(raised).collect();
    let numerator = factor.magnitude().numerator();
    let digits = (numerator != "1" || above.is_empty()).then(|| number(&numerator));
    let above: Vec<String> = digits.into_iter().chain(above).collect();
    quotient(&product(&above), &factor.denominator(), &below)
}

fn raised(power: &LetterPower<'_>) -> String {
    let (letter, exponent) = (name(power.letter), power.exponent.magnitude());
    match (exponent.is_integer(), exponent.numerator().as_str()) {
        (true, natural) => self::power(&letter, natural),
        (false, "1") => element("msqrt", &[&letter]),
        (false, odd) => {
            element("msup", &[&letter, &element("mrow", &[&number(odd), "<mo>/</mo>", &number("2")])])
        }
    }
}
