//! Distribution of the errors of a state.

use super::matrix::Matrix;

/// The errors that the steps of a motion have added, each propagated to a common time.
#[derive(Clone, Debug)]
pub(in crate::taylor) struct Spread {
    /// The sum of the squares of all errors, as a covariance matrix.
    pub(in crate::taylor) squares: Matrix,
    /// The derivatives of the state by the state at the start.
    pub(in crate::taylor) flow: Matrix,
    pub(in crate::taylor) product: Matrix,
}

impl Spread {
    /// The spread at the start, without errors.
    pub(in crate::taylor) fn none(numbers: usize) -> Self {
        Self { squares: Matrix::zero(numbers), flow: Matrix::one(numbers), product: Matrix::zero(numbers) }
    }

    /// Marks the spread as unknown.
    pub(in crate::taylor) fn forget(&mut self) {
        self.squares.entries.fill(f64::NAN);
    }

    /// Propagates the spread to a state with these derivatives by the present one.
    pub(in crate::taylor) fn pass(&mut self, flow: &Matrix) {
        let Self { squares, flow: whole, product } = self;
        product.set_product(flow, whole);
        std::mem::swap(product, whole);
        // The result is symmetric: the transpose of M·C times that of M is M·(M·C)ᵀ.
        product.set_product(flow, squares);
        product.transpose();
        squares.set_product(flow, product);
    }

    /// Adds an error to each component.
    pub(in crate::taylor) fn blur(&mut self, errors: &[f64]) {
        for (number, error) in errors.iter().enumerate() {
            self.squares.row_mut(number)[number] += error * error;
        }
    }

    /// The square root of the sum of squares of a component.
    pub(in crate::taylor) fn of(&self, number: usize) -> f64 {
        self.squares.row(number)[number].sqrt()
    }

    /// The square root of the sum of squares of a linear combination of the components with these factors.
    pub(in crate::taylor) fn of_sum(&self, factors: &[f64]) -> f64 {
        let row = |row: usize| self.squares.row(row).iter().zip(factors).map(|(a, b)| a * b).sum::<f64>();
        let sum: f64 = factors.iter().enumerate().map(|(number, factor)| factor * row(number)).sum();
        sum.max(0.0).sqrt()
    }
}
