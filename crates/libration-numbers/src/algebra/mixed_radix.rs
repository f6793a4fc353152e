//! Integers from their residues modulo many primes, several integers at once.

use dashu_int::{IBig, UBig};

use super::PrimeField;
use super::prime_fields::{LANES, PRODUCTS, Residues, Sums};
use libration_kernels::dispatch::{Kernel, dispatch_slices};

/// Number of additional primes with which a result must agree.
pub const CONFIRMING_PRIMES: usize = 5;

/// Numbers modulo the product of some primes, in the form d₀ + d₁p₀ + d₂p₀p₁ + …, whose digits are computed one after the other in machine
/// words. A small integer has few nonzero digits, and the last digits of a small negative one are p − 1.
///
/// Reference: H. L. Garner, *The residue number system*, IRE Trans. Electron. Comput. EC-8, 140 (1959).
#[derive(Clone, Debug, Default)]
pub struct MixedRadix {
    pub places: Vec<RadixPrime>,
}

/// A prime, with the products of the primes before it.
#[derive(Clone, Debug)]
pub struct RadixPrime {
    pub field: PrimeField,
    /// p₀⋯pⱼ₋₁ modulo this prime, by j, in Montgomery form.
    products: Vec<u32>,
    /// The inverse of the product of all primes before this one.
    inverse: u32,
}

impl MixedRadix {
    /// Adds another prime.
    pub fn push(&mut self, prime: u32) {
        let field = PrimeField::new(prime);
        let mut product = field.unit();
        let mut products = Vec::with_capacity(self.places.len());
        for digit in &self.places {
            products.push(product);
            product = field.product(product, field.integer(digit.field.prime()));
        }
        let inverse = field.inverse(product).expect("the primes differ");
        self.places.push(RadixPrime { field, products, inverse });
    }

    pub(super) fn len(&self) -> usize {
        self.places.len()
    }

    /// An integer modulo each prime, in Montgomery form.
    pub fn residues(&self, value: &UBig) -> Vec<u32> {
        self.places.iter().map(|digit| digit.field.integer(value % digit.field.prime())).collect()
    }

    /// The residues of a product.
    pub(super) fn products(&self, a: &[u32], b: &[u32]) -> Vec<u32> {
        self.places.iter().zip(a.iter().zip(b)).map(|(digit, (&a, &b))| digit.field.product(a, b)).collect()
    }

    /// The digits of eight numbers times a factor, from their residues modulo the k-th prime and those of the factor. The computation stops as
    /// soon as the digits show that all numbers are small integers.
    pub fn digits(&self, residues: impl Fn(usize) -> Residues, factor: &[u32]) -> Vec<Residues> {
        let mut digits: Vec<Residues> = Vec::with_capacity(self.places.len());
        let mut ends = Ends::default();
        for (k, digit) in self.places.iter().enumerate() {
            let next = digit.next_digits(&digits, &residues(k), factor[k]);
            digits.push(next);
            if ends.suffice(&next, digit.field.prime()) {
                break;
            }
        }
        digits
    }

    /// The integer of a lane, if its last digits show that it is small.
    pub fn small_integer(&self, digits: &[Residues], lane: usize) -> Option<IBig> {
        let negative = digits.last()?[lane] != 0;
        let prime = |k: usize| self.places[k].field.prime();
        let is_end = |k: usize| digits[k][lane] == if negative { prime(k) - 1 } else { 0 };
        let ends = (0..digits.len()).rev().take_while(|&k| is_end(k)).count();
        let kept = digits.len() - ends;
        if ends < CONFIRMING_PRIMES {
            None
        } else if negative {
            // The digits of −1 − v are those of v subtracted from p − 1.
            Some(-IBig::from(self.value((0..kept).map(|k| prime(k) - 1 - digits[k][lane])) + 1_u8))
        } else {
            Some(IBig::from(self.value((0..kept).map(|k| digits[k][lane]))))
        }
    }

