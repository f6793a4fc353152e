//! Côté, displayed equations 1 to 37: from the energy by a substitution to the series in sin²(θ0/2).

mod energy;
mod series;
mod substitution;

use super::statement::{Check, Document, Statement};

pub(super) const STATEMENTS: &[&[Statement]] =
    &[energy::STATEMENTS, substitution::STATEMENTS, series::STATEMENTS];

const fn statement(
    label: &'static str,
    claim: &'static str,
    printed: &'static [&'static str],
    check: Check,
) -> Statement {
    Statement { document: Document::Cote, label, claim, printed, check }
}
