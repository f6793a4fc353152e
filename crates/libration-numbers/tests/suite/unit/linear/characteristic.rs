use libration::algebra::{Rational, Rationals};
use libration::internals::linear::characteristic_polynomial;

#[test]
fn the_polynomial_of_a_companion_is_what_it_was_made_of() {
    let number = |n: i64| Rational::new(n, 3).unwrap();
    let coefficients = [7, -2, 0, 5].map(number);
    let row = |i: usize| {
        let last = -coefficients[i].clone();
        (0..3).map(move |j| Rational::from(i64::from(i == j + 1))).chain([last])
    };
    let companion: Vec<Vec<Rational>> = (0..4).map(|i| row(i).collect()).collect();
    let polynomial = characteristic_polynomial(&Rationals, &companion).unwrap();
    assert_eq!(polynomial[..4], coefficients);
    assert_eq!(polynomial[4], Rational::from(1));
}
