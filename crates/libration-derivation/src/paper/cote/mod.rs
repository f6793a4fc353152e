//! Côté, displayed equations 1 to 37: from the energy by a substitution to the series in sin²(θ0/2).

mod energy;
mod substitution;
mod binomial;
mod period;
mod recursion;
mod terms;

use super::statement::{PrintedStatement, statement, text_after};

pub(super) const STATEMENTS: &[&[PrintedStatement]] = &[
    energy::STATEMENTS,
    substitution::STATEMENTS,
    binomial::STATEMENTS,
    recursion::STATEMENTS,
    period::STATEMENTS,
];
