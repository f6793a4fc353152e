use libration::algebra::{Rational, Rationals, Ring};
use libration::internals::algebra::{PiPolynomial, PiPowers};

const RING: PiPowers<Rationals> = PiPowers { numbers: Rationals };

fn sum(terms: &[(i32, i64)]) -> PiPolynomial<Rational> {
    let each = terms.iter().map(|&(power, number)| RING.term(power, Rational::from(number)));
    each.fold(RING.zero(), |sum, term| RING.add(&sum, &term))
}

#[test]
fn products_add_powers_and_terms_cancel() {
    let (a, b) = (sum(&[(-1, 2), (0, 3)]), sum(&[(-1, 2), (0, -3)]));
    assert_eq!(RING.multiply(&a, &b), sum(&[(-2, 4), (0, -9)]));
    assert!(RING.is_zero(&RING.subtract(&a, &a)));
    assert!(RING.is_zero(&RING.times_integer(&a, 0)));
}

#[test]
fn single_terms_divide_and_sums_do_not() {
    let a = sum(&[(-1, 2), (1, 6)]);
    assert_eq!(RING.divide(&a, &sum(&[(1, 2)])), Some(sum(&[(-2, 1), (0, 3)])));
    assert_eq!(RING.divide(&a, &a), None);
    assert_eq!(RING.divide(&a, &RING.zero()), None);
}
