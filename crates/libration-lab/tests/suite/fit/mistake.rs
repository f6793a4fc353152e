//! Mistakes identified by their exact factors of g.

use libration_lab::fit::{GravityMistake, Uncertain};

fn explaining(value: f64, uncertainty: f64) -> Option<GravityMistake> {
    GravityMistake::explaining(Uncertain { value, uncertainty }, GravityMistake::anywhere_on_earth())
}

#[test]
fn exact_factors_are_named() {
    for (factor, mistake) in [
        (100.0, GravityMistake::CentimetresAsMetres),
        (0.01, GravityMistake::SwingsAsOne(10)),
        (1.0 / 25.0, GravityMistake::SwingsAsOne(5)),
        (1.0 / 400.0, GravityMistake::SwingsAsOne(20)),
        (4.0, GravityMistake::HalfPeriodsAsWhole),
        (0.25, GravityMistake::WholePeriodsAsHalf),
        (1.2 * 1.2, GravityMistake::FramesOf25As30),
        (1.0 / 1.44, GravityMistake::FramesOf30As25),
        (1e-6, GravityMistake::MillisecondsAsSeconds),
        (1e6, GravityMistake::SecondsAsMilliseconds),
    ] {
        for local in [9.764, 9.81, 9.833] {
            assert_eq!(explaining(factor * local, 1e-3 * factor), Some(mistake), "{factor} {local}");
        }
    }
    assert_eq!(explaining(9.81, 0.01), None);
    assert_eq!(explaining(2.9 * 9.81, 0.01), None);
}

/// The factor is inside or outside 2 u; g is excluded by 3 u of the logarithm, or it is not.
#[test]
fn uncertain_values_are_not_explained() {
    assert_eq!(explaining(40.0, 0.5), Some(GravityMistake::HalfPeriodsAsWhole));
    assert_eq!(explaining(40.0, 0.3), None, "more than 2 u from four times g");
    // ln 1.44 is 0.365: a relative uncertainty of 0.12 allows it, one of 0.123 does not, and with more 1 is not excluded.
    let value = 1.44 * 9.8;
    assert_eq!(explaining(value, 0.120 * value), Some(GravityMistake::FramesOf25As30));
    assert_eq!(explaining(value, 0.123 * value), None);
}

/// (30/29.97)² is 1.0020: identified only if g of the place is known.
#[test]
fn a_small_factor_needs_the_gravity_of_the_place() {
    let gravity = Uncertain { value: 9.81 * 1.002003, uncertainty: 0.003 };
    assert_eq!(GravityMistake::explaining(gravity, GravityMistake::anywhere_on_earth()), None);
    let local = Uncertain { value: 9.81, uncertainty: 3e-4 };
    assert_eq!(GravityMistake::explaining(gravity, local), Some(GravityMistake::FramesOf29As30));
}
