//! The large-amplitude pendulum: period, motion, harmonics and published formulas, each with its error.

mod dispatch;
mod double_double;
mod elementary;
mod series;

pub mod algebra;
pub mod elliptic;
pub mod fit;
pub mod measurement;
pub mod pendulum;
pub mod period_formulas;
pub mod quantity;
