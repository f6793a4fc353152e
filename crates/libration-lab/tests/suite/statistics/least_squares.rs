//! Linear least squares, weighted or generalised: y = X·β + e.

use libration_lab::internals::statistics::least_squares::{
    Design, ROUNDING, Undetermined, least_squares, weighted_least_squares,
};
use nalgebra::{DMatrix, DVector};

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

/// Columns with an angle between them of the size of their accuracy, and a smaller accuracy.
#[test]
fn columns_depend_on_each_other_as_far_as_they_are_exact() {
    let beside = |angle: f64| DMatrix::from_row_slice(2, 2, &[1.0, 1.0, 0.0, angle]);
    assert!(Design::new(&beside(1.1e-11), 1e-11).is_ok());
    assert!(Design::new(&beside(0.9e-11), 1e-11).is_err());
    assert!(Design::new(&beside(0.9e-11), ROUNDING).is_ok());
}
