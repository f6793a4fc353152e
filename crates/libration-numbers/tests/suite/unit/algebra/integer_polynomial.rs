use dashu_int::IBig;
use libration::internals::algebra::product;

fn schoolbook(a: &[IBig], b: &[IBig]) -> Vec<IBig> {
    let mut sums = vec![IBig::ZERO; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            sums[i + j] += x * y;
        }
    }
    sums
}

/// Signs and sizes that change from one coefficient to the next.
fn coefficients(length: i64, seed: i64) -> Vec<IBig> {
    (0..length)
        .map(|i| {
            let x = (seed * (i + 3)).wrapping_mul(0x9E37_79B9_7F4A_7C15_u64.cast_signed());
            IBig::from(x).pow(usize::try_from(i % 4).unwrap()) * x.signum() * ((i + seed) % 3 - 1)
        })
        .collect()
}

#[test]
fn kronecker_product_equals_the_schoolbook_product() {
    for (m, n) in [(1, 1), (1, 9), (5, 4), (40, 33)] {
        let (a, b) = (coefficients(m, 5), coefficients(n, 8));
        assert_eq!(product(&a, &b), schoolbook(&a, &b), "{m} × {n}");
    }
    assert!(product(&[], &coefficients(3, 1)).is_empty());
}

#[test]
fn coefficients_that_fill_their_slot_keep_their_signs() {
    let extreme = |sign: i64| vec![IBig::from(sign * i64::MAX); 7];
    for (s, t) in [(1, 1), (1, -1), (-1, -1)] {
        assert_eq!(product(&extreme(s), &extreme(t)), schoolbook(&extreme(s), &extreme(t)));
    }
}
