//! Equations of motion: the form in which they are solved, their parameters, and the text that is rejected.

use libration::expression::{Equation, Expression, Symbol};

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
    ("x[i]'' = -x[i]", "the index i of x[i] has no range"),
    ("x[i/2]'' = -x[i], i = 1..3", "the index of x[i/2] is 0.5 at i = 1"),
    ("x[i-2]'' = -x[i], i = 1..3", "x[-1] has an index below zero"),
    ("x[i]'' = -w[i-2]*x[i], i = 1..3", "w[-1] has an index below zero"),
    ("x[i]'' = -x[i], i = 3..1", "i = 3..1 has no number in it"),
    ("x[i]'' = -x[i], i = 1..2000", "more than 1000 equations"),
    ("x[i]'' = -x[i], i = 1..3; x[2] = 0", "gives a value to x[2], which has an equation of motion"),
    ("x[i]'' = x[i-1], i = 1..3; x[0] = 0; x[0] = 1", "x[0] is given twice"),
    ("x[i]'' = x[i-1], i = 1..3; x[0] = x[-1]", "x[0] is defined by x[-1], which is outside"),
    ("x[i]'' = x[i-1]', i = 1..3; x[0] = 2*x[1]", "an equation contains x[0]'"),
    ("x[i]'' = -x[i] + x0, i = 1..3", "`x0` may be a parameter or x[0]"),
    ("x[i]'' = -x[i], i = 1..3; x[2]'' = 0", "two equations for x2''"),
    ("x'' = -x, y", "one equation after another with ;"),
    ("x'' = sin[x]", "write brackets as ( and )"),
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

#[test]
fn an_index_with_a_range_stands_for_many_equations() {
    for (indexed, plain) in [
        ("x[i]'' = k*(x[i+1] - 2*x[i] + x[i-1]), i = 1..2", "x1'' = k*(x2 - 2*x1); x2'' = k*(-2*x2 + x1)"),
        ("x[i]''=x[i + 1]-x[i],i=1…2; x[3] = A*cos(t)", "x1'' = x2 - x1; x2'' = A*cos(t) - x2"),
        // A closed chain, and an end with a given motion and velocity.
        (
            "x[i]'' = x[i-1] + x[i+1], i = 1..3; x[0] = x[3]; x[4] = x[1]",
            "x1'' = x3 + x2; x2'' = x1 + x3; x3'' = x2 + x1",
        ),
        ("x[i]'' = x[i-1]', i = 1..2; x[0] = sin(2t)", "x1'' = 2*cos(2*t); x2'' = x1'"),
        ("x[i]'' = x[i-1]', i = 1..2; x[0] = x[2]", "x1'' = x2'; x2'' = x1'"),
        // The letter of the index is a number in its equations, even if it is a parameter elsewhere; a family of parameters.
        ("x[j]'' = -j*w[j]^2*x[j], j = 1..2; y' = -j*y", "x1'' = -w1^2*x1; x2'' = -2*w2^2*x2; y' = -j*y"),
        // A family of first order, together with a second-order variable whose equation contains a member.
        ("q[n]' = q[n-1] - q[n] + x', n = 0..1; x'' = q[1]", "q0' = -q0 + x'; q1' = q0 - q1 + x'; x'' = q1"),
        ("x[i]'' = 0, i = 1..1; x[i]'' = x[1], i = 2..2", "x1'' = 0; x2'' = x1"),
    ] {
        let (computed, expected) = (equation(indexed), equation(plain));
        assert_eq!(computed.variables(), expected.variables(), "{indexed}");
        for (computed, expected) in computed.derivatives().iter().zip(expected.derivatives()) {
            let symbols = computed.symbols().into_iter().chain(expected.symbols());
            let symbols: std::collections::BTreeSet<_> = symbols.collect();
            let [a, b] = [computed, expected].map(|formula| {
                // Square roots of different numbers satisfy no relation by chance.
                let put_in = |formula: Expression, (symbol, n): (&Symbol, i64)| {
                    formula.substitute(symbol, &format!("sqrt({})", n * n + 1).parse().unwrap())
                };
                symbols.iter().zip(1..).fold(formula.clone(), put_in).to_f64().unwrap()
            });
            assert!((a - b).abs() < 1e-12, "{indexed}: {computed} is not {expected}");
        }
    }
    assert_eq!("2*x[3] + v1[2]".parse::<Expression>().unwrap().to_string(), "2*x3 + v1_2");
}

#[test]
fn degrees_right_behind_a_number_are_an_angle() {
    for (text, plain) in [
        ("60deg", "pi/3"),
        ("2*90deg^2", "2*(pi/2)^2"),
        ("x/60deg", "x/(pi/3)"),
        ("sin 30deg", "sin(pi/6)"),
        ("2^180deg", "2^pi"),
        ("-1.5deg*deg", "-pi/120*deg"),
    ] {
        let [computed, expected] = [text, plain].map(|source| source.parse::<Expression>().unwrap());
        let put_in = |formula: &Expression, name: &str| {
            formula.substitute(&Symbol::plain(name), &"sqrt(2)".parse().unwrap())
        };
        let [a, b] =
            [computed, expected].map(|formula| put_in(&put_in(&formula, "x"), "deg").to_f64().unwrap());
        assert!((a / b - 1.0).abs() < 1e-15, "{text}: {a} {b}");
    }
    // As a separate name, or after a space, deg is a parameter like others.
    assert_eq!(equation("x'' = -2 deg x").parameters().into_iter().collect::<Vec<_>>(), ["deg"]);
    assert_eq!(Equation::read_as("x'' = -sin(x - 60deg)").as_deref(), Some("x'' = -sin(x - 1/3*pi)"));
}
