//! The motion: conservation laws, symmetries, regimes, and batches against single calls.

use crate::promises::{FOUR_ROUNDOFFS, STATE};
use core::f64::consts::{FRAC_PI_2, PI};
use libration::elliptic::Modulus;
use libration::pendulum::{self, Motion, Pendulum, PendulumError, Regime, State};
use libration::quantity::Angle;
use libration_testing::golden::Table;
use libration_testing::random::Random;
use libration_testing::ulp::ulp;

fn unit_pendulum() -> Pendulum {
    Pendulum::from_angular_frequency(1.0).unwrap()
}

fn radians(angle: f64) -> Angle {
    Angle::from_radians(angle).unwrap()
}

fn launched(angle: f64, velocity: f64) -> Motion {
    unit_pendulum().launched(radians(angle), velocity).unwrap()
}

/// Starts of every kind: libration, next to the separatrix on both sides, rotation, several turns away.
fn starts(seed: u64, count: usize) -> Vec<(f64, f64)> {
    let mut random = Random::seeded(seed);
    let mut draw = |n| {
        let angle = random.between(-PI, PI);
        match n % 4 {
            0 => (angle, 0.0),
            1 => (angle, random.between(-4.0, 4.0)),
            2 => (angle, 2.0 * libm::cos(angle / 2.0) * (1.0 + random.log_between(-15.0, -1.0))),
            _ => (random.between(-100.0, 100.0), random.between(-10.0, 10.0)),
        }
    };
    (0..count).map(&mut draw).collect()
}

/// (θ′/2)² + sin²(θ/2).
fn energy(state: &State) -> f64 {
    let sine = libm::sin(state.angle_in_turn / 2.0);
    state.velocity * state.velocity / 4.0 + sine * sine
}

#[test]
fn energy_is_conserved() {
    let mut random = Random::seeded(1);
    for (angle, velocity) in starts(1, 4000) {
        let motion = launched(angle, velocity);
        let expected = motion.energy_ratio();
        for time in [0.0, random.between(-20.0, 20.0), random.log_between(0.0, 4.0)] {
            // The state may be late by 2⁻⁵¹ of the time; |dE/dt| of either term is at most |θ′|.
            let state = motion.state_at(time);
            let slack = 16.0 * ulp(expected) + FOUR_ROUNDOFFS * (time * state.velocity).abs();
            assert!((energy(&state) - expected).abs() <= slack, "{angle} {velocity} {time}: {state:?}");
        }
    }
}

#[test]
fn the_parts_of_a_state_agree() {
    let mut random = Random::seeded(2);
    for (angle, velocity) in starts(2, 4000) {
        let state = launched(angle, velocity).state_at(random.between(-300.0, 300.0));
        #[expect(clippy::cast_precision_loss, reason = "few turns")]
        let turns = state.turns as f64;
        assert!(
            (state.angle - (2.0 * PI * turns + state.angle_in_turn)).abs() <= 2.0 * ulp(state.angle) + 1e-15,
            "{state:?}"
        );
        assert!((state.complement - (PI - state.angle_in_turn.abs())).abs() <= 1e-15, "{state:?}");
        assert!(state.angle_in_turn.abs() <= PI && state.complement >= 0.0, "{state:?}");
    }
}

#[test]
fn every_motion_starts_where_it_was_put() {
    for (angle, velocity) in starts(3, 4000) {
        let state = launched(angle, velocity).state_at(0.0);
        assert!((state.angle - angle).abs() <= 4.0 * ulp(angle), "{angle} {velocity}: {state:?}");
        assert!((state.velocity - velocity).abs() <= 4.0 * ulp(velocity), "{angle} {velocity}: {state:?}");
    }
}

#[test]
fn a_mirrored_start_gives_the_mirrored_motion_bit_for_bit() {
    let mut random = Random::seeded(4);
    for (angle, velocity) in starts(4, 4000) {
        let time = random.between(-100.0, 100.0);
        let (here, there) =
            (launched(angle, velocity).state_at(time), launched(-angle, -velocity).state_at(time));
        assert_eq!(here.angle.to_bits(), (-there.angle).to_bits(), "{angle} {velocity} {time}");
        assert_eq!(here.velocity.to_bits(), (-there.velocity).to_bits(), "{angle} {velocity} {time}");
    }
}

