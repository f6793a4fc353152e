//! Integers from their residues modulo many primes, several integers at once.

use dashu_int::{IBig, UBig};

use super::PrimeField;
use super::prime_fields::{LANES, PRODUCTS, Residues, Sums};
use libration_kernels::dispatch::{Kernel, dispatch_slices};

/// Primes that an answer must agree with although it could be told without them.
pub(super) const CONFIRMING_PRIMES: usize = 5;

/// Numbers modulo the product of some primes, in the form d₀ + d₁p₀ + d₂p₀p₁ + …, found digit by digit in machine
/// words. A small integer has few digits, and a small negative one ends in digits p − 1.
///
/// Reference: H. L. Garner, *The residue number system*, IRE Trans. Electron. Comput. EC-8, 140 (1959).
#[derive(Clone, Debug, Default)]
pub(super) struct MixedRadix {
    places: Vec<Place>,
}

/// A prime, with the products of those before it.
#[derive(Clone, Debug)]
struct Place {
    field: PrimeField,
    /// p₀⋯pⱼ₋₁ modulo this prime, by j, in Montgomery form.
    products: Vec<u32>,
    /// The inverse of the product of all before it.
    inverse: u32,
}

impl MixedRadix {
    /// Takes in another prime.
    pub(super) fn push(&mut self, prime: u32) {
        let field = PrimeField::new(prime);
        let mut product = field.unit();
        let mut products = Vec::with_capacity(self.places.len());
        for place in &self.places {
            products.push(product);
            product = field.product(product, field.integer(place.field.prime()));
        }
        let inverse = field.inverse(product).expect("the primes differ");
        self.places.push(Place { field, products, inverse });
    }

    pub(super) fn len(&self) -> usize {
        self.places.len()
    }

    /// An integer modulo each prime, in Montgomery form.
    pub(super) fn residues(&self, value: &UBig) -> Vec<u32> {
        self.places.iter().map(|place| place.field.integer(value % place.field.prime())).collect()
    }

    /// The residues of a product.
    pub(super) fn products(&self, a: &[u32], b: &[u32]) -> Vec<u32> {
        self.places.iter().zip(a.iter().zip(b)).map(|(place, (&a, &b))| place.field.product(a, b)).collect()
    }

    /// The digits of eight numbers times a factor, by their residues modulo the k-th prime and those of the factor: as many digits as show
    /// that all are small integers, or all of them.
    pub(super) fn digits(&self, residues: impl Fn(usize) -> Residues, factor: &[u32]) -> Vec<Residues> {
        let mut digits: Vec<Residues> = Vec::with_capacity(self.places.len());
        let mut ends = Ends::default();
        for (k, place) in self.places.iter().enumerate() {
            let next = place.next_digits(&digits, &residues(k), factor[k]);
            digits.push(next);
            if ends.suffice(&next, place.field.prime()) {
                break;
            }
        }
        digits
    }

    /// The integer of a lane, if its last digits say that it is small.
    pub(super) fn small_integer(&self, digits: &[Residues], lane: usize) -> Option<IBig> {
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
        let primes = self.places[..digits.len()].iter().map(|place| u64::from(place.field.prime()));
        let mut pairs = digits.map(u64::from).zip(primes).rev();
        // Two digits at a time make a step of a machine word; an odd one is alone at the end.
        while let Some((mut digit, mut radix)) = pairs.next() {
            if let Some((lower, prime)) = pairs.next() {
                (digit, radix) = (digit * prime + lower, radix * prime);
            }
            multiply_add(&mut words, radix, digit);
        }
        from_words(&words)
    }

    /// The product of the first primes.
    pub(super) fn modulus(&self, primes: usize) -> UBig {
        let mut words = vec![1];
        for place in &self.places[..primes] {
            multiply_add(&mut words, u64::from(place.field.prime()), 0);
        }
        from_words(&words)
    }
}

/// A number in words, lowest first, becomes its product with `factor` and `summand` more.
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

/// How many of the last digits of each lane are all zero, or all one less than their prime.
#[derive(Default)]
struct Ends {
    zeros: [u32; LANES],
    largest: [u32; LANES],
}

