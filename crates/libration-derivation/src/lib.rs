//! Worked derivations: every step in sentences and formulas, and every formula checked as it is written.
//!
//! A [`Derivation`] is data. Its formulas are trees that are printed and evaluated: what a reader sees is what was
//! checked, exactly with fractions where that is possible, else in 77 digits at several amplitudes, or against the
//! library's exact solution. A [`CheckedEquation`] cannot be made without passing its check.
//!
//! ```
//! use libration_derivation::{elliptic, to_markdown};
//! let derivation = elliptic(None)?;
//! assert!(to_markdown(&derivation).contains("K"));
//! # Ok::<(), libration_derivation::DerivationError>(())
//! ```

mod formula;
mod prose;
mod typeset;

mod document;

mod check;
mod evaluate;
mod numbers;
mod phase;
mod trials;
mod words;

mod averaging;
mod elliptic;
mod limit_cycle;
mod lindstedt;
mod published;

mod exercises;
mod print;
mod python;

pub mod paper;

#[cfg(test)]
mod tests;

pub use averaging::{HIGHEST_AMPLITUDE_ORDER, HIGHEST_DAMPING_ORDER, averaging, averaging_watched};
pub use check::{Against, Check, CheckedEquation, ComparedAt, DerivationError, Letters, OpenCondition};
pub use check::{
    AveragedClaim, AveragedFormula, CycleClaim, CycleFormula, CycleQuantity, FlowTerms, ForceTerm,
    TruncatedClaim, TruncatedFormula,
};
pub use document::{Block, Cells, Derivation, DerivationStep, DerivationTable};
pub use elliptic::elliptic;
pub use evaluate::NoEvaluation;
pub use formula::{Decimal, DecimalUnit, Formula, Name, Relation, Statement, Subscript};
pub use limit_cycle::{HIGHEST_CYCLE_ORDER, limit_cycle, limit_cycle_watched};
pub use lindstedt::{HIGHEST_ORDER, Released, perturbation, perturbation_watched};
pub use print::{to_html, to_latex, to_markdown, to_notebook};
pub use prose::{Prose, Span};
pub use published::formulas;
pub use trials::Swing;
pub use typeset::{formula_latex, statement_latex};
