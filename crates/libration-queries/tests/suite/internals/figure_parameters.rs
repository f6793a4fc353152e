//! Parameters as pictures say them.

use libration_queries::internals::figure_parameters::{amplitude, said};

#[test]
fn parameters_have_names_and_units() {
    assert_eq!(said("l", 1.0, "m"), "l = 1 m");
    assert_eq!(said("g", 9.80665, "m/s^2"), "g = 9.80665 m/s²");
    assert_eq!(said("gamma", -0.5, ""), "γ = −0.5");
    assert_eq!(amplitude(1.0_f64.to_radians()), "θ₀ = 1°");
}
