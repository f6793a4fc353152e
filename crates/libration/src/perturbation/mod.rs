//! Periodic motions of any oscillator as exact series.

mod approximate;
mod certificate;
mod conservative;
mod expand;
mod expansion;
mod first_integral;
mod gauge;
mod limit_cycle;
mod lindstedt;
mod model;
mod modular;
mod open_gauge;
mod selection;
mod series_set;

pub use expand::{ExpansionError, MAX_ORDER, expand, expand_watched};
pub use expansion::{AmplitudeSeries, Certificate, Expansion, Harmonics, Precision, Variable};
pub use gauge::{Gauge, NotAGauge};
pub use open_gauge::{Condition, OpenGauge, OpenGaugeError, Powers};

#[cfg(test)]
mod tests;
