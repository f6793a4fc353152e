//! The published approximations to the period, each with its exact error.
//!
//! A formula gives T/T0, the ratio of the period to that of small swings; its fractional error is formula/exact − 1. Every formula is written
//! once and evaluated in `f64`, or in floats of as many digits as its error needs.
//!
//! ```
//! # extern crate libration_pendulum as libration;
//! use libration::period_formulas::{ErrorTable, catalogue};
//! use libration::progress::Quiet;
//!
//! // The simplest published formula with an error of at most a thousandth at 90°.
//! let table = ErrorTable::new(catalogue(), &Quiet)?;
//! let simplest = table.simplest(&"90deg".parse()?, 1e-3);
//! let best = simplest.first().ok_or("none is so good")?;
//! assert!(best.fractional_error(&"90deg".parse()?).abs() < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Method
//! Each formula is written once for any `Real`. Its value is evaluated in `f64`. Its fractional error is evaluated in two words if every number
//! within their error bound rounds to the same `f64` (`quick.rs`; for many amplitudes, the exact ratios of a block at a time). Otherwise it is
//! evaluated in floats with enough bits that 60 of them are certain, up to errors that are too small for an `f64`.
//!
//! Tolerances and crossovers are zeros of these errors in ln(θ0/(π − θ0)), searched from the bottom to the top. The coefficients of the series
//! are exact integers over known denominators, from the Euler numbers, to any order.

mod by_key;
mod catalogue;
#[doc(hidden)]
pub(crate) mod error;
mod expansion;
pub(crate) mod family;
mod formula;
mod grid;
mod law;
#[doc(hidden)]
pub(crate) mod quick;
mod real;
mod search;
#[doc(hidden)]
pub(crate) mod swing;
mod worst;

pub use by_key::catalogue;
pub use expansion::{frequency_in_amplitude, period_in_amplitude, period_in_sine_squared};
pub use family::{LARGEST_PADE, MOST_TERMS};
pub use formula::{Attribution, Complexity, LeadingTerm, PeriodFormula, fractional_errors};
pub use search::{Crossover, ErrorMaximum, ErrorTable};

/// The abbreviations in [`PeriodFormula::text`] and [`PeriodFormula::derivation`], and the exact ratio in them.
pub const ABBREVIATIONS: &str = "c = cos(θ0/2), k = sin(θ0/2), s = √c, L = ln(4/c); exact: T/T0 = 1/M(1, c), M the arithmetic-geometric mean";
