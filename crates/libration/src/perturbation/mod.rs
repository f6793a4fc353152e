//! Periodic motions of any oscillator as exact series.

mod approximate;
mod certificate;
mod conservative;
mod cosines;
mod evaluation;
mod expand;
mod expansion;
mod first_integral;
mod gauge;
mod limit_cycle;
mod lindstedt;
mod model;
mod modular;
mod open_gauge;
mod relation;
mod selection;
mod series_set;
mod truncated_system;

pub use evaluation::{
    Certainty, Convergence, Evaluation, Pade, Pole, Remainder, Singularity, Step, pendulum_period_remainder,
};
pub use expand::{ExpansionError, MAX_ORDER, expand, expand_watched};
pub use expansion::{AmplitudeSeries, Certificate, Expansion, Harmonics, Precision, Variable};
pub use gauge::{Gauge, NotAGauge};
pub use open_gauge::{Condition, OpenGauge, OpenGaugeError, Powers};
pub use relation::{Approximant, ExactValue, NotAQuantity, Quantity, Radius, Relation, Road};
pub use truncated_system::{TruncatedSolution, TruncatedSystem, TruncatedSystemError, Verdict};

#[cfg(test)]
mod tests;
