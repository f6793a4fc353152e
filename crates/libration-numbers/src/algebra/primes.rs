//! Primes of 30 bits whose fields have the roots of unity that sampling on a circle requires.

/// Primes between 2²⁹ and 2³⁰ of the form c·2ᵏ + 1, in descending order: they have roots of unity of order 2ᵏ.
pub fn primes_with_roots(k: u32) -> impl Iterator<Item = u32> {
    let step = 1_u32 << k.min(29);
    let largest = ((1_u32 << 30) / step - 1) * step + 1;
    std::iter::successors(Some(largest), move |candidate| candidate.checked_sub(step))
        .take_while(|&candidate| candidate > 1 << 29)
        .filter(|&candidate| is_prime(candidate))
}

/// Returns `true` for a prime, by Miller and Rabin's test with bases that suffice below 3.2·10⁹.
///
/// Reference: G. Jaeschke, Math. Comp. 61, 915 (1993), doi:10.1090/S0025-5718-1993-1192971-8.
pub fn is_prime(n: u32) -> bool {
    const BASES: [u32; 4] = [2, 3, 5, 7];
    if let Some(&small) = BASES.iter().find(|&&base| n.is_multiple_of(base)) {
        return n == small;
    }
    let multiply =
        |a: u32, b: u32| u32::try_from(u64::from(a) * u64::from(b) % u64::from(n)).expect("it is below n");
    let raise = |base: u32, exponent: u32| {
        let bits = (0..u32::BITS - exponent.leading_zeros()).rev();
        bits.fold(1, |power, bit| {
            let square = multiply(power, power);
            if exponent >> bit & 1 == 1 { multiply(square, base) } else { square }
        })
    };
    let passes = |base: u32, twos: u32| {
        let mut power = raise(base, (n - 1) >> twos);
        power == 1
            || (0..twos).any(|_| {
                let is_minus_one = power == n - 1;
                power = multiply(power, power);
                is_minus_one
            })
    };
    n > 1 && BASES.iter().all(|&base| passes(base, (n - 1).trailing_zeros()))
}
