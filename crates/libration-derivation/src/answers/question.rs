//! The exercises whose answers can be compared.

use super::super::check::CheckedEquation;
use super::super::formula::{DecimalUnit, Formula, Name, Relation, Subscript, number};
use libration::algebra::Function;

/// An exercise whose result is a formula of numbers, symbols and elementary functions.
#[derive(Clone, Copy)]
pub(crate) struct Question<'a> {
    /// `true` if the result is a condition: a formula that vanishes.
    pub(crate) is_zero: bool,
    /// The formula whose value is to be found, where it is elementary too.
    pub(crate) asked: Option<&'a Formula>,
    /// The formula in place of the question mark.
    pub(crate) result: &'a Formula,
}

impl<'a> Question<'a> {
    /// The exercise of which this equation is the answer; `None` if answers to it cannot be compared.
    pub(crate) fn of(equation: &'a CheckedEquation) -> Option<Self> {
        let statement = equation.statement();
        let is_equality = statement.rest.iter().all(|(relation, _)| *relation == Relation::Equal);
        let (_, last) = statement.rest.last().filter(|_| is_equality)?;
        let is_zero = statement.rest.iter().all(|(_, side)| *side == number(0));
        let result = if is_zero { &statement.first } else { last };
        if matches!(result, Formula::Order(_)) || !result.is_elementary() {
            return None;
        }
        let asked = Some(&statement.first).filter(|formula| !is_zero && formula.is_elementary());
        Some(Self { is_zero, asked, result })
    }
}

impl Formula {
    /// Returns `true` for a formula that can be typed: numbers, symbols with numbers as indices, and functions of pocket calculators; or O(…).
    pub(crate) fn is_elementary(&self) -> bool {
        match self {
            Self::Number(_) | Self::Pi | Self::Order(_) => true,
            Self::Decimal(value) => value.unit != DecimalUnit::Degree,
            Self::Name(name) => name.can_be_typed(),
            Self::Call(Function::Abs, _) => false,
            Self::Apply(..)
            | Self::Agm(..)
            | Self::Series { .. }
            | Self::Integral { .. }
            | Self::Derivative { .. }
            | Self::DoubleFactorial(_) => false,
            _ => self.parts().into_iter().all(Self::is_elementary),
        }
    }
}

impl Name {
    pub(super) fn can_be_typed(&self) -> bool {
        match &self.subscript {
            None | Some(Subscript::Word(_)) => true,
            Some(Subscript::Index(index)) => matches!(&**index, Formula::Number(_)),
        }
    }
}
