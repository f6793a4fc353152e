//! Power series with exact coefficients, to read and in LaTeX.

use super::screen;
use libration::algebra::Rational;
use libration::comparison::Radius;
use libration::expression::Expression;
use libration::perturbation::{Certainty, Precision};

/// How coefficients are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Notation {
    pub(crate) precision: Precision,
    pub(crate) style: Style,
}

/// For whom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Style {
    Text,
    Latex,
}

impl Notation {
    /// A coefficient alone: a fraction, or decimal digits where it is none.
    pub(crate) fn coefficient(self, value: &Rational) -> String {
        match self.precision {
            Precision::Exact => fraction(value),
            digits => coefficient(value, digits),
        }
    }

    /// `1 - 1/16 ε² + …`, the zeros left out; `0` when all are zero.
    pub(crate) fn series(self, coefficients: &[Rational], variable: &str) -> String {
        let present = coefficients.iter().enumerate().filter(|(_, value)| !value.is_zero());
        let mut text = String::new();
        for (power, value) in present {
            let sign = match (value.is_negative(), text.is_empty()) {
                (true, true) => "-",
                (true, false) => " - ",
                (false, true) => "",
                (false, false) => " + ",
            };
            text.push_str(sign);
            text.push_str(&self.term(&value.magnitude(), variable, power));
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }

    fn term(self, value: &Rational, variable: &str, power: usize) -> String {
        let factor = match self.style {
            Style::Text => self.coefficient(value),
            Style::Latex => self.latex_coefficient(value),
        };
        let power = self.power(variable, power);
        match (power.is_empty(), *value == Rational::from(1)) {
            (true, _) => factor,
            (false, true) => power,
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
            (_, Style::Latex) => format!("{variable}^{{{power}}}"),
            (_, Style::Text) => format!("{variable}{}", superscript(power)),
        }
    }
}

/// A fraction as people read it: as it is, or as the decimal that it is where that is much shorter, such as 1e-300.
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

/// The word for what a bound rests on.
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
pub(crate) fn wrapped(first: &str, text: &str, column: usize) -> String {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn list(texts: &[&str]) -> Vec<Rational> {
        texts.iter().map(|text| text.parse().unwrap()).collect()
    }

    #[test]
    fn series_read_as_they_are_written_by_hand() {
        let text = Notation { precision: Precision::Exact, style: Style::Text };
        assert_eq!(text.series(&list(&["1", "0", "-1/16", "0", "11/3072"]), "ε"), "1 - 1/16 ε² + 11/3072 ε⁴");
        assert_eq!(text.series(&list(&["0", "-1", "2"]), "μ"), "-μ + 2 μ²");
        assert_eq!(text.series(&list(&["0", "0"]), "ε"), "0");
        let latex = Notation { style: Style::Latex, ..text };
        assert_eq!(
            latex.series(&list(&["0", "1", "-1/192"]), r"\epsilon"),
            r"\epsilon - \frac{1}{192} \epsilon^{2}"
        );
    }

    #[test]
    fn long_series_are_broken_between_terms() {
        assert_eq!(wrapped("x = ", "1 - 1/16 ε² + 11/3072 ε⁴", 18), "x = 1 - 1/16 ε²\n    + 11/3072 ε⁴");
    }
}
