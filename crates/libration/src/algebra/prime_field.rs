//! Arithmetic modulo a prime of 62 bits, for exact answers that are put together from many primes.

use super::primes::is_prime;
use super::{Function, Rational, Ring};

/// The integers modulo a prime p < 2⁶², as Montgomery residues: a stands for a·2⁶⁴ mod p.
///
/// Reference: P. L. Montgomery, Math. Comp. 44, 519 (1985), doi:10.1090/S0025-5718-1985-0777282-X.
#[derive(Clone, Debug)]
pub(crate) struct PrimeField {
    prime: u64,
    /// −1/p mod 2⁶⁴.
    negative_inverse: u64,
    one: u64,
    /// 2¹²⁸ mod p, which brings an integer into Montgomery form.
    radix_squared: u64,
    /// 1/n for small n.
    inverses: Vec<u64>,
}

/// How many inverses of small integers are kept.
const KEPT_INVERSES: u64 = 512;

impl PrimeField {
    /// The field of an odd prime below 2⁶².
    pub(crate) fn new(prime: u64) -> Self {
        debug_assert!(prime % 2 == 1 && prime < 1 << 62 && is_prime(prime), "{prime}");
        // Newton's iteration doubles the bits that are right; p·p ≡ 1 mod 8 gives the first three.
        let inverse = (0..5).fold(prime, |inverse: u64, _| {
            inverse.wrapping_mul(2_u64.wrapping_sub(prime.wrapping_mul(inverse)))
        });
        let radix = (1_u128 << 64) % u128::from(prime);
        let word = |value: u128| u64::try_from(value).expect("it is below the prime");
        let radix_squared = word(radix * radix % u128::from(prime));
        let (negative_inverse, one) = (inverse.wrapping_neg(), word(radix));
        let mut field = Self { prime, negative_inverse, one, radix_squared, inverses: vec![0, one] };
        for n in 2..KEPT_INVERSES {
            // p = n·⌊p/n⌋ + r, hence 1/n = −⌊p/n⌋/r.
            let remainder = usize::try_from(prime % n).expect("it is below the number of inverses kept");
            let product = field.product(field.integer(prime / n), field.inverses[remainder]);
            field.inverses.push(field.difference(0, product));
        }
        field
    }

    pub(crate) fn prime(&self) -> u64 {
        self.prime
    }

    /// t/2⁶⁴ mod p for t < 2⁶⁴·p.
    #[inline]
    #[expect(clippy::cast_possible_truncation, reason = "the low word is meant, and the sum fits one")]
    fn reduced(&self, t: u128) -> u64 {
        let quotient = (t as u64).wrapping_mul(self.negative_inverse);
        let sum = (t + u128::from(quotient) * u128::from(self.prime)) >> 64;
        self.below(sum as u64)
    }

    /// a mod p for a < 2p.
    #[inline]
    fn below(&self, a: u64) -> u64 {
        a.min(a.wrapping_sub(self.prime))
    }

    #[inline]
    pub(crate) fn product(&self, a: u64, b: u64) -> u64 {
        self.reduced(u128::from(a) * u128::from(b))
    }

    #[inline]
    pub(crate) fn sum(&self, a: u64, b: u64) -> u64 {
        self.below(a + b)
    }

    #[inline]
    pub(crate) fn difference(&self, a: u64, b: u64) -> u64 {
        let difference = a.wrapping_sub(b);
        difference.min(difference.wrapping_add(self.prime))
    }

    /// Σ aᵢ·bᵢ, reduced once.
    #[inline]
    pub(crate) fn inner_product(&self, pairs: impl Iterator<Item = (u64, u64)>) -> u64 {
        self.reduced(pairs.fold(0, |sum, (a, b)| self.accumulated(sum, a, b)))
    }

    /// `sum + a·b`, kept below 2⁶⁴·p.
    #[inline]
    pub(crate) fn accumulated(&self, sum: u128, a: u64, b: u64) -> u128 {
        let sum = sum + u128::from(a) * u128::from(b);
        // Subtract 2⁶⁴·p when that leaves it positive: the wrapped difference is the larger otherwise.
        sum.min(sum.wrapping_sub(u128::from(self.prime) << 64))
    }

    /// An accumulated sum as a residue.
    #[inline]
    pub(crate) fn settled(&self, sum: u128) -> u64 {
        self.reduced(sum)
    }

    pub(crate) fn integer(&self, value: u64) -> u64 {
        self.product(value % self.prime, self.radix_squared)
    }

    /// The representative between 0 and p − 1.
    pub(crate) fn representative(&self, a: u64) -> u64 {
        self.reduced(u128::from(a))
    }

    pub(crate) fn unit(&self) -> u64 {
        self.one
    }

    pub(crate) fn raised(&self, a: u64, exponent: u64) -> u64 {
        let (mut result, mut square, mut rest) = (self.one, a, exponent);
        while rest > 0 {
            if rest & 1 == 1 {
                result = self.product(result, square);
            }
            square = self.product(square, square);
            rest >>= 1;
        }
        result
    }

    /// `None` for zero.
    pub(crate) fn inverse(&self, a: u64) -> Option<u64> {
        (a != 0).then(|| self.raised(a, self.prime - 2))
    }

    /// An element of multiplicative order `order`, a power of two that divides p − 1.
    pub(crate) fn root_of_unity(&self, order: u64) -> Option<u64> {
        if order < 2 {
            return Some(self.one);
        }
        let minus_one = self.difference(0, self.one);
        let candidates = (2..200).map(|base| self.raised(self.integer(base), (self.prime - 1) / order));
        candidates.into_iter().find(|&root| self.raised(root, order / 2) == minus_one)
    }

