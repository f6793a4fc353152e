//! Sizes that reach down to nothing.

use libration_queries::internals::cusps::sizes;

#[test]
fn a_change_of_sign_reaches_down_to_nothing() {
    let sizes = sizes(&[(0.0, 1.0), (2.0, -1.0)]);
    let (x, least) = sizes.iter().copied().min_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
    assert!((x - 1.0).abs() < 1e-15 && least == 0.0);
    assert!(sizes.windows(2).all(|pair| pair[0].0 <= pair[1].0));
}

#[test]
fn what_is_not_a_number_stays_so() {
    assert!(sizes(&[(0.0, f64::NAN), (1.0, 1.0)])[0].1.is_nan());
}
