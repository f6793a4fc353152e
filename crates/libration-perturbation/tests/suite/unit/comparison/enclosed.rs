use libration::internals::comparison::other_equilibrium;

fn enclosed(equation: &str, centre: f64, ends: [f64; 2]) -> Option<f64> {
    other_equilibrium(&equation.parse().unwrap(), centre, ends)
}

#[test]
fn the_equilibrium_between_two_wells_is_seen_from_any_orbit_around_both() {
    let well = "x'' = x - x^3";
    for end in [1.415, 2.0, 30.0, 3e4] {
        let equilibrium = enclosed(well, 1.0, [-end, end]).unwrap();
        assert!(equilibrium.abs() < f64::MIN_POSITIVE, "{end}: {equilibrium:e}");
    }
    assert_eq!(enclosed(well, 1.0, [1e-6, 1.414]), None);
    assert_eq!(enclosed("x'' = -sin(x)", 0.0, [-3.14, 3.14]), None);
    // A force that double precision does not tell from zero about the centre.
    assert_eq!(enclosed("x'' = -x^101", 0.0, [-1.0, 1.0]), None);
    // A well of a thousandth of the swing, on the side above.
    let small = enclosed("x'' = (x - 1)*x*(1e-3 - x)", 0.0, [-2.0, 2.0]);
    assert!(small.is_some_and(|x| (x - 1e-3).abs() < 1e-15), "{small:?}");
}
