//! Three axes of a gyroscope → the rate about the axis of the pendulum, for any orientation of the device.

use libration_lab::internals::measurement::traces::gyroscope::{FEWEST, principal_axis};

/// Rates about an axis, with wobble across it and an offset of the sensor.
fn rows(axis: [f64; 3], wobble: f64) -> Vec<[f64; 3]> {
    let row = |n: u32| {
        let (rate, across) = (libm::sin(0.1 * f64::from(n)), wobble * libm::sin(0.37 * f64::from(n)));
        [0.3 + rate * axis[0] - across * axis[1], rate * axis[1] + across * axis[0], rate * axis[2]]
    };
    (0..630).map(row).collect()
}

#[test]
fn a_tilted_axis_is_found_whatever_the_sensor_shows_at_rest() {
    let axis = principal_axis(&rows([-0.6, 0.0, -0.8], 0.0)).unwrap();
    for (part, expected) in axis.iter().zip([0.6, 0.0, 0.8]) {
        assert!((part - expected).abs() < 1e-12, "{axis:?}");
    }
}

#[test]
fn a_device_that_turns_about_several_axes_has_none() {
    // The variance across is the square of the wobble: 4 % of that along, and 6 %, 95 % of all being 5.3 %.
    assert!(principal_axis(&rows([0.6, 0.8, 0.0], 0.2)).is_some());
    assert_eq!(principal_axis(&rows([0.6, 0.8, 0.0], 0.25)), None);
    assert_eq!(principal_axis(&[]), None);
    assert_eq!(principal_axis(&[[f64::MAX; 3], [f64::MIN; 3]].repeat(FEWEST)), None);
}
