//! Small dense matrices, as rows: linear equations and null spaces over any field, least squares, eigenvalues.

mod characteristic;
mod eigenvalues;
mod elimination;
mod least_squares;

pub(crate) use characteristic::characteristic_polynomial;
pub(crate) use eigenvalues::eigenvalues;
pub(crate) use elimination::{null_space, solve};
pub(crate) use least_squares::least_squares;