#[test]
fn a_motion_released_from_rest_is_even_in_time() {
    let mut random = Random::seeded(5);
    for _ in 0..4000 {
        let (angle, time) = (random.between(-PI, PI), random.log_between(-3.0, 3.0));
        let motion = unit_pendulum().released_from(radians(angle)).unwrap();
        let (after, before) = (motion.state_at(time), motion.state_at(-time));
        let slack = FOUR_ROUNDOFFS * time;
        let allowed = 8.0 * ulp(after.angle) + 2.0 * slack * after.velocity.abs();
        assert!((after.angle - before.angle).abs() <= allowed, "{angle} {time}");
        assert!(
            (after.velocity + before.velocity).abs() <= 8.0 * ulp(after.velocity) + 2.0 * slack,
            "{angle} {time}"
        );
    }
}

#[test]
fn a_libration_returns_after_its_period_and_a_rotation_a_turn_further() {
    let mut random = Random::seeded(6);
    for (angle, velocity) in starts(6, 4000) {
        let motion = launched(angle, velocity);
        let (time, period) = (random.between(0.0, 10.0), motion.period());
        let turn = if motion.regime() == Regime::Rotation { (2.0 * PI).copysign(velocity) } else { 0.0 };
        let (now, later) = (motion.state_at(time), motion.state_at(time + period));
        // The period and the sum of the times are rounded, each by half an ulp of time + period.
        let late = (2.0 * FOUR_ROUNDOFFS + f64::EPSILON) * (time + period);
        let slack = 8.0 * ulp(later.angle) + late * now.velocity.abs();
        assert!((later.angle - turn - now.angle).abs() <= slack + 1e-15, "{angle} {velocity} {time}");
    }
}

/// The bits of a number; NaN has no sign or payload to compare.
fn bits(x: f64) -> u64 {
    if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() }
}

#[test]
fn batch_of_states_equals_the_single_call_bit_for_bit() {
    let mut random = Random::seeded(7);
    for (angle, velocity) in
        starts(7, 40).into_iter().chain([(0.0, 2.0), (0.0, 0.0), (3.0, 0.0), (1e-150, 0.0)])
    {
        let motion = launched(angle, velocity);
        let mut times: Vec<f64> = (0..2500).map(|_| random.between(-100.0, 100.0)).collect();
        times.extend([0.0, -0.0, 1e6, f64::NAN, f64::INFINITY, 5e-324, f64::MAX]);
        let (mut angles, mut velocities) = (vec![0.0; times.len()], vec![0.0; times.len()]);
        motion.states_at(&times, &mut angles, &mut velocities).unwrap();
        for ((&time, batch_angle), batch_velocity) in times.iter().zip(&angles).zip(&velocities) {
            let single = motion.state_at(time);
            assert_eq!(bits(*batch_angle), bits(single.angle), "{angle} {velocity} {time}");
            assert_eq!(bits(*batch_velocity), bits(single.velocity), "{angle} {velocity} {time}");
        }
    }
}

#[test]
fn batch_of_a_prepared_motion_equals_its_single_call_bit_for_bit() {
    let mut random = Random::seeded(12);
    for (angle, velocity) in
        starts(12, 40).into_iter().chain([(0.0, 2.0), (0.0, 0.0), (3.0, 0.0), (1e-150, 0.0)])
    {
        let prepared = launched(angle, velocity).prepare();
        let mut times: Vec<f64> = (0..2500).map(|_| random.between(-100.0, 100.0)).collect();
        times.extend([0.0, -0.0, 1e6, f64::NAN, f64::INFINITY, 5e-324, f64::MAX]);
        let (mut angles, mut velocities) = (vec![0.0; times.len()], vec![0.0; times.len()]);
        prepared.states_at(&times, &mut angles, &mut velocities).unwrap();
        for ((&time, batch_angle), batch_velocity) in times.iter().zip(&angles).zip(&velocities) {
            let single = prepared.state_at(time);
            assert_eq!(bits(*batch_angle), bits(single.angle), "{angle} {velocity} {time}");
            assert_eq!(bits(*batch_velocity), bits(single.velocity), "{angle} {velocity} {time}");
        }
    }
}

#[test]
fn a_prepared_motion_agrees_with_the_motion() {
    let mut random = Random::seeded(13);
    for (angle, velocity) in starts(13, 200) {
        let motion = launched(angle, velocity);
        let prepared = motion.prepare();
        for _ in 0..100 {
            let time = random.between(-1000.0, 1000.0);
            let (table, direct) = (prepared.state_at(time), motion.state_at(time));
            let late = 2.0 * FOUR_ROUNDOFFS * time.abs();
            let slack = 8.0 * ulp(direct.angle) + late * direct.velocity.abs();
            assert!((table.angle - direct.angle).abs() <= slack, "{angle} {velocity} {time}");
            let slack = 8.0 * ulp(direct.velocity) + late * libm::sin(direct.complement).abs();
            assert!((table.velocity - direct.velocity).abs() <= slack, "{angle} {velocity} {time}");
        }
    }
}

