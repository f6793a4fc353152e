//! The large-amplitude pendulum: period, motion, harmonics and published formulas, each with its error.

mod dispatch;
mod double_double;
mod elementary;

pub mod elliptic;
pub mod quantity;
pub mod pendulum;