    /// The number with these digits.
    pub(super) fn value(&self, digits: impl DoubleEndedIterator<Item = u32> + ExactSizeIterator) -> UBig {
        let mut words: Vec<u64> = Vec::with_capacity(digits.len() / 2 + 1);
        let primes = self.places[..digits.len()].iter().map(|digit| u64::from(digit.field.prime()));
        let mut pairs = digits.map(u64::from).zip(primes).rev();
        // Two digits at a time make one step with a machine word; an odd digit remains at the end.
        while let Some((mut digit, mut radix)) = pairs.next() {
            if let Some((lower, prime)) = pairs.next() {
                (digit, radix) = (digit * prime + lower, radix * prime);
            }
            multiply_add(&mut words, radix, digit);
        }
        from_words(&words)
    }

    /// The product of the first primes.
    pub fn modulus(&self, primes: usize) -> UBig {
        let mut words = vec![1];
        for digit in &self.places[..primes] {
            multiply_add(&mut words, u64::from(digit.field.prime()), 0);
        }
        from_words(&words)
    }
}

/// Multiplies a number in words, lowest first, by `factor` and adds `summand`.
#[expect(clippy::cast_possible_truncation, reason = "the low word is meant")]
fn multiply_add(words: &mut Vec<u64>, factor: u64, summand: u64) {
    let mut carry = u128::from(summand);
    for word in words.iter_mut() {
        carry += u128::from(*word) * u128::from(factor);
        *word = carry as u64;
        carry >>= 64;
    }
    if carry > 0 {
        words.push(carry as u64);
    }
}

fn from_words(words: &[u64]) -> UBig {
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    UBig::from_le_bytes(&bytes)
}

/// For each lane, the number of last digits that are zero, and the number of those that are one less than their prime.
#[derive(Default)]
struct Ends {
    zeros: [u32; LANES],
    largest: [u32; LANES],
}

impl Ends {
    /// Counts these digits and returns `true` if every lane has enough of either kind.
    fn suffice(&mut self, digits: &Residues, prime: u32) -> bool {
        let longer = |count: &mut u32, is_end: bool| *count = if is_end { *count + 1 } else { 0 };
        self.zeros.iter_mut().zip(digits).for_each(|(count, &digit)| longer(count, digit == 0));
        self.largest.iter_mut().zip(digits).for_each(|(count, &digit)| longer(count, digit == prime - 1));
        let both = self.zeros.iter().zip(&self.largest);
        both.fold(true, |all, (&zeros, &largest)| all & (zeros.max(largest) as usize >= CONFIRMING_PRIMES))
    }
}

impl RadixPrime {
    fn next_digits(&self, digits: &[Residues], residues: &Residues, factor: u32) -> Residues {
        dispatch_slices(NextDigits { prime: self, digits, residues, factor })
    }
}

/// The digits for one prime from the digits for the primes before it.
struct NextDigits<'a> {
    prime: &'a RadixPrime,
    digits: &'a [Residues],
    residues: &'a Residues,
    factor: u32,
}

impl Kernel for NextDigits<'_> {
    type Output = Residues;

    #[inline(always)]
    fn run(self) -> Residues {
        let field = self.prime.field;
        let mut sums: Sums = [0; LANES];
        for (digits, products) in self.digits.chunks(PRODUCTS).zip(self.prime.products.chunks(PRODUCTS)) {
            for sum in &mut sums {
                *sum = field.folded(*sum);
            }
            for (digits, &product) in digits.iter().zip(products) {
                for (sum, &digit) in sums.iter_mut().zip(digits) {
                    *sum += u64::from(digit) * u64::from(product);
                }
            }
        }
        let mut next = [0; LANES];
        for ((next, &residue), &sum) in next.iter_mut().zip(self.residues).zip(&sums) {
            let lower = field.reduced(field.folded(sum));
            let residue = field.representative(field.product(residue, self.factor));
            *next = field.product(field.difference(residue, lower), self.prime.inverse);
        }
        next
    }
}
