//! Formulas as text that is parsed as the same tree.

use std::fmt;

use super::decimal::to_decimal;
use super::precedence::Binding;
use super::{Expression, Symbol};
use crate::algebra::Rational;

impl fmt::Display for Symbol {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}{}", self.name, "'".repeat(usize::from(self.primes)))
    }
}

/// Writes the formula with the fewest brackets from which the same tree is parsed. A number whose decimals do not end is written as a quotient.
impl fmt::Display for Expression {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(value) => write_number(value, formatter),
            Self::Pi => formatter.write_str("pi"),
            Self::Symbol(symbol) => symbol.fmt(formatter),
            Self::Negate(a) => write!(formatter, "-{}", at_least(Binding::Product, a)),
            Self::Add(a, b) => {
                write!(formatter, "{a} + {}", at_least(Binding::Product, b))
            }
            Self::Subtract(a, b) => {
                write!(formatter, "{a} - {}", at_least(Binding::Product, b))
            }
            Self::Multiply(a, b) => {
                write!(formatter, "{}*{}", at_least(Binding::Product, a), at_least(Binding::Power, b))
            }
            Self::Divide(a, b) => {
                write!(formatter, "{}/{}", at_least(Binding::Product, a), at_least(Binding::Power, b))
            }
            Self::Power(a, b) => {
                write!(formatter, "{}^{}", at_least(Binding::Atom, a), at_least(Binding::Power, b))
            }
            Self::Call(function, a) => write!(formatter, "{}({a})", function.name()),
        }
    }
}

fn write_number(value: &Rational, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
    let sign = if value.is_negative() { "-" } else { "" };
    let magnitude = value.magnitude();
    let decimal = to_decimal(&magnitude);
    write!(formatter, "{sign}{}", decimal.unwrap_or_else(|| magnitude.to_string()))
}

fn binding_of_number(value: &Rational) -> Binding {
    if to_decimal(value).is_some() { Binding::Atom } else { Binding::Product }
}

/// A part of a formula, in brackets unless it binds at least this tightly.
struct Part<'a> {
    tree: &'a Expression,
    bracketed: bool,
}

fn at_least(binding: Binding, tree: &Expression) -> Part<'_> {
    Part { tree, bracketed: Binding::from_tree(tree, binding_of_number) < binding }
}

impl fmt::Display for Part<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.bracketed { write!(formatter, "({})", self.tree) } else { self.tree.fmt(formatter) }
    }
}
