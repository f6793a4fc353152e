//! Arithmetic modulo a prime of 30 bits, for exact results that are reconstructed from several primes.

use super::Rational;
use super::primes::is_prime;

/// The integers modulo an odd prime p < 2³⁰, as Montgomery residues: the word a·2³² mod p represents a.
///
/// Reference: P. L. Montgomery, Math. Comp. 44, 519 (1985), doi:10.1090/S0025-5718-1985-0777282-X.
#[derive(Clone, Copy, Debug)]
pub struct PrimeField {
    prime: u32,
    /// −1/p mod 2³².
    negative_inverse: u32,
    unit: u32,
    /// 2⁶⁴ mod p, which brings an integer into Montgomery form.
    radix_squared: u32,
}

/// The low half of a sum.
const LOW_WORD: u64 = u32::MAX as u64;

impl PrimeField {
    pub fn new(prime: u32) -> Self {
        debug_assert!(prime % 2 == 1 && prime < 1 << 30 && is_prime(prime), "{prime}");
        // Newton's iteration doubles the number of correct bits; p·p ≡ 1 mod 8 gives the first three.
        let inverse = (0..4).fold(prime, |inverse: u32, _| {
            inverse.wrapping_mul(2_u32.wrapping_sub(prime.wrapping_mul(inverse)))
        });
        let modulus = u64::from(prime);
        let radix = (1_u64 << 32) % modulus;
        let word = |value: u64| u32::try_from(value).expect("it is below the prime");
        Self {
            prime,
            negative_inverse: inverse.wrapping_neg(),
            unit: word(radix),
            radix_squared: word(radix * radix % modulus),
        }
    }

    /// The field, from constants that were computed before.
    #[inline(always)]
    pub(super) fn from_constants(prime: u32, negative_inverse: u32, unit: u32, radix_squared: u32) -> Self {
        Self { prime, negative_inverse, unit, radix_squared }
    }

    #[inline(always)]
    pub fn prime(&self) -> u32 {
        self.prime
    }

    pub fn unit(&self) -> u32 {
        self.unit
    }

    pub(super) fn negative_inverse(&self) -> u32 {
        self.negative_inverse
    }

    pub(super) fn radix_squared(&self) -> u32 {
        self.radix_squared
    }

    /// t/2³² mod p for t < 2³²·p.
    #[inline(always)]
    pub(super) fn reduced(&self, t: u64) -> u32 {
        // Computed in 64-bit words, since processors multiply the low words of several lanes at once.
        let quotient = ((t & LOW_WORD) * u64::from(self.negative_inverse)) & LOW_WORD;
        self.below(((t + quotient * u64::from(self.prime)) >> 32) as u32)
    }

    /// A number congruent to t, at most (2³² − 1) + (2³² − 1)·(p − 1): it is below 2³²·p and leaves room for twelve products.
    #[inline(always)]
    pub(super) fn folded(&self, t: u64) -> u64 {
        (t & LOW_WORD) + (t >> 32) * u64::from(self.unit)
    }

    /// a mod p for a < 2p.
    #[inline(always)]
    fn below(&self, a: u32) -> u32 {
        a.min(a.wrapping_sub(self.prime))
    }

    #[inline(always)]
    pub fn product(&self, a: u32, b: u32) -> u32 {
        self.reduced(u64::from(a) * u64::from(b))
    }

    #[inline(always)]
    pub fn sum(&self, a: u32, b: u32) -> u32 {
        self.below(a + b)
    }

    #[inline(always)]
    pub fn difference(&self, a: u32, b: u32) -> u32 {
        let difference = a.wrapping_sub(b);
        difference.min(difference.wrapping_add(self.prime))
    }

    /// Any 32-bit word as an element: it may exceed p, because it is multiplied by a reduced factor.
    #[inline(always)]
    pub fn integer(&self, value: u32) -> u32 {
        self.product(value, self.radix_squared)
    }

    /// The residue of a number that may be longer than 32 bits.
    pub fn residue(&self, value: u64) -> u32 {
        self.integer(u32::try_from(value % u64::from(self.prime)).expect("it is below the prime"))
    }

    /// The representative between 0 and p − 1.
    #[inline(always)]
    pub fn representative(&self, a: u32) -> u32 {
        self.reduced(u64::from(a))
    }

    pub fn raised(&self, a: u32, exponent: u32) -> u32 {
        let (mut result, mut square, mut rest) = (self.unit, a, exponent);
        while rest > 0 {
            if rest & 1 == 1 {
                result = self.product(result, square);
            }
            square = self.product(square, square);
            rest >>= 1;
        }
        result
    }

    /// The inverse; `None` for zero.
    pub fn inverse(&self, a: u32) -> Option<u32> {
        (a != 0).then(|| self.raised(a, self.prime - 2))
    }

    /// An element of multiplicative order `order`, a power of two that divides p − 1.
    pub fn root_of_unity(&self, order: u32) -> Option<u32> {
        if order < 2 {
            return Some(self.unit);
        }
        if !(self.prime - 1).is_multiple_of(order) {
            return None;
        }
        let minus_one = self.difference(0, self.unit);
        let candidates = (2..200).map(|base| self.raised(self.integer(base), (self.prime - 1) / order));
        candidates.into_iter().find(|&root| self.raised(root, order / 2) == minus_one)
    }

    /// A fraction as an element; `None` if the prime divides the denominator.
    pub fn fraction(&self, value: &Rational) -> Option<u32> {
        let (numerator, denominator) = value.residues(self.prime);
        let whole = self.integer(numerator);
        // An inverse takes as long as sixty products.
        if denominator == 1 {
            Some(whole)
        } else {
            Some(self.product(whole, self.inverse(self.integer(denominator))?))
        }
    }

    /// A square root, if one exists (Tonelli and Shanks).
    pub fn square_root(&self, a: u32) -> Option<u32> {
        if a == 0 {
            return Some(0);
        }
        let twos = (self.prime - 1).trailing_zeros();
        let odd = (self.prime - 1) >> twos;
        let generator = self.root_of_unity(1 << twos)?;
        let mut root = self.raised(a, odd.div_ceil(2));
        let mut rest = self.product(self.product(root, root), self.inverse(a)?);
        // rest = generator^(2j): the bits of j are removed one by one.
        for bit in 1..=twos {
            let test = if bit == twos { rest } else { self.raised(rest, 1 << (twos - bit)) };
            if test != self.unit {
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
