//! Primes of 62 bits whose fields have the roots of unity that values on a circle need.

/// Primes below 2⁶² of the form c·2ᵏ + 1, in descending order: they have roots of unity of order 2ᵏ.
pub(crate) fn primes_with_roots(k: u32) -> impl Iterator<Item = u64> {
    let step = 1_u64 << k;
    let largest = ((1_u64 << 62) / step - 1) * step + 1;
    std::iter::successors(Some(largest), move |candidate| candidate.checked_sub(step))
        .filter(|&candidate| candidate > 1 << 61 && is_prime(candidate))
}

/// Miller and Rabin's test, with the bases that decide below 2⁶⁴.
///
/// Reference: J. Sorenson, J. Webster, Math. Comp. 86, 985 (2017), doi:10.1090/mcom/3134.
pub(super) fn is_prime(n: u64) -> bool {
    const BASES: [u64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    if let Some(&small) = BASES.iter().find(|&&base| n.is_multiple_of(base)) {
        return n == small;
    }
    let multiply =
        |a: u64, b: u64| u64::try_from(u128::from(a) * u128::from(b) % u128::from(n)).expect("it is below n");
    let raise = |base: u64, exponent: u64| {
        let bits = (0..u64::BITS - exponent.leading_zeros()).rev();
        bits.fold(1, |power, bit| {
            let square = multiply(power, power);
            if exponent >> bit & 1 == 1 { multiply(square, base) } else { square }
        })
    };
    let twos = (n - 1).trailing_zeros();
    n > 1
        && BASES.iter().all(|&base| {
            let mut power = raise(base, (n - 1) >> twos);
            power == 1
                || (0..twos).any(|_| {
                    let found = power == n - 1;
                    power = multiply(power, power);
                    found
                })
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_primes_are_told_from_composites() {
        let primes: Vec<u64> = (0..60).filter(|&n| is_prime(n)).collect();
        assert_eq!(primes, [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59]);
        // A strong pseudoprime to the first nine bases, and 2⁶¹ − 1.
        assert!(!is_prime(3825123056546413051));
        assert!(is_prime((1 << 61) - 1));
    }
}
