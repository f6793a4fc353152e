//! Linear least squares.

use nalgebra::{DMatrix, DVector};

/// The vector that makes the sum of squares of M·x − b least; `None` where the columns depend on each other to rounding
/// errors.
pub(crate) fn least_squares(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    if matrix.nrows() < matrix.ncols() {
        return None;
    }
    // Columns of length 1 make the singular values comparable, whatever the units.
    let lengths: Vec<f64> = matrix.column_iter().map(|column| column.norm()).collect();
    if lengths.iter().any(|length| !length.is_normal()) {
        return None;
    }
    let scaled = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, k| matrix[(i, k)] / lengths[k]);
    let svd = scaled.svd(true, true);
    // What is left of a column that the others span is rounding errors.
    let negligible = 64.0 * f64::EPSILON * svd.singular_values.max();
    if svd.singular_values.min() <= negligible {
        return None;
    }
    let solution = svd.solve(right, 0.0).ok()?;
    let solution = DVector::from_fn(solution.len(), |k, _| solution[k] / lengths[k]);
    solution.iter().all(|x| x.is_finite()).then_some(solution)
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
            let line = least_squares(&matrix, &right).unwrap();
            assert!((line[0] - 2.0).abs() < 1e-14 && (line[1] * unit - 3.0).abs() < 1e-14, "{line}");
        }
    }

    #[test]
    fn dependent_columns_are_refused() {
        let refused = |rows, numbers: &[f64], right: &[f64]| {
            let matrix = DMatrix::from_row_slice(rows, 2, numbers);
            least_squares(&matrix, &DVector::from_row_slice(right)).is_none()
        };
        assert!(refused(2, &[1.0, 2.0, 3.0, 6.0], &[1.0, 1.0]));
        assert!(refused(2, &[1.0, 0.0, 3.0, 0.0], &[1.0, 1.0]));
        assert!(refused(2, &[1.0, f64::NAN, 3.0, 1.0], &[1.0, 1.0]));
        assert!(refused(1, &[1.0, 2.0], &[1.0]));
    }
}
