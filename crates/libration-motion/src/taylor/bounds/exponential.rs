//! The exponential of small matrices.

use super::matrix::Matrix;

/// Buffers for exponentials of matrices of one size.
#[derive(Clone, Debug)]
pub(in crate::taylor) struct Exponential {
    square: Matrix,
    cube: Matrix,
    sum: Matrix,
    product: Matrix,
}

impl Exponential {
    pub(in crate::taylor) fn new(size: usize) -> Self {
        let [square, cube, sum, product] = std::array::from_fn(|_| Matrix::zero(size));
        Self { square, cube, sum, product }
    }

    /// The exponential: Taylor's polynomial of degree 8 of the matrix divided by a power of two, squared as often as the matrix was halved.
    ///
    /// # Accuracy
    /// 2e-7, if the rounding error of large exponentials is smaller.
    pub(in crate::taylor) fn of(&mut self, exponent: &mut Matrix, exponential: &mut Matrix) {
        /// Largest number of squarings; beyond it the exponential overflows.
        const MOST_SQUARINGS: i32 = 60;
        /// Largest row sum for the polynomial: 0.7⁹/9! = 1.1e-7.
        const LARGEST: f64 = 0.7;
        let Self { square, cube, sum, product } = self;
        square.set_product(exponent, exponent);
        let mut squarings = 0;
        // The square does not depend on the units of the entries of an oscillation's matrix.
        let mut size = square.largest_row_sum().sqrt();
        while size > LARGEST && squarings < MOST_SQUARINGS {
            (size, squarings) = (0.5 * size, squarings + 1);
        }
        if squarings > 0 {
            let part = libm::ldexp(1.0, -squarings);
            exponent.entries.iter_mut().for_each(|entry| *entry *= part);
            square.entries.iter_mut().for_each(|entry| *entry *= part * part);
        }
        cube.set_product(square, exponent);
        let terms = exponent.entries.iter().zip(&square.entries).zip(&cube.entries);
        let sums = sum.entries.iter_mut().zip(&mut exponential.entries);
        for (((a, b), c), (higher, lower)) in terms.zip(sums) {
            *higher = a / 5040.0 + b / 40320.0;
            *lower = a + b / 2.0 + c / 6.0;
        }
        sum.add_to_diagonal(1.0 / 720.0);
        exponential.add_to_diagonal(1.0);
        product.set_product(cube, sum);
        product.add(1.0 / 24.0, exponent);
        product.add(1.0 / 120.0, square);
        sum.set_product(cube, product);
        exponential.add(1.0, sum);
        for _ in 0..squarings {
            product.set_product(exponential, exponential);
            std::mem::swap(product, exponential);
        }
    }
}
