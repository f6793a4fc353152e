//! A header cell → the quantity, the unit and the run that its words name.

mod words;

use libration_lab::measurement::{Heading, QuantityKind, Unit};

#[test]
fn headers_of_instruments_are_understood() {
    use QuantityKind::{Acceleration, Angle, AngularVelocity, Gate, Other, Run, Time, X};
    for (text, quantity, unit, run) in [
        ("Time (s)", Time, "s", None),
        ("t [ms]", Time, "ms", None),
        ("t / s", Time, "s", None),
        ("time_us", Time, "us", None),
        ("Zeit t / s", Time, "s", None),
        ("Angle/rad", Angle, "rad", None),
        ("θ / °", Angle, "deg", None),
        ("winkel w / rad", Angle, "rad", None),
        ("Angle (rad) Run #3", Angle, "rad", Some("Run #3")),
        ("Angle (rad) Anna 0.02 1.5", Angle, "rad", Some("Anna 0.02 1.5")),
        ("Latest: Time (s)", Time, "s", Some("Latest")),
        ("Data Set 1:Time(s)", Time, "s", Some("Data Set 1")),
        ("Latest: GateState", Gate, "", Some("Latest")),
        ("Gyroscope x (rad/s)", AngularVelocity, "rad/s", None),
        ("x (m)", X, "m", None),
        ("x", X, "", None),
        ("packet", Run, "", None),
        ("Time shift (s)", Other, "s", None),
        ("Angular Acceleration (rad/s²)", Other, "", None),
        ("Acceleration x (m/s^2)", Acceleration, "", None),
        ("Absolute acceleration (m/s²)", Acceleration, "", None),
        ("a_x / m/s²", Acceleration, "", None),
        ("Acceleration (g)", Acceleration, "", None),
        ("t_{1}", Time, "", None),
        ("θ_{1} (deg)", Angle, "deg", None),
        ("timestamp (ns)", Time, "ns", None),
        ("t / nsec", Time, "ns", None),
        ("Angle (turns)", Angle, "turn", None),
        ("θ [rev]", Angle, "turn", None),
        ("T/2", Other, "", None),
        ("Δt (s)", Other, "s", None),
        ("Angle (furlong)", Angle, "", None),
        ("f (Hz)", Other, "Hz", None),
        ("Sampling rate / kHz", Other, "kHz", None),
    ] {
        let heading = Heading::read(text, None, None);
        let found = heading.unit.map_or(String::new(), |unit| unit.to_string());
        assert_eq!((heading.quantity, found.as_str()), (quantity, unit), "{text}: {heading:?}");
        assert_eq!(heading.run.as_deref(), run, "{text}");
    }
}

#[test]
fn uncertainties_are_told_from_what_they_belong_to() {
    for text in [
        "sigma_theta",
        "θ error",
        "σθ",
        "err_angle (rad)",
        "uncertainty of angle (deg)",
        "u(θ)",
        "u(θ) / °",
        "U(theta) (deg)",
        "σ(angle)",
        "Δθ (rad)",
        "delta_theta",
        "u_theta",
        "± (deg)",
        "+/- (rad)",
    ] {
        let heading = Heading::read(text, None, None);
        assert!(heading.is_uncertainty && heading.quantity == QuantityKind::Angle, "{text}: {heading:?}");
        assert!(!heading.is(QuantityKind::Angle));
    }
    assert!(!Heading::read("U(V)", None, None).is_uncertainty, "a voltage");
    let bare = |text| Heading::read(text, None, None).is_bare_uncertainty();
    assert!(bare("±") && bare("error (deg)") && !bare("u(θ)") && !bare("θ"));
}

#[test]
fn a_line_of_units_and_a_line_of_titles_complete_the_name() {
    let heading = Heading::read("Angle", Some("(deg)"), Some("mass_A"));
    assert_eq!((heading.quantity, heading.unit), (QuantityKind::Angle, Some(Unit::Degree)));
    assert_eq!(heading.run.as_deref(), Some("mass_A"));
}
