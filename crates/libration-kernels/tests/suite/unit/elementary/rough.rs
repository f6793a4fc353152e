use libration::elementary::rough::{exp2, log2};

#[test]
fn both_are_right_to_a_few_digits() {
    for n in -1000..=1000 {
        let x = 0.987 * f64::from(n);
        assert!((exp2(x) / libm::exp2(x) - 1.0).abs() < 1e-5, "{x}");
        assert!((log2(libm::exp2(x)) - x).abs() < 2e-4, "{x}");
    }
    assert!(log2(0.0).is_infinite());
    assert!((exp2(f64::NEG_INFINITY) - exp2(-1000.0)).abs() == 0.0);
}
