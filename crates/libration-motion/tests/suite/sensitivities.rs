//! Derivatives of motions with respect to parameters and initial values.

use crate::typed::equation;
use libm::{cos, exp, sin, sqrt};
use libration::expression::Expression;
use libration::progress::Quiet;
use libration::taylor::{Effort, Moment, Sensitivities, SensitivityError, System, integrate};
use libration_testing::golden::Table;

fn value(number: f64) -> Expression {
    format!("{number:?}").parse().unwrap()
}

fn end(by: &Sensitivities, start: &[f64], time: f64) -> Moment {
    let system = System::new(by.equation()).unwrap();
    integrate(&system, &by.start(start), &[time], &Effort::to_tolerance(1e-15), &Quiet).unwrap().end
}

/// x″ = −k·x − c·x′: x = e^(−ct/2)·(x0·cos wt + (v0 + c·x0/2)·sin(wt)/w) with w² = k − c²/4.
#[test]
fn a_damped_oscillator_changes_as_its_closed_form_does() {
    let (k, c, x0, v0) = (2.0, 0.375, 0.75, -0.5);
    let values = [("k", value(k)), ("c", value(c))];
    let by = Sensitivities::new(&equation("x'' = -k*x - c*x'"), &values, &["x'", "c", "x"]).unwrap();
    assert_eq!(by.names(), ["dx/dx'(0)", "dx'/dx'(0)", "dx/dc", "dx'/dc", "dx/dx(0)", "dx'/dx(0)"]);
    let w = sqrt(k - c * c / 4.0);
    for t in [0.5, 4.0, 20.0] {
        let state = end(&by, &[x0, v0], t).state;
        let (e, a, s) = (exp(-c * t / 2.0), cos(w * t), sin(w * t) / w);
        let x = e * (x0 * a + (v0 + c * x0 / 2.0) * s);
        let by_c = -t / 2.0 * x
            + e * (x0 * c * t / 4.0 * s + x0 / 2.0 * s
                - (v0 + c * x0 / 2.0) * c * (t * a - s) / (4.0 * w * w));
        let [of_v0, _, of_c, _, of_x0, speed_of_x0] = by.derivatives_in(&state)[..] else { panic!() };
        assert!((by.state_in(&state)[0] - x).abs() < 1e-14, "{t}");
        assert!((of_v0 - e * s).abs() < 1e-14, "{t}: {of_v0}");
        assert!((of_c - by_c).abs() < 1e-13, "{t}: {of_c} {by_c}");
        assert!((of_x0 - e * (a + c / 2.0 * s)).abs() < 1e-14, "{t}: {of_x0}");
        assert!((speed_of_x0 + e * k * s).abs() < 1e-14, "{t}: {speed_of_x0}");
    }
}

#[test]
fn motions_that_are_not_linear_change_as_their_differences_do() {
    let table = Table::read("sensitivities.csv");
    assert!(table.rows().count() > 20);
    for row in table.rows() {
        let numbers = |name: &str| row.text(name).split(' ').map(|word| word.parse::<f64>().unwrap());
        let motion = equation(row.text("equation"));
        let mut names: Vec<&str> = vec![];
        // The parameters in the order in which they occur in the equations.
        for name in ["omega", "c", "sigma", "rho", "beta", "k"] {
            names.extend(motion.parameters().contains(name).then_some(name));
        }
        let values: Vec<_> = names.iter().copied().zip(numbers("values").map(value)).collect();
        let by = Sensitivities::new(&motion, &values, &[row.text("to")]).unwrap();
        let start: Vec<f64> = numbers("start").collect();
        let derivatives = by.derivatives_in(&end(&by, &start, row.input("time")).state);
        let exact: Vec<f64> = numbers("derivatives").collect();
        let size = exact.iter().fold(1.0, |size: f64, derivative| size.max(derivative.abs()));
        for (computed, exact) in derivatives.iter().zip(&exact) {
            // Lorenz's motion loses two digits until t = 5.
            let case = (row.text("equation"), row.text("time"), row.text("to"));
            assert!((computed - exact).abs() < 1e-12 * size, "{case:?}: {computed} {exact}");
        }
    }
}

#[test]
fn forces_with_kinks_are_differentiated_and_those_that_jump_are_not() {
    let new = |text: &str, to: &[&str]| Sensitivities::new(&equation(text), &[], to);
    for text in [
        "x'' = -x*abs(x)",
        "x'' = -x - x'*sqrt(abs(x'))",
        "x'' = -sign(x)*abs(x)^1.5",
        "x'' = -max(x, 0)^1.5",
        "x'' = -x - sign(x')*abs(x')^1",
    ] {
        assert!(new(text, &["x"]).is_ok(), "{text}");
    }
    for (text, argument) in [
        ("x'' = -x - sign(x')/9", "x'"),
        ("x'' = -x - sign(x' - 1)*abs(x')", "x' - 1"),
        ("x' = -sign(x)*abs(x)^0", "x"),
    ] {
        assert_eq!(new(text, &["x"]).unwrap_err(), SensitivityError::Jump(argument.to_owned()), "{text}");
    }
    // For |x|·x from rest the derivative by the amplitude is known from the scaling x(t; A) = A·x(√A·t; 1).
    let by = new("x'' = -x*abs(x)", &["x"]).unwrap();
    let all = end(&by, &[1.0, 0.0], 5.0).state;
    let (state, derivatives) = (by.state_in(&all), by.derivatives_in(&all));
    assert!((derivatives[0] - (state[0] + 2.5 * state[1])).abs() < 1e-13, "{derivatives:?}");
}

#[test]
fn names_that_are_not_there_are_refused() {
    let refused = |to: &[&str]| {
        let values = [("k", value(1.0))];
        Sensitivities::new(&equation("x'' = -k*x"), &values, to).unwrap_err().to_string()
    };
    assert_eq!(refused(&["q"]), "the system has no parameter or state variable `q`: it has k, x, x'");
    assert_eq!(refused(&["x", "k", "x"]), "x is given twice: give it once");
    assert!(Sensitivities::new(&equation("x'' = -x"), &[("k", value(1.0))], &["x"]).is_err());
}
