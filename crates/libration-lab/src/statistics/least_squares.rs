//! Linear least squares, weighted or generalised: y = X·β + e.
//!
//! X has a row for each datum and a column for each coefficient. The errors e are independent with variance one once rows and
//! values are multiplied by their weights, one over their standard deviations; where errors are correlated, L⁻¹ of each column
//! and of the values is such a problem, with the covariance L·Lᵀ.

use nalgebra::{DMatrix, DVector};

/// The part of its length that rounding errors leave of a column that the columns before it span: 64 units in the last place.
pub(crate) const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Why data leave coefficients open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Undetermined {
    /// Fewer rows than columns, or no column.
    TooFewRows,
    /// Something that is no number, or too large to be squared.
    NotFinite,
    /// The columns before this one, counted from zero, span it; or it is zero.
    Dependent {
        /// Which one.
        column: usize,
    },
}

/// The matrix X of a linear model, factored into orthogonal columns and a triangle: X = Q·R.
#[derive(Clone, Debug)]
pub(crate) struct Design {
    orthogonal: DMatrix<f64>,
    /// R⁻¹.
    inverse: DMatrix<f64>,
}

impl Design {
    /// Of a matrix whose columns are exact to this part of their lengths, [`ROUNDING`] where they are not computed by anything
    /// worse.
    pub(crate) fn new(matrix: &DMatrix<f64>, exactness: f64) -> Result<Self, Undetermined> {
        if matrix.is_empty() || matrix.nrows() < matrix.ncols() {
            return Err(Undetermined::TooFewRows);
        }
        // With columns of length one units do not matter.
        let lengths: Vec<f64> = matrix.column_iter().map(|column| column.norm()).collect();
        if !lengths.iter().all(|length| length.is_finite()) {
            return Err(Undetermined::NotFinite);
        }
        if let Some(column) = lengths.iter().position(|length| !length.is_normal()) {
            return Err(Undetermined::Dependent { column });
        }
        let scaled = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, k| matrix[(i, k)] / lengths[k]);
        let (orthogonal, triangle) = scaled.qr().unpack();
        let spanned = |column: &usize| triangle[(*column, *column)].abs() <= exactness;
        if let Some(column) = (0..lengths.len()).find(spanned) {
            return Err(Undetermined::Dependent { column });
        }
        let identity = DMatrix::identity(lengths.len(), lengths.len());
        let inverse = triangle.solve_upper_triangular(&identity).ok_or(Undetermined::NotFinite)?;
        let inverse = DMatrix::from_fn(lengths.len(), lengths.len(), |i, k| inverse[(i, k)] / lengths[i]);
        Ok(Self { orthogonal, inverse })
    }

    /// (XᵀX)⁻¹Xᵀ: a row for each coefficient, by which it answers to the values.
    pub(crate) fn pseudo_inverse(&self) -> DMatrix<f64> {
        &self.inverse * self.orthogonal.transpose()
    }

    /// (XᵀX)⁻¹: the covariance of the coefficients where that of the errors is one, in products of their units.
    pub(crate) fn covariance(&self) -> DMatrix<f64> {
        &self.inverse * self.inverse.transpose()
    }

    /// The logarithm of the determinant of `XᵀX`.
    pub(crate) fn log_determinant(&self) -> f64 {
        -2.0 * self.inverse.diagonal().iter().map(|entry| libm::log(entry.abs())).sum::<f64>()
    }

    /// What is left of a vector without its part in the span of the columns.
    pub(crate) fn without_span(&self, vector: &DVector<f64>) -> DVector<f64> {
        vector - &self.orthogonal * self.orthogonal.tr_mul(vector)
    }

    /// The coefficients that make the sum of squares least.
    pub(crate) fn solve(&self, values: &DVector<f64>) -> Result<LinearFit, Undetermined> {
        let components = self.orthogonal.tr_mul(values);
        let coefficients = &self.inverse * &components;
        if !coefficients.iter().all(|coefficient| coefficient.is_finite()) {
            return Err(Undetermined::NotFinite);
        }
        let residuals = values - &self.orthogonal * components;
        Ok(LinearFit {
            coefficients,
            covariance: self.covariance(),
            residuals,
            log_determinant: self.log_determinant(),
        })
    }
}

/// The best coefficients of a linear model.
#[derive(Clone, Debug)]
pub(crate) struct LinearFit {
    /// In the order of the columns.
    pub(crate) coefficients: DVector<f64>,
    /// Of the coefficients, where the weights are right; without weights in units of the variance of a row.
    pub(crate) covariance: DMatrix<f64>,
    /// y − X·β, times the weights.
    pub(crate) residuals: DVector<f64>,
    /// The logarithm of the determinant of `XᵀX`.
    pub(crate) log_determinant: f64,
}

impl LinearFit {
    /// The sum of the squares of the residuals.
    pub(crate) fn chi2(&self) -> f64 {
        self.residuals.norm_squared()
    }
}

/// The best coefficients where all rows count alike.
pub(crate) fn least_squares(matrix: &DMatrix<f64>, values: &DVector<f64>) -> Result<LinearFit, Undetermined> {
    Design::new(matrix, ROUNDING)?.solve(values)
}

