//! Equations of motion: what they are solved to, their parameters, and what is refused.

use libration::expression::{Equation, Expression};

fn equation(text: &str) -> Equation {
    text.parse().unwrap_or_else(|error| panic!("{text}\n{error}"))
}

#[test]
fn equations_are_solved_for_the_acceleration() {
    for (text, acceleration) in [
        ("x'' + sin(x) = 0", "-sin(x)"),
        ("x'' = -x - 0.1*x^3", "-x - 0.1*x^3"),
        ("theta'' + omega0^2 sin(theta) = 0", "-omega0^2*sin(theta)"),
        ("(1+x^2) x'' + x x'^2 + x = 0", "(-x*x'^2 - x)/(1 + x^2)"),
        ("0 = x + x''", "-x"),
        ("2ẍ = -8x", "-8*x/2"),
        ("x''/m = cos(ωt)", "cos(omega*t)/(1/m)"),
        ("θ̈ = -θ", "-theta"),
        ("x'' - mu*(1-x^2)*x' + x = 0", "mu*(1 - x^2)*x' - x"),
    ] {
        let expected: Expression = acceleration.parse().unwrap();
        assert_eq!(equation(text).accelerations(), [expected], "{text}");
    }
}

#[test]
fn several_equations_have_one_variable_each() {
    let pair = equation("x'' = -x + a*y; y'' + y = a*x'");
    assert_eq!(pair.variables(), ["x", "y"]);
    assert_eq!(pair.accelerations()[1].to_string(), "-y + a*x'");
    assert_eq!(pair.to_string(), "x'' = -x + a*y; y'' + y = a*x'");
    assert_eq!(pair.to_latex()[0], r"\ddot{x} = -x + a y");
    assert_eq!(equation("x'' = -x;").variables(), ["x"]);
}

#[test]
fn parameters_are_all_that_is_neither_variable_nor_time() {
    let driven = equation("θ'' + γ θ' + ω0² sin(θ) = F cos(ωt)");
    let names: Vec<String> = driven.parameters().into_iter().collect();
    assert_eq!(names, ["F", "gamma", "omega", "omega0"]);
    let number = |text: &str| text.parse::<Expression>().unwrap();
    let set = driven.with(&[("ω0", number("2/3")), ("F", number("0")), ("gamma", number("-1"))]).unwrap();
    assert_eq!(set.to_string(), "theta'' - theta' + 4/9*sin(theta) = 0");
    assert_eq!(set.accelerations()[0].to_string(), "theta' - 4/9*sin(theta)");
}

const REFUSED: &[(&str, &str)] = &[
    ("-sin(x)", "write x'' = -sin(x)"),
    ("x'' + x", "write x'' + x = 0"),
    ("x'' = -x = 0", "one = sign"),
    ("x = 1", "`x = 1` has no derivative: mark the acceleration with two primes"),
    ("x'' = -x; x' = y; y' = x", "`x' = y` is an equation for x', but x has one for x'' already"),
    ("x' = y' - x; y' = x", "solve for each of them, as in x' = …; y' = …"),
    ("x' = 1; x' = 2", "two equations for x'"),
    ("x'^2 = x", "not linear in x'"),
    ("x' - x' = x", "drops out"),
    ("t' = 1", "t is the time"),
    ("x''' = -x", "above the second"),
    ("x'' + y'' = 0; y'' = 1", "appear in one equation"),
    ("x'' = 1; x'' = 2", "two equations for x''"),
    ("x'' = y'", "no equation has y''"),
    ("x''^2 = x", "not linear in x''"),
    ("sin(x'') = x", "not linear in x''"),
    ("x'' - x'' = x", "drops out"),
    ("((1+x)^2 - 1 - 2x - x²) x'' = x", "drops out"),
    ("t'' = 1", "t is the time"),
    ("x'' = ", "expected a number, a name or (, found the end"),
    ("", "the formula is empty"),
    ("x'' = sin x^2", "may be sin(x^2) or sin(x)^2"),
];

#[test]
fn what_is_no_equation_of_motion_is_refused_with_a_hint() {
    for (text, part) in REFUSED {
        let error = text.parse::<Equation>().unwrap_err().to_string();
        assert!(error.contains(part), "{text}\n{error}");
    }
}

#[test]
fn what_is_written_freely_is_told_how_it_was_read() {
    for (text, reading) in [
        (r"\ddot{\theta} + \frac{g}{l}\sin\theta = 0", Some("theta'' + g/l*sin(theta) = 0")),
        ("d²x/dt² + x(1 + x²) = 0", Some("x'' + x*(1 + x^2) = 0")),
        ("x''(t) = -x(t)", Some("x'' = -x")),
        ("x'' = -sin 2x", Some("x'' = -sin(2*x)")),
        ("x'' + 2 x = 0", None),
        ("x'' + sin(2 x) = 0", None),
        ("x'' + sin x^2 = 0", None),
        ("", None),
    ] {
        assert_eq!(Equation::read_as(text).as_deref(), reading, "{text}");
        if let Some(reading) = reading {
            assert_eq!(equation(text), equation(reading));
            assert_eq!(Equation::read_as(reading), None, "what is written back is plain");
        }
    }
}

#[test]
fn values_that_do_not_fit_are_refused() {
    let equation = equation("m x'' = -k x");
    let refusal =
        |name: &str, value: &str| equation.with(&[(name, value.parse().unwrap())]).unwrap_err().to_string();
    assert!(refusal("q", "1").contains("its parameters are k, m"));
    assert!(refusal("x", "1").contains("no parameter `x`"));
    assert!(refusal("k", "m").contains("contains m:"));
    assert!(refusal("m", "0").contains("has no second derivative"));
    let one: Expression = "1".parse().unwrap();
    let twice = equation.with(&[("k", one.clone()), ("k", one)]).unwrap_err();
    assert!(twice.to_string().contains("given twice"));
}
