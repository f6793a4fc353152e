use libration::internals::algebra::{is_prime, primes_with_roots};

#[test]
fn small_primes_are_told_from_composites() {
    let primes: Vec<u32> = (0..60).filter(|&n| is_prime(n)).collect();
    assert_eq!(primes, [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59]);
    // The least strong pseudoprime to the first three bases, and 2³¹ − 1.
    assert!(!is_prime(25_326_001));
    assert!(is_prime((1 << 31) - 1));
}

#[test]
fn primes_for_the_longest_series_are_plenty() {
    for k in [3, 9, 11, 14] {
        assert!(primes_with_roots(k).take(3000).all(|p| p % (1 << k) == 1 && p >> 29 == 1), "{k}");
    }
}
