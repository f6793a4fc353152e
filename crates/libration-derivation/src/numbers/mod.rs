//! The numbers in which formulas are evaluated: floats, and power series with rational coefficients.

pub(crate) mod digits;
mod power_series;
mod precision;
mod quadrature;

pub(super) use digits::DIGITS;
pub(super) use power_series::Coefficients;
pub(super) use precision::PRECISION;
