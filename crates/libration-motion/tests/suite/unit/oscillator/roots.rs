use libration::internals::oscillator::zeros;

#[test]
fn poles_are_no_zeros() {
    assert!(zeros(|x| 1.0 / (x - 0.123)).zeros.is_empty());
    assert!(!zeros(|_| f64::NAN).has_values);
    let roots = zeros(|x| libm::exp(x) - 2.0).zeros;
    assert!((roots[0] - core::f64::consts::LN_2).abs() < 1e-15 && roots.len() == 1);
}
