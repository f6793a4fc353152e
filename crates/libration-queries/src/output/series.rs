//! Power series with exact coefficients, to read and in LaTeX.

use super::{mathml, screen};
use libration::algebra::{LaurentPolynomial, LetterPower, Rational};
use libration::comparison::Radius;
use libration::expression::{Expression, Symbol};
use libration::perturbation::{Certainty, Precision};

/// The notation of coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Notation {
    /// The precision of coefficients.
    pub precision: Precision,
    /// The notation of the series.
    pub style: Style,
}

/// The notation of a series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Plain text.
    Text,
    /// LaTeX.
    Latex,
    /// Text with fewer digits of coefficients that are not fractions.
    Sentence,
    /// MathML.
    MathMl,
}

/// Digits of a number in a sentence.
const SHORT: usize = 12;

/// The coefficients of a series: a fraction, a number in digits, or a formula of letters.
pub trait Coefficient: Sized {
    fn is_zero(&self) -> bool;
    /// The coefficient as in JSON and CSV.
    fn written(&self, precision: Precision) -> String;
    /// The sign (`true` for minus) and the text after it; of a product with a power, brackets included.
    fn split(&self, notation: Notation, in_product: bool) -> (bool, String);
    /// Returns `true` if their sum is zero.
    fn is_opposite_of(&self, other: &Self) -> bool;
    /// The numbers whose sum it is, each with the powers of the symbols that follow it.
    fn in_terms(&self) -> Vec<(f64, Vec<(String, Rational)>)>;
}

impl Coefficient for Rational {
    fn is_zero(&self) -> bool {
        self.is_zero()
    }

    fn written(&self, precision: Precision) -> String {
        coefficient(self, precision)
    }

    fn split(&self, notation: Notation, _: bool) -> (bool, String) {
        let magnitude = self.magnitude();
        let text = match notation.style {
            Style::Sentence if notation.precision != Precision::Exact => magnitude.to_decimal(SHORT),
            Style::Text | Style::Sentence => notation.coefficient(&magnitude),
            Style::Latex => notation.latex_coefficient(&magnitude),
            Style::MathMl if notation.precision == Precision::Exact => mathml::fraction(&magnitude),
            Style::MathMl => mathml::number(&notation.coefficient(&magnitude)),
        };
        (self.is_negative(), text)
    }

    fn is_opposite_of(&self, other: &Self) -> bool {
        *self == -other.clone()
    }

    fn in_terms(&self) -> Vec<(f64, Vec<(String, Rational)>)> {
        vec![(self.to_f64(), vec![])]
    }
}

impl Coefficient for LaurentPolynomial {
    fn is_zero(&self) -> bool {
        self.is_zero()
    }

    fn written(&self, _: Precision) -> String {
        self.to_string()
    }

    fn split(&self, notation: Notation, in_product: bool) -> (bool, String) {
        let text = match notation.style {
            Style::Text | Style::Sentence => self.to_string(),
            Style::Latex => in_latex(self),
            Style::MathMl => mathml::sum(self),
        };
        match (self.terms().count(), in_product) {
            (1, _) if notation.style == Style::MathMl => {
                let is_negative = self.terms().any(|(factor, _)| factor.is_negative());
                let term = self.terms().map(|(factor, powers)| mathml::term(factor, &powers)).collect();
                (is_negative, term)
            }
            (1, _) => text.strip_prefix('-').map_or((false, text.clone()), |rest| (true, rest.to_owned())),
            (_, false) => (false, text),
            (_, true) if notation.style == Style::MathMl => (false, mathml::bracketed(&text)),
            (_, true) if notation.style == Style::Latex => (false, format!(r"\left({text}\right)")),
            (_, true) => (false, format!("({text})")),
        }
    }

    fn is_opposite_of(&self, other: &Self) -> bool {
        let opposite = |(factor, powers): &(&Rational, Vec<_>), (other, theirs): &(&Rational, Vec<_>)| {
            factor.is_opposite_of(other) && powers == theirs
        };
        let (terms, other): (Vec<_>, Vec<_>) = (self.terms().collect(), other.terms().collect());
        terms.len() == other.len() && terms.iter().zip(&other).all(|(term, other)| opposite(term, other))
    }

    fn in_terms(&self) -> Vec<(f64, Vec<(String, Rational)>)> {
        let powers = |powers: Vec<LetterPower<'_>>| {
            powers.into_iter().map(|power| (power.letter.to_owned(), power.exponent)).collect()
        };
        self.terms().map(|(factor, letters)| (factor.to_f64(), powers(letters))).collect()
    }
}

/// A sum of fractions of letters.
fn in_latex(polynomial: &LaurentPolynomial) -> String {
    let mut text = String::new();
    for (factor, powers) in polynomial.terms() {
        text.push_str(match (factor.is_negative(), text.is_empty()) {
            (true, true) => "-",
            (true, false) => " - ",
            (false, true) => "",
            (false, false) => " + ",
        });
        let (above, below): (Vec<_>, Vec<_>) =
            powers.into_iter().partition(|power| !power.exponent.is_negative());
        let above = latex_product(factor.magnitude().numerator(), &above);
        match latex_product(factor.denominator(), &below) {
            one if one == "1" => text.push_str(&above),
            below => text.push_str(&format!(r"\frac{{{above}}}{{{below}}}")),
        }
    }
    if text.is_empty() { "0".to_owned() } else { text }
}

