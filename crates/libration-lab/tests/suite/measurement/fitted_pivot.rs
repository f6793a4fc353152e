//! The error that all angles share where the pivot was found from positions.

use libration_lab::measurement::FittedPivot;

#[test]
fn errors_add_up_to_the_covariance_of_the_angles() {
    let covariance = [[4.0, -1.5], [-1.5, 2.0]];
    let derivatives = vec![[1.0, 0.0], [0.0, 1.0], [0.3, -0.7]];
    let pivot = FittedPivot { position: [0.0; 2], covariance, derivatives, contradicted_by: None };
    let [one, other] = pivot.errors();
    let variance = |row: usize| one[row] * one[row] + other[row] * other[row];
    assert!((variance(0) - 4.0).abs() < 1e-14 && (variance(1) - 2.0).abs() < 1e-14);
    // 0.09·4 + 2·0.21·1.5 + 0.49·2.
    assert!((variance(2) - 1.97).abs() < 1e-14, "{}", variance(2));
    assert!((one[0] * one[1] + other[0] * other[1] + 1.5).abs() < 1e-14);
}
