use libration::algebra::Complex;

#[test]
fn quotients_undo_products() {
    for (a, b) in [((3.0, -2.0), (0.5, 4.0)), ((1e200, 1e200), (1e-180, 3e-180)), ((1.0, 0.0), (0.0, 2.0))] {
        let (a, b) = (Complex::new(a.0, a.1), Complex::new(b.0, b.1));
        assert!((a * b / b - a).abs() <= 1e-15 * a.abs());
    }
}

#[test]
fn powers_of_a_unit_turn_it() {
    assert!((Complex::unit(0.3).powi(7) - Complex::unit(2.1)).abs() < 1e-15);
}
