//! The evidence, one file per kind.
#![expect(clippy::unwrap_used, reason = "a test may fail")]

mod fit;
mod measurement;
mod period_formulas;
mod quantity;
mod series;
