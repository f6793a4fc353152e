//! Fractions from their residues modulo many primes.

use dashu::base::{BitTest, Gcd, UnsignedAbs};
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
}

/// The numbers whose images are given: more primes are taken until the fractions found agree with fresh ones.
///
/// This is not a proof: a wrong answer would have to agree with two primes of 62 bits that had no part in it.
pub(crate) fn reconstruct<I: Images>(
    images: &mut I,
    primes: impl Iterator<Item = u64>,
) -> Result<Option<Vec<Rational>>, I::Error> {
    let mut residues = Residues::default();
    let (mut hint, mut due) = (0, 1);
    for prime in primes {
        let field = PrimeField::new(prime);
        let Some(image) = images.image(&field)? else { continue };
        residues.push(&field, &image);
        if residues.primes.len() < due + CONFIRMING_PRIMES {
            continue;
        }
        match residues.fractions(hint) {
            Ok(fractions) => return Ok(Some(fractions)),
            Err(unknown) => hint = unknown,
        }
        due += 1 + due / 4;
    }
    Ok(None)
}

/// The images so far: for each number its residues modulo each prime, or nothing while they are all zero.
#[derive(Debug, Default)]
struct Residues {
    primes: Vec<u64>,
    residues: Vec<Option<Vec<u64>>>,
}

impl Residues {
    fn push(&mut self, field: &PrimeField, image: &[u64]) {
        self.residues.resize(image.len(), None);
        for (list, &residue) in self.residues.iter_mut().zip(image) {
            if list.is_some() || residue != 0 {
                let list = list.get_or_insert_with(|| vec![0; self.primes.len()]);
                list.push(field.representative(residue));
            }
        }
        self.primes.push(field.prime());
    }

    /// All fractions, the one at `first` before the others; or the place of one that needs more primes.
    fn fractions(&self, first: usize) -> Result<Vec<Rational>, usize> {
        let used = self.primes.len() - CONFIRMING_PRIMES;
        let basis = Basis::new(&self.primes[..used]);
        let one = |at: usize, denominator: &mut UBig| {
            let Some(list) = &self.residues[at] else { return Ok(Rational::from(0)) };
            basis
                .fraction(&list[..used], denominator)
                .filter(|fraction| self.confirms(fraction, &list[used..], used))
                .ok_or(at)
        };
        if first < self.residues.len() {
            one(first, &mut UBig::from(1_u8))?;
        }
        let mut denominator = UBig::ONE;
        (0..self.residues.len()).map(|at| one(at, &mut denominator)).collect()
    }

    fn confirms(&self, fraction: &Rational, residues: &[u64], used: usize) -> bool {
        self.primes[used..].iter().zip(residues).all(|(&prime, &residue)| {
            let (numerator, denominator) = fraction.residues(prime);
            let product = u128::from(denominator) * u128::from(residue) % u128::from(prime);
            denominator != 0 && product == u128::from(numerator)
        })
    }
}

/// The Chinese remainder theorem for some primes.
#[derive(Debug)]
struct Basis {
    product: UBig,
    /// 1 modulo one of the primes and 0 modulo the others.
    idempotents: Vec<UBig>,
}

impl Basis {
    fn new(primes: &[u64]) -> Self {
        let product: UBig = primes.iter().map(|&prime| UBig::from(prime)).product();
        let idempotent = |&prime: &u64| {
            let others = &product / prime;
            let field = PrimeField::new(prime);
            let inverse = field.inverse(field.integer(&others % prime)).expect("the primes differ");
            others * field.representative(inverse)
        };
        Self { idempotents: primes.iter().map(idempotent).collect(), product }
    }

    /// The residue modulo the product of the primes.
    fn residue(&self, residues: &[u64]) -> UBig {
        let sum: UBig = self.idempotents.iter().zip(residues).map(|(e, &residue)| e * residue).sum();
        sum % &self.product
    }

    /// The fraction with these residues, if the primes are enough to tell. `common` is a denominator that many of
    /// the fractions are expected to divide; it is brought up to date.
    fn fraction(&self, residues: &[u64], common: &mut UBig) -> Option<Rational> {
        let residue = self.residue(residues);
        let numerator = self.balanced(&residue * &*common % &self.product);
        if numerator.bit_len() + common.bit_len() + SPARE_BITS < self.product.bit_len() {
            return Some(Rational::from_parts(numerator, common.clone()));
        }
        let fraction = self.by_division(residue)?;
        let (_, denominator) = fraction.parts();
        *common = lcm(common, denominator);
        Some(fraction)
    }

    fn balanced(&self, residue: UBig) -> IBig {
        let negative = &self.product - &residue;
        if residue <= negative { IBig::from(residue) } else { -IBig::from(negative) }
    }

    /// The step of Euclid's algorithm whose quotient stands out.
    ///
    /// Reference: M. Monagan, *Maximal quotient rational reconstruction*, ISSAC 2004, doi:10.1145/1005285.1005321.
    fn by_division(&self, residue: UBig) -> Option<Rational> {
        let (mut r, mut s) = ((self.product.clone(), residue), (IBig::ZERO, IBig::ONE));
        while !r.1.is_zero() {
            let bits = r.1.bit_len() + s.1.bit_len();
            if bits + SPARE_BITS < self.product.bit_len() {
                let denominator = s.1.clone().unsigned_abs();
                let sign = s.1.sign();
                return Some(Rational::from_parts(sign * IBig::from(r.1), denominator));
            }
            let (quotient, remainder) = (&r.0 / &r.1, &r.0 % &r.1);
            let next = &s.0 - IBig::from(quotient) * &s.1;
            r = (r.1, remainder);
            s = (s.1, next);
        }
        None
    }
}

fn lcm(a: &UBig, b: &UBig) -> UBig {
    a / a.gcd(b) * b
}

#[cfg(test)]
mod tests {
    use super::super::Ring;
    use super::super::prime_field::primes_with_roots;
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

    #[test]
    fn primes_in_a_denominator_are_passed_over() {
        let first = primes_with_roots(20).next().unwrap();
        let number = Rational::new(1, i64::try_from(first).unwrap()).unwrap();
        let found = reconstruct(&mut Known(vec![number.clone()], 0), primes_with_roots(20)).unwrap();
        assert_eq!(found, Some(vec![number]));
    }
}