/// Amplitudes and times of every kind, with invalid ones among them.
fn varying(count: usize) -> (Vec<f64>, Vec<f64>) {
    let mut random = Random::seeded(10);
    let mut amplitudes: Vec<f64> = (0..count).map(|_| random.between(-PI, PI)).collect();
    let mut times: Vec<f64> = (0..count).map(|_| random.between(-300.0, 300.0)).collect();
    for i in (0..count).step_by(4) {
        amplitudes[i] = random.log_between(-300.0, 0.0);
        times[i] = random.log_between(-300.0, 8.0);
    }
    let edges =
        [0.0, -0.0, f64::NAN, f64::INFINITY, -f64::INFINITY, 5e-324, PI, PI.next_down(), PI.next_up(), 1e300];
    for amplitude in edges {
        for time in edges {
            amplitudes.push(amplitude);
            times.push(time);
        }
    }
    (amplitudes, times)
}

#[test]
fn batch_of_varying_states_equals_the_single_call_bit_for_bit() {
    let (amplitudes, times) = varying(100_000);
    let count = times.len();
    let (mut angles, mut velocities) = (vec![0.0; count], vec![0.0; count]);
    pendulum::states(&amplitudes, 1.5, &times, &mut angles, &mut velocities).unwrap();
    for i in 0..count {
        let single = pendulum::state(amplitudes[i], 1.5, times[i]);
        let batch = (bits(angles[i]), bits(velocities[i]));
        assert_eq!(batch, (bits(single.angle), bits(single.velocity)), "{} {}", amplitudes[i], times[i]);
    }
}

#[test]
fn varying_states_agree_with_prepared_motions() {
    let mut random = Random::seeded(11);
    for _ in 0..20_000 {
        let (amplitude, time) = (random.between(0.0, PI), random.between(0.0, 1000.0));
        let prepared = unit_pendulum().released_from(radians(amplitude)).unwrap().state_at(time);
        let single = pendulum::state(amplitude, 1.0, time);
        let late = 2.0 * FOUR_ROUNDOFFS * time;
        let (angle, velocity) = (single.angle - prepared.angle, single.velocity - prepared.velocity);
        assert!(angle.abs() <= 8.0 * ulp(single.angle) + late * single.velocity.abs(), "{amplitude} {time}");
        let acceleration = libm::sin(single.angle).abs();
        assert!(velocity.abs() <= 8.0 * ulp(single.velocity) + late * acceleration, "{amplitude} {time}");
    }
}

#[test]
fn regimes_are_told_apart_to_the_last_bit() {
    assert_eq!(launched(0.0, 0.0).regime(), Regime::RestStable);
    assert_eq!(launched(0.0, 2.0).regime(), Regime::Separatrix);
    assert_eq!(launched(0.0, 2.0_f64.next_down()).regime(), Regime::Libration);
    assert_eq!(launched(0.0, 2.0_f64.next_up()).regime(), Regime::Rotation);
    assert_eq!(launched(PI, 0.0).regime(), Regime::Libration);
    assert_eq!(launched(PI, 1e-15).regime(), Regime::Rotation);
    assert_eq!(unit_pendulum().on_separatrix().regime(), Regime::Separatrix);
    let from_top = |complement, velocity| {
        unit_pendulum().launched(Angle::from_complement(complement).unwrap(), velocity).unwrap().regime()
    };
    assert_eq!(from_top(0.0, 0.0), Regime::RestUpright);
    assert_eq!(from_top(1e-300, 0.0), Regime::Libration);
    for complement in [1e-9, 1e-100, 1e-300] {
        assert_eq!(from_top(complement, -2.0 * complement), Regime::Rotation, "{complement}");
        assert_eq!(from_top(complement, complement / 2.0), Regime::Libration, "{complement}");
    }
    // 2 cos(θ/2) = 2 sin(δ/2) lies a relative δ²/24 below δ.
    for complement in [1e-3, 1e-9, 1e-60] {
        assert_eq!(from_top(complement, complement), Regime::Rotation, "{complement}");
    }
    let top = Angle::from_complement(1e-300).unwrap();
    assert!(unit_pendulum().launched(top, 1e-300).is_err(), "a relative 1e-601 cannot be held");
    for complement in [1e-9, 1e-60, 1e-300] {
        assert_eq!(from_top(complement, complement.next_down()), Regime::Libration, "{complement}");
    }
}

