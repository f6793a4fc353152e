//! Forces without a series at zero, such as |x|^1.5: passed to the tolerance, compared with closed forms.

use crate::typed::system;
use libm::{atan, log, pow, sqrt, tgamma};
use libration::expression::Expression;
use libration::progress::Quiet;
use libration::systems::Model;
use libration::taylor::{
    Direction, Effort, Event, Moment, Solution, System, Trajectory, integrate, integrate_dense,
    integrate_from, integrate_many,
};
use std::f64::consts::PI;
use std::ops::ControlFlow;

fn watching(text: &str, formula: &str, direction: Direction) -> System {
    let event = Event { direction, ..Event::zero_of(formula.parse().unwrap()) };
    system(text).with_events(&[event]).unwrap()
}

fn from(state: &[f64]) -> Moment {
    Moment { time: 0.0, state: state.to_vec() }
}

fn solve(system: &System, start: &Moment, times: &[f64], tolerance: f64) -> Solution {
    integrate(system, start, times, &Effort::to_tolerance(tolerance), &Quiet).unwrap()
}

/// B(1/a, 1/2)/a = ∫₀¹ dx/√(1 − xᵃ).
fn arc(a: f64) -> f64 {
    sqrt(PI) * tgamma(1.0 / a) / (a * tgamma(1.0 / a + 0.5))
}

/// The sum of the allowed errors of all steps of a solution, and a few rounding errors.
fn allowed(solution: &Solution, tolerance: f64, size: f64) -> f64 {
    let steps = f64::from(u32::try_from(solution.steps).unwrap());
    steps * tolerance.max(2.0 * f64::EPSILON) * size
}

const POWERS: [(&str, f64); 8] = [
    ("0.05", 0.05),
    ("0.5", 0.5),
    ("2/3", 2.0 / 3.0),
    ("sqrt(2)", std::f64::consts::SQRT_2),
    ("1.5", 1.5),
    ("2.5", 2.5),
    ("pi", PI),
    ("7.25", 7.25),
];

/// x″ + |x|^p·sign(x) = 0 from 1: a quarter of its period is √((p + 1)/2)·B(1/(p + 1), 1/2)/(p + 1).
#[test]
fn pure_powers_have_their_half_periods() {
    for (text, p) in POWERS {
        let system = watching(&format!("x'' + abs(x)^({text})*sign(x) = 0"), "x", Direction::Any);
        let quarter = sqrt(0.5 * (p + 1.0)) * arc(p + 1.0);
        for tolerance in [1e-9, 1e-12, 1e-15] {
            let solution = solve(&system, &from(&[1.0, 0.0]), &[20.5 * quarter], tolerance);
            assert_eq!(solution.events.len(), 10, "{text}");
            for (event, odd) in solution.events.iter().zip((1..).step_by(2).map(f64::from)) {
                let error = event.time - odd * quarter;
                let allowed = allowed(&solution, tolerance, event.time);
                assert!(error.abs() < allowed, "{text} to {tolerance:e}: {error:e}, allowed {allowed:e}");
                let speed = event.state[1].abs() - sqrt(2.0 / (p + 1.0));
                assert!(speed.abs() < allowed, "{text} to {tolerance:e}: {speed:e}, allowed {allowed:e}");
            }
        }
    }
}

