//! Worked derivations: every step in sentences and formulas, with every printed formula checked.
//!
//! # Terms
//! A [`Derivation`] is data: **steps** of sentences and formulas. A **formula** is a tree that is both printed and evaluated, so
//! that the text a reader sees is the one checked. A [`CheckedEquation`] exists only if its **check** has passed: exactly with
//! fractions where possible, otherwise in 77 digits at several amplitudes, or against the exact solution of the library.
//!
//! # Tasks
//!
//! | item | task |
//! |---|---|
//! | [`elliptic()`] | the exact period of the pendulum: energy, elliptic integral, series, arithmetic–geometric mean |
//! | [`first_correction`] | from sin θ ≈ θ − θ³/6 to T ≈ T0(1 + θ0²/16), on two pages |
//! | [`formulas`] | the published formulas for the period |
//! | [`perturbation`] | Lindstedt's series of a free oscillator with numbers or symbols, order by order; a quarter swing under a force of two sides |
//! | [`averaging()`] | amplitude and phase under weak damping or excitation |
//! | [`slow_flow()`] | amplitude and phase with symbols, several small terms and a drive; steady states |
//! | [`limit_cycle()`] | a limit cycle, by powers of its excitation |
//! | [`paper`] | every equation of two published derivations, verified or corrected |
//! | [`to_markdown`], [`to_html`], [`to_latex`], [`to_notebook`] | a derivation as a document |
//!
//! ```
//! use libration_derivation::{elliptic, to_markdown};
//! let derivation = elliptic(None)?;
//! assert!(to_markdown(&derivation).contains("K"));
//! # Ok::<(), libration_derivation::DerivationError>(())
//! ```
//!
//! # Errors
//! [`DerivationError`] states the formula that failed its check, or the reason why an oscillator has no derivation of this kind.

mod formula;
mod prose;
mod typeset;
mod document;
mod check;
mod renaming;
mod evaluate;
mod numbers;
mod phase;
mod trials;
mod words;
mod averaging;
mod elliptic;
mod first_correction;
mod limit_cycle;
mod lindstedt;
mod published;
mod slow_flow;
mod two_sided;
mod answers;
mod exercises;
mod print;
mod python;
pub mod paper;

pub use answers::{AnswerError, Judgement};
pub use averaging::{HIGHEST_AMPLITUDE_ORDER, HIGHEST_DAMPING_ORDER, averaging};
pub use check::{Against, Check, CheckedEquation, ComparedAt, DerivationError, Letters, OpenCondition};
pub use check::{
    AveragedClaim, AveragedFormula, CycleClaim, CycleFormula, CycleQuantity, FlowTerms, ForceTerm,
    QuarterClaim, QuarterFormula, TruncatedClaim, TruncatedFormula,
};
pub use document::{Block, Cells, Derivation, DerivationStep, DerivationTable};
pub use elliptic::elliptic;
pub use evaluate::EvaluationError;
pub use first_correction::first_correction;
pub use formula::{Decimal, DecimalUnit, Formula, Name, Relation, Statement, Subscript};
pub use limit_cycle::{HIGHEST_CYCLE_ORDER, limit_cycle};
pub use lindstedt::{HIGHEST_ORDER, Released, perturbation};
pub use print::{judgement_to_html, judgement_to_markdown, to_html, to_latex, to_markdown, to_notebook};
pub use prose::{Prose, Span};
pub use published::formulas;
pub use slow_flow::slow_flow;
pub use trials::Swing;
pub use typeset::{formula_latex, statement_latex};

/// Internals that the test suite uses; they may change at any time.
#[doc(hidden)]
pub mod internals {
    pub use crate::check::{Given, equal_fractions, same_series, same_series_where};
    pub use crate::evaluate::{Values, evaluate};
    pub use crate::numbers::digits::DIGITS;
    pub use crate::trials::Trials;
    pub use crate::words::theta_0;

    pub mod build {
        pub use crate::formula::build::{
            call, double_factorial, integral, letter, number, order, series, sin, sqrt, sum, tenths,
        };
    }
    pub mod phase {
        pub use crate::phase::function::{PhaseFunction, Wave};
        pub use crate::phase::pi_number::PiNumber;
        pub use crate::phase::written::{number, series};
    }
    pub mod averaging {
        pub use crate::averaging::flow::Flow;
        pub use crate::averaging::put_back::{agrees_with_library, check};
        pub use crate::averaging::question::AveragingQuestion;
    }
    pub mod lindstedt {
        pub use crate::lindstedt::accuracy::{as_given, exactly_at, motion as motion_in_numbers};
        pub use crate::lindstedt::ansatz::fundamental_and_harmonics;
        pub use crate::lindstedt::contributions::Contributions;
        pub use crate::lindstedt::few_harmonics::step as few_harmonics;
        pub use crate::lindstedt::motion::motion;
        pub use crate::lindstedt::orders::check_contributions;
        pub use crate::lindstedt::question::LindstedtQuestion;
        pub use crate::lindstedt::substitution::{has_harmonics, solves};
        pub use crate::lindstedt::three_harmonics::check as check_three_harmonics;
        pub use crate::lindstedt::truncated::Elimination;
    }
    pub mod two_sided {
        pub use crate::two_sided::Quarter;
    }
    pub mod paper {
        pub use crate::paper::cosines::{cosine, projection, second_derivative};
        pub use crate::paper::lindstedt::Expansion;
        pub use crate::paper::statement::{NOT_EVALUATED, PrintedStatement};
        pub use crate::paper::statements;
    }
}
