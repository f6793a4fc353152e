//! The numbers in which formulas are evaluated: digits, and power series with rational coefficients.

mod digits;
mod precision;
mod power_series;
mod quadrature;

pub(super) use digits::DIGITS;
pub(super) use precision::PRECISION;
pub(super) use power_series::Coefficients;
