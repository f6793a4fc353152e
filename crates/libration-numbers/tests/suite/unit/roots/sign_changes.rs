use libration::roots::polynomial_sign_changes;

fn assert_near(coefficients: &[f64], expected: &[f64], tolerance: f64) {
    let zeros = polynomial_sign_changes(coefficients).unwrap();
    assert_eq!(zeros.len(), expected.len(), "{coefficients:?}: {zeros:?}");
    for (zero, expected) in zeros.iter().zip(expected) {
        assert!((zero - expected).abs() <= tolerance * expected.abs(), "{zero} {expected}");
    }
}

#[test]
fn sign_changes_are_found_everywhere() {
    // (x − 1)(x − 2)(x + 300).
    assert_near(&[600.0, -898.0, 297.0, 1.0], &[-300.0, 1.0, 2.0], 1e-12);
    for none in [&[1.0, 0.0, 1.0][..], &[1.0], &[], &[0.0], &[3.0, 0.0]] {
        assert_eq!(polynomial_sign_changes(none), Some(vec![]));
    }
    // (x − 1)³ changes its sign at its zero; (x − 1)²(x + 2) changes it at −2 and touches zero at 1.
    assert_near(&[-1.0, 3.0, -3.0, 1.0], &[1.0], 1e-4);
    assert!(polynomial_sign_changes(&[2.0, -3.0, 0.0, 1.0]).unwrap().contains(&-2.0));
}

#[test]
fn extreme_coefficients_and_zeros_at_the_top_change_nothing() {
    assert_near(&[-6.0, 2.0, 0.0, 0.0], &[3.0], 0.0);
    assert_near(&[-1e-200, 1e-200], &[1.0], 1e-15);
    assert_near(&[-2e300, 0.0, 1e300], &[-std::f64::consts::SQRT_2, std::f64::consts::SQRT_2], 1e-15);
    assert_near(&[1e-200, 0.0, -1e-200], &[-1.0, 1.0], 1e-15);
    assert_eq!(polynomial_sign_changes(&[1e300, 0.0, 1e-300]), None);
    assert_eq!(polynomial_sign_changes(&[f64::INFINITY, 0.0, 1.0]), None);
    assert_eq!(polynomial_sign_changes(&[1.0, f64::NAN, 1.0]), None);
}