fn latex_product(number: String, powers: &[LetterPower<'_>]) -> String {
    let number = (number != "1" || powers.is_empty()).then_some(number);
    let powers = powers.iter().map(|power| {
        let letter = Symbol::plain(power.letter).to_latex();
        let exponent = power.exponent.magnitude();
        match (exponent.to_natural(), exponent.numerator().as_str()) {
            (Some(1), _) => letter,
            (Some(natural), _) => format!("{letter}^{{{natural}}}"),
            (None, "1") => format!(r"\sqrt{{{letter}}}"),
            (None, odd) => format!("{letter}^{{{odd}/2}}"),
        }
    });
    number.into_iter().chain(powers).collect::<Vec<_>>().join(" ")
}

impl Notation {
    /// A coefficient alone: a fraction, or decimal digits if it is not one.
    pub(crate) fn coefficient(self, value: &Rational) -> String {
        match self.precision {
            Precision::Exact => fraction(value),
            digits => coefficient(value, digits),
        }
    }

    /// `1 - 1/16 ε² + …`, the zeros left out; `0` when all are zero.
    pub fn series<C: Coefficient>(self, coefficients: &[C], variable: &str) -> String {
        let present = coefficients.iter().enumerate().filter(|(_, value)| !value.is_zero());
        let mut text = String::new();
        for (power, value) in present {
            let (is_negative, factor) = value.split(self, power > 0);
            text.push_str(&self.sign(is_negative, text.is_empty()));
            text.push_str(&self.term(factor, variable, power));
        }
        if text.is_empty() { self.digit('0') } else { text }
    }

    fn sign(self, is_negative: bool, is_first: bool) -> String {
        match (is_negative, is_first) {
            (false, true) => String::new(),
            _ if self.style == Style::MathMl => mathml::sign(is_negative),
            (true, true) => "-".to_owned(),
            (true, false) => " - ".to_owned(),
            (false, false) => " + ".to_owned(),
        }
    }

    fn digit(self, digit: char) -> String {
        if self.style == Style::MathMl { mathml::number(&digit.to_string()) } else { digit.to_string() }
    }

    fn term(self, factor: String, variable: &str, power: usize) -> String {
        let power = self.power(variable, power);
        match (power.is_empty(), factor == self.digit('1')) {
            (true, _) => factor,
            (false, true) => power,
            (false, false) if self.style == Style::MathMl => mathml::product(&[factor, power]),
            (false, false) => format!("{factor} {power}"),
        }
    }

    fn latex_coefficient(self, value: &Rational) -> String {
        if self.precision != Precision::Exact {
            let decimal = self.coefficient(value);
            let (mantissa, exponent) = decimal.split_once('e').unwrap_or((&decimal, ""));
            let scale =
                if exponent.is_empty() { String::new() } else { format!(r" \times 10^{{{exponent}}}") };
            return format!("{mantissa}{scale}");
        }
        if value.is_integer() {
            return value.to_string();
        }
        format!(r"\frac{{{}}}{{{}}}", value.numerator(), value.denominator())
    }

    fn power(self, variable: &str, power: usize) -> String {
        match (power, self.style) {
            (0, _) => String::new(),
            (1, _) => variable.to_owned(),
            (_, Style::MathMl) => mathml::power(variable, &power.to_string()),
            (_, Style::Latex) => format!("{variable}^{{{power}}}"),
            (_, Style::Text | Style::Sentence) => format!("{variable}{}", superscript(power)),
        }
    }
}

/// A fraction as printed: as it is, or as its decimal if that is exact and much shorter, such as 1e-300.
pub(crate) fn fraction(value: &Rational) -> String {
    const LONG: usize = 40;
    let plain = value.to_string();
    if plain.len() <= LONG {
        return plain;
    }
    let decimal = Expression::Number(value.clone()).to_string();
    if 2 * decimal.len() < plain.len() { decimal } else { plain }
}

/// A fraction as it is, other numbers in decimal digits.
pub(crate) fn coefficient(value: &Rational, precision: Precision) -> String {
    match precision {
        Precision::Exact => value.to_string(),
        Precision::Digits(digits) => value.to_decimal(digits),
    }
}

/// The word for the basis of a bound.
pub(crate) fn certainty(certainty: Certainty) -> &'static str {
    match certainty {
        Certainty::Proven => "proven",
        Certainty::Estimated => "estimated",
    }
}

pub(crate) fn radius_certainty(radius: &Radius) -> Certainty {
    match radius {
        Radius::Known(_) => Certainty::Proven,
        Radius::Estimated(_) => Certainty::Estimated,
    }
}

/// A number in raised digits.
pub(crate) fn superscript(number: usize) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    number.to_string().bytes().map(|digit| DIGITS[usize::from(digit - b'0')]).collect()
}

/// A number in lowered digits.
pub(crate) fn subscript(number: usize) -> String {
    const DIGITS: [char; 10] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'];
    number.to_string().bytes().map(|digit| DIGITS[usize::from(digit - b'0')]).collect()
}

/// A series broken between its terms before this column or the end of the screen, further lines indented.
pub fn wrapped(first: &str, text: &str, column: usize) -> String {
    let column = column.min(screen::width());
    let indent = first.chars().count();
    let mut lines = vec![first.to_owned()];
    // A sign stays with its term, and a coefficient with its power.
    for term in text.replace(" + ", "\n+ ").replace(" - ", "\n- ").split('\n') {
        let line = lines.last_mut().expect("there is always a line");
        if line.chars().count() + term.chars().count() + 1 > column && line.chars().count() > indent {
            lines.push(format!("{:indent$}{term}", ""));
        } else {
            let gap = if line.chars().count() > indent { " " } else { "" };
            line.push_str(gap);
            line.push_str(term);
        }
    }
    lines.join("\n")
}
