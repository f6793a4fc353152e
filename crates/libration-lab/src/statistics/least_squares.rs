//! Linear least squares, weighted or generalised: y = X·β + e.
//!
//! X has a row for each datum and a column for each coefficient. The errors e are independent with variance one once rows and
//! values are multiplied by their weights, one over their standard deviations; where errors are correlated, L⁻¹ of each column
//! and of the values is such a problem, with the covariance L·Lᵀ.

use nalgebra::{DMatrix, DVector};

/// Length below which a column that the preceding columns span is zero, relative to its original length: 64 units in the last place.
pub const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Reason why data do not determine coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Undetermined {
    /// Fewer rows than columns, or no column.
    TooFewRows,
    /// A number that is not finite, or too large to be squared.
    NotFinite,
    /// The columns before this one, counted from zero, span it; or it is zero.
    Dependent {
        /// The column.
        column: usize,
    },
}

/// The matrix X of a linear model, factored into orthogonal columns and a triangle: X = Q·R.
#[derive(Clone, Debug)]
pub struct Design {
    orthogonal: DMatrix<f64>,
    /// R⁻¹.
    inverse: DMatrix<f64>,
}

impl Design {
    /// Factors a matrix whose columns are exact to this fraction of their lengths, [`ROUNDING`] if they contain only rounding errors.
    pub fn new(matrix: &DMatrix<f64>, exactness: f64) -> Result<Self, Undetermined> {
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

    /// (XᵀX)⁻¹Xᵀ: a row for each coefficient, with its derivatives with respect to the values.
    pub fn pseudo_inverse(&self) -> DMatrix<f64> {
        &self.inverse * self.orthogonal.transpose()
    }

    /// (XᵀX)⁻¹: the covariance of the coefficients for unit variance of the errors, in products of their units.
    pub(crate) fn covariance(&self) -> DMatrix<f64> {
        &self.inverse * self.inverse.transpose()
    }

    /// The logarithm of the determinant of `XᵀX`.
    pub(crate) fn log_determinant(&self) -> f64 {
        -2.0 * self.inverse.diagonal().iter().map(|entry| libm::log(entry.abs())).sum::<f64>()
    }

    /// Component of a vector that is orthogonal to the span of the columns.
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
pub struct LinearFit {
    /// Coefficients, in the order of the columns.
    pub coefficients: DVector<f64>,
    /// Covariance of the coefficients, where the weights are right; without weights in units of the variance of a row.
    pub covariance: DMatrix<f64>,
    /// y − X·β, times the weights.
    pub residuals: DVector<f64>,
    /// The logarithm of the determinant of `XᵀX`.
    pub log_determinant: f64,
}

impl LinearFit {
    /// The sum of the squares of the residuals.
    pub fn chi2(&self) -> f64 {
        self.residuals.norm_squared()
    }
}

/// The best coefficients where all rows count alike.
pub fn least_squares(matrix: &DMatrix<f64>, values: &DVector<f64>) -> Result<LinearFit, Undetermined> {
    Design::new(matrix, ROUNDING)?.solve(values)
}

/// The best coefficients where rows have these weights, one over their standard deviations; zero for rows that do not count.
pub fn weighted_least_squares(
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

/// Returns `true` if parameters whose weights are renewed in rounds have settled: the last round changed them by less than a millionth of their
/// standard deviations, or by rounding. The covariance is that for rows with this variance at unit weight.
pub(crate) fn is_settled(last: &[f64], next: &[f64], covariance: &DMatrix<f64>, variance: f64) -> bool {
    /// A change relative to the standard deviation.
    const NEGLIGIBLE: f64 = 1e-6;
    /// A change relative to the parameter that rounding errors of a search may cause.
    const ROUNDING_OF_SEARCH: f64 = 1e-10;
    last.iter().zip(next).enumerate().all(|(k, (last, next))| {
        let deviation = (variance * covariance[(k, k)]).sqrt();
        (next - last).abs() <= NEGLIGIBLE * deviation + ROUNDING_OF_SEARCH * next.abs()
    })
}
