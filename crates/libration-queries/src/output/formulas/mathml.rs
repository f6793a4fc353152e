//! The formulas in MathML, one a line.

use super::NamedFormula;
use crate::output::mathml::{bracketed, display, element, fraction, name, number, product};
use libration::expression::{Expression, Function};
use std::io::{self, Write};

pub(super) fn write(out: &mut dyn Write, equations: &str, formulas: &[NamedFormula]) -> io::Result<()> {
    writeln!(out, "{}", display(&element("mtext", &[equations])))?;
    for NamedFormula { meaning, text, .. } in formulas {
        let left = element("mtext", &[meaning]);
        let right =
            text.parse().map_or_else(|_| element("mtext", &[text]), |tree: Expression| written(&tree));
        writeln!(out, "{}", display(&format!("{left}<mo>=</mo>{right}")))?;
    }
    Ok(())
}

fn written(formula: &Expression) -> String {
    match formula {
        Expression::Number(value) => match formula.to_string() {
            decimal if decimal.contains('.') => number(&decimal),
            _ => fraction(value),
        },
        Expression::Pi => name("pi"),
        Expression::Symbol(symbol) => name(&symbol.name),
        Expression::Negate(a) => format!("<mo>−</mo>{}", factor(a)),
        Expression::Add(a, b) => format!("{}<mo>+</mo>{}", written(a), written(b)),
        Expression::Subtract(a, b) => format!("{}<mo>−</mo>{}", written(a), factor(b)),
        Expression::Multiply(a, b) => product(&[factor(a), factor(b)]),
        Expression::Divide(a, b) => {
            let row = |part: &Expression| element("mrow", &[&written(part)]);
            element("mfrac", &[&row(a), &row(b)])
        }
        Expression::Power(a, b) => element("msup", &[&factor(a), &element("mrow", &[&written(b)])]),
        Expression::Call(Function::Sqrt, a) => element("msqrt", &[&written(a)]),
        Expression::Call(Function::Abs, a) => element("mrow", &["<mo>|</mo>", &written(a), "<mo>|</mo>"]),
        Expression::Call(function, a) => {
            let of = element("mi", &[function.name()]);
            format!("{of}<mo>&#x2061;</mo>{}", bracketed(&written(a)))
        }
    }
}

/// A formula as a factor: sums in brackets.
fn factor(formula: &Expression) -> String {
    match formula {
        Expression::Add(..) | Expression::Subtract(..) | Expression::Negate(_) => {
            bracketed(&written(formula))
        }
        _ => written(formula),
    }
}
