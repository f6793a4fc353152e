#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]
//! The evidence, one file per subject.

mod series;
