//! Components that reach zero in a finite time, and stay there.

use crate::typed::{from, system};
use libm::{pow, sqrt};
use libration::progress::Quiet;
use libration::taylor::{
    Cause, Effort, Event, IntegrationError, Moment, Solution, Start, System, Trajectory, integrate,
    integrate_from, integrate_many,
};
use std::ops::ControlFlow;

/// The height of water over a hole, by Evangelista Torricelli's law.
const WATER: &str = "x' = -sqrt(abs(x))*sign(x)";

fn solve(equations: &str, state: &[f64], times: &[f64], tolerance: f64) -> Solution {
    integrate(&system(equations), &from(state), times, &Effort::to_tolerance(tolerance), &Quiet).unwrap()
}

/// √x = √x₀ − t/2 until it is zero, from either side.
#[test]
fn water_runs_out_as_its_closed_form_does() {
    let times: Vec<f64> = (0..=40).map(|n| f64::from(n) / 8.0).collect();
    for tolerance in [1e-15, 1e-12, 1e-6] {
        for start in [1.0, 2.0, -0.3, 1e-12, 5.0] {
            let solution = solve(WATER, &[start], &times, tolerance);
            assert_eq!(solution.samples.len(), times.len());
            for Moment { time, state } in &solution.samples {
                let root = (sqrt(start.abs()) - time / 2.0).max(0.0);
                let exact = (root * root).copysign(start);
                assert!(
                    (state[0] - exact).abs() <= 10.0 * tolerance.max(1e-15),
                    "{start} {time}: {}",
                    state[0]
                );
                assert!(root > 0.0 || state[0].abs() < 1e-28, "{start} {time}: {}", state[0]);
            }
            assert!(solution.end.state[0] == 0.0 && solution.steps < 3000, "{} {}", start, solution.steps);
        }
    }
}

/// x^(1−p) = 1 − (1 − p)t.
#[test]
fn other_powers_come_to_zero_when_they_should() {
    for (text, p) in [("1/4", 0.25), ("1/3", 1.0 / 3.0), ("0.7", 0.7)] {
        let equation = format!("x' = -abs(x)^({text})*sign(x)");
        let stops = 1.0 / (1.0 - p);
        let times = [0.5 * stops, 0.99 * stops, 1.000001 * stops, 2.0 * stops];
        let samples = solve(&equation, &[1.0], &times, 1e-15).samples;
        for (sample, part) in samples.iter().zip([0.5, 0.99]) {
            let exact = pow(1.0 - part, stops);
            assert!((sample.state[0] - exact).abs() < 1e-14, "{equation}: {}", sample.state[0]);
        }
        assert_eq!([samples[2].state[0], samples[3].state[0]], [0.0; 2], "{equation}");
    }
}

/// x = (1 − t/10)¹⁰, a polynomial whose terms are a thousand times as large as its value:
/// from either side of zero, and without |…| from the side on which the power has a value.
#[test]
fn powers_next_to_one_lose_nothing_to_cancellation() {
    let times: Vec<f64> = (0..=14).map(f64::from).collect();
    for (equation, start) in
        [("x' = -abs(x)^0.9*sign(x)", 1.0), ("x' = -abs(x)^0.9*sign(x)", -1.0), ("x' = -x^0.9", 1.0)]
    {
        for tolerance in [1e-15, 1e-12] {
            let solution = solve(equation, &[start], &times, tolerance);
            for Moment { time, state } in &solution.samples {
                let exact = start * pow((1.0 - time / 10.0).max(0.0), 10.0);
                let error = (state[0] - exact).abs();
                assert!(error <= 2.0 * tolerance, "{equation} to {tolerance:e} at {time}: {error:e}");
            }
            assert!(solution.end.state[0] == 0.0 && solution.steps < 400, "{}", solution.steps);
        }
    }
}

