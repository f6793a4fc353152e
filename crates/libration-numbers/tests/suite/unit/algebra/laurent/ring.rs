use libration::algebra::{LaurentPolynomial, LaurentPolynomials, Rational, Ring};

fn ring() -> LaurentPolynomials {
    LaurentPolynomials::new(["a", "b", "w"].map(str::to_owned).to_vec())
}

fn rational(text: &str) -> Rational {
    text.parse().unwrap()
}

/// 3b/(8w²) − 5a²/12 + 2.
fn sample(ring: &LaurentPolynomials) -> LaurentPolynomial {
    let term = |powers: [i64; 3], factor| ring.term(powers.map(|power| 2 * power).into(), rational(factor));
    let sum = ring.add(&term([0, 1, -2], "3/8"), &term([2, 0, 0], "-5/12"));
    ring.add(&sum, &term([0, 0, 0], "2"))
}

#[test]
fn arithmetic_keeps_the_ring_laws() {
    let ring = ring();
    let (x, y) = (sample(&ring), ring.subtract(&ring.letter(0), &ring.letter(2)));
    let z = ring.divide(&ring.letter(1), &ring.letter(2)).unwrap();
    let sum = ring.add(&y, &z);
    let products = ring.add(&ring.multiply(&x, &y), &ring.multiply(&x, &z));
    assert_eq!(ring.multiply(&x, &sum), products);
    assert!(ring.subtract(&x, &x).is_zero());
    assert_eq!(ring.divide(&products, &sum), Some(x.clone()));
    assert_eq!(ring.divide(&ring.add(&products, &ring.letter(0)), &sum), None, "a rest is left");
    assert_eq!(ring.divide(&x, &ring.zero()), None);
}

#[test]
fn a_value_is_the_same_before_and_after_an_operation() {
    let ring = ring();
    // a = 4, b = 1/9, w = 25.
    let at = ["2", "1/3", "5"].map(rational);
    let power =
        |letter: usize, half_power: i64| at[letter].integer_power(isize::try_from(half_power).unwrap());
    let value = |polynomial: &LaurentPolynomial| polynomial.value(power).unwrap();
    // (3/8)(1/9)/625 − (5/12)·16 + 2 by hand.
    assert_eq!(value(&sample(&ring)), rational("-23333/5000"));
    let square = ring.multiply(&sample(&ring), &sample(&ring));
    assert_eq!(value(&square), value(&sample(&ring)) * value(&sample(&ring)));
}

#[test]
fn roots_are_those_of_single_terms() {
    let ring = ring();
    let half = rational("1/2");
    let quotient = ring.divide(&ring.times_integer(&ring.letter(0), 4), &ring.letter(1)).unwrap();
    let root = ring.power(&quotient, &half).unwrap();
    assert_eq!(root.to_string(), "2*sqrt(a)/sqrt(b)");
    assert_eq!(ring.multiply(&root, &root), quotient);
    assert_eq!(ring.power(&root, &half), None, "a fourth root");
    assert_eq!(ring.power(&ring.times_integer(&ring.letter(0), 2), &half), None, "√2 is not a fraction");
    assert_eq!(ring.power(&ring.add(&ring.letter(0), &ring.letter(1)), &half), None);
}

#[test]
fn what_grows_beyond_the_limit_stays_unknown() {
    let ring = ring();
    let sum = ring.add(&ring.add(&ring.letter(0), &ring.letter(1)), &ring.letter(2));
    let beyond = ring.power(&sum, &rational("1000")).unwrap();
    assert!(beyond.is_beyond_limit() && !beyond.is_zero());
    assert!(ring.add(&beyond, &sum).is_beyond_limit() && ring.multiply(&sum, &beyond).is_beyond_limit());
    let large = ring.power(&ring.letter(0), &rational("700000")).unwrap();
    assert!(!large.is_beyond_limit() && ring.multiply(&large, &large).is_beyond_limit());
    // The square of ten terms with numbers of a million bits, 3 to the power 2²⁰, would take seconds, its powers hours.
    let three = ring.rational(&rational("3")).unwrap();
    let number = (0..20).fold(three, |power, _| ring.multiply(&power, &power));
    let long = ring.multiply(&number, &ring.power(&sum, &rational("3")).unwrap());
    assert!(!long.is_beyond_limit() && ring.multiply(&long, &long).is_beyond_limit());
    assert!(!ring.multiply(&number, &number).is_beyond_limit());
}
