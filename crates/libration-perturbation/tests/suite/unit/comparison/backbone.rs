use libration::comparison::{Backbone, BackboneError};
use libration::orbit::OrbitError;
use libration::progress::Quiet;

fn backbone(equation: &str) -> Backbone {
    Backbone::new(&equation.parse().unwrap(), None, 15, &Quiet).unwrap()
}

#[test]
fn three_roads_meet_for_the_pendulum() {
    let pendulum = backbone("theta'' + 4*sin(theta) = 0");
    for amplitude in [0.05, 0.5, 1.5, 3.0] {
        let point = pendulum.at(amplitude, &Quiet);
        let (orbit, series) = (point.orbit.unwrap(), point.series.unwrap());
        let exact = point.exact.unwrap().unwrap();
        let allowed = orbit.uncertainty + exact.uncertainty;
        assert!((orbit.frequency - exact.value).abs() <= allowed, "{amplitude}");
        // What is estimated to be missing is missing, but for a factor of some units.
        let missing = (series.frequency - exact.value).abs();
        assert!(missing <= 5.0 * series.remainder.size + 1e-14, "{amplitude}: {missing:e}");
        assert!((orbit.other_side + amplitude).abs() < 1e-10);
    }
}

#[test]
fn amplitudes_count_from_the_centre() {
    let well = backbone("x'' - x + x^3 = 0");
    assert!((well.centre() - 1.0).abs() < 1e-15 && (well.omega0().unwrap() - 2.0_f64.sqrt()).abs() < 1e-15);
    let point = well.at(0.1, &Quiet);
    let series = point.series.unwrap();
    let difference = (point.orbit.unwrap().frequency - series.frequency).abs();
    assert!(difference < 5.0 * series.remainder.size && difference < 1e-11, "{difference:e}");
}

/// Frequencies by mpmath, from the beta function of a force −uⁿ.
#[test]
fn amplitudes_count_from_a_centre_without_expansion() {
    for (equation, centre, frequency) in [
        ("x'' = -(x - 1)^3", 1.0, 0.423_606_542_396_989_6),
        ("x'' = -(x + 1/3)^3", -1.0 / 3.0, 0.423_606_542_396_989_6),
        ("x'' = -(x - 2)*abs(x - 2)", 2.0, 0.646_777_389_807_447_6),
    ] {
        let curve = backbone(equation);
        assert!(curve.has_equilibrium() && (curve.centre() - centre).abs() < 1e-15, "{equation}");
        let orbit = curve.at(0.5, &Quiet).orbit.unwrap();
        assert!((orbit.frequency - frequency).abs() <= orbit.uncertainty, "{equation}: {orbit:?}");
        assert!((orbit.other_side + 0.5).abs() < 1e-9, "{equation}: {orbit:?}");
        assert_eq!(orbit.encloses, None, "{equation}");
    }
    let cubic = "x'' = -x*(x - 1)^3".parse().unwrap();
    let told = Backbone::new(&cubic, Some(&"1".parse().unwrap()), 9, &Quiet).unwrap();
    assert!(told.has_equilibrium() && (told.centre() - 1.0).abs() < 1e-15);
    let unstable = Backbone::new(&cubic, Some(&"0".parse().unwrap()), 9, &Quiet);
    assert!(matches!(unstable, Err(BackboneError::About(_))));
    assert!(!backbone("x'' = exp(x)").has_equilibrium());
}

#[test]
fn orbits_about_another_equilibrium_are_none_of_this_curve() {
    let pendulum = backbone("theta'' + sin(theta) = 0");
    assert!(matches!(pendulum.at(3.5, &Quiet).orbit, Err(OrbitError::Elsewhere { .. })));
    // The well at −1 ends at 0; beyond the motion is in the other well.
    let equation = "x'' - x + x^3 = 0".parse().unwrap();
    let well = Backbone::new(&equation, Some(&"-1".parse().unwrap()), 9, &Quiet).unwrap();
    assert!(well.at(0.9, &Quiet).orbit.is_ok());
    assert!(matches!(well.at(1.5, &Quiet).orbit, Err(OrbitError::Elsewhere { .. })));
    // Around both wells, which is not what the series is for.
    assert!(well.at(3.0, &Quiet).orbit.unwrap().encloses.is_some_and(|position| position.abs() < 1e-15));
    assert_eq!(well.at(0.9, &Quiet).orbit.unwrap().encloses, None);
}

#[test]
fn what_has_no_family_of_orbits_is_refused_for_a_reason() {
    let refusal = |text: &str| Backbone::new(&text.parse().unwrap(), None, 9, &Quiet).unwrap_err();
    assert_eq!(refusal("x'' = -y; y'' = -x"), BackboneError::SeveralCoordinates(2));
    assert_eq!(refusal("x'' = -x + cos(t)"), BackboneError::DependsOnTime);
    assert_eq!(refusal("x'' = mu*(1 - x^2)*x' - x"), BackboneError::LimitCycle("mu".to_owned()));
    assert_eq!(refusal("x'' = -k*sin(x)"), BackboneError::WithoutValue("k".to_owned()));
}
