//! The large-amplitude pendulum: period, motion, harmonics and published formulas, each with its error.

mod double_double;

pub mod algebra;
mod series;

pub mod quantity;
pub mod pendulum;
pub mod period_formulas;
