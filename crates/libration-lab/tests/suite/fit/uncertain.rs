//! A number with its uncertainty.

use libration::quantity::Quantity;
use libration_lab::fit::Uncertain;

#[test]
fn errors_add_as_squares() {
    let both = Uncertain { value: -2.0, uncertainty: 0.3 }.with_error(0.4);
    assert!((both.uncertainty - 0.5).abs() < 1e-15 && (both.relative() - 0.25).abs() < 1e-15);
    assert!((both.deviation_from(-1.0) - 2.0).abs() < 1e-15);
    assert_eq!(Quantity::from(both).uncertainty, Some(both.uncertainty));
}
