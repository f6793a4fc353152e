//! Fractions from their residues modulo many primes.

use dashu::base::{BitTest, DivRem, Gcd, UnsignedAbs};
use dashu::integer::{IBig, UBig};

use super::{PrimeField, Rational};

/// A fraction is believed when its residue fits it with this many bits to spare.
const SPARE_BITS: usize = 48;

/// Fresh primes that must confirm the answer.
const CONFIRMING_PRIMES: usize = 2;

/// A computation that can be done modulo any prime but a few bad ones.
pub(crate) trait Images {
    /// Why it may end without an answer.
    type Error;

    /// The numbers wanted, as residues of `field`; `None` modulo a bad prime.
    fn image(&mut self, field: &PrimeField) -> Result<Option<Vec<u64>>, Self::Error>;

    /// Asked while fractions are put together from so many primes.
    fn go_on(&mut self, _primes: usize) -> Result<(), Self::Error> {
        Ok(())
    }
}

/// A computation that has come to an early end, with the residues that were found.
#[derive(Debug)]
pub(crate) struct Stopped<E> {
    pub(crate) error: E,
    pub(crate) residues: Residues,
}

/// The numbers whose images are given: more primes are taken until the fractions found agree with fresh ones.
///
/// This is not a proof: a wrong answer would have to agree with two primes of 62 bits that had no part in it.
pub(crate) fn reconstruct<I: Images>(
    images: &mut I,
    primes: impl Iterator<Item = u64>,
) -> Result<Option<Vec<Rational>>, Stopped<I::Error>> {
    let mut residues = Residues::default();
    let (mut hint, mut due) = (0, 1);
    for prime in primes {
        let field = PrimeField::new(prime);
        let image = match images.image(&field) {
            Ok(Some(image)) => image,
            Ok(None) => continue,
            Err(error) => return Err(Stopped { error, residues }),
        };
        residues.push(&field, &image);
        if residues.fields.len() < due + CONFIRMING_PRIMES {
            continue;
        }
        match residues.fractions(hint, images) {
            Ok(Ok(fractions)) => return Ok(Some(fractions)),
            Ok(Err(unknown)) => hint = unknown,
            Err(error) => return Err(Stopped { error, residues }),
        }
        due += 1 + due / 4;
    }
    Ok(None)
}

/// The images so far: for each number its residues modulo each prime, or nothing while they are all zero.
#[derive(Debug, Default)]
pub(crate) struct Residues {
    fields: Vec<PrimeField>,
    residues: Vec<Option<Vec<u64>>>,
}

impl Residues {
    fn push(&mut self, field: &PrimeField, image: &[u64]) {
        self.residues.resize(image.len(), None);
        for (list, &residue) in self.residues.iter_mut().zip(image) {
            if list.is_some() || residue != 0 {
                let list = list.get_or_insert_with(|| vec![0; self.fields.len()]);
                list.push(residue);
            }
        }
        self.fields.push(field.clone());
    }

    /// All fractions, the one at `first` before the others; or the place of one that needs more primes.
    fn fractions<I: Images>(
        &self,
        first: usize,
        images: &mut I,
    ) -> Result<Result<Vec<Rational>, usize>, I::Error> {
        let radix = MixedRadix::new(&self.fields);
        if first < self.residues.len()
            && self.fraction(first, &radix, &mut radix.denominator(UBig::ONE)).is_none()
        {
            return Ok(Err(first));
        }
        // Series end in their largest denominators, which the coefficients before them divide.
        let mut common = radix.denominator(UBig::ONE);
        let mut fractions = vec![];
        for at in (0..self.residues.len()).rev() {
            images.go_on(self.fields.len())?;
            match self.fraction(at, &radix, &mut common) {
                Some(fraction) => fractions.push(fraction),
                None => return Ok(Err(at)),
            }
        }
        fractions.reverse();
        Ok(Ok(fractions))
    }

    fn fraction(&self, at: usize, radix: &MixedRadix<'_>, common: &mut Denominator) -> Option<Rational> {
        match self.residues.get(at)? {
            None => Some(Rational::from(0)),
            Some(list) => radix.fraction(list, common),
        }
    }

