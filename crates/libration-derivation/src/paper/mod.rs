//! Two published derivations checked line by line: every numbered equation, the errors
//! in the text, and the quantitative claims with the ranges in which they hold.
//!
//! Each statement is kept as text, as the document prints it. A check computes the correct statement
//! (exactly, in fractions, if possible) and compares: the verdict follows from the comparison.
//!
//! The documents are B. Black and V. Vel, *An analysis of the large amplitude simple pendulum using Fourier series*, Am. J. Phys. 91, 776
//! (2023), doi:10.1119/5.0130943, and J. Côté, *Period of a Pendulum*, whose displayed equations are numbered here in order.
//!
//! ```
//! use libration_derivation::paper::{StatementVerdict, rows};
//! let rows = rows();
//! let row = rows.iter().find(|row| row.label == "(25)").ok_or("missing")?;
//! assert_eq!(row.finding.verdict, StatementVerdict::Wrong);
//! assert_eq!(row.finding.correct, "Delta^2 = 1 - a1^2/8 - a1*a3/8 - a3^2/4");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Method
//! A check is a function that parses the text of a statement with `expression`, evaluates it in a suitable ring (numbers, power series,
//! polynomials with undetermined constants) and compares it with the result of an independent method; if that fails, the statement is undecided.
//! A formula for a statement in words is marked as a paraphrase. Verdicts are not stored: the tests change every number and every sign of a
//! verified statement and check that the verdict changes, and correct the wrong ones and check that they are verified. The tolerances of
//! comparisons of numbers, 1e-3 to 1e-15, lie between the rounding of the evaluation and the effect of such a change.

mod finding;
pub(crate) mod statement;
mod black_vel;
mod cote;

// Interpretation and comparison of printed formulas.
mod compare;
mod evaluate;
mod printed;

// Exact results for the comparison.
mod amplitudes;
pub(crate) mod cosines;
mod errors;
mod exact_motion;
pub(crate) mod lindstedt;
mod orders;
mod period_series;
mod quadrature;
mod sine;

pub use finding::{StatementFinding, StatementVerdict};
pub use statement::{Document, Row};

use statement::{PrintedStatement, in_order};

/// Every statement with its verdict, in the order of the documents.
#[must_use]
pub fn rows() -> Vec<Row> {
    rows_where(|_, _| true)
}

/// The findings for the statements chosen by document and label; only these are checked.
#[must_use]
pub fn rows_where(chosen: impl Fn(Document, &str) -> bool) -> Vec<Row> {
    let asked = statements().into_iter().filter(|(document, statement)| chosen(*document, statement.label));
    asked.map(|(document, statement)| statement.row(document)).collect()
}

/// All statements with their documents, in order.
pub fn statements() -> Vec<(Document, PrintedStatement)> {
    let documents = [(Document::BlackVel, black_vel::STATEMENTS), (Document::Cote, cote::STATEMENTS)];
    let of = |(document, groups)| in_order(groups).into_iter().map(move |statement| (document, *statement));
    documents.into_iter().flat_map(of).collect()
}
