//! Binding strength of formulas in output.

use super::Expression;

/// Bindings from the loosest to the tightest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Binding {
    Sum,
    /// A sign before a product.
    Sign,
    Product,
    Power,
    Atom,
}

impl Binding {
    /// Binding of a formula; `number` returns the binding of a positive number.
    pub(super) fn from_tree(tree: &Expression, number: impl Fn(&super::Rational) -> Self) -> Self {
        match tree {
            Expression::Number(value) if value.is_negative() => Self::Sign,
            Expression::Number(value) => number(value),
            Expression::Pi | Expression::Symbol(_) | Expression::Call(..) => Self::Atom,
            Expression::Negate(_) => Self::Sign,
            Expression::Add(..) | Expression::Subtract(..) => Self::Sum,
            Expression::Multiply(..) | Expression::Divide(..) => Self::Product,
            Expression::Power(..) => Self::Power,
        }
    }
}
