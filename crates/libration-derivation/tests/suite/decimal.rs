//! Numbers are rounded to the printed digits.

use libration::algebra::Rational;
use libration_derivation::{Decimal, DecimalUnit};

#[test]
fn a_rounded_number_is_the_number_it_prints() {
    let decimal = |value, digits| Decimal::rounded(value, digits, DecimalUnit::One);
    assert_eq!(decimal(2.1532423518, 5).mantissa, "2.1532");
    assert_eq!(decimal(2.1532423518, 5).value(), Rational::new(21532, 10000));
    assert_eq!(decimal(2.1532423518, 5).last_place(), Rational::new(1, 10000));
    assert_eq!((decimal(-1.25e-9, 3).mantissa.as_str(), decimal(-1.25e-9, 3).exponent), ("-1.25", -9));
    assert_eq!(decimal(-1.25e-9, 3).value(), Rational::new(-125, 100_000_000_000));
    assert_eq!(Decimal::short(60.0, DecimalUnit::Degree).mantissa, "60");
}
