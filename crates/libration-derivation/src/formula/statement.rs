//! Statements: formulas with relations between them.

use super::Formula;

/// The relation of a formula to the previous one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// Equal.
    Equal,
    /// Equal by definition of the left side.
    Defined,
    /// Equal to the printed digits.
    Rounded,
    /// Less than the next formula.
    Less,
}

/// A chain such as a = b = c ≈ 1.07.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement {
    /// The first formula.
    pub first: Formula,
    /// The following formulas, each with its relation.
    pub rest: Vec<(Relation, Formula)>,
}

impl Statement {
    /// left = right.
    #[doc(hidden)]
    pub fn equal(left: impl Into<Formula>, right: impl Into<Formula>) -> Self {
        Self { first: left.into(), rest: vec![(Relation::Equal, right.into())] }
    }

    /// left ≔ right.
    pub(crate) fn defined(left: impl Into<Formula>, right: impl Into<Formula>) -> Self {
        Self { first: left.into(), rest: vec![(Relation::Defined, right.into())] }
    }

    /// … = next.
    pub(crate) fn and_equal(self, next: impl Into<Formula>) -> Self {
        self.and(Relation::Equal, next)
    }

    /// The chain continued by a formula with this relation.
    pub(crate) fn and(mut self, relation: Relation, next: impl Into<Formula>) -> Self {
        self.rest.push((relation, next.into()));
        self
    }
}

impl From<Formula> for Statement {
    fn from(formula: Formula) -> Self {
        Self { first: formula, rest: Vec::new() }
    }
}
