//! Displacements are read as lists and ranges.

use libration::quantity::Displacement;
use libration_queries::internals::displacements::displacements;
use libration_queries::internals::query_error::option;

fn numbers(text: &str, is_angle: bool) -> Vec<f64> {
    displacements(&option("amplitudes"), text, is_angle).unwrap().iter().map(Displacement::to_f64).collect()
}

#[test]
fn lists_and_ranges_are_read() {
    assert_eq!(numbers("0.1:0.3:0.1", false), [0.1, 0.2, 0.3]);
    assert_eq!(numbers("90deg,2rad", true), [std::f64::consts::FRAC_PI_2, 2.0]);
    assert_eq!(numbers("1e-3, 1e8", false), [1e-3, 1e8]);
    for text in ["1deg", "0:1:0.1", "-1", "a", ""] {
        assert!(displacements(&option("amplitudes"), text, false).is_err(), "{text}");
    }
}
