//! Periodic motions of any oscillator as exact series.

mod certificate;
mod conservative;
mod expansion;
mod gauge;
mod limit_cycle;
mod lindstedt;
mod model;
mod modular;
mod open_gauge;
mod selection;
mod series_set;

pub use expansion::{AmplitudeSeries, Certificate, Expansion, Harmonics, Precision, Variable};
pub use gauge::{Gauge, NotAGauge};
pub use open_gauge::{Condition, OpenGauge, OpenGaugeError, Powers};

#[cfg(test)]
mod tests;
