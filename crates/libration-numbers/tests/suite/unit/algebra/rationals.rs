use libration::algebra::{Rational, Rationals, Ring};

#[test]
fn convolutions_are_sums_of_products() {
    let fraction = |n: i64, seed: i64| Rational::new((n * n - seed) % 11, 1 + (n * seed) % 7 * 6).unwrap();
    for length in 0..9 {
        let (a, b): (Vec<_>, Vec<_>) = (0..length).map(|n| (fraction(n, 4), fraction(n, 5))).unzip();
        let terms = a.iter().zip(b.iter().rev()).map(|(a, b)| Rationals.multiply(a, b));
        let expected = terms.fold(Rational::from(0), |sum, term| Rationals.add(&sum, &term));
        assert_eq!(Rationals.convolution(&a, &b), expected);
    }
}
