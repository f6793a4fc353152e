//! The median and the spread of numbers some of which may be wrong.

use libration_lab::internals::statistics::robust::robust_deviation;

#[test]
fn the_deviation_is_that_of_the_many() {
    let mut residuals: Vec<f64> = (0..100).map(|k| if k % 2 == 0 { 1.0 } else { -1.0 }).collect();
    residuals.push(1000.0);
    assert!((robust_deviation(&residuals).unwrap() - 1.0).abs() < 1e-12);
    assert_eq!(robust_deviation(&[]), None);
}
