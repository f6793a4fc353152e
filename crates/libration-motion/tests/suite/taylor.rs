//! Integration in time compared with the exact pendulum, solutions in closed form, and damped pendulums in forty digits.

use crate::typed::{from, system};
use libration::pendulum::Pendulum;
use libration::progress::Quiet;
use libration::quantity::Angle;
use libration::taylor::{
    Cause, Effort, IntegrationError, Moment, Solution, System, integrate, integrate_stepwise,
};
use libration_testing::golden::{Row, Table};
use libration_testing::random::Random;
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;

const PENDULUM: &str = "theta'' + sin(theta) = 0";

fn attempt(
    equation: &str,
    start: &Moment,
    times: &[f64],
    tolerance: f64,
) -> Result<Solution, IntegrationError> {
    let effort = Effort::to_tolerance(tolerance);
    integrate(&system(equation), start, times, &effort, &Quiet)
}

fn solve(equation: &str, state: &[f64], times: &[f64], tolerance: f64) -> Solution {
    attempt(equation, &from(state), times, tolerance).unwrap()
}

fn state_at(equation: &str, state: &[f64], time: f64, tolerance: f64) -> Vec<f64> {
    solve(equation, state, &[time], tolerance).samples.remove(0).state
}

fn assert_close(got: &[f64], wanted: &[f64], bound: f64, what: &str) {
    for (got, wanted) in got.iter().zip(wanted) {
        assert!((got - wanted).abs() <= bound, "{what}: {got:e}, not {wanted:e}, within {bound:e}");
    }
}

/// A rounding error of the energy, half of 2ᵐ radians squared, changes the period by its T/(4(1 − m)): this is the accuracy of an integration in
/// words of 53 bits, without the errors in the turns. Near the top only the fall is accurate, and later errors grow like eᵗ.
fn condition(row: Row<'_>, time: f64) -> f64 {
    let (start, velocity) = (row.input("start_hex"), row.input("velocity_hex"));
    let from_top = row.text("given") == "complement";
    let half = libm::sin(0.5 * start);
    let above = if from_top { -half * half } else { half * half - 1.0 };
    let complement = (above + 0.25 * velocity * velocity).abs();
    let word = 1e-14 + 3e-16 * row.input("angle").abs();
    let whole = word * (1.0 + time.abs() / complement);
    let quarter = 0.25 * row.input("period");
    let fall = if from_top { 1e-14 * libm::exp((time.abs() - quarter).max(0.0)) } else { f64::INFINITY };
    whole.min(fall)
}

#[test]
fn the_exact_pendulum_is_met_in_every_regime() {
    let mut judged = 0;
    for row in Table::read("motion.csv").rows() {
        let (start, velocity, time) =
            (row.input("start_hex"), row.input("velocity_hex"), row.input("time_hex"));
        let bound = condition(row, time);
        if bound > 1e-4 || time.abs() > 1000.0 * row.input("period") {
            continue;
        }
        judged += 1;
        let angle = if row.text("given") == "complement" {
            PI - state_at("phi'' = sin(phi)", &[start, -velocity], time, 1e-15)[0]
        } else {
            state_at(PENDULUM, &[start, velocity], time, 1e-15)[0]
        };
        assert_close(
            &[angle],
            &[row.input("angle")],
            bound,
            &format!("{} {start} {velocity} {time}", row.text("given")),
        );
    }
    assert!(judged > 280, "{judged}");
}

#[test]
fn from_179_degrees_the_energy_keeps_for_a_thousand_periods() {
    let start = 179_f64.to_radians();
    let exact = Pendulum::from_angular_frequency(1.0)
        .unwrap()
        .released_from(Angle::from_radians(start).unwrap())
        .unwrap();
    let times: Vec<f64> = (1..=1000).map(|n| f64::from(n) * exact.period()).collect();
    for (tolerance, drift, error) in [(1e-9, 2e-9, 4e-6), (1e-12, 2e-12, 4e-10), (1e-15, 4e-15, 4e-12)] {
        let solution = solve(PENDULUM, &[start, 0.0], &times, tolerance);
        for Moment { time, state } in &solution.samples {
            let energy = 0.5 * state[1] * state[1] + 1.0 - libm::cos(state[0]);
            assert!(
                (energy / (1.0 - libm::cos(start)) - 1.0).abs() < drift,
                "{tolerance:e}: {energy} at {time}"
            );
        }
        let end = &solution.samples[999];
        assert_close(&end.state[..1], &[exact.state_at(end.time).angle], error, "after 1000 periods");
        assert!(solution.steps < 80_000, "{} steps", solution.steps);
    }
}

