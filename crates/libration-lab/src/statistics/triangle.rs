//! Many rows of a problem of least squares as few: X = Q·R, and R with Qᵀ of the residuals has the same sums of products.

use nalgebra::DMatrix;

/// Rows that are taken at a time: what is left of those before is a small part of them, and all fit into the nearest memory.
const TOGETHER: usize = 256;

/// The triangle of a matrix, by Householder's reflections of some rows after the other.
pub(crate) fn triangle(matrix: &DMatrix<f64>) -> DMatrix<f64> {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Fewer rows than columns, as many, one more, and some blocks with and without a rest.
    #[test]
    fn the_products_of_columns_are_kept() {
        for rows in [1, 3, 4, 255, 256, 257, 1000] {
            let matrix = DMatrix::from_fn(rows, 3, |i, k| libm::sin(crate::statistics::count(i * i + 7 * k)));
            let (whole, few) = (matrix.tr_mul(&matrix), triangle(&matrix));
            assert!(few.nrows() <= 3 && (few.tr_mul(&few) - &whole).norm() < 1e-13 * whole.norm(), "{rows}");
        }
    }
}