    /// A square root where there is one (Tonelli and Shanks).
    pub(crate) fn square_root(&self, a: u64) -> Option<u64> {
        if a == 0 {
            return Some(0);
        }
        let twos = (self.prime - 1).trailing_zeros();
        let odd = (self.prime - 1) >> twos;
        let generator = self.root_of_unity(1 << twos)?;
        let mut root = self.raised(a, odd.div_ceil(2));
        let mut rest = self.product(self.product(root, root), self.inverse(a)?);
        // rest = generator^(2j): take the bits of j off one by one.
        for bit in 1..=twos {
            let test = if bit == twos { rest } else { self.raised(rest, 1 << (twos - bit)) };
            if test != self.one {
                if bit == 1 {
                    return None;
                }
                let step = self.raised(generator, 1 << (bit - 2));
                let inverse = self.inverse(step)?;
                root = self.product(root, inverse);
                rest = self.product(rest, self.product(inverse, inverse));
            }
        }
        (self.product(root, root) == a).then_some(root)
    }
}

impl Ring for PrimeField {
    type Element = u64;

    fn zero(&self) -> u64 {
        0
    }

    fn is_zero(&self, a: &u64) -> bool {
        *a == 0
    }

    /// `None` when the prime divides the denominator.
    fn rational(&self, value: &Rational) -> Option<u64> {
        let (numerator, denominator) = value.residues(self.prime);
        Some(self.product(self.integer(numerator), self.inverse(self.integer(denominator))?))
    }

    fn add(&self, a: &u64, b: &u64) -> u64 {
        self.sum(*a, *b)
    }

    fn subtract(&self, a: &u64, b: &u64) -> u64 {
        self.difference(*a, *b)
    }

    fn negate(&self, a: &u64) -> u64 {
        self.difference(0, *a)
    }

    fn multiply(&self, a: &u64, b: &u64) -> u64 {
        self.product(*a, *b)
    }

    fn times_integer(&self, a: &u64, factor: i64) -> u64 {
        let product = self.product(*a, self.integer(factor.unsigned_abs()));
        if factor < 0 { self.difference(0, product) } else { product }
    }

    fn divide(&self, a: &u64, divisor: &u64) -> Option<u64> {
        Some(self.product(*a, self.inverse(*divisor)?))
    }

    fn over_integer(&self, a: &u64, divisor: u64) -> Option<u64> {
        let kept = usize::try_from(divisor).ok().and_then(|n| self.inverses.get(n)).filter(|&&n| n != 0);
        match kept {
            Some(&inverse) => Some(self.product(*a, inverse)),
            None => self.divide(a, &self.integer(divisor)),
        }
    }

    fn value(&self, _: Function, _: &u64) -> Option<u64> {
        None
    }

    fn power(&self, _: &u64, _: &Rational) -> Option<u64> {
        None
    }

    fn pi(&self) -> Option<u64> {
        None
    }

    fn convolution(&self, a: &[u64], b: &[u64]) -> u64 {
        self.inner_product(a.iter().copied().zip(b.iter().rev().copied()))
    }
}

#[cfg(test)]
mod tests {
    use super::super::primes_with_roots;
    use super::*;

    fn fields() -> impl Iterator<Item = PrimeField> {
        primes_with_roots(20).take(3).map(PrimeField::new)
    }

    #[test]
    fn residues_keep_the_field_laws() {
        for field in fields() {
            let p = u128::from(field.prime());
            for (a, b) in [(3_u64, 5_u64), (field.prime() - 1, field.prime() - 2), (1 << 61, 12345678901)] {
                let expected = u64::try_from(u128::from(a) * u128::from(b) % p).unwrap();
                let (x, y) = (field.integer(a), field.integer(b));
                assert_eq!(field.representative(field.product(x, y)), expected);
                assert_eq!(field.sum(field.difference(x, y), y), x);
                assert_eq!(field.product(field.inverse(x).unwrap(), x), field.unit());
            }
        }
    }

    #[test]
    fn long_inner_products_do_not_overflow() {
        for field in fields() {
            let large = field.prime() - 1;
            let a = field.inner_product(std::iter::repeat_n((large, large), 1000));
            let b = (0..1000).fold(0, |sum, _| field.sum(sum, field.product(large, large)));
            assert_eq!(a, b);
        }
    }

    #[test]
    fn roots_have_their_order_and_squares_their_roots() {
        for field in fields() {
            let root = field.root_of_unity(1 << 20).unwrap();
            assert_eq!(field.raised(root, 1 << 20), field.unit());
            let found = (2..40).filter_map(|n| field.square_root(field.integer(n)).map(|root| (n, root)));
            let found: Vec<(u64, u64)> = found.collect();
            assert!(found.iter().all(|&(n, root)| field.product(root, root) == field.integer(n)));
            assert!(found.len() > 10 && found.iter().any(|&(n, _)| n == 36));
        }
    }

    #[test]
    fn fractions_are_quotients() {
        let field = fields().next().unwrap();
        let seventh = field.rational(&Rational::new(-3, 7).unwrap()).unwrap();
        assert_eq!(field.times_integer(&seventh, -7), field.integer(3));
        assert_eq!(field.over_integer(&seventh, 3), field.rational(&Rational::new(-1, 7).unwrap()));
    }
}
