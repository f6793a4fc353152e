use libration::algebra::Rational;
use libration::internals::expression::{from_digits, to_decimal};

#[test]
fn decimals_are_read_exactly_and_written_back() {
    let cases = [("12", 0, "12"), ("125", -3, "0.125"), ("1", -300, "1e-300"), ("100", 30, "1e32")];
    for (digits, exponent, text) in cases {
        assert_eq!(to_decimal(&from_digits(digits, exponent).unwrap()).unwrap(), text);
    }
    assert_eq!(from_digits("25", -2), Rational::new(1, 4));
    assert_eq!(from_digits("000", -99999), Some(Rational::from(0)));
}

#[test]
fn numbers_beyond_the_limits_are_none() {
    assert_eq!(from_digits("1", 1001), None);
    assert_eq!(from_digits("1", i64::MIN), None);
    assert_eq!(from_digits(&"1".repeat(1001), 0), None);
    assert_eq!(to_decimal(&Rational::new(1, 3).unwrap()), None);
}
