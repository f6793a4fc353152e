//! Normal gravity against the exact field of the Geodetic Reference System 1980, and published values of it.

use libration_lab::fit::{NormalGravityError, normal_gravity};

fn at(degrees: f64, height: f64) -> f64 {
    normal_gravity(degrees.to_radians(), Some(height)).unwrap().value
}

/// H. Moritz, Bull. Géod. 54, 395 (1980): equator, pole, and 45° to half a digit; the rounded constants of the closed form add 5e-11.
#[test]
fn published_values_are_reproduced() {
    for (latitude, published) in [(0.0, 9.780_326_771_5), (90.0, 9.832_186_368_5), (45.0, 9.806_199_203)] {
        for sign in [1.0, -1.0] {
            assert!(
                (at(sign * latitude, 0.0) - published).abs() < 5.5e-10,
                "{latitude}: {}",
                at(latitude, 0.0)
            );
        }
    }
}

/// Latitude in degrees, height in metres, gravity in m/s² by `reference/normal_gravity.py`: the gradient of the exact potential that the four defining
/// constants of the system make.
const EXACT: [(f64, f64, f64); 27] = [
    (0.0, 0.0, 9.78032677153),
    (0.0, 500.0, 9.77878305408),
    (0.0, 3000.0, 9.77106991166),
    (15.0, 0.0, 9.78378639766),
    (15.0, 500.0, 9.78224282725),
    (15.0, 3000.0, 9.77453041901),
    (30.0, 0.0, 9.79324870361),
    (30.0, 500.0, 9.79170553538),
    (30.0, 3000.0, 9.78399513523),
    (43.07, 0.0, 9.8044539111),
    (43.07, 500.0, 9.80291121916),
    (43.07, 3000.0, 9.79520319707),
    (45.0, 0.0, 9.80619920252),
    (45.0, 500.0, 9.80465658476),
    (45.0, 3000.0, 9.79694893309),
    (48.0, 0.0, 9.80891021518),
    (48.0, 500.0, 9.80736771266),
    (48.0, 3000.0, 9.79966063635),
    (60.0, 0.0, 9.81917838502),
    (60.0, 500.0, 9.81763631898),
    (60.0, 3000.0, 9.80993142197),
    (75.0, 0.0, 9.82869805848),
    (75.0, 500.0, 9.82715639711),
    (75.0, 3000.0, 9.81945352058),
    (90.0, 0.0, 9.83218636852),
    (90.0, 500.0, 9.83064485544),
    (90.0, 3000.0, 9.82294271929),
];

#[test]
fn the_closed_form_is_the_exact_field() {
    for (latitude, height, exact) in EXACT {
        let error = (at(latitude, height) - exact).abs();
        // The gradient, 3.1e-6 1/s², is to the first power of the flattening and of m: squares of these are 3.5e-5 of it.
        let allowed = 1e-9 + 1.1e-10 * height;
        assert!(error < allowed, "{latitude} {height}: {error:e}");
    }
}

#[test]
fn the_anomaly_depends_on_the_height() {
    let uncertainty = |height| normal_gravity(0.8, height).unwrap().uncertainty;
    assert_eq!([Some(0.0), Some(500.0)].map(uncertainty), [3e-4, 3e-4]);
    assert_eq!([Some(500.1), Some(3000.0), None].map(uncertainty), [1e-3, 1e-3, 1e-3]);
    assert_eq!(normal_gravity(0.8, None).unwrap().value, at(0.8_f64.to_degrees(), 0.0));
}

#[test]
fn places_beyond_the_earth_are_refused() {
    for latitude in [91.0_f64, -90.001, f64::NAN] {
        let refused = normal_gravity(latitude.to_radians(), None);
        assert!(matches!(refused, Err(NormalGravityError::Latitude(_))), "{latitude}");
    }
    assert!(normal_gravity(90.0_f64.to_radians(), Some(9000.0)).is_ok());
    for height in [9001.0, -501.0, f64::NAN] {
        let refused = normal_gravity(0.5, Some(height));
        assert!(matches!(refused, Err(NormalGravityError::Height(_))), "{height}");
    }
}
