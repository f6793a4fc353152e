//! Distribution of the errors of a state.

use super::matrix::Matrix;

/// The errors that the steps of a motion have added, each carried on to some time.
#[derive(Clone, Debug)]
pub(in crate::taylor) struct Spread {
    /// The sum of the squares of all.
    pub(in crate::taylor) squares: Matrix,
    /// The derivatives of the state by that at the start.
    pub(in crate::taylor) flow: Matrix,
    pub(in crate::taylor) product: Matrix,
}

impl Spread {
    /// The spread at the start, without errors.
    pub(in crate::taylor) fn none(numbers: usize) -> Self {
        Self { squares: Matrix::zero(numbers), flow: Matrix::one(numbers), product: Matrix::zero(numbers) }
    }

    /// Becomes one that is not known.
    pub(in crate::taylor) fn forget(&mut self) {
        self.squares.entries.fill(f64::NAN);
    }

    /// Goes on to a state that has these derivatives by the one here.
    pub(in crate::taylor) fn pass(&mut self, flow: &Matrix) {
        let Self { squares, flow: whole, product } = self;
        product.set_product(flow, whole);
        std::mem::swap(product, whole);
        // Symmetric: the transpose of M·C times that of M is M·(M·C)ᵀ.
        product.set_product(flow, squares);
        product.transpose();
        squares.set_product(flow, product);
    }

    /// Adds an error to each number.
    pub(in crate::taylor) fn blur(&mut self, errors: &[f64]) {
        for (number, error) in errors.iter().enumerate() {
            self.squares.row_mut(number)[number] += error * error;
        }
    }

    /// The root of the sum of squares of a number.
    pub(in crate::taylor) fn of(&self, number: usize) -> f64 {
        self.squares.row(number)[number].sqrt()
    }

    /// The root of the sum of squares of a sum of the components with these factors.
    pub(in crate::taylor) fn of_sum(&self, factors: &[f64]) -> f64 {
        let row = |row: usize| self.squares.row(row).iter().zip(factors).map(|(a, b)| a * b).sum::<f64>();
        let sum: f64 = factors.iter().enumerate().map(|(number, factor)| factor * row(number)).sum();
        sum.max(0.0).sqrt()
    }
}
