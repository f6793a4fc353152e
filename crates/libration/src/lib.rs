//! The large-amplitude pendulum: period, motion, harmonics and published formulas, each with its error.

mod double_double;

pub mod measurement;
pub mod quantity;
pub mod pendulum;