#[test]
fn the_separatrix_has_its_elementary_motion() {
    let motion = unit_pendulum().on_separatrix();
    let mut random = Random::seeded(8);
    for _ in 0..2000 {
        let time = random.between(-40.0, 40.0);
        let (expected, state) = (2.0 * libm::atan(libm::sinh(time)), motion.state_at(time));
        assert!((state.angle - expected).abs() <= 8.0 * ulp(expected), "{time}");
        let velocity = 2.0 / libm::cosh(time);
        assert!((state.velocity - velocity).abs() <= 8.0 * ulp(velocity), "{time}");
        let complement = 4.0 * libm::atan(libm::exp(-time.abs()));
        assert!(
            (state.complement - complement).abs() <= 8.0 * ulp(complement) + 1e-15 * complement * time.abs(),
            "{time}"
        );
    }
    assert!(motion.period().is_infinite());
}

#[test]
fn rotations_given_by_their_excess_of_energy_keep_the_promise_of_states() {
    for row in Table::read("separatrix/rotation.csv").rows() {
        let (excess, time) = (row.input("e"), row.input("tau"));
        let motion = unit_pendulum().with_energy_excess(excess).unwrap();
        let (state, late) = (motion.state_at(time), FOUR_ROUNDOFFS * time);
        let (angle, velocity) = (row.truth("theta"), row.truth("dtheta_dtau"));
        STATE.holds(angle.error_beyond(state.angle, late * velocity.hi), &("angle", excess, time));
        let acceleration = libm::sin(angle.hi).abs();
        STATE.holds(velocity.error_beyond(state.velocity, late * acceleration), &("velocity", excess, time));
        let turn = motion.period() / (2.0 * PI);
        assert!(row.truth("turn_time_over_T0").error(turn) <= 3.0, "{excess}");
    }
}

#[test]
fn rotations_through_the_bottom_follow_the_amplitude_function() {
    // θ = 2 am(√(1+e) τ), m = 1/(1 + e), turn time 2K/√(1+e); mc = e/(1 + e) is rounded.
    for row in Table::read("separatrix/rotation.csv").rows() {
        let (e, time) = (row.input("e"), row.input("tau"));
        let modulus = Modulus::from_complementary_parameter(e / (1.0 + e)).unwrap();
        let rate = libm::sqrt(1.0 + e);
        let (theta, velocity) = (row.truth("theta"), row.truth("dtheta_dtau").hi);
        let j = modulus.jacobi(rate * time);
        let late = 2.0 * FOUR_ROUNDOFFS * time;
        assert!(theta.error_beyond(2.0 * j.am, late * velocity) <= 8.0, "{e} {time}");
        let turn = modulus.first() / (rate * PI);
        assert!(row.truth("turn_time_over_T0").error(turn) <= 6.0, "{e}");
    }
}

#[test]
fn time_scales_with_the_natural_frequency() {
    // A power of two scales exactly.
    let fast = Pendulum::from_angular_frequency(8.0).unwrap();
    for (angle, velocity) in starts(9, 500) {
        let (slow, quick) =
            (launched(angle, velocity), fast.launched(radians(angle), 8.0 * velocity).unwrap());
        assert_eq!((slow.period() / 8.0).to_bits(), quick.period().to_bits(), "{angle} {velocity}");
        assert_eq!(
            slow.state_at(4.0).angle.to_bits(),
            quick.state_at(0.5).angle.to_bits(),
            "{angle} {velocity}"
        );
    }
}

