use libration::internals::algebra::PrimeField;
use libration::internals::algebra::primes_with_roots;

fn fields() -> impl Iterator<Item = PrimeField> {
    primes_with_roots(16).take(3).map(PrimeField::new)
}

#[test]
fn residues_keep_the_field_laws() {
    for field in fields() {
        let p = u64::from(field.prime());
        for (a, b) in [(3_u32, 5_u32), (field.prime() - 1, field.prime() - 2), (u32::MAX, 1_234_567_890)] {
            let expected = u32::try_from(u64::from(a) * u64::from(b) % p).unwrap();
            let (x, y) = (field.integer(a), field.integer(b));
            assert_eq!(field.representative(field.product(x, y)), expected);
            assert_eq!(field.sum(field.difference(x, y), y), x);
            assert_eq!(field.product(field.inverse(x).unwrap(), x), field.unit());
            assert_eq!(field.residue(u64::from(a) + 7 * p), x);
        }
    }
}

#[test]
fn roots_have_their_order_and_squares_their_roots() {
    for field in fields() {
        let root = field.root_of_unity(1 << 16).unwrap();
        assert_eq!(field.raised(root, 1 << 16), field.unit());
        assert_eq!(field.root_of_unity(1 << 29), None);
        let squares = (2..40).filter_map(|n| field.square_root(field.integer(n)).map(|root| (n, root)));
        let squares: Vec<(u32, u32)> = squares.collect();
        assert!(squares.iter().all(|&(n, root)| field.product(root, root) == field.integer(n)));
        assert!(squares.len() > 10 && squares.len() < 38 && squares.iter().any(|&(n, _)| n == 36));
    }
}
