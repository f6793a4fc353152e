//! Reduction of the rows of a least squares problem: X = Q·R, and R with Qᵀ of the residuals has the same sums of products.

use libration_lab::internals::statistics::triangle::triangle;
use nalgebra::DMatrix;

/// Fewer rows than columns, as many, one more, and several blocks with and without a remainder.
#[test]
fn the_products_of_columns_are_kept() {
    for rows in [1, 3, 4, 255, 256, 257, 1000] {
        let matrix = DMatrix::from_fn(rows, 3, |i, k| {
            libm::sin(libration_lab::internals::statistics::count(i * i + 7 * k))
        });
        let (whole, few) = (matrix.tr_mul(&matrix), triangle(&matrix));
        assert!(few.nrows() <= 3 && (few.tr_mul(&few) - &whole).norm() < 1e-13 * whole.norm(), "{rows}");
    }
}