/// Heinrich Hertz's ball: x″ = −max(x, 0)^1.5. It enters with the speed v, penetrates to
/// (5v²/4)^(2/5) and leaves with the same speed after 2.9432 times this depth over v.
#[test]
fn a_ball_leaves_contact_as_it_came() {
    let factor = 2.0 * sqrt(PI) * tgamma(1.4) / tgamma(0.9);
    assert!((factor - 2.9432).abs() < 1e-4);
    let written = ["-max(x, 0)^1.5", "-max(0, x)^(3/2)", "-((x + abs(x))/2)^1.5", "-(x*(1 + sign(x))/2)^1.5"];
    for formula in written {
        let system = watching(&format!("x'' = {formula}"), "x'", Direction::Falling);
        for start in [-3.0, -1.0, -1e-9, -1e-16, -5e-324, 0.0, -0.1] {
            for v in [0.01, 1.0, 7.0] {
                let deepest = pow(1.25 * v * v, 0.4);
                let contact = factor * deepest / v;
                let entered = -start / v;
                let times = [entered + contact, entered + contact + 1.0];
                let solution = solve(&system, &from(&[start, v]), &times, 1e-13);
                let allowed = allowed(&solution, 1e-13, 1.0 + times[1]);
                let [out, later] = [0, 1].map(|n| &solution.samples[n].state);
                assert!(out[0].abs() < allowed * v, "{formula} {start} {v}: {out:?}");
                assert!(
                    (out[1] + v).abs() < allowed * v && (later[0] + v).abs() < allowed * v,
                    "{start} {v}"
                );
                let [turn] = &solution.events[..] else { panic!("{formula} {start} {v}") };
                assert!(
                    (turn.time - entered - 0.5 * contact).abs() < allowed,
                    "{formula} {start} {v}: {turn:?}"
                );
                assert!(
                    (turn.state[0] - deepest).abs() < allowed * deepest,
                    "{formula} {start} {v}: {turn:?}"
                );
            }
        }
    }
}

/// A ball in free flight that bounced on a spring of Hertz under gravity returns to its initial height.
#[test]
fn a_ball_bounces_for_ever() {
    let system = watching("z'' = -1 + 1000*max(-z, 0)^1.5", "z'", Direction::Falling);
    let solution = solve(&system, &from(&[1.0, 0.0]), &[60.0], 1e-14);
    assert!(solution.events.len() > 15);
    for event in &solution.events {
        assert!((event.state[0] - 1.0).abs() < allowed(&solution, 1e-14, 60.0), "{event:?}");
    }
}

/// x″ = 1 − |x|^p from rest at zero turns at (p + 1)^(1/p), returns, and touches zero with zero velocity.
#[test]
fn a_motion_may_touch_where_it_has_no_series() {
    for (text, p) in [("0.5", 0.5), ("2/3", 2.0 / 3.0), ("1.5", 1.5), ("2.5", 2.5)] {
        let system = system(&format!("x'' = 1 - abs(x)^({text})"));
        let highest = pow(p + 1.0, 1.0 / p);
        // ∫dx/√(2x − 2xᵖ⁺¹/(p + 1)), substituting x/highest = y² in `arc`.
        let half = sqrt(2.0 * highest) * arc(2.0 * p);
        let times = [half, 2.0 * half, 3.0 * half, 4.0 * half];
        let solution = solve(&system, &from(&[0.0, 0.0]), &times, 1e-13);
        for (sample, position) in solution.samples.iter().zip([highest, 0.0, highest, 0.0]) {
            // Where the motion touches zero, the remaining velocity decides on which
            // side it continues: the error is the square root of the earlier one.
            let allowed = 100.0 * allowed(&solution, 1e-13, highest * 4.0 * half);
            let [x, v] = sample.state[..] else { panic!() };
            assert!(
                (x - position).abs() < allowed && v.abs() < allowed,
                "{text}: {sample:?} {position} {allowed:e}"
            );
        }
    }
}

/// Starts that differ from zero by the smallest number, and by a rounding error of nearby values, have neighbouring motions.
#[test]
fn starts_beside_zero_are_like_the_start_at_zero() {
    for formula in
        ["-abs(x)^0.5*sign(x)", "-abs(x)^1.5*sign(x)", "1 - sqrt(abs(x'))*x'", "1 - abs(x')^0.5*sign(x')"]
    {
        let system = system(&format!("x'' = {formula}"));
        // From rest next to zero |x|^0.5 oscillates faster the smaller the distance: no motion is close to rest.
        let speeds: &[f64] =
            if formula.starts_with("-abs(x)^0.5") { &[1.0, -1.0] } else { &[0.0, 1.0, -1.0] };
        for &speed in speeds {
            let end = |start: [f64; 2]| solve(&system, &from(&start), &[3.0], 1e-13).end.state;
            let at_zero = end([0.0, speed]);
            for beside in [5e-324, -5e-324, 1e-300, 1e-16, -1e-16] {
                let near = end([beside, speed]);
                let apart = (near[0] - at_zero[0]).abs().max((near[1] - at_zero[1]).abs());
                assert!(apart < 1e-11, "{formula} at {speed}: {beside:e}: {near:?} {at_zero:?}");
            }
            for beside in [5e-324, -1e-300, 1e-17] {
                let near = end([0.0, speed + beside]);
                let apart = (near[0] - at_zero[0]).abs().max((near[1] - at_zero[1]).abs());
                assert!(apart < 1e-11, "{formula} at {speed}: {beside:e}: {near:?} {at_zero:?}");
            }
        }
    }
}