#[test]
fn linear_oscillators_keep_their_phase() {
    let time = 1000.0 * TAU;
    let got = state_at("x'' = -x", &[1.0, 0.0], time, 1e-15);
    assert_close(&got, &[libm::cos(time), -libm::sin(time)], 2e-13, "x'' = -x");
    // In other units, and so small that an absolute tolerance would have no effect.
    let got = state_at("x'' = -1000000 x", &[1e-30, 0.0], time * 1e-3, 1e-15);
    assert_close(&got[..1], &[1e-30 * libm::cos(1e3 * (time * 1e-3))], 2e-43, "at 1000 rad/s");
}

#[test]
fn coupled_oscillators_beat() {
    // x + y oscillates with frequency 1, x − y with frequency 2.
    let got = state_at("x'' = -2.5 x + 1.5 y; y'' = -2.5 y + 1.5 x", &[1.0, 0.0, 0.0, 0.0], 100.0, 1e-15);
    let (slow, fast) = (libm::cos(100.0), libm::cos(200.0));
    assert_close(&got[..2], &[0.5 * (slow + fast), 0.5 * (slow - fast)], 2e-14, "beats");
}

#[test]
fn kepler_ellipses_close() {
    // An orbit of eccentricity 1/2, from the pericentre.
    let start = [0.5, 0.0, 0.0, 3_f64.sqrt()];
    let kepler = "x'' = -x/(x^2 + y^2)^(3/2); y'' = -y/(x^2 + y^2)^(3/2)";
    let got = state_at(kepler, &start, 100.0 * TAU, 1e-15);
    assert_close(&got, &start, 1e-10, "after 100 revolutions");
}

#[test]
fn going_back_leads_to_the_start() {
    let equation = "theta'' + 0.1 theta' abs(theta') + sin(theta) = 0.5 cos(2t/3)";
    let there = attempt(equation, &from(&[1.0, 0.0]), &[20.0], 1e-15).unwrap();
    let back = attempt(equation, &there.end, &[10.0, 0.0], 1e-15).unwrap();
    assert_close(&back.end.state, &[1.0, 0.0], 1e-14, "back");
    let middle = state_at(equation, &[1.0, 0.0], 10.0, 1e-15);
    assert_close(&back.samples[0].state, &middle, 1e-14, "on the way");
}

#[test]
fn states_inside_a_step_are_as_good_as_its_end() {
    let exact = Pendulum::from_angular_frequency(1.0)
        .unwrap()
        .released_from(Angle::from_radians(2.0).unwrap())
        .unwrap();
    let times: Vec<f64> = (0..5000).map(|i| 0.01 * f64::from(i)).collect();
    for Moment { time, state } in solve(PENDULUM, &[2.0, 0.0], &times, 1e-15).samples {
        let wanted = exact.state_at(time);
        assert_close(&state, &[wanted.angle, wanted.velocity], 2e-14, &format!("at {time}"));
    }
}

