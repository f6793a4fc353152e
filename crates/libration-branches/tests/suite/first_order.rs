//! Equations of first order, alone and together with second-order ones,
//! compared with the thirty digits of `first_order.csv` and with closed forms.

use crate::typed::{equation, system};
use libration::chaos::{
    Continuation, Family, LyapunovVerdict, Points, Schedule, Section, compute_bifurcation_diagram,
    compute_section, lyapunov_exponent,
};
use libration::normal_modes::NormalModes;
use libration::orbit::{Orbit, OrbitGuess, Stability};
use libration::oscillator::Oscillator;
use libration::progress::Quiet;
use libration::systems::Model;
use libration::taylor::{
    Cause, Direction, Effort, Event, IntegrationError, Moment, System, integrate, integrate_dense,
    with_sensitivities,
};
use libration_testing::condition::{Growth, error};
use libration_testing::golden::{Row, Table};
use std::f64::consts::TAU;

const LORENZ: &str = "x' = 10*(y - x); y' = x*(28 - z) - y; z' = x*y - 8/3*z";

fn from(state: &[f64]) -> Moment {
    Moment { time: 0.0, state: state.to_vec() }
}

fn effort() -> Effort {
    Effort::to_tolerance(1e-15)
}

fn numbers(text: &str) -> Vec<f64> {
    text.split(' ').map(|word| word.parse().unwrap()).collect()
}

/// Rounding errors are relative to the size of the components, and grow with the sensitivity of the motion.
#[test]
fn every_motion_is_met_as_well_as_its_condition_allows() {
    let table = Table::read("first_order.csv");
    assert!(table.rows().count() > 15);
    let mut growth = Growth::default();
    for row in table.rows() {
        let case = row.text("equation");
        let allowed = growth.until(case, row);
        let end = integrate(&system(case), &start(row), &[row.input("time")], &effort(), &Quiet);
        let error = error(&end.unwrap().end.state, row);
        assert!(error <= allowed, "{case} at {}: {error:e}", row.text("time"));
    }
}

fn start(row: Row) -> Moment {
    from(&numbers(row.text("start")))
}

/// x″ = −x and its first-order form, in which the velocity is a variable, give the same numbers up to a few rounding errors.
#[test]
fn both_forms_of_one_equation_have_one_motion() {
    let as_it_is = system("x'' = -sin(x) - x'/10");
    let as_two = system("x' = v; v' = -sin(x) - v/10");
    for time in [0.3, -2.0, 40.0] {
        let [one, two] = [&as_it_is, &as_two].map(|system| {
            integrate(system, &from(&[1.0, 0.5]), &[time], &effort(), &Quiet).unwrap().end.state
        });
        for (a, b) in one.iter().zip(&two) {
            assert!((a - b).abs() < 2e-15 * (1.0 + a.abs()), "{one:?} {two:?}");
        }
    }
}

/// The accuracy of a motion does not depend on the origin: x' = v together with x of a million.
#[test]
fn the_error_of_a_variable_is_a_part_of_how_far_it_moves() {
    let far = system("x' = v; v' = -(x - 1000000)");
    let effort = Effort::to_tolerance(1e-9);
    let end = integrate(&far, &from(&[1e6 + 1.0, 0.0]), &[10.0], &effort, &Quiet).unwrap().end.state;
    let exact = 1e6 + libm::cos(10.0);
    assert!((end[0] - exact).abs() < 2e-9, "{end:?}");
}

#[test]
fn a_variable_may_rest_while_others_move() {
    let mixed = system("q' = -q; x'' = -x; z' = 0; p' = p^2");
    let end =
        integrate(&mixed, &from(&[0.0, 1.0, 3.0, 0.0, 0.0]), &[TAU], &effort(), &Quiet).unwrap().end.state;
    assert_eq!([end[0], end[2], end[3]], [0.0, 3.0, 0.0]);
    assert!((end[1] - 1.0).abs() < 1e-14 && end[4].abs() < 1e-14);
}

#[test]
fn motions_in_closed_form_are_met_from_a_power_to_a_pole() {
    // x = (1 + t/2)⁻², x = 1/(1 − t), x = e^(t²).
    for (text, from_here, time, exact) in [
        ("x' = -x^(3/2)", 1.0, 8.0, 1.0 / 25.0),
        ("x' = x^2", 1.0, 0.9375, 16.0),
        ("x' = 2*t*x", 1.0, 3.0, libm::exp(9.0)),
        ("x' = abs(t - 1)", 0.0, 3.0, 2.5),
    ] {
        let end =
            integrate(&system(text), &from(&[from_here]), &[time], &effort(), &Quiet).unwrap().end.state[0];
        assert!((end / exact - 1.0).abs() < 2e-14, "{text}: {end}");
    }
    let error = integrate(&system("x' = x^2"), &from(&[1.0]), &[2.0], &effort(), &Quiet).unwrap_err();
    let IntegrationError::Stopped { cause: Cause::StepUnderflow, solution } = error else {
        panic!("{error}")
    };
    assert!((solution.end.time - 1.0).abs() < 1e-10);
}

