use libration::algebra::{Rational, Rationals};
use libration::expression::{Expression, Function, Symbol};
use libration::internals::expression::{Jet, Tape};

fn x() -> Expression {
    Expression::Symbol(Symbol { name: "x".to_owned(), primes: 0 })
}

fn call(function: Function, of: Expression) -> Expression {
    Expression::Call(function, Box::new(of))
}

fn number(value: &str) -> Box<Expression> {
    Box::new(Expression::Number(value.parse().unwrap()))
}

/// The Taylor coefficients of a formula in x about a point.
fn taylor(formula: &Expression, at: i64, length: usize) -> Vec<String> {
    let tape = Tape::new(&[formula], &[Symbol { name: "x".to_owned(), primes: 0 }]).unwrap();
    let mut jet = Jet::new(&Rationals, &tape, &[Rational::from(at)]).unwrap();
    for n in 1..length {
        jet.extend(&[Rational::from(i64::from(n == 1))]).unwrap();
    }
    jet.result(0).iter().map(ToString::to_string).collect()
}

#[test]
fn elementary_functions_have_their_taylor_series() {
    let series: [(Function, i64, [&str; 6]); 13] = [
        (Function::Sin, 0, ["0", "1", "0", "-1/6", "0", "1/120"]),
        (Function::Cos, 0, ["1", "0", "-1/2", "0", "1/24", "0"]),
        (Function::Tan, 0, ["0", "1", "0", "1/3", "0", "2/15"]),
        (Function::Asin, 0, ["0", "1", "0", "1/6", "0", "3/40"]),
        (Function::Atan, 0, ["0", "1", "0", "-1/3", "0", "1/5"]),
        (Function::Sinh, 0, ["0", "1", "0", "1/6", "0", "1/120"]),
        (Function::Cosh, 0, ["1", "0", "1/2", "0", "1/24", "0"]),
        (Function::Tanh, 0, ["0", "1", "0", "-1/3", "0", "2/15"]),
        (Function::Exp, 0, ["1", "1", "1/2", "1/6", "1/24", "1/120"]),
        (Function::Ln, 1, ["0", "1", "-1/2", "1/3", "-1/4", "1/5"]),
        (Function::Sqrt, 4, ["2", "1/4", "-1/64", "1/512", "-5/16384", "7/131072"]),
        (Function::Abs, -3, ["3", "-1", "0", "0", "0", "0"]),
        (Function::Sign, -3, ["-1", "0", "0", "0", "0", "0"]),
    ];
    for (function, at, coefficients) in series {
        assert_eq!(taylor(&call(function, x()), at, 6), coefficients, "{function:?}");
    }
}

#[test]
fn powers_and_quotients_agree_with_the_binomial_series() {
    let one_plus = || Box::new(Expression::Add(number("1"), Box::new(x())));
    let power = |exponent: &str| Expression::Power(one_plus(), number(exponent));
    assert_eq!(taylor(&power("-1"), 0, 5), ["1", "-1", "1", "-1", "1"]);
    assert_eq!(taylor(&power("5"), 0, 7), ["1", "5", "10", "10", "5", "1", "0"]);
    assert_eq!(taylor(&power("-3/2"), 0, 4), ["1", "-3/2", "15/8", "-35/16"]);
    let quotient = Expression::Divide(Box::new(x()), one_plus());
    assert_eq!(taylor(&quotient, 1, 4), ["1/2", "1/4", "-1/8", "1/16"]);
    // (1 + x)ˣ at zero, by exponential and logarithm.
    let tower = Expression::Power(one_plus(), Box::new(x()));
    assert_eq!(taylor(&tower, 0, 5), ["1", "0", "1", "-1/2", "5/6"]);
}

#[test]
fn amending_a_coefficient_is_the_same_as_knowing_it_before() {
    let formula = Expression::Multiply(
        Box::new(call(Function::Sin, x())),
        Box::new(Expression::Divide(
            Box::new(call(Function::Exp, x())),
            Box::new(Expression::Power(Box::new(Expression::Add(number("3"), Box::new(x()))), number("2"))),
        )),
    );
    let tape = Tape::new(&[&formula], &[Symbol { name: "x".to_owned(), primes: 0 }]).unwrap();
    let zero = [Rational::from(0)];
    let mut extended = Jet::new(&Rationals, &tape, &zero).unwrap();
    let mut amended = Jet::new(&Rationals, &tape, &zero).unwrap();
    let gains = amended.gains(0).unwrap();
    for n in 1..8 {
        let value = Rational::new(n * n - 5, n).unwrap();
        extended.extend(std::slice::from_ref(&value)).unwrap();
        amended.extend(&zero).unwrap();
        amended.amend(&gains, &value);
    }
    assert_eq!(extended.result(0), amended.result(0));
}
