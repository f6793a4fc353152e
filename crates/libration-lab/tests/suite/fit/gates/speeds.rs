//! The amplitude by the time for which the bob blocks the gate.

use libration::pendulum::Pendulum;
use libration::quantity::Angle;
use libration_lab::internals::fit::gates::speeds::amplitude;

/// A narrow bob, 0.1 rad from the bottom.
#[test]
fn a_gate_off_the_centre_tells_the_same_amplitude() {
    let motion = Pendulum::from_angular_frequency(3.0).unwrap();
    let motion = motion.released_from(Angle::from_radians(0.8).unwrap()).unwrap();
    let quarter = 0.25 * motion.period();
    for from_bottom in [0.0, 0.04] {
        let width = 1e-4;
        let state = motion.state_at(quarter + from_bottom);
        let found = amplitude(3.0, width, width / state.velocity.abs(), from_bottom).unwrap();
        assert!((found - 0.8).abs() < 1e-7, "{found}");
    }
    assert_eq!(amplitude(3.0, 0.1, 0.01, 0.0), None);
}

/// A flag of 30 mm on a pendulum of 0.3 m is nearly as wide as a swing of 7°: its edges by the times of the motion itself.
#[test]
fn the_speed_changes_while_a_wide_flag_passes() {
    let motion = Pendulum::from_angular_frequency(5.7).unwrap();
    let motion = motion.released_from(Angle::from_radians(0.1222).unwrap()).unwrap();
    let quarter = 0.25 * motion.period();
    for (from_bottom, half) in [(0.0, 0.075), (0.03, 0.05)] {
        let angle = |time: f64| motion.state_at(quarter + time).angle;
        let width = (angle(from_bottom + half) - angle(from_bottom - half)).abs();
        let found = amplitude(5.7, width, 2.0 * half, from_bottom).unwrap();
        assert!((found - 0.1222).abs() < 1e-10, "{found}");
    }
}