type Law<'a> = &'a dyn Fn(f64) -> f64;

/// A body thrown up against a resistance proportional to the power n of the velocity, and falling: v′ = 1 − |v|ⁿ·sign(v).
#[test]
fn a_throw_against_a_broken_power_of_the_velocity_is_that_of_closed_forms() {
    // The times from v = 0, with the root w of the speed: ∫2w dw/(1 ∓ w) and ∫2w dw/(1 ∓ w³).
    let fall_half = |v: f64| -2.0 * sqrt(v) - 2.0 * log(1.0 - sqrt(v));
    let rise_half = |v: f64| 2.0 * sqrt(v) - 2.0 * log(1.0 + sqrt(v));
    let third = sqrt(3.0);
    let odd = |w: f64| {
        -2.0 / 3.0 * log(1.0 - w) + log(w * w + w + 1.0) / 3.0
            - 2.0 / third * (atan((2.0 * w + 1.0) / third) - atan(1.0 / third))
    };
    let fall_three_halves = |v: f64| odd(sqrt(v));
    let rise_three_halves = |v: f64| odd(-sqrt(v));
    let laws: [(&str, Law<'_>, Law<'_>); 2] =
        [("0.5", &rise_half, &fall_half), ("1.5", &rise_three_halves, &fall_three_halves)];
    for (n, rise, fall) in laws {
        for equation in ["x'' = 1 - abs(x')^(N)*sign(x')", "v' = 1 - abs(v)^(N)*sign(v)"] {
            let system = system(&equation.replace('N', n));
            for thrown in [0.0, 1e-6, 0.3, 2.0, 50.0] {
                let top = rise(thrown);
                for reached in [1e-6, 0.1, 0.5, 0.9] {
                    let mut start = vec![0.0; system.state_names().len()];
                    *start.last_mut().unwrap() = -thrown;
                    let solution = solve(&system, &from(&start), &[top + fall(reached)], 1e-14);
                    let speed = solution.end.state.last().unwrap();
                    let allowed = allowed(&solution, 1e-14, 1.0 + thrown);
                    assert!((speed - reached).abs() < allowed, "{equation} {n} {thrown}: {speed} {reached}");
                }
            }
        }
    }
}

/// The pendulum of `decay`, which computes averages and swings by another method.
#[test]
fn a_pendulum_damped_by_a_broken_power_turns_where_decay_says() {
    use libration::decay::{Damping, Decay, PowerLawTerm};
    use libration::pendulum::Pendulum;
    use libration::quantity::Angle;
    for n in ["1.5", "0.5", "2.25"] {
        let value = |text: &str| text.parse::<Expression>().unwrap();
        let model = Model::by_key("damped_pendulum", &[("c", value("0.1")), ("n", value(n))], &[]).unwrap();
        let turning = Event::zero_of("theta'".parse().unwrap());
        let system = model.system().unwrap().with_events(&[turning]).unwrap();
        let start = model.start(&[("theta", 2.0)]).unwrap();
        let solution = solve(&system, &start, &[40.0], 1e-14);
        let terms = [PowerLawTerm { exponent: n.parse().unwrap(), coefficient: 0.1 }];
        let pendulum = Pendulum::from_angular_frequency(1.0).unwrap();
        let decay =
            Decay::new(pendulum, Damping::new(&terms).unwrap(), Angle::from_radians(2.0).unwrap()).unwrap();
        for (event, turn) in solution.events.iter().zip(decay.swings()) {
            let turn = turn.unwrap();
            // The accuracy of `decay` for powers that are not integers.
            assert!((event.time - turn.time).abs() < 2e-13 * 40.0, "{n}: {event:?} {turn:?}");
            assert!(
                (event.state[0].abs() - turn.amplitude.radians()).abs() < 2e-13,
                "{n}: {event:?} {turn:?}"
            );
        }
        assert!(solution.events.len() > 8, "{n}");
    }
}

