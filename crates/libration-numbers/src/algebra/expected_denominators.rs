//! Denominators that grow from order to order, so that only a few of their factors have to be reconstructed.

use dashu_base::{BitTest, DivRem, Gcd, UnsignedAbs};
use dashu_int::{IBig, UBig};

use super::Rational;
use super::mixed_radix::{CONFIRMING_PRIMES, MixedRadix};
use super::prime_fields::{LANES, Residues};

/// Number of bits by which numerator and denominator must be shorter than the modulus, for a fraction to be accepted.
const SPARE_BITS: usize = 48;

/// The least common denominators of the last two orders with nonzero numbers.
#[derive(Clone, Debug)]
pub(super) struct DenominatorGrowth {
    before: UBig,
    last: UBig,
}

impl Default for DenominatorGrowth {
    fn default() -> Self {
        Self { before: UBig::ONE, last: UBig::ONE }
    }
}

impl DenominatorGrowth {
    /// Expected denominator of the next order, if it grows as before.
    pub(super) fn expected(&self) -> UBig {
        let common = (&self.last).gcd(&self.before);
        &self.last * (&self.last / common)
    }

    pub(super) fn push(&mut self, next: UBig) {
        self.before = std::mem::replace(&mut self.last, next);
    }
}

/// A common denominator of some numbers, extended as the numbers are reconstructed.
pub(super) struct Common<'a> {
    radix: &'a MixedRadix,
    value: UBig,
    residues: Vec<u32>,
    /// Factor of the denominator that none of the numbers so far needs.
    excess: Option<UBig>,
}

impl<'a> Common<'a> {
    pub(super) fn new(radix: &'a MixedRadix, value: UBig) -> Self {
        Self { radix, residues: radix.residues(&value), value, excess: None }
    }

    /// The fractions of up to eight numbers, reconstructed from their residues.
    pub(super) fn fractions(&mut self, lists: &[&[Residues]]) -> Option<Vec<Rational>> {
        let residues = |k: usize| {
            let (group, lane, mut row) = (k / LANES, k % LANES, [0; LANES]);
            for (entry, list) in row.iter_mut().zip(lists) {
                *entry = list[group][lane];
            }
            row
        };
        // Each number can add one factor that was not expected.
        for _ in 0..=lists.len() {
            let digits = self.radix.digits(residues, &self.residues);
            let integers: Vec<Option<IBig>> =
                (0..lists.len()).map(|lane| self.radix.small_integer(&digits, lane)).collect();
            match integers.iter().position(Option::is_none) {
                None => return Some(integers.into_iter().flatten().map(|n| self.fraction(n)).collect()),
                Some(lane) => {
                    let residues: Vec<u32> = (0..self.radix.len()).map(|k| residues(k)[lane]).collect();
                    self.extend(&residues)?;
                }
            }
        }
        None
    }

    fn fraction(&mut self, numerator: IBig) -> Rational {
        let fraction = Rational::from_parts(numerator, self.value.clone());
        if self.excess.as_ref().is_none_or(|excess| !excess.is_one()) {
            let needed = &self.value / fraction.parts().1;
            self.excess = Some(self.excess.as_ref().map_or(needed.clone(), |excess| excess.gcd(&needed)));
        }
        fraction
    }

    /// Multiplies the denominator by the factor that a number needs in addition; `None` if the primes do not suffice to determine it.
    fn extend(&mut self, residues: &[u32]) -> Option<()> {
        let used = self.radix.len().checked_sub(CONFIRMING_PRIMES)?;
        let digits = self.radix.digits(|k| [residues[k]; LANES], &self.residues);
        if digits.len() < used {
            return None;
        }
        let value = self.radix.value(digits[..used].iter().map(|digit| digit[0]));
        let factor = by_division(&self.radix.modulus(used), value)?;
        self.residues = self.radix.products(&self.residues, &self.radix.residues(&factor));
        self.value *= &factor;
        self.excess = self.excess.take().map(|excess| excess * factor);
        Some(())
    }

    /// The least common denominator.
    pub(super) fn least(self) -> UBig {
        match self.excess {
            Some(excess) => self.value / excess,
            None => self.value,
        }
    }
}

/// The denominator of the fraction with this residue modulo a product of primes, if the fraction is unambiguous: the step of Euclid's algorithm
/// after which numerator and denominator together are much smaller than the product.
///
/// Reference: M. Monagan, *Maximal quotient rational reconstruction*, ISSAC 2004, doi:10.1145/1005285.1005321.
fn by_division(product: &UBig, residue: UBig) -> Option<UBig> {
    let (mut r, mut s) = ((product.clone(), residue), (IBig::ZERO, IBig::ONE));
    while !r.1.is_zero() {
        if r.1.bit_len() + s.1.bit_len() + SPARE_BITS < product.bit_len() {
            return Some(s.1.unsigned_abs());
        }
        let (quotient, remainder) = (&r.0).div_rem(&r.1);
        let next = &s.0 - IBig::from(quotient) * &s.1;
        r = (r.1, remainder);
        s = (s.1, next);
    }
    None
}
