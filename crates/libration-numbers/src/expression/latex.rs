//! Formulas in LaTeX.

use super::decimal::to_decimal;
use super::letters::is_greek;
use super::precedence::Binding;
use super::{Expression, Function, Symbol};
use crate::algebra::Rational;

impl Symbol {
    /// The symbol in LaTeX: `\ddot{x}`, `\omega_{0}`, `\mathrm{mass}`.
    #[must_use]
    pub fn to_latex(&self) -> String {
        let letters = self.name.trim_end_matches(|c: char| c.is_ascii_digit());
        let (stem, index) = match self.name.split_once('_') {
            Some((stem, index)) if !stem.is_empty() => (stem, index),
            _ => (letters, &self.name[letters.len()..]),
        };
        let stem = if is_greek(stem) {
            format!("\\{stem}")
        } else if stem.len() == 1 {
            stem.to_owned()
        } else {
            format!("\\mathrm{{{}}}", escaped(stem))
        };
        let dotted = match self.primes {
            0 => stem,
            1 => format!("\\dot{{{stem}}}"),
            2 => format!("\\ddot{{{stem}}}"),
            more => format!("{stem}^{{({more})}}"),
        };
        match index {
            "" => dotted,
            _ if index.bytes().all(|b| b.is_ascii_digit()) || index.len() == 1 => {
                format!("{dotted}_{{{index}}}")
            }
            _ => format!("{dotted}_{{\\mathrm{{{}}}}}", escaped(index)),
        }
    }
}

fn escaped(name: &str) -> String {
    name.replace('_', "\\_")
}

impl Expression {
    /// The formula in LaTeX, for mathematical mode.
    #[must_use]
    pub fn to_latex(&self) -> String {
        let mut text = String::new();
        self.write_latex(&mut text);
        text
    }

    fn write_latex(&self, text: &mut String) {
        match self {
            Self::Number(value) => text.push_str(&number(value)),
            Self::Pi => text.push_str("\\pi"),
            Self::Symbol(symbol) => text.push_str(&symbol.to_latex()),
            Self::Negate(a) => {
                text.push('-');
                a.write_latex_at_least(Binding::Product, text);
            }
            Self::Add(a, b) => joined(a, " + ", b, text),
            Self::Subtract(a, b) => joined(a, " - ", b, text),
            Self::Multiply(a, b) => product(a, b, text),
            Self::Divide(a, b) => {
                text.push_str("\\frac{");
                a.write_latex(text);
                text.push_str("}{");
                b.write_latex(text);
                text.push('}');
            }
            Self::Power(a, b) => {
                a.write_base(text);
                text.push_str("^{");
                b.write_latex(text);
                text.push('}');
            }
            Self::Call(function, a) => call(*function, a, text),
        }
    }

    fn write_latex_at_least(&self, binding: Binding, text: &mut String) {
        if Binding::from_tree(self, |_| Binding::Atom) < binding {
            bracketed(self, text);
        } else {
            self.write_latex(text);
        }
    }

    /// Writes the base of a power; a derivative, a fraction or an exponential gets brackets.
    fn write_base(&self, text: &mut String) {
        let bare = match self {
            Self::Symbol(symbol) => symbol.primes < 3,
            Self::Number(value) => !value.is_negative() && value.is_integer(),
            Self::Call(function, _) => !matches!(function, Function::Exp),
            Self::Pi => true,
            _ => false,
        };
        if bare { self.write_latex(text) } else { bracketed(self, text) }
    }
}

fn bracketed(tree: &Expression, text: &mut String) {
    text.push_str("\\left(");
    tree.write_latex(text);
    text.push_str("\\right)");
}

fn joined(a: &Expression, sign: &str, b: &Expression, text: &mut String) {
    a.write_latex(text);
    text.push_str(sign);
    b.write_latex_at_least(Binding::Product, text);
}

/// Writes the factors side by side, with a dot before a digit.
fn product(a: &Expression, b: &Expression, text: &mut String) {
    a.write_latex_at_least(Binding::Product, text);
    let point = text.len();
    text.push(' ');
    b.write_latex_at_least(Binding::Product, text);
    if text[point + 1..].starts_with(|c: char| c.is_ascii_digit()) {
        text.insert_str(point, " \\cdot");
    }
}

fn call(function: Function, a: &Expression, text: &mut String) {
    let [open, close] = function.latex();
    text.push_str(open);
    a.write_latex(text);
    text.push_str(close);
}

/// A decimal, such as `3 \cdot 10^{-30}`, or a fraction.
fn number(value: &Rational) -> String {
    let sign = if value.is_negative() { "-" } else { "" };
    let magnitude = value.magnitude();
    match to_decimal(&magnitude) {
        Some(decimal) => match decimal.split_once('e') {
            Some(("1", power)) => format!("{sign}10^{{{power}}}"),
            Some((digits, power)) => format!("{sign}{digits} \\cdot 10^{{{power}}}"),
            None => format!("{sign}{decimal}"),
        },
        None => format!("{sign}\\frac{{{}}}{{{}}}", magnitude.numerator(), magnitude.denominator()),
    }
}
