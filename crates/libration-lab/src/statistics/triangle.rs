//! Reduction of the rows of a least squares problem: X = Q·R, and R with Qᵀ of the residuals has the same sums of products.

use nalgebra::DMatrix;

/// Number of rows reduced at a time: the remainder of the preceding ones is a small part of them, and all fit into the nearest cache.
const TOGETHER: usize = 256;

/// The triangle of a matrix, by Householder's reflections of groups of rows.
pub fn triangle(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let (rows, columns) = matrix.shape();
    let mut left = DMatrix::zeros(0, columns);
    for first in (0..rows).step_by(TOGETHER) {
        let more = TOGETHER.min(rows - first);
        let mut both = DMatrix::zeros(left.nrows() + more, columns);
        both.rows_mut(0, left.nrows()).copy_from(&left);
        both.rows_mut(left.nrows(), more).copy_from(&matrix.rows(first, more));
        left = if both.nrows() > columns { both.qr().r() } else { both };
    }
    left
}
