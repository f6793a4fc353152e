//! The amplitude by the time for which the bob blocks the gate.

use libration::pendulum::Pendulum;
use libration::progress::Quiet;
use libration::quantity::Angle;
use libration::taylor::{Effort, Moment, System, integrate};
use libration_lab::internals::fit::gates::speeds::NearBottom;

fn free(omega0: f64) -> NearBottom {
    NearBottom { omega0, drag: 0.0 }
}

/// A narrow bob, 0.1 rad from the bottom.
#[test]
fn a_gate_off_the_centre_tells_the_same_amplitude() {
    let motion = Pendulum::from_angular_frequency(3.0).unwrap();
    let motion = motion.released_from(Angle::from_radians(0.8).unwrap()).unwrap();
    let quarter = 0.25 * motion.period();
    for from_bottom in [0.0, 0.04] {
        let width = 1e-4;
        let state = motion.state_at(quarter + from_bottom);
        let computed = free(3.0).amplitude(width, width / state.velocity.abs(), from_bottom).unwrap();
        assert!((computed - 0.8).abs() < 1e-7, "{computed}");
    }
    assert_eq!(free(3.0).amplitude(0.1, 0.01, 0.0), None);
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
        let computed = free(5.7).amplitude(width, 2.0 * half, from_bottom).unwrap();
        assert!((computed - 0.1222).abs() < 1e-10, "{computed}");
    }
}

/// Speeds before and after the bottom differ by the drag: the motion by the integrator, from the bottom forwards and backwards.
#[test]
fn a_drag_makes_the_bob_faster_before_the_bottom_than_after_it() {
    let (omega0, drag, amplitude) = (3.2, 0.1, 0.5);
    let speed = 2.0 * omega0 * libm::sin(0.5 * amplitude);
    let angle = |time: f64| {
        // Backwards in time the drag drives.
        let (length, signed) = (time.abs(), drag * time.signum());
        let equation = format!("x'' = -{:e}*sin(x) - ({signed:e})*x'", omega0 * omega0);
        let system = System::new(&equation.parse().unwrap()).unwrap();
        let start = Moment { time: 0.0, state: vec![0.0, speed * time.signum()] };
        let motion = integrate(&system, &start, &[length], &Effort::to_tolerance(1e-12), &Quiet).unwrap();
        motion.samples[0].state[0]
    };
    let near = NearBottom { omega0, drag };
    for from_bottom in [-0.05, 0.05] {
        let half = 0.01;
        let width = angle(from_bottom + half) - angle(from_bottom - half);
        let computed = near.amplitude(width, 2.0 * half, from_bottom).unwrap();
        // The relative error of the form is of the order qt·θ², 1e-4 here; the drag alone changes the amplitude by 5e-3.
        assert!((computed / amplitude - 1.0).abs() < 1e-4, "{computed}");
        assert!(
            (free(omega0).amplitude(width, 2.0 * half, from_bottom).unwrap() / amplitude - 1.0).abs() > 3e-3
        );
        let time = near.time_at(amplitude, angle(from_bottom)).unwrap();
        assert!((time - from_bottom).abs() < 1e-6, "{time}");
    }
}
