//! The range of values.

use libration_report::range::around;

#[test]
fn the_range_holds_the_values_closely() {
    let (low, high) = around([1.0, 9.0]);
    assert!((0.5..1.0).contains(&low) && (9.0..9.5).contains(&high));
    assert_eq!(around([f64::NAN]), (-1.0, 1.0));
    let (low, high) = around([3.0]);
    assert!(low < 3.0 && high > 3.0);
}