/// The argument of a root without |…| stays at zero too if the force leads below zero; if it leads above zero the argument may leave.
#[test]
fn roots_without_bars_come_to_rest_where_they_end() {
    let end = solve("x' = -sqrt(x); y'' = -sqrt(y')", &[1.0, 0.0, 1.0], &[9.0], 1e-15).end.state;
    assert!(end[0] == 0.0 && end[2] == 0.0 && (end[1] - 2.0 / 3.0).abs() < 1e-15, "{end:?}");
    let away =
        integrate(&system("x' = sqrt(x)"), &from(&[0.0]), &[1.0], &Effort::to_tolerance(1e-12), &Quiet);
    let Err(IntegrationError::Stopped { cause, .. }) = away else { panic!("{away:?}") };
    assert_eq!(cause, Cause::Undecided);
}

/// v/|v|^p is |v|^(1 − p)·sign(v) in all equivalent forms: v^p = 1 − pt. With p = 1 it is dry friction.
#[test]
fn quotients_that_vanish_with_their_divisor_come_to_rest() {
    let written = [
        ("-x'/sqrt(abs(x'))", 0.5),
        ("-3*x'/(3*sqrt(abs(x')))", 0.5),
        ("x'*(-abs(x')^(-1/2))", 0.5),
        ("-x'^3/abs(x')^2.5", 0.5),
        ("-x'/(abs(x')^0.15)^2", 0.3),
        ("-x'/abs(x')^0.3", 0.3),
        ("-x'/abs(x')", 1.0),
        ("-x'*(1/abs(x'))", 1.0),
    ];
    for (formula, p) in written {
        for start in [1.0, -1.0] {
            let equation = format!("x'' = {formula}");
            let times = [0.5 / p, 0.9 / p, 2.0 / p, 30.0 / p];
            for Moment { time, state } in &solve(&equation, &[0.0, start], &times, 1e-15).samples {
                let left = (1.0 - p * time).max(0.0);
                let speed = pow(left, 1.0 / p);
                let way = (1.0 - speed * left) / (1.0 + p);
                let errors = [(state[0] - start * way).abs(), (state[1] - start * speed).abs()];
                assert!(errors.iter().all(|error| *error < 1e-14), "{formula} at {time}: {errors:?}");
                assert!(left > 0.0 || state[1] == 0.0, "{formula} at {time}: {}", state[1]);
            }
        }
    }
}

/// x′ = x²/|x|^1.5 is √|x| on both sides: (1 + t/2)² above zero, −(1 − t/2)² below.
#[test]
fn even_powers_over_powers_of_a_modulus_keep_no_sign() {
    let state = solve("x' = x^2/abs(x)^1.5", &[1.0], &[2.0], 1e-15).end.state[0];
    assert!((state - 4.0).abs() < 1e-14, "{state}");
    let state = solve("x' = x^2/abs(x)^1.5", &[-1.0], &[1.0], 1e-15).end.state[0];
    assert!((state + 0.25).abs() < 1e-15, "{state}");
}

/// v′ = −1/√v ends at t = 2/3, with an infinite rate: the equation does not determine the continuation, and the error contains the time.
#[test]
fn a_rate_that_is_infinite_at_zero_ends_the_motion() {
    let equation = "x'' = -x'/abs(x')^1.5";
    let motion =
        integrate(&system(equation), &from(&[0.0, 1.0]), &[9.0], &Effort::to_tolerance(1e-12), &Quiet);
    let Err(IntegrationError::Stopped { solution, .. }) = motion else { panic!("{motion:?}") };
    assert!((solution.end.time - 2.0 / 3.0).abs() < 1e-12, "{}", solution.end.time);
}

/// The rates are integrable, but times next to the singularity have no digits to integrate it.
#[test]
fn a_rate_that_is_infinite_at_a_time_ends_the_motion() {
    for equation in
        ["x' = 1/sqrt(abs(t - 1))", "x' = 1/abs(t - 1)^0.9", "x' = abs(t - 1)^(-0.3) + sqrt(abs(t - 1))"]
    {
        let motion =
            integrate(&system(equation), &from(&[0.0]), &[2.0], &Effort::to_tolerance(1e-12), &Quiet);
        let Err(IntegrationError::Stopped { solution, .. }) = motion else {
            panic!("{equation}: {motion:?}")
        };
        assert!((solution.end.time - 1.0).abs() < 1e-12, "{equation}: {}", solution.end.time);
    }
}

