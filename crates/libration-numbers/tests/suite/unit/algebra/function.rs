use libration::algebra::{BigFloat, Rational};
use libration::expression::Function;
use libration::internals::algebra::{Domain, Parity};

#[test]
fn a_function_is_found_by_its_name_and_by_no_other() {
    for function in Function::ALL {
        assert_eq!(Function::by_name(function.name()), Some(function));
    }
    assert_eq!(
        (Function::by_name("Sin"), Function::by_name("log"), Function::by_name("")),
        (None, None, None)
    );
}

/// Values in all three kinds of numbers, parity, zeros and domain, at rational arguments on both sides of zero.
#[test]
fn what_an_entry_says_belongs_together() {
    const PRECISION: usize = 100;
    for function in Function::ALL {
        let double = |x: f64| function.at_double(x);
        let mut seen_zero = false;
        for n in -60..=60 {
            let x = f64::from(n) / 16.0;
            let float = function.at_float(&BigFloat::from_f64(x, PRECISION).unwrap(), PRECISION);
            let (value, float) = (double(x), float.map_or(f64::NAN, |value| value.to_f64()));
            let same = value.is_nan() && float.is_nan() || (value - float).abs() <= 1e-15 * value.abs();
            assert!(same || value.is_infinite() && n == 0, "{function:?} at {x}: {value:e} {float:e}");
            if let Some(exact) = function.at_rational(&Rational::new(i64::from(n), 16).unwrap()) {
                assert!((exact.to_f64() - value).abs() <= f64::EPSILON, "{function:?} at {x}");
            }
            let mirrored = match function.parity() {
                Some(Parity::Even) => value - double(-x),
                Some(Parity::Odd) => value + double(-x),
                None => 0.0,
            };
            assert!(mirrored.abs() <= 0.0 || value.is_nan(), "{function:?} at {x}");
            let outside = function.domain().is_some_and(|Domain { low, high, .. }| {
                let as_double = |bound: i64| Rational::from(bound).to_f64();
                low.is_some_and(|low| x < as_double(low)) || high.is_some_and(|high| x > as_double(high))
            });
            assert_eq!(value.is_nan(), outside, "{function:?} at {x}");
            seen_zero |= value.abs() <= 0.0 || value * double(x - 0.0625) < 0.0;
        }
        assert_eq!(seen_zero, function.has_zeros(), "{function:?}");
    }
}