impl Ends {
    /// Whether all lanes have so many after these digits.
    fn suffice(&mut self, digits: &Residues, prime: u32) -> bool {
        let longer = |count: &mut u32, is_end: bool| *count = if is_end { *count + 1 } else { 0 };
        self.zeros.iter_mut().zip(digits).for_each(|(count, &digit)| longer(count, digit == 0));
        self.largest.iter_mut().zip(digits).for_each(|(count, &digit)| longer(count, digit == prime - 1));
        let both = self.zeros.iter().zip(&self.largest);
        both.fold(true, |all, (&zeros, &largest)| all & (zeros.max(largest) as usize >= CONFIRMING_PRIMES))
    }
}

impl Place {
    fn next_digits(&self, digits: &[Residues], residues: &Residues, factor: u32) -> Residues {
        dispatch_slices(NextDigits { place: self, digits, residues, factor })
    }
}

/// The digits of one prime from those of the primes before it.
struct NextDigits<'a> {
    place: &'a Place,
    digits: &'a [Residues],
    residues: &'a Residues,
    factor: u32,
}

impl Kernel for NextDigits<'_> {
    type Output = Residues;

    #[inline(always)]
    fn run(self) -> Residues {
        let field = self.place.field;
        let mut sums: Sums = [0; LANES];
        for (digits, products) in self.digits.chunks(PRODUCTS).zip(self.place.products.chunks(PRODUCTS)) {
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
            let known = field.reduced(field.folded(sum));
            let residue = field.representative(field.product(residue, self.factor));
            *next = field.product(field.difference(residue, known), self.place.inverse);
        }
        next
    }
}

#[cfg(test)]
mod tests {
    use super::super::primes_with_roots;
    use super::*;

    fn radix(primes: usize) -> MixedRadix {
        let mut radix = MixedRadix::default();
        primes_with_roots(12).take(primes).for_each(|prime| radix.push(prime));
        radix
    }

    #[test]
    fn integers_of_either_sign_come_back_until_the_primes_run_out() {
        let radix = radix(12);
        let one = radix.residues(&UBig::ONE);
        let negative = |value: &UBig| {
            let residues = radix.residues(value).into_iter().zip(&radix.places);
            residues.map(|(a, place)| place.field.difference(0, a)).collect::<Vec<u32>>()
        };
        for power in [0, 1, 29, 30, 31, 59, 60, 61, 180, 206] {
            for value in [(UBig::ONE << power) - 1_u8, UBig::ONE << power, (UBig::ONE << power) + 1_u8] {
                let (plus, minus) = (radix.residues(&value), negative(&value));
                let digits = radix
                    .digits(|k| std::array::from_fn(|lane| if lane < 5 { plus[k] } else { minus[k] }), &one);
                assert_eq!(radix.small_integer(&digits, 4), Some(IBig::from(value.clone())));
                assert_eq!(radix.small_integer(&digits, 5), Some(-IBig::from(value.clone())));
                let needed = (0..8).find(|&primes| radix.modulus(primes) > value).unwrap();
                assert_eq!(digits.len(), needed + CONFIRMING_PRIMES);
            }
        }
        // Seven primes are left when five confirm.
        let found = |value: &UBig| {
            let residues = radix.residues(value);
            radix.small_integer(&radix.digits(|k| [residues[k]; LANES], &one), 0)
        };
        let (less, more) = (radix.modulus(7) * 2_u8 / 3_u8, radix.modulus(7) * 4_u8 / 3_u8);
        assert_eq!(found(&less), Some(IBig::from(less.clone())));
        assert_eq!((found(&more), found(&(UBig::ONE << 300))), (None, None));
    }

    #[test]
    fn digits_are_those_of_the_product_with_the_factor() {
        let radix = radix(9);
        let (third, factor) = (UBig::from(12_345_678_901_234_567_u64), UBig::from(3_u8));
        let thirds: Vec<u32> = radix
            .residues(&third)
            .iter()
            .zip(&radix.places)
            .map(|(&a, place)| place.field.product(a, place.field.inverse(place.field.integer(3)).unwrap()))
            .collect();
        let digits = radix.digits(|k| [thirds[k]; LANES], &radix.residues(&factor));
        assert_eq!(radix.small_integer(&digits, 7), Some(IBig::from(third)));
    }
}
