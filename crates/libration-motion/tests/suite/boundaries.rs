//! Boundaries of formulas, at which motions end, and removable singularities, which motions pass.

use libration::progress::Quiet;
use libration::taylor::{Cause, Effort, IntegrationError, Moment, Solution, System, integrate};
use std::f64::consts::{FRAC_PI_2, SQRT_2};

fn attempt(equation: &str, state: [f64; 2], time: f64, tolerance: f64) -> Result<Solution, IntegrationError> {
    let system = System::new(&equation.parse().unwrap()).unwrap();
    let start = Moment { time: 0.0, state: state.to_vec() };
    integrate(&system, &start, &[time], &Effort::to_tolerance(tolerance), &Quiet)
}

/// The solution up to the singularity that stops it.
fn end(equation: &str, state: [f64; 2], time: f64, tolerance: f64) -> Solution {
    match attempt(equation, state, time, tolerance) {
        Err(IntegrationError::Stopped { cause: Cause::Singularity | Cause::StepUnderflow, solution }) => {
            *solution
        }
        other => panic!("{equation}: {other:?}"),
    }
}

/// Equations whose right-hand side has a value only on one side of a position, or another formula after it; a start, and the position.
const ENDS: [(&str, [f64; 2], f64); 16] = [
    ("x'' = -exp(-1/x)", [1.0, 0.0], 0.0),
    ("x'' = exp(-1/x) - 1/5", [0.1, 0.0], 0.0),
    ("x'' = -1 - exp(1/x)", [-1.0, 2.0], 0.0),
    ("x'' = -1/2 - exp(-1/x^3)", [1.0, 0.0], 0.0),
    ("x'' = -1 + atan(1/x)/10", [1.0, 0.0], 0.0),
    ("x'' = -1 + tanh(1/x)/10", [1.0, 0.0], 0.0),
    ("x'' = -1 - 1e-9*sqrt(x)", [1.0, 0.0], 0.0),
    ("x'' = -1 - 1e-9*x^2*ln(x)", [1.0, 0.0], 0.0),
    ("x'' = -x^(7/2)", [1.0, 0.0], 0.0),
    ("x'' = -sqrt(x)", [1.0, 0.0], 0.0),
    ("x'' = -x^(1/3)", [1.0, 0.0], 0.0),
    ("x'' = ln(x) - 1", [1.0, 0.0], 0.0),
    ("x'' = -1/x^2", [1.0, 0.0], 0.0),
    ("x'' = tan(x)", [1.0, 1.0], FRAC_PI_2),
    ("x'' = exp(-tan(x))", [0.0, 1.0], FRAC_PI_2),
    ("x'' = asin(x)", [0.5, 1.0], 1.0),
];

#[test]
fn motions_end_where_their_formulas_end() {
    for (equation, start, boundary) in ENDS {
        for tolerance in [1e-6, 1e-9, 1e-12, 1e-15] {
            let end = end(equation, start, 100.0, tolerance).end;
            let short = (end.state[0] - boundary) * (start[0] - boundary).signum();
            assert!((-1e-14..1e-5).contains(&short), "{equation} to {tolerance:e}: {end:?}");
        }
    }
}

#[test]
fn the_end_is_reached_when_the_energy_says() {
    // ∫ dx/√(2∫ₓ¹ e^(−1/u) du) from 0 to 1, by mpmath.
    let end = end("x'' = -exp(-1/x)", [1.0, 0.0], 100.0, 1e-14).end;
    assert!((end.time - 2.66631248972).abs() < 1e-11, "{}", end.time);
}

#[test]
fn ends_in_the_time_are_ends_too() {
    let drive = end("x'' = -x + exp(-1/(1 - t))", [1.0, 0.0], 3.0, 1e-12).end;
    assert!((drive.time - 1.0).abs() < 1e-12, "{}", drive.time);
}

#[test]
fn backward_motions_end_as_well() {
    let there = end("x'' = -exp(-1/x)", [1.0, 0.0], -100.0, 1e-12).end;
    assert!((there.time + 2.66631248972).abs() < 1e-9 && there.state[0].abs() < 1e-9, "{there:?}");
}

#[test]
fn removable_singularities_are_passed() {
    // x″ = −(x + 1) in another form.
    for tolerance in [1e-9, 1e-12, 1e-15] {
        let solution = attempt("x'' = -(x^2 - 1)/(x - 1)", [2.0, 0.0], 2.0, tolerance).unwrap();
        assert!((solution.end.state[0] - (3.0 * libm::cos(2.0) - 1.0)).abs() < 100.0 * tolerance);
    }
    assert!(attempt("x'' = -sin(x)/x", [1.0, 0.0], 3.0, 1e-12).is_ok());
    // The force is flat at zero, with the same formula on both sides.
    assert!(attempt("x'' = -1 - exp(-1/x^2)", [1.0, 0.0], 3.0, 1e-12).is_ok());
}

#[test]
fn a_bend_that_is_sharper_than_the_tolerance_is_not_cut() {
    // The motion is close to that of x″ = −sign(x), which passes x = 0 at √2 and is at −1 at 2√2.
    for bend in ["1e-20", "1e-16", "1e-14", "1e-12"] {
        let equation = format!("x'' = -x/sqrt(x^2 + {bend})");
        let solution = attempt(&equation, [1.0, 0.0], 2.0 * SQRT_2, 1e-12).unwrap();
        assert!((solution.end.state[0] + 1.0).abs() < 1e-8, "{bend}: {:?}", solution.end);
    }
}

#[test]
fn a_kink_is_passed_as_it_is_or_not_at_all() {
    for (equation, with_bars) in [
        ("x'' = -1 + sqrt(x^2)/1000", "x'' = -1 + abs(x)/1000"),
        ("x'' = -1 + 1e-6*sqrt(x^2)", "x'' = -1 + 1e-6*abs(x)"),
    ] {
        for tolerance in [1e-6, 1e-9, 1e-12] {
            let right = attempt(with_bars, [1.0, 0.0], 4.0, 1e-15).unwrap().end;
            match attempt(equation, [1.0, 0.0], 4.0, tolerance) {
                // A hundred tolerances at the kink, and the tolerance for the rest of the motion.
                Ok(solution) => {
                    let error = (solution.end.state[0] - right.state[0]).abs();
                    assert!(error < 1e3 * tolerance, "{equation} to {tolerance:e}: {error:e}");
                }
                Err(IntegrationError::Stopped { solution, .. }) => {
                    assert!(solution.end.state[0].abs() < 1e-5, "{equation} to {tolerance:e}: {solution:?}");
                }
                other => panic!("{other:?}"),
            }
        }
    }
}
