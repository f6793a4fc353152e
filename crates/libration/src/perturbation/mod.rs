//! Lindstedt–Poincaré expansions: frequency and harmonics of an oscillator as power series, exact.

mod cosines;
mod open_gauge;
mod truncated_system;

pub use open_gauge::{Condition, OpenGauge, OpenGaugeError, Powers};
pub use truncated_system::{TruncatedSolution, TruncatedSystem, TruncatedSystemError, Verdict};
