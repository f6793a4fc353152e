//! Least squares next to the minimum.

use nalgebra::{DMatrix, DVector};

/// A problem of least squares at its minimum, in which parameters answer linearly to residuals.
pub(super) struct Linearised {
    pub(super) jacobian: DMatrix<f64>,
    pub(super) residuals: DVector<f64>,
    /// A row for each parameter.
    pub(super) response: DMatrix<f64>,
}