/// v = (1 − t/2)²: after 2/3 it stays at rest, and another coordinate is not affected.
#[test]
fn a_velocity_comes_to_rest_while_others_move_on() {
    let equations = "x'' = -sqrt(abs(x'))*sign(x'); y'' = -y";
    let solution = solve(equations, &[0.0, 1.0, 1.0, 0.0], &[1.0, 2.5, 60.0], 1e-15);
    let [before, after, late] = &solution.samples[..] else { panic!() };
    assert!((before.state[0] - 7.0 / 12.0).abs() < 1e-15 && (before.state[2] - 0.25).abs() < 1e-15);
    for Moment { time, state } in [after, late] {
        assert!((state[0] - 2.0 / 3.0).abs() < 1e-15 && state[2] == 0.0, "{state:?}");
        assert!((state[1] - libm::cos(*time)).abs() < 1e-13, "{state:?}");
    }
}

/// From one tank into the next and out: each runs empty, and the total volume is conserved.
#[test]
fn tanks_run_empty_one_after_the_other() {
    let equations = "x' = -sqrt(abs(x))*sign(x); y' = sqrt(abs(x)) - sqrt(abs(y))*sign(y); z' = sqrt(abs(y))";
    let solution = solve(equations, &[1.0, 0.0, 0.0], &[1.0, 2.25, 9.0], 1e-15);
    for Moment { state, .. } in &solution.samples {
        assert!((state.iter().sum::<f64>() - 1.0).abs() < 1e-14, "{state:?}");
    }
    let [_, second, last] = &solution.samples[..] else { panic!() };
    assert!(second.state[0] == 0.0 && second.state[1] > 0.01, "{second:?}");
    assert!(last.state[..2] == [0.0, 0.0] && (last.state[2] - 1.0).abs() < 1e-14, "{last:?}");
}

#[test]
fn events_are_found_before_and_at_the_rest() {
    let zero = |formula: &str| Event::zero_of(formula.parse().unwrap());
    let water = system("x' = -sqrt(abs(x))*sign(x); y'' = -y")
        .with_events(&[
            zero("x - 1/4"),
            zero("x"),
            zero("t - 4"),
            zero("sqrt(abs(x)) - 1/4"),
            zero("ln(x) + 5"),
        ])
        .unwrap();
    let solution =
        integrate(&water, &from(&[1.0, 1.0, 0.0]), &[9.0], &Effort::to_tolerance(1e-12), &Quiet).unwrap();
    assert!(solution.steps < 300, "{}", solution.steps);
    let times: Vec<(usize, f64)> = solution.events.iter().map(|event| (event.event, event.time)).collect();
    assert_eq!(times.len(), 5, "{times:?}");
    for ((event, time), (wanted, exact)) in
        times.iter().zip([(0, 1.0), (3, 1.5), (4, 2.0 - 2.0 * libm::exp(-2.5)), (1, 2.0), (2, 4.0)])
    {
        assert!(*event == wanted && (time - exact).abs() < 1e-11, "{times:?}");
    }
}

/// Among motions that never come to rest each result is that of the motion alone.
#[test]
fn motions_side_by_side_rest_by_themselves() {
    let equations = "x' = -sqrt(abs(x))*sign(x) + k*cos(t)";
    let system = System::with_parameters(&equations.parse().unwrap(), &["k"]).unwrap();
    let times = [1.0, 3.0, 10.0];
    let motion = |n: u32| {
        let k = if n.is_multiple_of(3) { 0.0 } else { 0.1 * f64::from(n) };
        Trajectory { start: from(&[0.2 * f64::from(n)]), parameters: vec![k], times: &times }
    };
    let all: Vec<Trajectory<'_>> = (0..11).map(motion).collect();
    let effort = Effort::to_tolerance(1e-12);
    let alone: Vec<_> = all.iter().map(|motion| motion.integrate(&system, &effort, &Quiet)).collect();
    assert_eq!(integrate_many(&system, &all, &effort, &Quiet), alone);
}

