use libration::double_double::{DoubleDouble, two_prod, two_sum};

#[test]
fn sums_and_products_of_words_are_exact() {
    assert_eq!(two_sum(1.0, 1e-30), DoubleDouble::new(1.0, 1e-30));
    let x = 1.0 + f64::EPSILON;
    assert_eq!(two_prod(x, x), DoubleDouble::new(1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
}

#[test]
fn quotients_and_roots_undo_products() {
    for i in 1..1000 {
        let x = DoubleDouble::PI * f64::from(i) + 1e-20;
        assert!(((x / DoubleDouble::LN_2) * DoubleDouble::LN_2 - x).to_f64().abs() < 2e-31 * x.hi);
        assert!((x.sqrt().square() - x).to_f64().abs() < 1e-31 * x.hi);
    }
}

#[test]
fn squares_are_rounded_once_however_large_or_small() {
    let x = DoubleDouble::new(1.5, 1e-17);
    for exponent in [-1074, -600, -537, -530, -400, 0, 400, 511] {
        let expected = libm::scalbn(x.square().to_f64(), 2 * exponent);
        let shifted = x.times_power_of_two(exponent);
        let exact = shifted.lo != 0.0 || exponent < -1000;
        assert!(exact, "{exponent}: its second word is there, or below the smallest number");
        assert_eq!(shifted.square_to_f64().to_bits(), expected.to_bits(), "{exponent}");
    }
    assert!(x.times_power_of_two(512).square_to_f64().is_infinite());
    assert_eq!(DoubleDouble::ZERO.square_to_f64().to_bits(), 0);
}

#[test]
fn the_root_of_zero_is_zero_and_of_a_negative_number_nan() {
    assert_eq!(DoubleDouble::ZERO.sqrt(), DoubleDouble::ZERO);
    assert!(DoubleDouble::new(-1.0, 0.0).sqrt().hi.is_nan());
}
