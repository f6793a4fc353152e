//! Angles that jump by a turn, as encoders and arctangents give them.

use std::f64::consts::{PI, TAU};

use crate::random::Random;
use crate::synthetic_trace::Synthetic;
use libration_lab::internals::measurement::traces::turns::{take_out_jumps, unwrap};

#[test]
fn an_angle_over_the_top_is_made_whole() {
    let whole: Vec<f64> = (0..400).map(|n| 2.0 * libm::sin(0.1 * f64::from(n)) + PI).collect();
    let mut wrapped: Vec<f64> = whole.iter().map(|angle| (angle + PI) % TAU - PI).collect();
    let mut told = Vec::new();
    unwrap(&mut wrapped, "", &mut |finding| told.push(finding));
    let shift = whole[0] - wrapped[0];
    assert!(whole.iter().zip(&wrapped).all(|(whole, angle)| (whole - angle - shift).abs() < 1e-12));
    assert_eq!(told.len(), 1, "{told:?}");
}

#[test]
fn what_goes_beyond_a_turn_is_left_alone() {
    let mut rotation: Vec<f64> = (0..100).map(|n| 0.3 * f64::from(n)).collect();
    let before = rotation.clone();
    assert_eq!(take_out_jumps(&mut rotation), 0);
    assert_eq!(rotation, before);
}

/// Swings to 170° about ±π, with up to 1.9 rad between rows, and rotations, written with four digits: from -3.1416 to 3.1416 is more than a turn.
#[test]
fn fast_motions_that_are_written_with_few_digits_are_made_whole() {
    for (amplitude, velocity, step) in
        [(2.97, 0.0, 0.1), (0.0, 19.0, 0.09), (2.0, 0.0, 0.02), (1.0, 4.0, 0.13)]
    {
        let swing = Synthetic {
            omega0: 9.0,
            amplitude,
            velocity,
            step,
            rows: 300,
            linear: 0.1,
            offset: PI,
            ..Synthetic::USUAL
        };
        let whole = swing.trace(&mut Random::seeded(1));
        let written = |angle: &f64| 1e-4 * libm::round(1e4 * (angle - TAU * libm::round(angle / TAU)));
        let mut wrapped: Vec<f64> = whole.values().iter().map(written).collect();
        assert!(take_out_jumps(&mut wrapped) > 5);
        let shift = whole.values()[0] - wrapped[0];
        let worst =
            whole.values().iter().zip(&wrapped).map(|(a, b)| (a - b - shift).abs()).fold(0.0, f64::max);
        assert!(worst < 2e-4, "{amplitude} {velocity}: {worst}");
    }
}

/// A spike is not a jump, whatever its size below a turn and however fast the pendulum is.
#[test]
fn a_spike_is_no_jump() {
    for size in 5..60 {
        let spike = 0.1 * f64::from(size);
        let mut angles: Vec<f64> = (0..100).map(|n| 0.6 * libm::sin(0.8 * f64::from(n))).collect();
        angles[50] -= spike;
        let before = angles.clone();
        take_out_jumps(&mut angles);
        // A spike of nearly a turn is taken out as such and put back in the next row.
        let moved = angles.iter().zip(&before).filter(|(a, b)| a != b).count();
        assert!(moved <= 1, "{spike}: {moved}");
    }
}
