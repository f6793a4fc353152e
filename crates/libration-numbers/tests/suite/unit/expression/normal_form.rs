use libration::algebra::Rational;
use libration::expression::{Expression, Symbol};

fn formula(text: &str) -> Expression {
    text.parse().unwrap()
}

#[test]
fn what_vanishes_is_proved_to() {
    for text in [
        "0",
        "(x+1)^2 - x^2 - 2*x - 1",
        "sin(-x) + sin(x)",
        "cos(a - b) - cos(b - a)",
        "exp(-x) - exp(x) + exp(-(-x)) - exp(-x)",
        "1/(1+x) + 1/(1-x) - 2/(1-x^2)",
        "(1 - (-v)^2)^(3/2) - (1 - v^2)^(3/2)",
        "x^2000000 * x^-2000000 - 1",
        "abs(-x*y) - abs(x*y)",
        "sign(-x*y) + sgn(x*y)",
    ] {
        assert!(formula(text).vanishes(), "{text}");
    }
}

#[test]
fn what_does_not_vanish_or_is_too_much_work_is_not_said_to() {
    for text in ["1", "x", "sin(x) - x", "1/0", "exp(x) - exp(-x)", "(1+x)^4000000000 - (1+x)^4000000000"] {
        assert!(!formula(text).vanishes(), "{text}");
    }
}

#[test]
fn degree_is_that_of_the_expanded_polynomial() {
    let (x, v) = (Symbol::plain("x"), Symbol::plain("x").with_primes(1));
    let degree = |text: &str| formula(text).polynomial_degree(&[x.clone(), v.clone()]);
    assert_eq!(degree("-x - a*x^3"), Some(3));
    assert_eq!(degree("(x+1)^2 - x^2"), Some(1));
    assert_eq!(degree("x^2*x'^3/(1+a^2)"), Some(5));
    assert_eq!(degree("sin(a)*x"), Some(1));
    assert_eq!(degree("7"), Some(0));
    for text in ["1/x", "sin(x)", "x^(1/2)", "a^x", "x^a", "(1+x)^1e9"] {
        assert_eq!(degree(text), None, "{text}");
    }
}

#[test]
fn coefficients_are_exact() {
    let x = Symbol::plain("x");
    let fractions = |text: &str| {
        let coefficients = formula(text).polynomial_coefficients(&x)?;
        Some(coefficients.iter().map(Rational::to_string).collect::<Vec<_>>())
    };
    assert_eq!(fractions("(x-1/3)*(x+0.5)").unwrap(), ["-1/6", "1/6", "1"]);
    assert_eq!(fractions("(x^2-1)/2").unwrap(), ["-1/2", "0", "1/2"]);
    assert_eq!(fractions("a*x"), None);
    assert_eq!(fractions("pi*x"), None);
    assert_eq!(fractions("1/x"), None);
}
