use libration::algebra::{BigFloat, Floats, Rational, Ring};
use libration::expression::Function;

#[test]
fn functions_and_their_inverses_meet() {
    let floats = Floats { precision: 200 };
    let at = floats.rational(&Rational::new(3, 7).unwrap()).unwrap();
    let value = |function, at: &BigFloat| floats.value(function, at).unwrap();
    let close = |a: &BigFloat, b: &BigFloat| {
        (a.clone() - b.clone()).exponent().is_none_or(|exponent| exponent < -190)
    };
    for (function, inverse) in [
        (Function::Sin, Function::Asin),
        (Function::Cos, Function::Acos),
        (Function::Tan, Function::Atan),
        (Function::Exp, Function::Ln),
    ] {
        assert!(close(&value(inverse, &value(function, &at)), &at), "{function:?}");
    }
    let (s, c) = (value(Function::Sinh, &at), value(Function::Cosh, &at));
    assert!(close(&(c.clone() * c - s.clone() * s), &floats.integer(1)));
    let root = floats.power(&at, &Rational::new(1, 3).unwrap()).unwrap();
    assert!(close(&(root.clone() * root.clone() * root), &at));
}

#[test]
fn powers_of_zero_and_of_negative_numbers_are_those_of_the_real_line() {
    let floats = Floats { precision: 200 };
    let power = |base: i64, n: i64, d: i64| {
        let value = floats.power(&floats.integer(base), &Rational::new(n, d).unwrap());
        value.map(|value| value.to_f64())
    };
    assert_eq!(power(0, 5, 2), Some(0.0));
    assert_eq!(power(0, 10_001, 1), Some(0.0));
    assert_eq!([power(0, -1, 2), power(0, 0, 1), power(-2, 1, 2)], [None; 3]);
    assert_eq!([power(-2, 3, 1), power(-2, 4, 1), power(-2, -1, 1)], [Some(-8.0), Some(16.0), Some(-0.5)]);
}

#[test]
fn what_would_take_too_long_is_refused() {
    let floats = Floats { precision: 200 };
    let at = |exponent| floats.rational(&Rational::from(10).integer_power(exponent).unwrap()).unwrap();
    assert!(floats.value(Function::Exp, &at(5)).is_some() && floats.value(Function::Ln, &at(60)).is_some());
    for function in [Function::Exp, Function::Sinh, Function::Tanh] {
        assert_eq!(floats.value(function, &at(9)), None, "{function:?}");
    }
    assert_eq!(floats.power(&at(1), &Rational::from(1_000_000_000)), None);
}

/// The exponent of the seventieth square exceeds all integers of the machine.
#[test]
fn squares_of_squares_stay_numbers() {
    let floats = Floats { precision: 100 };
    for first in [floats.integer(3), floats.integer(-3), floats.integer(1) / floats.integer(3)] {
        let mut square = first.clone();
        for _ in 0..70 {
            square = square.clone() * square;
        }
        let one = floats.integer(1);
        assert!((square.clone() + one.clone() - square.clone()).to_f64().is_finite());
        let is_large = first > one || first < floats.integer(0);
        assert!(square.to_f64().is_infinite() == is_large && (is_large || square.to_f64() < 1e-300));
    }
}

#[test]
fn logarithms_of_magnitudes_are_those_of_many_bits() {
    let number = |text: &str| BigFloat::from_rational(&text.parse::<Rational>().unwrap(), 200);
    let huge = (0..11).fold(number("3/2"), |square, _| square.clone() * square); // beyond the range of f64
    let tiny = number("1") / (huge.clone() * huge.clone());
    let beside = number("1") - BigFloat::from_f64(f64::EPSILON / 2.0, 200).unwrap();
    for positive in [huge, tiny, beside, number("1"), number("2"), number("1/2"), number("1048577/1048576")] {
        let exact = positive.ln().to_f64();
        for x in [positive.clone(), -positive] {
            assert!((x.ln_magnitude() - exact).abs() <= 2.0 * f64::EPSILON * exact.abs().max(1.0), "{x:?}");
        }
    }
    assert!(number("0").ln_magnitude() < f64::MIN);
}