/// x′ = −sign(x) reaches zero at t = 1 and stays there, as a velocity stops under dry friction; a stronger drive moves it on.
#[test]
fn a_variable_that_no_way_leads_from_zero_stays_there() {
    let falls = system("x' = -sign(x)");
    assert_eq!(integrate(&falls, &from(&[1.0]), &[3.0], &effort(), &Quiet).unwrap().end.state, [0.0]);
    let released = system("x' = -sign(x) + t/2");
    // At rest until t = 2, then x = (t − 2)²/4.
    let solution = integrate(&released, &from(&[0.25]), &[1.5, 4.0], &effort(), &Quiet).unwrap();
    assert_eq!(solution.samples[0].state, [0.0]);
    assert!((solution.samples[1].state[0] - 1.0).abs() < 1e-14);
}

#[test]
fn rates_of_change_are_known_to_events_and_to_other_equations() {
    let maxima = Event { formula: "x'".parse().unwrap(), direction: Direction::Falling, ends_at: None };
    let circle = system("x' = -y; y' = x").with_events(&[maxima]).unwrap();
    let maxima = integrate(&circle, &from(&[0.0, 1.0]), &[10.0], &effort(), &Quiet).unwrap().events;
    let times: Vec<f64> = maxima.iter().map(|event| event.time).collect();
    assert_eq!(times.len(), 1, "{times:?}");
    assert!((times[0] - 0.75 * TAU).abs() < 1e-14);
    // x'' = q' + 1 with q = −t²/2: x = t²/2 − t³/6.
    let coupled = system("x'' = q' + 1; q' = -t");
    let end = integrate(&coupled, &from(&[0.0, 0.0, 0.0]), &[3.0], &effort(), &Quiet).unwrap().end.state;
    assert!(end[0].abs() < 1e-14, "{end:?}");
}

#[test]
fn sensitivities_are_those_of_the_closed_form() {
    // x = x0·e^(−kt): ∂x/∂k = −t·x, ∂x/∂x0 = x/x0.
    let decay = with_sensitivities(&equation("x' = -k*x"), &["k"], 1);
    let system = System::new(&decay.with(&[("k", "1/2".parse().unwrap())]).unwrap()).unwrap();
    assert_eq!(system.state_names(), ["x", "delta1 x", "delta2 x"]);
    let end = integrate(&system, &from(&[3.0, 0.0, 1.0]), &[4.0], &effort(), &Quiet).unwrap().end.state;
    let exact = libm::exp(-2.0);
    for (got, truth) in end.iter().zip([3.0 * exact, -12.0 * exact, exact]) {
        assert!((got / truth - 1.0).abs() < 1e-14);
    }
}

#[test]
fn a_section_of_the_lorenz_system_is_where_the_motion_crosses() {
    let surface = Section::Crossing { formula: "z - 27".parse().unwrap(), direction: Direction::Rising };
    let points = Points { skipped: 0, recorded: 5 };
    let section =
        compute_section(&equation(LORENZ), &from(&[1.0, 1.0, 1.0]), &surface, points, &effort(), &Quiet)
            .unwrap();
    let motion = integrate_dense(&system(LORENZ), &from(&[1.0, 1.0, 1.0]), 10.0, &effort()).unwrap();
    assert_eq!(section.points.len(), 5);
    for point in &section.points {
        assert!((point.state[2] - 27.0).abs() < 1e-12);
        let [x, y, z] = point.state[..] else { panic!("three numbers") };
        assert!(x * y - 8.0 / 3.0 * z > 0.0);
        let same = motion.state_at(point.time).unwrap();
        assert!(same.iter().zip(&point.state).all(|(a, b)| (a - b).abs() < 1e-9), "{point:?} {same:?}");
    }
}

#[test]
fn a_bifurcation_diagram_follows_the_fixed_points() {
    // From a positive start to √r.
    let family_equation = equation("x' = r*x - x^3");
    let section = Section::Stroboscope { period: Some(1.0), phase: 0.0 };
    let family = Family {
        equation: &family_equation,
        parameter: "r",
        section: &section,
        points: Points { skipped: 100, recorded: 2 },
        with_errors: false,
    };
    let columns = compute_bifurcation_diagram(
        &family,
        &[0.25, 1.0],
        &from(&[0.1]),
        Continuation::SameStart,
        &effort(),
        &Quiet,
    )
    .unwrap();
    for (column, exact) in columns.iter().zip([0.5, 1.0]) {
        assert!(column.section.points.iter().all(|point| (point.state[0] - exact).abs() < 1e-13));
    }
}

