//! The value about which a pendulum swings, fixed or followed if it drifts.

use libration_lab::internals::fit::cycles::centre::Centre;
use libration_lab::internals::fit::cycles::turning_point::Extreme;

fn extremes(centre: impl Fn(f64) -> f64) -> Vec<Option<Extreme>> {
    let extreme = |k: u32| {
        let (time, side) = (f64::from(k), if k.is_multiple_of(2) { 1.0 } else { -1.0 });
        // A decay by a hundredth a swing.
        let value = side * (1.0 - 0.01 * time) + centre(time);
        Some(Extreme { time, value, uncertainty: 1e-4 })
    };
    (0..40).map(extreme).collect()
}

#[test]
fn the_decay_does_not_move_the_centre() {
    let centre = Centre::fixed(0.0).renewed(&extremes(|_| 0.3));
    assert!((centre.value.value - 0.3).abs() < 1e-12 && centre.wander.to_bits() == 0, "{centre:?}");
    assert!((centre.at(7.3) - 0.3).abs() < 1e-12);
}

#[test]
fn a_decay_that_is_no_straight_line_does_not_move_the_centre() {
    for rate in [0.02, 0.05, 0.09] {
        let extreme = |k: u32| {
            let (time, side) = (f64::from(k), if k.is_multiple_of(2) { 1.0 } else { -1.0 });
            Some(Extreme { time, value: side * libm::exp(-rate * time) + 0.1, uncertainty: 1e-4 })
        };
        let centre = Centre::fixed(0.0).renewed(&(0..40).map(extreme).collect::<Vec<_>>());
        assert!((centre.value.value - 0.1).abs() < 1e-5, "{centre:?}");
        assert!(centre.wander.to_bits() == 0, "{centre:?}");
    }
}

#[test]
fn a_centre_that_moves_is_followed() {
    let centre = Centre::fixed(0.0).renewed(&extremes(|t| 0.002 * t));
    assert!(centre.wander > 0.01 && (centre.at(20.5) - 0.041).abs() < 1e-6, "{centre:?}");
}