#[test]
fn extreme_states_are_answered_or_refused() {
    let at =
        |angle: f64, velocity: f64| unit_pendulum().launched(Angle::from_radians(angle).unwrap(), velocity);
    assert!(at(0.0, 1e300).is_err(), "an energy beyond the range of f64");
    assert_eq!(at(0.0, 1e140).unwrap().regime(), Regime::Rotation);
    assert_eq!(at(0.0, 5e-324).unwrap().regime(), Regime::RestStable);
    let slow = at(0.0, 1e-300).unwrap();
    assert_eq!(slow.regime(), Regime::Libration);
    assert!((slow.state_at(FRAC_PI_2).angle / 1e-300 - 1.0).abs() < 1e-15);
    for (length, gravity) in [(1e308, 1e308), (1e-300, 1e-300), (1e-150, 1e150)] {
        let pendulum = Pendulum::new(length, gravity).unwrap();
        let motion =
            pendulum.launched(Angle::from_radians(1.0).unwrap(), pendulum.angular_frequency()).unwrap();
        assert_eq!(motion.regime(), Regime::Libration, "{length} {gravity}");
        let time = motion.period().min(1.0);
        assert!(motion.period().is_finite() && motion.state_at(time).angle.is_finite());
    }
    for frequency in [1e308, 1e-310, 5e-324] {
        assert!(Pendulum::from_angular_frequency(frequency).is_err(), "{frequency}");
    }
    // l·θ′² = 9e-340 against 4g·cos²(θ/2) = 4e-340.
    let weak = Pendulum::new(1.0, 1e-300).unwrap();
    let top = Angle::from_complement(2e-20).unwrap();
    assert_eq!(weak.launched(top, 3e-170).unwrap().regime(), Regime::Rotation);
    assert_eq!(weak.launched(top, 1e-170).unwrap().regime(), Regime::Libration);
}

#[test]
fn motions_at_any_frequency_are_those_at_another_scaled() {
    // A power of two scales exactly where nothing leaves the range of numbers.
    let scale = libm::exp2(960.0);
    for frequency in [scale, 1.0 / scale] {
        let pendulum = Pendulum::from_angular_frequency(frequency).unwrap();
        for (angle, velocity) in
            [(1.0, 0.0), (3.1, 0.0), (0.5, 0.3), (0.0, 2.0), (1.0, 3.0), (-2.0, 1.08), (100.0, -5.0)]
        {
            let (unit, scaled) =
                (launched(angle, velocity), pendulum.launched(radians(angle), velocity * frequency).unwrap());
            assert_eq!(unit.regime(), scaled.regime(), "{angle} {velocity}");
            assert_eq!(unit.period(), scaled.period() * frequency, "{angle} {velocity}");
            assert_eq!(unit.action(), scaled.action() / frequency, "{angle} {velocity}");
            for time in [0.0, 0.7, -3.0, 1e5] {
                let (one, other) = (unit.state_at(time), scaled.state_at(time / frequency));
                assert_eq!(one.angle, other.angle, "{frequency:e} {angle} {velocity} {time}");
                assert_eq!(
                    one.velocity,
                    other.velocity / frequency,
                    "{frequency:e} {angle} {velocity} {time}"
                );
                let (one, other) =
                    (unit.prepare().state_at(time), scaled.prepare().state_at(time / frequency));
                assert_eq!(one.angle, other.angle, "{frequency:e} {angle} {velocity} {time}");
                assert_eq!(
                    one.velocity,
                    other.velocity / frequency,
                    "{frequency:e} {angle} {velocity} {time}"
                );
            }
        }
    }
}

/// Asserts that a state with a known phase is on its orbit, and that otherwise only the unwrapped angle of a rotation is a number.
fn assert_on_orbit_or_unknown(motion: &Motion, state: &State, frequency: f64, time: f64) {
    let input = (frequency, motion.regime(), time);
    // 2⁹⁷ periods of a libration; in a rotation two turns count as one period.
    let rotates = motion.regime() == Regime::Rotation;
    let periods = (time / motion.period()).abs() * if rotates { 0.5 } else { 1.0 };
    if periods >= libm::exp2(97.0) {
        assert!(state.velocity.is_nan() && state.complement.is_nan(), "{input:?}: {state:?}");
        assert!(state.angle_in_turn.is_nan() && state.angle.is_nan() != rotates, "{input:?}: {state:?}");
    } else {
        assert_on_orbit(motion, state, frequency, &input);
    }
}

/// Asserts the property of a state with a known phase: it is on its orbit.
fn assert_on_orbit(motion: &Motion, state: &State, frequency: f64, input: &dyn core::fmt::Debug) {
    let relative = state.velocity / frequency / (2.0 * motion.energy_ratio().sqrt());
    assert!(relative.abs() <= 1.0 + 4.0 * f64::EPSILON, "{input:?}: {state:?}");
    assert!(state.angle_in_turn.abs() <= PI && state.complement >= 0.0, "{input:?}: {state:?}");
    let rotates = motion.regime() == Regime::Rotation;
    assert!(state.angle.is_finite() || (rotates && state.angle.is_infinite()), "{input:?}: {state:?}");
}