/// The exponents 0.9056 of the Lorenz system and 0.0714 of Rössler's: J. C. Sprott, *Chaos and Time-Series Analysis*, Oxford 2003, appendix A.
/// The stated uncertainty is a standard error; four of these plus the last digit of the published number are allowed.
#[test]
fn lyapunov_exponents_of_lorenz_and_roessler_are_the_published_ones() {
    let roessler = "x' = -y - z; y' = x + 0.2*y; z' = 0.2 + z*(x - 5.7)";
    for (text, published, interval, intervals) in [(LORENZ, 0.9056, 1.0, 3000), (roessler, 0.0714, 6.0, 3000)]
    {
        let effort = Effort::to_tolerance(1e-10);
        let schedule = Schedule { transient: 100.0, interval, intervals };
        let exponent =
            lyapunov_exponent(&equation(text), &from(&[1.0, 1.0, 1.0]), &schedule, &effort, &Quiet).unwrap();
        assert_eq!(exponent.verdict, LyapunovVerdict::Chaotic, "{text}");
        assert!((exponent.exponent - published).abs() < 4.0 * exponent.uncertainty + 5e-5, "{exponent:?}");
        assert!(exponent.uncertainty < 0.05 * published);
    }
}

#[test]
fn a_natural_schedule_has_intervals_of_about_a_period() {
    // Along the circle, with the period 2π.
    let circle = equation("x' = -y*(x^2 + y^2); y' = x*(x^2 + y^2)");
    let schedule = Schedule::natural(&circle, &from(&[1.0, 0.0]), 10, &effort()).unwrap();
    assert!((schedule.interval / TAU - 1.0).abs() < 0.05, "{schedule:?}");
}

/// Small oscillations of predators and prey about x = y = 1 have the period 2π, large ones are slower; x − ln x + y − ln y is conserved.
#[test]
fn cycles_of_predator_and_prey_close_and_keep_their_integral() {
    let predators = equation("x' = x - x*y; y' = x*y - y");
    let small = OrbitGuess { state: vec![1.001, 1.0], period: 6.3 };
    let small = Orbit::near(&predators, &small, &[0, 1], &Quiet).unwrap();
    // The change of the period with the amplitude is of second order.
    assert!((small.period() / TAU - 1.0).abs() < 1e-6, "{}", small.period());
    let large =
        Orbit::near(&predators, &OrbitGuess { state: vec![2.0, 1.0], period: 7.0 }, &[0, 1], &Quiet).unwrap();
    let integral = |state: &[f64]| state.iter().map(|x| x - libm::log(*x)).sum::<f64>();
    for part in 0..50 {
        let state = large.state_at(large.period() * f64::from(part) / 50.0);
        assert!((integral(&state) - integral(&[2.0, 1.0])).abs() < 1e-14);
    }
    assert_eq!(large.floquet().unwrap().multipliers.len(), 2);
}

/// In polar coordinates r' = r(1 − r²), θ' = 1: the unit circle is a limit cycle with the multiplier e^(−4π).
#[test]
fn a_limit_cycle_of_the_first_order_is_found_with_its_multipliers() {
    let hopf = equation("x' = x - y - x*(x^2 + y^2); y' = x + y - y*(x^2 + y^2)");
    let orbit = Orbit::limit_cycle(&hopf, &[0.1, 0.0], &Quiet).unwrap();
    assert!((orbit.period() - TAU).abs() <= orbit.period_uncertainty().max(1e-14), "{}", orbit.period());
    let floquet = orbit.floquet().unwrap();
    assert_eq!(floquet.stability, Stability::Attracting);
    assert!((floquet.multipliers[1].abs() / libm::exp(-2.0 * TAU) - 1.0).abs() < 1e-6, "{floquet:?}");
    let driven = Orbit::driven(&equation("q' = -q + cos(t)"), &[3.0], TAU, &Quiet).unwrap();
    // q = (cos t + sin t)/2.
    assert!((driven.start()[0] - 0.5).abs() < 1e-14);
}

#[test]
fn what_needs_an_acceleration_says_so() {
    let (decay, mixed) = (equation("x' = -x"), equation("x'' = -x; q' = x"));
    let refusals = [
        Oscillator::new(&decay).unwrap_err().to_string(),
        NormalModes::new(&decay).unwrap_err().to_string(),
        NormalModes::new(&mixed).unwrap_err().to_string(),
        Orbit::released(&decay, 1.0, &Quiet).unwrap_err().to_string(),
        Model::typed("x' = -x", &[], &[]).unwrap().energy().unwrap_err().to_string(),
        Model::typed("x'' = -x; q' = x", &[], &[]).unwrap().energy().unwrap_err().to_string(),
    ];
    for refusal in refusals {
        assert!(refusal.contains("' is of the first order"), "{refusal}");
    }
    assert!(Model::typed("theta' = 1", &[], &[]).unwrap().bodies().is_none());
}

#[test]
fn an_equation_keeps_its_order_when_values_are_put_in() {
    let zero = || "0".parse().unwrap();
    let refusal = |text: &str, name: &str| equation(text).with(&[(name, zero())]).unwrap_err().to_string();
    assert!(refusal("m x'' + c x' + x = 0", "m").contains("has no second derivative"));
    assert!(refusal("L q' + q = x'; x'' = q", "L").contains("q' drops out"));
}