    /// The numbers of the lowest orders that the primes suffice to tell and to confirm, those of higher ones being zero, and
    /// the highest of these orders. Each number has its order in `orders`.
    pub(crate) fn of_low_orders(&self, orders: &[usize]) -> Option<(Vec<Rational>, usize)> {
        let radix = MixedRadix::new(&self.fields);
        let mut by_order: Vec<usize> = (0..orders.len()).collect();
        by_order.sort_by_key(|&at| orders[at]);
        let mut known = vec![Rational::from(0); orders.len()];
        let mut common = radix.denominator(UBig::ONE);
        for at in by_order {
            match self.fraction(at, &radix, &mut common) {
                Some(fraction) => known[at] = fraction,
                None => return orders[at].checked_sub(1).map(|complete| (known, complete)),
            }
        }
        Some((known, orders.iter().copied().max()?))
    }
}

/// Numbers modulo the product of some primes, in the form d₀ + d₁p₀ + d₂p₀p₁ + …, found digit by digit in machine
/// words. A small integer has few digits, and a small negative one ends in digits p − 1.
///
/// Reference: H. L. Garner, *The residue number system*, IRE Trans. Electron. Comput. EC-8, 140 (1959).
#[derive(Debug)]
struct MixedRadix<'a> {
    fields: &'a [PrimeField],
    /// p₀⋯pⱼ₋₁ modulo pₖ, by k and j ≤ k, in Montgomery form.
    products: Vec<Vec<u64>>,
    /// The inverse of the last of these.
    inverses: Vec<u64>,
}

/// A denominator, with its residues.
#[derive(Debug)]
struct Denominator {
    value: UBig,
    residues: Vec<u64>,
}

impl<'a> MixedRadix<'a> {
    fn new(fields: &'a [PrimeField]) -> Self {
        let products: Vec<Vec<u64>> = fields
            .iter()
            .enumerate()
            .map(|(k, field)| {
                let mut products = vec![field.unit()];
                for other in &fields[..k] {
                    products.push(field.product(products[products.len() - 1], field.integer(other.prime())));
                }
                products
            })
            .collect();
        let inverse = |(field, products): (&PrimeField, &Vec<u64>)| {
            products.last().and_then(|&product| field.inverse(product)).expect("the primes differ")
        };
        let inverses = fields.iter().zip(&products).map(inverse).collect();
        Self { fields, products, inverses }
    }

    fn denominator(&self, value: UBig) -> Denominator {
        let residues = self.fields.iter().map(|field| field.integer(&value % field.prime())).collect();
        Denominator { value, residues }
    }

    /// The digits of the number with these residues times a denominator.
    fn digits(&self, residues: &[u64], denominator: &Denominator) -> Vec<u64> {
        let mut digits: Vec<u64> = Vec::with_capacity(self.fields.len());
        for (k, field) in self.fields.iter().enumerate() {
            let residue = field.representative(field.product(residues[k], denominator.residues[k]));
            let known = field.inner_product(digits.iter().copied().zip(self.products[k].iter().copied()));
            digits.push(field.product(field.difference(residue, known), self.inverses[k]));
        }
        digits
    }

    /// The integer with these digits, if the last of them say that it is small.
    fn small_integer(&self, digits: &[u64]) -> Option<IBig> {
        let negative = *digits.last()? != 0;
        let is_end =
            |(&digit, field): (&u64, &PrimeField)| digit == if negative { field.prime() - 1 } else { 0 };
        let ends = digits.iter().zip(self.fields).rev().take_while(|&pair| is_end(pair)).count();
        if ends < CONFIRMING_PRIMES {
            return None;
        }
        let value = self.value(&digits[..digits.len() - ends]);
        if !negative {
            return Some(IBig::from(value));
        }
        let kept = &self.fields[..digits.len() - ends];
        let product: UBig = kept.iter().map(|field| UBig::from(field.prime())).product();
        Some(IBig::from(value) - IBig::from(product))
    }

    fn value(&self, digits: &[u64]) -> UBig {
        let pairs = digits.iter().zip(self.fields).rev();
        pairs.fold(UBig::ZERO, |value, (&digit, field)| value * field.prime() + digit)
    }

    /// The fraction with these residues, if the primes are enough to tell. `common` is a denominator that many of
    /// the fractions are expected to divide; it is brought up to date.
    fn fraction(&self, residues: &[u64], common: &mut Denominator) -> Option<Rational> {
        if let Some(numerator) = self.small_integer(&self.digits(residues, common)) {
            return Some(Rational::from_parts(numerator, common.value.clone()));
        }
        let one = self.denominator(UBig::ONE);
        let used = self.fields.len().checked_sub(CONFIRMING_PRIMES)?;
        let digits = self.digits(residues, &one);
        let product: UBig = self.fields[..used].iter().map(|field| UBig::from(field.prime())).product();
        let fraction = by_division(&product, self.value(&digits[..used]))?;
        let own = self.denominator(fraction.parts().1.clone());
        // The primes that had no part in it confirm it.
        self.small_integer(&self.digits(residues, &own)).filter(|n| n == fraction.parts().0)?;
        let both = lcm(&common.value, &own.value);
        *common = if 2 * both.bit_len() < product.bit_len() { self.denominator(both) } else { own };
        Some(fraction)
    }
}

