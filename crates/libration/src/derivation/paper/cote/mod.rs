//! Côté, displayed equations 1 to 37: from the energy by a substitution to the series in sin²(θ0/2).

mod energy;
mod substitution;

mod binomial;
mod period;
mod recursion;
mod terms;

use super::statement::{Check, Document, Statement};

pub(super) const STATEMENTS: &[&[Statement]] = &[
    energy::STATEMENTS,
    substitution::STATEMENTS,
    binomial::STATEMENTS,
    recursion::STATEMENTS,
    period::STATEMENTS,
];

const fn statement(
    label: &'static str,
    claim: &'static str,
    printed: &'static [&'static str],
    check: Check,
) -> Statement {
    Statement { document: Document::Cote, after: label, label, claim, printed, check }
}

/// Text that stands after an equation.
const fn text_after(
    after: &'static str,
    label: &'static str,
    claim: &'static str,
    printed: &'static [&'static str],
    check: Check,
) -> Statement {
    Statement { document: Document::Cote, after, label, claim, printed, check }
}