#[test]
fn states_are_on_the_orbit_until_their_phase_is_lost() {
    for frequency in [1e-290, 1.0, 1e10, 1e150] {
        let pendulum = Pendulum::from_angular_frequency(frequency).unwrap();
        for (angle, velocity) in [(1.0, 0.0), (3.0, 0.0), (0.0, 2.0), (0.0, 3.0), (0.0, -3.0)] {
            let motion = pendulum.launched(radians(angle), velocity * frequency).unwrap();
            let prepared = motion.prepare();
            let full = motion.period() * if motion.regime() == Regime::Rotation { 2.0 } else { 1.0 };
            let seam = libm::exp2(97.0) * full;
            let near = [1e26 / frequency, 1e28 / frequency, seam * (1.0 - 1e-15), seam * (1.0 + 1e-15)];
            for time in near.into_iter().chain([1e300, f64::MAX, -f64::MAX]) {
                let time = time.clamp(-f64::MAX, f64::MAX);
                let state = motion.state_at(time);
                assert_on_orbit_or_unknown(&motion, &state, frequency, time);
                assert_on_orbit_or_unknown(&motion, &prepared.state_at(time), frequency, time);
                for index in [0, 70] {
                    let mut times = [0.0; 71];
                    times[index] = time;
                    let (mut angles, mut velocities) = ([0.0; 71], [0.0; 71]);
                    motion.states_at(&times, &mut angles, &mut velocities).unwrap();
                    let (got, expected) = ([angles[index], velocities[index]], [state.angle, state.velocity]);
                    assert_eq!(got.map(bits), expected.map(bits), "{frequency} {angle} {velocity} {time}");
                }
            }
        }
    }
}

#[test]
fn a_released_pendulum_is_known_to_two_to_the_forty_nine_periods() {
    let (amplitude, frequency) = (1.0, 1.5);
    let period =
        Pendulum::from_angular_frequency(frequency).unwrap().released_from(radians(amplitude)).unwrap();
    let seam = libm::exp2(49.0) * period.period();
    for (time, is_known) in [(seam * (1.0 - 1e-14), true), (seam * (1.0 + 1e-14), false), (-1e30, false)] {
        let state = pendulum::state(amplitude, frequency, time);
        assert_eq!(state.angle.is_nan(), !is_known, "{time}: {state:?}");
        assert_eq!(state.velocity.is_nan(), !is_known, "{time}: {state:?}");
        assert!(!is_known || state.angle.abs() <= amplitude, "{time}: {state:?}");
        let (mut angles, mut velocities) = ([0.0; 80], [0.0; 80]);
        pendulum::states(&[amplitude; 80], frequency, &[time; 80], &mut angles, &mut velocities).unwrap();
        assert_eq!(angles.map(bits), [bits(state.angle); 80], "{time}");
        assert_eq!(velocities.map(bits), [bits(state.velocity); 80], "{time}");
    }
    let motion =
        Pendulum::from_angular_frequency(frequency).unwrap().released_from(radians(amplitude)).unwrap();
    assert!(motion.state_at(-1e28).angle.abs() <= amplitude && motion.state_at(1e30).angle.is_nan());
    assert!(motion.angle_variable_at(1e28).is_finite() && motion.angle_variable_at(1e30).is_nan());
}

#[test]
fn a_rotation_keeps_its_angle_to_the_last_bit_when_its_phase_is_lost() {
    let motion = unit_pendulum().launched(radians(0.0), 3.0).unwrap();
    for time in [1e29, 1e100, 1e300] {
        let expected = 2.0 * PI / motion.period() * time;
        assert!((motion.state_at(time).angle / expected - 1.0).abs() <= 4.0 * f64::EPSILON, "{time}");
        assert!((motion.state_at(-time).angle / expected + 1.0).abs() <= 4.0 * f64::EPSILON, "{time}");
    }
    let fast = Pendulum::from_angular_frequency(1e10).unwrap().launched(radians(0.0), 3e10).unwrap();
    assert_eq!(fast.state_at(1e308).angle, f64::INFINITY);
    assert_eq!(fast.state_at(-1e308).angle, f64::NEG_INFINITY);
}

