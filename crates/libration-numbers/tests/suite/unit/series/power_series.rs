use libration::algebra::{Doubles, Rational, Ring};
use libration::expression::Function;
use libration::series::PowerSeries;

fn texts(series: &[Rational]) -> Vec<String> {
    series.iter().map(ToString::to_string).collect()
}

/// Abramowitz and Stegun, 4.3.67, 4.3.68, 4.4.40, 4.4.42, 4.5.64, 4.1.24 and 3.6.9.
#[test]
fn functions_have_their_series() {
    let series = PowerSeries::rational(6);
    let x = series.variable().unwrap();
    let one_and_x = series.add(&series.rational(&1.into()).unwrap(), &x);
    for (function, at, expected) in [
        (Function::Sin, &x, ["0", "1", "0", "-1/6", "0", "1/120"]),
        (Function::Cos, &x, ["1", "0", "-1/2", "0", "1/24", "0"]),
        (Function::Tan, &x, ["0", "1", "0", "1/3", "0", "2/15"]),
        (Function::Asin, &x, ["0", "1", "0", "1/6", "0", "3/40"]),
        (Function::Atan, &x, ["0", "1", "0", "-1/3", "0", "1/5"]),
        (Function::Tanh, &x, ["0", "1", "0", "-1/3", "0", "2/15"]),
        (Function::Exp, &x, ["1", "1", "1/2", "1/6", "1/24", "1/120"]),
        (Function::Ln, &one_and_x, ["0", "1", "-1/2", "1/3", "-1/4", "1/5"]),
        (Function::Sqrt, &one_and_x, ["1", "1/2", "-1/8", "1/16", "-5/128", "7/256"]),
        (Function::Abs, &series.negate(&one_and_x), ["1", "1", "0", "0", "0", "0"]),
    ] {
        assert_eq!(texts(&series.value(function, at).unwrap()), expected, "{function:?}");
    }
    for function in [Function::Sqrt, Function::Ln, Function::Abs, Function::Sign, Function::Acos] {
        assert_eq!(series.value(function, &x), None, "{function:?}");
    }
}

#[test]
fn a_function_and_its_inverse_meet_elsewhere_too() {
    let series = PowerSeries { coefficients: Doubles, terms: 8 };
    let at = vec![0.3, 1.0, -0.5, 0.25, 0.0, 2.0, 1.0, -1.0];
    for (function, inverse) in [
        (Function::Sin, Function::Asin),
        (Function::Cos, Function::Acos),
        (Function::Tan, Function::Atan),
        (Function::Exp, Function::Ln),
    ] {
        let back = series.value(inverse, &series.value(function, &at).unwrap()).unwrap();
        for (a, b) in back.iter().zip(&at) {
            assert!((a - b).abs() < 1e-11, "{function:?}: {back:?}");
        }
    }
}

#[test]
fn powers_that_cancel_cost_coefficients() {
    let series = PowerSeries::rational(6);
    let x = series.variable().unwrap();
    let sine = series.value(Function::Sin, &x).unwrap();
    assert_eq!(texts(&series.divide(&sine, &x).unwrap()), ["1", "0", "-1/6", "0", "1/120"]);
    assert_eq!(series.divide(&series.rational(&1.into()).unwrap(), &x), None);
}
