//! Small dense matrices, stored as rows: linear equations and null spaces over any field, least squares, eigenvalues.

#[doc(hidden)]
pub(crate) mod characteristic;
#[doc(hidden)]
pub(crate) mod eigenvalues;
#[doc(hidden)]
pub(crate) mod elimination;
#[doc(hidden)]
pub(crate) mod least_squares;