/// x = x′ = 0 is an equilibrium, and remains one.
#[test]
fn rest_is_rest() {
    for formula in [
        "-abs(x)^0.5*sign(x)",
        "-x - abs(x')^1.5*sign(x')",
        "-max(x, 0)^1.5",
        "-sqrt(abs(x))*x - x'*sqrt(abs(x'))",
    ] {
        let solution = solve(&system(&format!("x'' = {formula}")), &from(&[0.0, 0.0]), &[1.0, 1e6], 1e-12);
        assert!(solution.samples.iter().all(|sample| sample.state == [0.0, 0.0]), "{formula}: {solution:?}");
        assert!(solution.steps < 10, "{formula}: {}", solution.steps);
    }
}

/// Forward and backward, through eight zeros in each direction.
#[test]
fn motions_run_back_to_where_they_began() {
    let system = system("x'' = -abs(x)^0.5*sign(x); y'' = -max(y - x, 0)^1.5 + max(-y - x, 0)^1.5");
    let start = from(&[1.0, 0.5, 0.0, -0.25]);
    let there = solve(&system, &start, &[12.0], 1e-15).end;
    let back = solve(&system, &there, &[0.0], 1e-15).end;
    for (a, b) in back.state.iter().zip(&start.state) {
        assert!((a - b).abs() < 1e-12, "{back:?}");
    }
}

#[test]
fn motions_in_lanes_and_motions_gone_on_with_have_the_same_bits() {
    let system = watching("x'' = -abs(x)^0.5*sign(x) - abs(x')^1.5*sign(x')/50", "x'", Direction::Any);
    let effort = Effort::to_tolerance(1e-12);
    let starts: Vec<Moment> = (0..11).map(|n| from(&[f64::from(n) / 10.0 - 0.5, 0.0])).collect();
    let times = [5.0, 20.0];
    let trajectories: Vec<Trajectory<'_>> = starts
        .iter()
        .map(|start| Trajectory { start: start.clone(), parameters: vec![], times: &times })
        .collect();
    for (start, together) in starts.iter().zip(integrate_many(&system, &trajectories, &effort, &Quiet)) {
        assert_eq!(integrate(&system, start, &times, &effort, &Quiet), together);
        let mut marks = vec![];
        let begin = libration::taylor::Start::State(start.clone());
        let whole = integrate_from(&system, &begin, &times, &effort, |step| {
            marks.extend(step.checkpoint());
            ControlFlow::Continue(())
        });
        let whole = whole.unwrap();
        for mark in marks.into_iter().step_by(29) {
            let resumed = libration::taylor::Start::Checkpoint(mark);
            let rest =
                integrate_from(&system, &resumed, &[20.0], &effort, |_| ControlFlow::Continue(())).unwrap();
            assert_eq!(rest.end, whole.end);
        }
    }
}

/// Inside the step over a zero the state is as accurate as at its ends.
#[test]
fn the_state_is_known_inside_the_step_over_a_zero() {
    let system = system("x'' = -abs(x)^0.5*sign(x)");
    let quarter = sqrt(0.75) * arc(1.5);
    let motion = integrate_dense(&system, &from(&[1.0, 0.0]), 2.0, &Effort::to_tolerance(1e-15)).unwrap();
    let speed = -sqrt(2.0 / 1.5);
    for apart in [-1e-7, -1e-10, -1e-13, -1e-15, 0.0, 1e-15, 1e-14, 1e-12, 1e-8] {
        let state = motion.state_at(quarter + apart).unwrap();
        // The coefficient of the next term of x is below one.
        let next = pow(f64::abs(apart), 1.5);
        assert!((state[0] - speed * apart).abs() < 2e-14 + next * f64::abs(apart), "{apart:e}: {state:?}");
        assert!((state[1] - speed).abs() < 2e-14 + next, "{apart:e}: {state:?}");
    }
}
