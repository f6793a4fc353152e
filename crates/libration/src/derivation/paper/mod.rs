//! Two published derivations checked line by line: every numbered equation, the errors in the running text, and
//! the quantitative claims with the range in which they hold.
//!
//! Each statement is kept as the document prints it, as text. A check computes what should stand there (exactly,
//! in rationals, where that can be done) and compares: the verdict follows from the comparison.
//!
//! The documents are B. Black and V. Vel, *An analysis of the large amplitude simple pendulum using Fourier
//! series*, Am. J. Phys. 91, 776 (2023), doi:10.1119/5.0130943, and J. Côté, *Period of a Pendulum*, whose
//! displayed equations are numbered here in their order.

mod finding;
mod statement;

mod compare;
mod decimals;
mod evaluate;
mod power_series;
mod printed;

mod cosines;
mod exact_motion;
mod lindstedt;
mod quadrature;
mod roots;

mod better_formulas;
mod claims;
mod errors;
mod exact;
mod fifth_order;
mod fourier;
mod truncated;

mod appendices;

mod cote;

pub use finding::{Finding, Verdict};
pub use statement::{Document, Row};

use statement::Statement;

/// Every row, in the order of the documents.
#[must_use]
pub fn rows() -> Vec<Row> {
    statements().iter().map(Statement::row).collect()
}

fn statements() -> Vec<Statement> {
    [
        exact::STATEMENTS,
        fourier::STATEMENTS,
        truncated::STATEMENTS,
        fifth_order::STATEMENTS,
        claims::STATEMENTS,
        better_formulas::STATEMENTS,
        appendices::STATEMENTS,
    ]
    .into_iter()
    .chain(cote::STATEMENTS.iter().copied())
    .flatten()
    .copied()
    .collect()
}

#[cfg(test)]
mod tests;