#[test]
fn the_separatrix_ends_at_the_top() {
    for frequency in [1e-290, 1.0, 1e290] {
        let motion = Pendulum::from_angular_frequency(frequency).unwrap().on_separatrix();
        for time in [1e28 / frequency, f64::MAX] {
            let time = time.min(f64::MAX);
            if time * frequency > 2000.0 {
                let state = motion.state_at(time);
                assert_eq!(
                    (state.angle, state.complement, state.velocity),
                    (PI, 0.0, 0.0),
                    "{frequency} {time}"
                );
                assert_eq!(motion.state_at(-time).angle, -PI, "{frequency} {time}");
            }
        }
    }
}

#[test]
fn a_fast_separatrix_keeps_its_velocity_where_the_complement_is_lost() {
    // θ′ = 4ω0e^−x at x = 2¹⁰, ω0 = 2⁹⁶⁰, where the complement 4e^−x is below the range of numbers.
    let frequency = libm::exp2(960.0);
    let motion = Pendulum::from_angular_frequency(frequency).unwrap().on_separatrix();
    let state = motion.state_at(libm::exp2(10.0 - 960.0));
    let expected = 4.0 * (frequency * libm::exp(-512.0)) * libm::exp(-512.0);
    assert_eq!(state.complement, 0.0);
    assert!((state.velocity / expected - 1.0).abs() <= 6.0 * f64::EPSILON, "{state:?} {expected}");
}

#[test]
fn motions_beyond_the_range_of_numbers_are_refused() {
    let fast = Pendulum::from_angular_frequency(1e290).unwrap();
    assert!(matches!(fast.with_energy_ratio(1e154), Err(PendulumError::TooMuchEnergy(_))));
    assert!(matches!(fast.with_energy_excess(1e154), Err(PendulumError::TooMuchEnergy(_))));
    assert!(matches!(unit_pendulum().with_energy_ratio(f64::MAX), Err(PendulumError::TooMuchEnergy(_))));
    assert!(matches!(fast.launched(radians(0.0), 1e308), Err(PendulumError::TooFast(_))));
    let rotation = fast.launched(radians(0.0), 9e306).unwrap();
    assert!(rotation.period() > 0.0 && rotation.state_at(1e-300).velocity.is_finite());
    assert_eq!(rotation.specific_energy(), f64::INFINITY);
    assert!(matches!(unit_pendulum().with_energy_ratio(-1e-300), Err(PendulumError::NegativeEnergy(_))));
    assert!(matches!(unit_pendulum().with_energy_excess(f64::NAN), Err(PendulumError::NotFinite { .. })));
}

#[test]
fn a_start_closer_to_the_top_than_numbers_can_tell_is_refused() {
    for complement in [5e-324, 1.5e-323, 1e-310, 4.4e-308] {
        let angle = Angle::from_complement(complement).unwrap();
        for velocity in [0.0, 1e-310, 1.0] {
            let refused = unit_pendulum().launched(angle, velocity).unwrap_err();
            assert_eq!(refused, PendulumError::TooCloseToTop(complement));
        }
    }
    let motion = unit_pendulum().released_from(Angle::from_complement(4.5e-308).unwrap()).unwrap();
    assert_eq!(motion.regime(), Regime::Libration);
    assert!((motion.state_at(0.0).complement / 4.5e-308 - 1.0).abs() <= 4.0 * f64::EPSILON);
}

#[test]
fn a_small_velocity_at_a_low_frequency_is_told_from_the_separatrix() {
    // w = θ′/2ω0 = 1e-18 compared with cos(θ/2) = 1.0000001e-18, scaled so that the velocity is 2e-308.
    let frequency = libm::exp2(-960.0);
    let pendulum = Pendulum::from_angular_frequency(frequency).unwrap();
    let (top, velocity) = (Angle::from_complement(2.000_000_2e-18).unwrap(), 2e-18);
    let (unit, slow) = (
        unit_pendulum().launched(top, velocity).unwrap(),
        pendulum.launched(top, velocity * frequency).unwrap(),
    );
    assert_eq!(unit.period(), slow.period() * frequency);
}

#[test]
fn the_specific_energy_is_that_of_the_initial_state() {
    let pendulum = Pendulum::new(0.7, 9.81).unwrap();
    let square = 9.81 / 0.7;
    for (angle, velocity) in [(0.0, 0.0), (1.0, 0.0), (0.3, -2.0), (3.0, 9.0), (PI, 0.1)] {
        let motion = pendulum.launched(Angle::from_radians(angle).unwrap(), velocity).unwrap();
        let expected = 0.5 * velocity * velocity + square * (1.0 - libm::cos(angle));
        // Four roundings of terms of the same sign.
        assert!(
            (motion.specific_energy() - expected).abs() <= 4.0 * f64::EPSILON * expected,
            "{angle} {velocity}"
        );
    }
}

