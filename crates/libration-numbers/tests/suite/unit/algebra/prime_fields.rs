use libration::algebra::{Rational, Ring};
use libration::internals::algebra::primes_with_roots;
use libration::internals::algebra::{PrimeField, PrimeFields, Residues};

fn fields() -> PrimeFields {
    let mut primes = primes_with_roots(16);
    PrimeFields::new(std::array::from_fn(|_| primes.next().unwrap()))
}

#[test]
fn each_lane_is_a_field_of_its_own() {
    let fields = fields();
    let (a, b) = (fields.integer(1 << 40), fields.integer(12_345_678_901));
    let alone = |operation: fn(&PrimeField, u32, u32) -> u32| {
        std::array::from_fn(|lane| operation(&PrimeField::new(fields.primes()[lane]), a[lane], b[lane]))
    };
    assert_eq!(fields.multiply(&a, &b), alone(PrimeField::product));
    assert_eq!(fields.add(&a, &b), alone(PrimeField::sum));
    assert_eq!(fields.subtract(&a, &b), alone(PrimeField::difference));
    assert_eq!(fields.multiply(&fields.inverse(&a).unwrap(), &a), fields.unit());
    assert_eq!(fields.times_integer(&a, -(1 << 40)), fields.negate(&fields.multiply(&a, &a)));
    // A number that is zero modulo only one of the primes.
    let one_zero = fields.integer(u64::from(fields.primes()[3]));
    assert!(one_zero[3] == 0 && !fields.is_zero(&one_zero));
    assert_eq!(fields.inverse(&one_zero), None);
}

#[test]
fn long_convolutions_do_not_overflow() {
    let fields = fields();
    let largest = fields.primes().map(|prime| prime - 1);
    for length in [0, 1, 7, 8, 9, 1000] {
        let sum = fields.convolution(&vec![largest; length], &vec![largest; length]);
        let expected =
            fields.times_integer(&fields.multiply(&largest, &largest), i64::try_from(length).unwrap());
        assert_eq!(sum, expected, "{length}");
    }
    let numbers: Vec<Residues> = (0..20).map(|n| fields.integer(n * n + 1)).collect();
    let direct = |n: usize| fields.multiply(&numbers[n], &numbers[18 - n]);
    let expected = (0..19).fold(fields.zero(), |sum, n| fields.add(&sum, &direct(n)));
    assert_eq!(fields.convolution(&numbers[..19], &numbers[..19]), expected);
}

#[test]
fn fractions_are_quotients() {
    let fields = fields();
    let seventh = fields.rational(&Rational::new(-3, 7).unwrap()).unwrap();
    assert_eq!(fields.times_integer(&seventh, -7), fields.integer(3));
    for divisor in [3_i64, 511, 512, 100_003] {
        let quotient = fields.over_integer(&seventh, divisor.unsigned_abs());
        assert_eq!(quotient, fields.rational(&Rational::new(-3, 7 * divisor).unwrap()));
    }
    let prime = i64::from(fields.primes()[5]);
    assert_eq!(fields.rational(&Rational::new(1, prime).unwrap()), None);
}
