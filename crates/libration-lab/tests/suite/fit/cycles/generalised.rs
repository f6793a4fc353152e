//! Least squares with rows whose errors are correlated: neighbours share passages, with the opposite sign, and extremes.

use libration_lab::internals::fit::cycles::generalised::{Bands, Factor};
use nalgebra::{DMatrix, DVector};

/// Comparison with the inverse of the whole matrix.
#[test]
fn the_bands_give_what_the_whole_covariance_gives() {
    let entries = |n: usize| [if n > 1 { -0.3 } else { 0.0 }, if n > 0 { 0.2 } else { 0.0 }, 1.5];
    let noise: Bands = (0..6).map(entries).collect();
    let none = vec![[0.0; 3]; 6];
    let factor = Factor::new(&noise, &none, 1.0).unwrap();
    let matrix = DMatrix::from_fn(6, 6, |i: usize, j: usize| match i.abs_diff(j) {
        0 => 1.5,
        1 => 0.2,
        2 => -0.3,
        _ => 0.0,
    });
    let column = [1.0, -2.0, 0.5, 3.0, 0.0, 1.0];
    let white = factor.whitened(&column);
    let square = white.norm_squared();
    let vector = DVector::from_row_slice(&column);
    let whole = (vector.transpose() * matrix.clone().try_inverse().unwrap() * &vector)[(0, 0)];
    assert!((square - whole).abs() < 1e-12 * whole);
    assert!((factor.log_determinant() - libm::log(matrix.determinant())).abs() < 1e-12);
    let inverse = matrix.try_inverse().unwrap();
    for (n, entries) in factor.inverse().into_iter().enumerate() {
        for (back, entry) in entries.into_iter().rev().enumerate() {
            let expected = n.checked_sub(back).map_or(0.0, |m| inverse[(n, m)]);
            assert!((entry - expected).abs() < 1e-12, "{n} {back}");
        }
    }
}