/// The fraction with this residue modulo a product of primes, if it stands out: the step of Euclid's algorithm
/// after which numerator and denominator together are much smaller than the product.
///
/// Reference: M. Monagan, *Maximal quotient rational reconstruction*, ISSAC 2004, doi:10.1145/1005285.1005321.
fn by_division(product: &UBig, residue: UBig) -> Option<Rational> {
    let (mut r, mut s) = ((product.clone(), residue), (IBig::ZERO, IBig::ONE));
    while !r.1.is_zero() {
        if r.1.bit_len() + s.1.bit_len() + SPARE_BITS < product.bit_len() {
            let sign = s.1.sign();
            return Some(Rational::from_parts(sign * IBig::from(r.1), s.1.unsigned_abs()));
        }
        let (quotient, remainder) = (&r.0).div_rem(&r.1);
        let next = &s.0 - IBig::from(quotient) * &s.1;
        r = (r.1, remainder);
        s = (s.1, next);
    }
    None
}

fn lcm(a: &UBig, b: &UBig) -> UBig {
    a / a.gcd(b) * b
}

#[cfg(test)]
mod tests {
    use super::super::Ring;
    use super::super::primes_with_roots;
    use super::*;

    struct Known(Vec<Rational>, usize);

    impl Images for Known {
        type Error = ();

        fn image(&mut self, field: &PrimeField) -> Result<Option<Vec<u64>>, ()> {
            self.1 += 1;
            Ok(self.0.iter().map(|number| field.rational(number)).collect())
        }
    }

    #[test]
    fn fractions_of_any_size_come_back() {
        let power = |base: i64, n: isize| Rational::new(base, 7).unwrap().integer_power(n).unwrap();
        let numbers =
            vec![Rational::from(0), power(-3, 5), power(22, 300), power(5, -211), Rational::from(-1)];
        let mut known = Known(numbers.clone(), 0);
        let found = reconstruct(&mut known, primes_with_roots(20)).unwrap().unwrap();
        assert_eq!(found, numbers);
        // 300·(log₂ 22 + log₂ 7) bits are 2180, 36 primes.
        assert!(known.1 >= 36 && known.1 < 55, "{}", known.1);
    }

    /// The powers of 22/7 with the exponent for their order, broken off after so many primes.
    struct BrokenOff(Vec<Rational>, usize);

    impl Images for BrokenOff {
        type Error = ();

        fn image(&mut self, field: &PrimeField) -> Result<Option<Vec<u64>>, ()> {
            self.1 = self.1.checked_sub(1).ok_or(())?;
            Ok(self.0.iter().map(|number| field.rational(number)).collect())
        }
    }

    #[test]
    fn low_orders_are_certain_before_high_ones() {
        let power = |n: isize| Rational::new(22, 7).unwrap().integer_power(n).unwrap();
        let numbers: Vec<Rational> = (0..300).map(power).collect();
        let orders: Vec<usize> = (0..300).collect();
        let mut before = 0;
        for primes in [5, 10, 20, 30] {
            let stopped =
                reconstruct(&mut BrokenOff(numbers.clone(), primes), primes_with_roots(20)).unwrap_err();
            let (known, complete) = stopped.residues.of_low_orders(&orders).unwrap();
            assert_eq!(known[..=complete], numbers[..=complete]);
            // A power has 7.3 bits an order, a prime 62 bits, two primes confirm and 48 bits are spare.
            assert!(
                complete > before && complete > 7 * (primes - 3) && complete < 9 * primes,
                "{primes}: {complete}"
            );
            before = complete;
        }
        let stopped = reconstruct(&mut BrokenOff(numbers, 1), primes_with_roots(20)).unwrap_err();
        assert!(stopped.residues.of_low_orders(&orders).is_none());
    }

    #[test]
    fn primes_in_a_denominator_are_passed_over() {
        let first = primes_with_roots(20).next().unwrap();
        let number = Rational::new(1, i64::try_from(first).unwrap()).unwrap();
        let found = reconstruct(&mut Known(vec![number.clone()], 0), primes_with_roots(20)).unwrap();
        assert_eq!(found, Some(vec![number]));
    }
}
