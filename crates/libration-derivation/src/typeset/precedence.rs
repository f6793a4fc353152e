//! Precedence of the parts of a formula.

use super::super::formula::Formula;
use libration::algebra::Function;

/// Precedences, from the weakest binding, which needs brackets nearly everywhere, to the strongest, which needs none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Place {
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

pub(super) fn place(formula: &Formula) -> Place {
    match formula {
        Formula::Sum(terms) if terms.len() != 1 => Place::Sum,
        Formula::Negate(_) => Place::Sum,
        Formula::Number(value) if value.is_negative() => Place::Sum,
        Formula::Number(value) if value.denominator() != "1" => Place::Product,
        Formula::Decimal(value) if value.mantissa.starts_with('-') => Place::Sum,
        Formula::Decimal(value) if value.exponent != 0 => Place::Product,
        Formula::Series { .. } => Place::Large,
        Formula::Sum(_)
        | Formula::Product(_)
        | Formula::Fraction(..)
        | Formula::Integral { .. }
        | Formula::Derivative { .. } => Place::Product,
        Formula::Call(Function::Abs, _) => Place::Atom,
        Formula::Call(..) | Formula::Power(..) | Formula::DoubleFactorial(_) => Place::Power,
        Formula::Number(_)
        | Formula::Decimal(_)
        | Formula::Pi
        | Formula::Name(_)
        | Formula::Apply(..)
        | Formula::Agm(..)
        | Formula::Order(_) => Place::Atom,
    }
}