#[test]
fn the_watch_sees_steps_without_gaps_and_may_stop_them() {
    let mut ends = vec![0.0];
    let effort = Effort::to_tolerance(1e-12);
    let outcome = integrate_stepwise(&system(PENDULUM), &from(&[1.0, 0.0]), &[0.1, 50.0], &effort, |step| {
        assert_eq!(step.start(), ends[ends.len() - 1]);
        ends.push(step.end());
        if ends.len() > 10 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let Err(IntegrationError::Stopped { cause: Cause::Interrupted, solution }) = outcome else {
        panic!("{outcome:?}")
    };
    assert_eq!((solution.steps, solution.samples.len(), solution.end.time), (10, 1, ends[10]));
}

#[test]
fn absolute_values_go_on_with_their_other_branch() {
    // x'' = −sign(x) by |x|/x: parabolas, from x = 1 the period is 4√2. Each of 200 jumps
    // of the force is late by up to half of 2⁻⁴³, the spacing of an f64 at times about 500.
    let got = state_at("x'' = -abs(x)/x", &[1.0, 0.0], 400.0 * 2_f64.sqrt(), 1e-15);
    assert_close(&got, &[1.0, 0.0], 1e-11, "x'' = -|x|/x");
    let got = state_at("x'' = -sign(x)", &[1.0, 0.0], 400.0 * 2_f64.sqrt(), 1e-15);
    assert_close(&got, &[1.0, 0.0], 1e-11, "x'' = -sign(x)");
    // x'' = −x for x > 0, −4x for x < 0: half a turn each.
    let got = state_at("x'' = -2.5 x + 1.5 abs(x)", &[1.0, 0.0], 150.0 * PI, 1e-15);
    assert_close(&got, &[1.0, 0.0], 1e-12, "two springs");
    // x = (t − 1)² touches zero without crossing it.
    let got = state_at("x'' = 2 + 0 t - x + abs(x)", &[1.0, -2.0], 3.0, 1e-15);
    assert_close(&got, &[4.0, 4.0], 1e-13, "touching");
}

fn stop(equation: &str, state: &[f64], times: &[f64]) -> (Cause, Solution) {
    match attempt(equation, &from(state), times, 1e-12) {
        Err(IntegrationError::Stopped { cause, solution }) => (cause, *solution),
        other => panic!("{equation}: {other:?}"),
    }
}

#[test]
fn singularities_stop_with_what_is_known() {
    // x = 1/(1 − t) ends at t = 1, x = √(1 − 2t) … falls into the centre.
    let (cause, solution) = stop("x'' = 2 x^3", &[1.0, 1.0], &[0.5, 2.0]);
    assert_eq!((cause, solution.samples.len()), (Cause::StepUnderflow, 1));
    assert!((solution.end.time - 1.0).abs() < 1e-12, "{}", solution.end.time);
    assert_eq!(stop("x'' = 1/x", &[0.0, 1.0], &[1.0]).0, Cause::Singularity);
    assert_eq!(stop("x'' = -sqrt(x)", &[-1.0, 0.0], &[1.0]).0, Cause::Singularity);
    // x = t²/2 overflows at 1.9e154.
    let (_, solution) = stop("x'' = 1", &[0.0, 0.0], &[1e200]);
    assert!(solution.end.time > 1e154 && solution.end.state[0].is_finite(), "{:?}", solution.end);
}

#[test]
fn a_series_that_seems_to_end_is_not_trusted() {
    // Up to the order of the method all coefficients of t³⁰ at zero vanish.
    let got = state_at("x'' = 930 t^30", &[0.0, 0.0], 1.5, 1e-12);
    assert_close(&got[..1], &[0.9375 * libm::pow(1.5, 32.0)], 1e-6, "t^30");
    let got = state_at("x'' = 6 t", &[1.0, 0.0], 1e6, 1e-12);
    assert_close(&got, &[1e18 + 1.0, 3e12], 1e3, "t^3");
}

#[test]
fn the_number_of_steps_is_limited() {
    let effort = Effort { most_steps: 7, ..Effort::to_tolerance(1e-12) };
    let outcome = integrate(&system(PENDULUM), &from(&[1.0, 0.0]), &[1e9], &effort, &Quiet);
    let Err(IntegrationError::Stopped { cause: Cause::StepLimit, solution }) = outcome else {
        panic!("{outcome:?}")
    };
    assert_eq!(solution.steps, 7);
}

#[test]
fn an_absolute_tolerance_spares_steps() {
    let steps = |absolute| {
        let effort = Effort { absolute, ..Effort::to_tolerance(1e-12) };
        let start = from(&[1e-9, 0.0]);
        integrate(&system(PENDULUM), &start, &[100.0], &effort, &Quiet).unwrap().steps
    };
    assert!(steps(1e-12) < steps(0.0));
}

#[test]
fn what_cannot_be_is_refused() {
    let refused = |state: &[f64], times: &[f64], tolerance| {
        attempt(PENDULUM, &from(state), times, tolerance).unwrap_err()
    };
    assert_eq!(refused(&[1.0], &[1.0], 1e-9), IntegrationError::StateLength { got: 1, wanted: 2 });
    assert!(matches!(refused(&[f64::NAN, 0.0], &[1.0], 1e-9), IntegrationError::StartNotFinite(_)));
    assert!(matches!(refused(&[1.0, 0.0], &[f64::INFINITY], 1e-9), IntegrationError::TimeNotFinite(_)));
    for times in [&[1.0, 0.5][..], &[1.0, -1.0], &[-1.0, 1.0], &[-1.0, -0.5]] {
        assert!(matches!(refused(&[1.0, 0.0], times, 1e-9), IntegrationError::TimesNotInOrder { .. }));
    }
    for tolerance in [0.0, -1e-9, f64::NAN, f64::INFINITY, 1e-40, 1.0] {
        assert!(matches!(refused(&[1.0, 0.0], &[1.0], tolerance), IntegrationError::Tolerance { .. }));
    }
    let none = solve(PENDULUM, &[1.0, 0.0], &[], 1e-9);
    assert_eq!((none.samples.len(), none.steps, none.end), (0, 0, from(&[1.0, 0.0])));
    let here = solve(PENDULUM, &[1.0, 0.5], &[0.0, 0.0], 1e-9);
    assert_eq!(here.samples, [from(&[1.0, 0.5]), from(&[1.0, 0.5])]);
    assert_eq!(System::new(&"x'' = -k x".parse().unwrap()).unwrap_err().0, "k");
}

#[test]
fn no_start_makes_it_panic_or_hang() {
    let mut random = Random::seeded(5);
    let equations =
        ["x'' = -x", "x'' = exp(x) - t", "x'' = -abs(x)^1.5 - x' abs(x')", "x'' = tan(x)/x + ln(t)"];
    for equation in equations {
        let system = system(equation);
        for _ in 0..50 {
            let mut number = || random.log_between(-150.0, 150.0) * random.between(-1.0, 1.0).signum();
            let start = Moment { time: number(), state: vec![number(), number()] };
            let effort = Effort { most_steps: 100, ..Effort::to_tolerance(1e-12) };
            let outcome = integrate(&system, &start, &[number()], &effort, &Quiet);
            let end = match &outcome {
                Ok(solution) => &solution.end,
                Err(IntegrationError::Stopped { solution, .. }) => &solution.end,
                Err(other) => panic!("{other}"),
            };
            assert!(end.state.iter().all(|value| value.is_finite()), "{equation} from {start:?}");
        }
    }
}

/// Powers of such times overflow, which does not end the sticking by friction.
#[test]
fn what_friction_holds_it_holds_for_ever() {
    for goal in [1e12, 1e17, 1e100, 1e200] {
        let solution = solve("x'' + 0.1*sign(x') + sin(x) = 0", &[0.055, 0.0], &[1.0, goal], 1e-12);
        for sample in &solution.samples {
            assert_eq!(sample.state, [0.055, 0.0], "to {goal:e}, at {:e}", sample.time);
        }
    }
}

#[test]
fn whole_powers_of_zero_are_as_smooth_as_low_ones() {
    // From zero to sin(1/2)/2 the power is below 1e-6000, so that the motion is harmonic.
    for (equation, tolerance) in [("x'' = -x - x^10001", 1e-15), ("x'' = -x - x^4097", 1e-15)] {
        let end = state_at(equation, &[0.0, 0.5], 1.0, tolerance);
        assert_close(&end, &[0.5 * libm::sin(1.0), 0.5 * libm::cos(1.0)], 4e-16, equation);
    }
}
