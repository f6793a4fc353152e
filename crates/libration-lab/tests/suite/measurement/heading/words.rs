//! The words that name quantities, in the languages that instruments speak.

use libration_lab::internals::measurement::heading::words::{Words, is_of_acceleration};
use libration_lab::measurement::QuantityKind;

#[test]
fn numbers_behind_a_symbol_are_no_part_of_it() {
    for (name, quantity, index) in [
        ("t_{1}", QuantityKind::Time, Some("1")),
        ("$t_1$", QuantityKind::Time, Some("1")),
        ("theta2", QuantityKind::Angle, Some("2")),
        ("\\theta_{12}", QuantityKind::Angle, Some("12")),
        ("x₃", QuantityKind::X, Some("3")),
        ("t", QuantityKind::Time, None),
        ("Kanal 1", QuantityKind::Other, None),
    ] {
        let words = Words::read(name);
        assert_eq!((words.quantity, words.index.as_deref()), (quantity, index), "{name}");
    }
}

#[test]
fn accelerations_are_known_by_name_and_unit() {
    for name in ["Acceleration x", "Linear Accelerometer z", "Beschleunigung", "Absolute acceleration"] {
        assert_eq!(Words::read(name).quantity, QuantityKind::Acceleration, "{name}");
    }
    for name in ["Angular acceleration", "Winkelbeschleunigung", "a"] {
        assert_eq!(Words::read(name).quantity, QuantityKind::Other, "{name}");
    }
    assert!(is_of_acceleration("m/s^2") && is_of_acceleration("m / s²") && !is_of_acceleration("g"));
}