#[test]
fn a_start_next_to_a_quarter_keeps_its_small_part() {
    for velocity in [1e-20, -1e-200, 3e-9] {
        for angle in [1.0, -3.0] {
            let state = launched(angle, velocity).state_at(0.0);
            assert!((state.velocity / velocity - 1.0).abs() <= 4.0 * f64::EPSILON, "{angle} {velocity}");
            assert!((state.angle - angle).abs() <= 4.0 * ulp(angle), "{angle} {velocity}");
            let prepared = launched(angle, velocity).prepare().state_at(0.0);
            assert!((prepared.velocity / velocity - 1.0).abs() <= 4.0 * f64::EPSILON, "{angle} {velocity}");
        }
        let below = launched(velocity, 1.0).state_at(0.0);
        assert!((below.angle / velocity - 1.0).abs() <= 4.0 * f64::EPSILON, "{velocity}");
    }
    for complement in [1e-20, 1e-200] {
        let top = Angle::from_complement(complement).unwrap();
        for velocity in [1.0, -1.0] {
            let motion = unit_pendulum().launched(top, velocity).unwrap();
            for state in [motion.state_at(0.0), motion.prepare().state_at(0.0)] {
                let close = (state.complement / complement - 1.0).abs() <= 4.0 * f64::EPSILON;
                assert!(close, "{complement} {velocity} {state:?}");
                assert!(state.turns == 0 && state.angle_in_turn > 3.0, "{complement} {velocity} {state:?}");
            }
        }
    }
}

#[test]
fn the_energy_excess_is_kept_on_both_sides_of_the_separatrix() {
    for excess in [-1.0, -0.5, -1e-300, 0.0, 5e-324, 1e-300, 1e-16, 0.5, 1e300] {
        let motion = unit_pendulum().with_energy_excess(excess).unwrap();
        assert!((motion.energy_excess() - excess).abs() <= ulp(excess), "{excess}");
        assert!((motion.energy_ratio() - (1.0 + excess)).abs() <= ulp(1.0 + excess), "{excess}");
    }
    // 1 − sin²(θ0/2) = sin²(δ/2).
    let near = unit_pendulum().released_from(Angle::from_complement(2e-100).unwrap()).unwrap();
    assert!((near.energy_excess() / -1e-200 + -1.0).abs() <= 4.0 * f64::EPSILON);
}

#[test]
fn a_motion_tells_its_modulus_and_its_direction() {
    let Motion::Libration(libration) = launched(1.0, 0.0) else { panic!("a libration") };
    assert!((libration.modulus().modulus() - libm::sin(0.5)).abs() <= ulp(0.5));
    for direction in [1.0, -1.0] {
        let Motion::Rotation(rotation) = launched(0.0, 4.0 * direction) else { panic!("a rotation") };
        assert_eq!((rotation.modulus().modulus(), rotation.direction()), (0.5, direction));
        let Motion::Separatrix(separatrix) = launched(0.0, 2.0 * direction) else { panic!("the separatrix") };
        assert_eq!(separatrix.direction(), direction);
        let prepared = launched(0.0, 4.0 * direction).prepare();
        assert_eq!(prepared.motion().state_at(0.3), launched(0.0, 4.0 * direction).state_at(0.3));
    }
}

/// Values by mpmath, 4 arctan e^(−√9.80665·|t|) for exactly this `f64`; rounding √9.80665 to one word would cause a relative error of 2e-14.
#[test]
fn the_separatrix_keeps_its_complement_for_a_frequency_of_two_words() {
    let motion = Pendulum::new(1.0, 9.80665).unwrap().on_separatrix();
    for (time, complement) in [(150.0, 3.975_240_430_191_219e-204), (-200.0, 3.967_021_344_795_514e-272)] {
        let state = motion.state_at(time);
        assert!(
            (state.complement - complement).abs() <= 4.0 * ulp(complement),
            "{time}: {:e}",
            state.complement
        );
    }
}

/// The largest accepted velocity is 1e150 times 2ω0.
#[test]
fn velocities_end_where_their_squares_would() {
    let fastest = 2e150;
    assert!(unit_pendulum().launched(radians(0.5), fastest).is_ok());
    let beyond = unit_pendulum().launched(radians(0.5), 1.0000001 * fastest);
    assert_eq!(beyond.unwrap_err(), PendulumError::TooFast(1.0000001 * fastest));
}
