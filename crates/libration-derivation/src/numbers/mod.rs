//! The numbers in which formulas are evaluated: floats, and power series.

pub(crate) mod digits;
mod power_series;
mod precision;
mod quadrature;

pub(super) use digits::DIGITS;
pub(super) use precision::PRECISION;
