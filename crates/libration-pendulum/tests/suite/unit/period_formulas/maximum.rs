use libration::internals::period_formulas::maximum_between;

#[test]
fn maxima_are_found() {
    let (place, value) = maximum_between(&mut |x| -(x - 0.3) * (x - 0.3), -1.0, 2.0, 1e-9);
    assert!((place - 0.3).abs() < 1e-8 && value.abs() < 1e-16);
}