/// The best coefficients where rows have these weights, one over their standard deviations; zero for rows that do not count.
pub(crate) fn weighted_least_squares(
    mut matrix: DMatrix<f64>,
    mut values: DVector<f64>,
    weights: &[f64],
) -> Result<LinearFit, Undetermined> {
    for ((mut row, value), weight) in matrix.row_iter_mut().zip(values.iter_mut()).zip(weights) {
        row *= *weight;
        *value *= weight;
    }
    least_squares(&matrix, &values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_through_points_is_the_best_one_in_any_units() {
        // Residuals (1, −2, 1)/6 are orthogonal to both columns: y = 2 + 3x.
        for unit in [1.0, 1e-100, 1e100] {
            let matrix = DMatrix::from_row_slice(3, 2, &[1.0, 0.0, 1.0, unit, 1.0, 2.0 * unit]);
            let right = DVector::from_row_slice(&[2.0 + 1.0 / 6.0, 5.0 - 2.0 / 6.0, 8.0 + 1.0 / 6.0]);
            let fit = least_squares(&matrix, &right).unwrap();
            let line = &fit.coefficients;
            assert!((line[0] - 2.0).abs() < 1e-14 && (line[1] * unit - 3.0).abs() < 1e-14, "{line}");
            assert!((fit.chi2() - 1.0 / 6.0).abs() < 1e-14, "{}", fit.chi2());
            // XᵀX = [3, 3; 3, 5] has the determinant 6.
            let covariance = [5.0 / 6.0, -0.5 / unit, -0.5 / unit, 0.5 / unit / unit];
            for (entry, expected) in fit.covariance.iter().zip(covariance) {
                assert!((entry / expected - 1.0).abs() < 1e-13, "{}", fit.covariance);
            }
            let logarithm = libm::log(6.0) + 2.0 * libm::log(unit);
            assert!((fit.log_determinant - logarithm).abs() < 1e-12);
        }
    }

    /// Weights 1, 2, 3 of a mean: (1·5 + 4·2 + 9·1)/14, with the variance 1/14; a row without weight does not count.
    #[test]
    fn weights_are_one_over_standard_deviations() {
        let values = DVector::from_row_slice(&[5.0, 2.0, 1.0, 1e9]);
        let fit = weighted_least_squares(DMatrix::repeat(4, 1, 1.0), values, &[1.0, 2.0, 3.0, 0.0]).unwrap();
        assert!((fit.coefficients[0] - 22.0 / 14.0).abs() < 1e-14);
        assert!((fit.covariance[(0, 0)] - 1.0 / 14.0).abs() < 1e-15);
        assert!((fit.residuals[1] - 2.0 * (2.0 - 22.0 / 14.0)).abs() < 1e-14 && fit.residuals[3] == 0.0);
    }

    #[test]
    fn the_pseudo_inverse_undoes_the_matrix() {
        let matrix = DMatrix::from_row_slice(4, 2, &[1.0, 2.0, 0.0, 1.0, 3.0, -1.0, 1e-3, 5.0]);
        let product = Design::new(&matrix, ROUNDING).unwrap().pseudo_inverse() * matrix;
        assert!((product - DMatrix::identity(2, 2)).norm() < 1e-14);
    }

    #[test]
    fn what_leaves_coefficients_open_is_named() {
        let refused = |rows, numbers: &[f64], right: &[f64]| {
            let matrix = DMatrix::from_row_slice(rows, 2, numbers);
            least_squares(&matrix, &DVector::from_row_slice(right)).map(|_| ()).unwrap_err()
        };
        let second = Undetermined::Dependent { column: 1 };
        assert_eq!(refused(2, &[1.0, 2.0, 3.0, 6.0], &[1.0, 1.0]), second);
        assert_eq!(refused(2, &[1.0, 0.0, 3.0, 0.0], &[1.0, 1.0]), second);
        assert_eq!(refused(2, &[0.0, 1.0, 0.0, 3.0], &[1.0, 1.0]), Undetermined::Dependent { column: 0 });
        assert_eq!(refused(2, &[1.0, f64::NAN, 3.0, 1.0], &[1.0, 1.0]), Undetermined::NotFinite);
        assert_eq!(refused(2, &[1.0, 2.0, 3.0, 1.0], &[1.0, f64::INFINITY]), Undetermined::NotFinite);
        assert_eq!(refused(1, &[1.0, 2.0], &[1.0]), Undetermined::TooFewRows);
    }

    /// Columns whose directions differ by an angle that is this exact, and one that is not.
    #[test]
    fn columns_depend_on_each_other_as_far_as_they_are_exact() {
        let beside = |angle: f64| DMatrix::from_row_slice(2, 2, &[1.0, 1.0, 0.0, angle]);
        assert!(Design::new(&beside(1.1e-11), 1e-11).is_ok());
        assert!(Design::new(&beside(0.9e-11), 1e-11).is_err());
        assert!(Design::new(&beside(0.9e-11), ROUNDING).is_ok());
    }
}
