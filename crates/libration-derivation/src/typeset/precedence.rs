//! Precedence of the parts of a formula.

use super::super::formula::Formula;
use libration::algebra::Function;

/// Precedences, from the weakest binding, which needs brackets nearly everywhere, to the strongest, which needs none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Precedence {
    /// a + b, −a.
    Sum,
    /// Σ, which extends to the end of its summand.
    Large,
    /// a·b, and functions without brackets.
    Product,
    /// aᵇ.
    Power,
    /// A letter, a number, a function with brackets.
    Atom,
}

pub(super) fn precedence(formula: &Formula) -> Precedence {
    match formula {
        Formula::Sum(terms) if terms.len() != 1 => Precedence::Sum,
        Formula::Negate(_) => Precedence::Sum,
        Formula::Number(value) if value.is_negative() => Precedence::Sum,
        Formula::Number(value) if value.denominator() != "1" => Precedence::Product,
        Formula::Decimal(value) if value.mantissa.starts_with('-') => Precedence::Sum,
        Formula::Decimal(value) if value.exponent != 0 => Precedence::Product,
        Formula::Series { .. } => Precedence::Large,
        Formula::Sum(_)
        | Formula::Product(_)
        | Formula::Fraction(..)
        | Formula::Integral { .. }
        | Formula::Derivative { .. } => Precedence::Product,
        Formula::Call(Function::Abs, _) => Precedence::Atom,
        Formula::Call(..) | Formula::Power(..) | Formula::DoubleFactorial(_) => Precedence::Power,
        Formula::Number(_)
        | Formula::Decimal(_)
        | Formula::Pi
        | Formula::Name(_)
        | Formula::Apply(..)
        | Formula::Agm(..)
        | Formula::Order(_) => Precedence::Atom,
    }
}
