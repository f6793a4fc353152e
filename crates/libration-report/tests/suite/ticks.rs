//! The ticks of axes.

use libration_report::chart::{Axis, Units};
use libration_report::internals::ticks::{choices, chosen};

fn labels_of(axis: &Axis, length: f64) -> Vec<String> {
    chosen(axis, length, |label| 8.0 * label.chars().map(|_| 1.0).sum::<f64>())
        .labelled
        .into_iter()
        .map(|label| label.1)
        .collect()
}

#[test]
fn degrees_have_ticks_where_people_look_for_them() {
    let axis = |from, to| Axis::linear("", from, to).in_units(Units::Degrees);
    assert_eq!(labels_of(&axis(0.0, 180.0), 400.0), ["0", "30", "60", "90", "120", "150", "180"]);
    assert_eq!(labels_of(&axis(0.0, 180.0), 60.0), ["0", "90", "180"]);
    assert_eq!(labels_of(&axis(0.0, 63.0), 400.0), ["0", "15", "30", "45", "60"]);
    assert_eq!(labels_of(&axis(-100.0, 1000.0), 400.0), ["0", "180", "360", "540", "720", "900"]);
}

#[test]
fn half_turns_are_named_after_pi() {
    let axis = Axis::linear("", -3.2, 3.2).in_units(Units::HalfTurns(std::f64::consts::PI));
    assert_eq!(labels_of(&axis, 200.0), ["−π", "−π/2", "0", "π/2", "π"]);
}

#[test]
fn powers_of_ten_have_minor_ticks_between_them() {
    let axis = Axis::logarithmic("", 1e-3, 10.0);
    let ticks = chosen(&axis, 400.0, |_| 20.0);
    assert_eq!(
        ticks.labelled.iter().map(|label| label.1.as_str()).collect::<Vec<_>>(),
        ["10⁻³", "10⁻²", "10⁻¹", "10⁰", "10¹"]
    );
    assert_eq!(ticks.minor.len(), 4 * 8);
}

#[test]
fn every_axis_has_two_ticks() {
    for (from, to) in [
        (0.0, 1.0),
        (0.3, 0.9),
        (-1e-9, 2e-9),
        (1e7, 1.0001e7),
        (3.0, 17.0),
        (0.99, 1.02),
        (44.0, 47.3),
        (91.0, 119.0),
        (0.0, 359.0),
    ] {
        for units in [Units::Decimal, Units::Degrees, Units::HalfTurns(1.0)] {
            let axis = Axis::linear("", from, to).in_units(units.clone());
            let all = choices(&axis);
            assert!(
                !all.is_empty() && all.iter().all(|ticks| ticks.labelled.len() >= 2),
                "{from} {to} {units:?}: {all:?}"
            );
            let parts = all.iter().flat_map(|ticks| &ticks.labelled).map(|tick| tick.0);
            assert!(parts.into_iter().all(|part| (-1e-6..=1.0 + 1e-6).contains(&part)));
        }
    }
    for (from, to) in [(1e-8, 10.0), (2e-3, 5e-3), (0.5, 1.5), (1e-300, 1e300), (0.2, 30.0)] {
        let all = choices(&Axis::logarithmic("", from, to));
        assert!(!all.is_empty() && all.iter().all(|ticks| ticks.labelled.len() >= 2), "{from} {to}: {all:?}");
    }
}
