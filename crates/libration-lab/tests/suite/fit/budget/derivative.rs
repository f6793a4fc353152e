//! Derivatives of functions of the inputs.

use libration_lab::internals::fit::budget::derivative::{derivative, second_derivative};

#[test]
fn powers_have_their_derivatives() {
    let inverse_square = |x: f64| 1.0 / (x * x);
    assert!((derivative(2.0, 2.0, inverse_square) / -0.25 - 1.0).abs() < 1e-10);
    assert!((second_derivative(2.0, 2.0, inverse_square) / 0.375 - 1.0).abs() < 1e-8);
}
