//! Lindstedt–Poincaré expansions: frequency and harmonics of an oscillator as power series, exact.

mod open_gauge;

pub use open_gauge::{Condition, OpenGauge, OpenGaugeError, Powers};
