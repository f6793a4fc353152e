//! Formulas as printed in books: one tree that is printed, and evaluated to check the printed formula.
//!
//! # Method
//! An `Expression` of the numbers crate serves computation: elementary operations, which can be differentiated, simplified,
//! expanded and put on a tape. A formula serves readers: sums of many terms in a chosen order, indices, units, rounded
//! numbers, series, integrals, O(…). Every `Expression` can be converted to a formula (`convert.rs`), but not conversely.
//! The two share no evaluator: a formula is evaluated term by term as printed, which checks the result of the tape.

pub(crate) mod build;
mod convert;
pub(crate) mod decimal;
mod name;
mod names;
mod statement;

pub use decimal::{Decimal, DecimalUnit};
pub use name::{Name, Subscript};
pub use statement::{Relation, Statement};

pub(super) use build::*;
pub(super) use convert::laurent;

use libration::algebra::{Function, Rational};

/// A formula. Nothing is simplified: the output corresponds to the tree.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Formula {
    /// An exact number.
    Number(Rational),
    /// A rounded number, with its unit.
    Decimal(Decimal),
    /// π.
    Pi,
    /// A variable, a constant or an index.
    Name(Name),
    /// −a.
    Negate(Box<Self>),
    /// a + b + …; a summand with a leading minus is printed as a difference.
    Sum(Vec<Self>),
    /// a·b·….
    Product(Vec<Self>),
    /// a/b.
    Fraction(Box<Self>, Box<Self>),
    /// aᵇ.
    Power(Box<Self>, Box<Self>),
    /// An elementary function of its argument.
    Call(Function, Box<Self>),
    /// A function that the derivation has defined, applied to its arguments.
    Apply(Name, Vec<Self>),
    /// The arithmetic–geometric mean of two numbers.
    Agm(Box<Self>, Box<Self>),
    /// Σ of the term over the index.
    Series {
        /// The index of summation.
        index: Name,
        /// The first index.
        from: Box<Self>,
        /// The last index; `None` is ∞.
        to: Option<Box<Self>>,
        /// The term of the sum.
        term: Box<Self>,
    },
    /// ∫ of the integrand over the variable.
    Integral {
        /// The variable.
        variable: Name,
        /// The lower limit.
        from: Box<Self>,
        /// The upper limit.
        to: Box<Self>,
        /// The integrand.
        integrand: Box<Self>,
    },
    /// The derivative with respect to a variable.
    Derivative {
        /// The differentiated formula.
        of: Box<Self>,
        /// The variable.
        by: Name,
    },
    /// n!!, the product of every second integer down from n.
    DoubleFactorial(Box<Self>),
    /// Omitted terms of this order and above.
    Order(Box<Self>),
}
