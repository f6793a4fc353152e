//! A header cell → the quantity, the unit and the run that its words name.

mod words;

use libration_lab::measurement::{
    Column, Heading, QuantityKind, ReadOptions, StatedUncertainty, Table, Unit,
};

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
        let notation = heading.unit.map_or(String::new(), |unit| unit.to_string());
        assert_eq!((heading.quantity, notation.as_str()), (quantity, unit), "{text}: {heading:?}");
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

#[test]
fn an_uncertainty_of_a_whole_column_is_read_from_its_heading() {
    let second = Some(Unit::Second);
    let plain = |value| StatedUncertainty { value, unit: None, is_relative: false };
    for (text, unit, stated) in [
        ("T (s) ± 0.004", second, plain(0.004)),
        ("T (s) +/- 0.004", second, plain(0.004)),
        ("T ± 0,004 (s)", second, plain(0.004)),
        ("T (±0.004 s)", second, plain(0.004)),
        ("T (s, ± 0.004)", second, plain(0.004)),
        ("T / s ± 0.004", second, plain(0.004)),
        ("T (s) ± 4 ms", second, StatedUncertainty { unit: Some(Unit::Millisecond), ..plain(4.0) }),
        ("T (s) ± 2%", second, StatedUncertainty { is_relative: true, ..plain(0.02) }),
        ("T (s) (± 0.004)", second, plain(0.004)),
    ] {
        let heading = Heading::read(text, None, None);
        assert_eq!(heading.stated_uncertainty, Some(stated), "{text}");
        assert_eq!(
            (heading.unit, heading.name.as_str(), heading.is_uncertainty),
            (unit, "T", false),
            "{text}"
        );
    }
    for text in ["± T (s)", "±", "T (s)", "uncertainty ± (s)"] {
        assert_eq!(Heading::read(text, None, None).stated_uncertainty, None, "{text}");
    }
}

#[test]
fn parts_of_the_values_are_no_numbers_in_their_unit() {
    let fraction = |heading: &str| {
        let text = format!("T (s),{heading}\n2.00,1\n2.01,1\n2.05,1\n");
        Table::read(text.as_bytes(), &ReadOptions::default()).unwrap().fraction(&Column::Number(2))
    };
    for (heading, expected) in [
        ("u (%)", Some(0.01)),
        ("u(T) in %", Some(0.01)),
        ("uncertainty %", Some(0.01)),
        ("u(T) / ‰", Some(0.001)),
        ("Unsicherheit in Prozent", Some(0.01)),
        ("relative uncertainty (%)", Some(0.01)),
        ("u (s)", None),
        ("u (68 %) (s)", None),
    ] {
        assert_eq!(fraction(heading), Ok(expected), "{heading}");
    }
    assert!(fraction("relative uncertainty").is_err());
}
