//! Angles that jump by a turn, as encoders and arctangents give them.

use std::f64::consts::{PI, TAU};

use libration_lab::internals::measurement::traces::turns::{take_out_jumps, unwrap};

#[test]
fn an_angle_over_the_top_is_made_whole() {
    let whole: Vec<f64> = (0..400).map(|n| 2.0 * libm::sin(0.1 * f64::from(n)) + PI).collect();
    let mut wrapped: Vec<f64> = whole.iter().map(|angle| (angle + PI) % TAU - PI).collect();
    let mut told = Vec::new();
    unwrap(&mut wrapped, "", &mut |finding| told.push(finding));
    let shift = whole[0] - wrapped[0];
    assert!(whole.iter().zip(&wrapped).all(|(whole, found)| (whole - found - shift).abs() < 1e-12));
    assert_eq!(told.len(), 1, "{told:?}");
}

#[test]
fn what_goes_beyond_a_turn_is_left_alone() {
    let mut rotation: Vec<f64> = (0..100).map(|n| 0.3 * f64::from(n)).collect();
    let before = rotation.clone();
    assert_eq!(take_out_jumps(&mut rotation), 0);
    assert_eq!(rotation, before);
}