#[test]
fn a_motion_with_a_rest_is_gone_on_with_from_its_last_checkpoint() {
    // For water itself the height is a polynomial in the time, and each step reaches the goal.
    let (water, effort) = (system("x' = -abs(x)^0.3*sign(x); y'' = -y"), Effort::to_tolerance(1e-12));
    let mut last = None;
    let begin = Start::State(from(&[1.0, 1.0, 0.0]));
    let whole = integrate_from(&water, &begin, &[50.0], &effort, |step| {
        last = step.checkpoint().or(last.take());
        ControlFlow::Continue(())
    });
    let last = last.unwrap();
    assert!(last.time < 1.43, "{}", last.time);
    let resumed =
        integrate_from(&water, &Start::Checkpoint(last), &[50.0], &effort, |_| ControlFlow::Continue(()));
    assert_eq!(resumed.unwrap().end, whole.unwrap().end);
}

#[test]
fn tolerances_hold_beside_a_rest() {
    let steps = |tolerances: &[(&str, f64)]| {
        let tank = system("x' = -sqrt(abs(x))*sign(x); y'' = -900*y").with_tolerances(tolerances).unwrap();
        let whole = |time| {
            integrate(&tank, &from(&[1.0, 1.0, 0.0]), &[time], &Effort::to_tolerance(1e-13), &Quiet)
                .unwrap()
                .steps
        };
        whole(20.0) - whole(3.0)
    };
    assert!(4 * steps(&[("y", 1e-5)]) < 3 * steps(&[]), "{} of {}", steps(&[("y", 1e-5)]), steps(&[]));
}

/// Below zero −√|x| leads away: at zero the motion may stay for any time.
#[test]
fn where_zero_may_be_left_at_any_time_the_motion_ends() {
    let motion =
        integrate(&system("x' = -sqrt(abs(x))"), &from(&[1.0]), &[9.0], &Effort::to_tolerance(1e-12), &Quiet);
    let Err(IntegrationError::Stopped { cause, solution }) = motion else { panic!("{motion:?}") };
    assert_eq!(cause, Cause::Undecided);
    assert!((solution.end.time - 2.0).abs() < 1e-12 && cause.to_string().contains("do not decide"));
    // If the root is not the whole force, zero is passed.
    let passed = solve("x' = -sqrt(abs(x)) - 1/8", &[1.0], &[9.0], 1e-12).end.state[0];
    assert!(passed < -1.0, "{passed}");
}

/// At a jump that leads away on both sides, the sign of zero would choose one of three motions.
#[test]
fn a_motion_that_begins_where_a_force_leads_away_on_both_sides_ends() {
    let cause = |equations: &str, state: &[f64], end: f64| {
        let motion =
            integrate(&system(equations), &from(state), &[end], &Effort::to_tolerance(1e-12), &Quiet);
        match motion {
            Err(IntegrationError::Stopped { cause, .. }) => Some(cause),
            _ => None,
        }
    };
    for (equations, state, end) in [
        ("x'' = sign(x)", &[0.0, 0.0][..], 1.0),
        ("x'' = sign(x)", &[0.0, 0.0], -1.0),
        ("x' = sign(x)", &[0.0], 1.0),
        ("x' = -sign(x)", &[0.0], -1.0),
        ("x'' = sign(x')/3 - x", &[0.1, 0.0], 1.0),
        ("x'' = sign(x - 1)", &[1.0, 0.0], 1.0),
        ("x'' = -y; y'' = sign(y)", &[0.0, 0.0, 1.0, 0.0], 1.0),
    ] {
        assert_eq!(cause(equations, state, end), Some(Cause::Undecided), "{equations}");
    }
    for (equations, state) in [
        ("x'' = sign(x)", &[0.0, 1.0][..]),
        ("x'' = sign(x)", &[1e-300, 0.0]),
        ("x' = -sign(x)", &[0.0]),
        ("x'' = 2 + sign(x)", &[0.0, 0.0]),
        ("x'' = sign(x')/3 - x", &[1.0, 0.0]),
        ("x'' = 1 + abs(x)", &[0.0, 0.0]),
        ("x'' = abs(x) - x", &[0.0, 0.0]),
    ] {
        assert_eq!(cause(equations, state, 1.0), None, "{equations}");
    }
}
