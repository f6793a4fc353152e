use dashu_int::{IBig, UBig};
use libration::algebra::Rational;

fn rational(text: &str) -> Rational {
    text.parse().unwrap()
}

#[test]
fn decimals_have_the_digits_asked_for() {
    for (text, digits, decimal) in [
        ("1/3", 5, "0.33333"),
        ("-2/3", 3, "-0.667"),
        ("999999/1000", 3, "1000"),
        ("1/80000", 4, "1.25e-5"),
        ("123456789", 3, "123000000"),
        ("355/113", 10, "3.14159292"),
        ("0", 7, "0"),
        ("1/1024", 20, "0.0009765625"),
    ] {
        assert_eq!(rational(text).to_decimal(digits), decimal);
    }
    let power = rational("7").integer_power(100).unwrap();
    assert_eq!(power.to_decimal(6), "3.23448e84");
    for n in (-60..-4).chain(21..60) {
        let power = rational("10").integer_power(n).unwrap();
        assert_eq!(power.to_decimal(9), format!("1e{n}"));
        let less = power * rational("999999999/1000000000");
        assert_eq!(less.to_decimal(5), format!("1e{n}"));
    }
}

/// Reference values by mpmath, computed from 3000000·log₁₀ 2.
#[test]
fn a_few_digits_of_numbers_of_millions_of_bits_are_right() {
    let huge = Rational::from_parts(IBig::ONE << 3_000_000, UBig::ONE);
    assert_eq!(huge.to_decimal(12), "9.7049196389e903089");
    let tiny = Rational::from_parts(IBig::ONE, UBig::ONE << 3_000_000);
    assert_eq!(tiny.to_decimal(12), "1.03040523488e-903090");
}
