//! The ring of Laurent polynomials in given letters.

use super::super::ordered_map::ordered_map;
use std::collections::BTreeMap;
use std::sync::Arc;

use super::{HalfPowers, LaurentPolynomial, add_term};
use crate::algebra::{Function, Rational, Rationals, Ring};

/// The ring of all [`LaurentPolynomial`]s in some letters.
///
/// Quotients and powers with other than natural exponents exist for single terms, and for sums if the division has no remainder. Results with
/// more than ten thousand terms, or exponents beyond a million, are not kept: see [`LaurentPolynomial::is_beyond_limit`].
#[derive(Clone, Debug)]
pub struct LaurentPolynomials {
    letters: Arc<[String]>,
}

/// Maximum number of products of terms in one product of sums, which takes a tenth of a second; an order has hundreds of such products.
const MOST_PRODUCTS: usize = 100_000;
/// Maximum of the same number times the words of both factors' numbers, a few seconds: powers of sums with large numbers would take hours.
const MOST_WORD_PRODUCTS: usize = 1 << 31;
const MOST_TERMS: usize = 10_000;
const LARGEST_HALF_POWER: i64 = 2_000_000;

type Terms = BTreeMap<HalfPowers, Rational>;

/// The words of the longest number.
fn words(terms: &Terms) -> usize {
    terms.values().map(|factor| factor.bits() / 64 + 1).max().unwrap_or(0)
}

impl LaurentPolynomials {
    /// The ring in letters with these names.
    #[must_use]
    pub fn new(letters: Vec<String>) -> Self {
        Self { letters: letters.into() }
    }

    /// The names of the letters.
    #[must_use]
    pub fn letters(&self) -> &[String] {
        &self.letters
    }

    /// The letter with this index; zero beyond the last.
    #[must_use]
    pub fn letter(&self, number: usize) -> LaurentPolynomial {
        let mut powers = self.no_powers();
        match powers.get_mut(number) {
            Some(power) => *power = 2,
            None => return self.zero(),
        }
        self.term(powers, Rational::from(1))
    }

    #[doc(hidden)]
    pub fn term(&self, powers: HalfPowers, factor: Rational) -> LaurentPolynomial {
        let beyond = powers.iter().any(|power| power.abs() > LARGEST_HALF_POWER);
        let terms =
            if factor.is_zero() { BTreeMap::new() } else { ordered_map(std::iter::once((powers, factor))) };
        self.element((!beyond).then_some(terms))
    }

    /// The sum of terms, several of which may have the same powers.
    #[doc(hidden)]
    pub fn sum_of_terms(&self, terms: impl IntoIterator<Item = (HalfPowers, Rational)>) -> LaurentPolynomial {
        self.sum_of(&mut terms.into_iter())
    }

    // Compiled once for all iterators, as the next two are for all closures: it is the sorting of terms that has a size.
    fn sum_of(&self, terms: &mut dyn Iterator<Item = (HalfPowers, Rational)>) -> LaurentPolynomial {
        let mut sum = BTreeMap::new();
        for (powers, factor) in terms.filter(|(_, factor)| !factor.is_zero()) {
            if powers.iter().any(|power| power.abs() > LARGEST_HALF_POWER) {
                return self.element(None);
            }
            add_term(&mut sum, powers, factor);
        }
        self.element(Some(sum))
    }

    /// The sum of the terms for which `is_such` holds.
    #[doc(hidden)]
    pub fn part(&self, of: &LaurentPolynomial, is_such: impl Fn(&[i64]) -> bool) -> LaurentPolynomial {
        self.part_by(of, &is_such)
    }

    fn part_by(&self, of: &LaurentPolynomial, is_such: &dyn Fn(&[i64]) -> bool) -> LaurentPolynomial {
        let such = |terms: &BTreeMap<HalfPowers, Rational>| {
            let such = terms.iter().filter(|(powers, _)| is_such(powers));
            ordered_map(such.map(|(powers, factor)| (powers.clone(), factor.clone())))
        };
        self.element(of.terms.as_ref().map(such))
    }

    fn no_powers(&self) -> HalfPowers {
        vec![0; self.letters.len()].into()
    }

    fn element(&self, terms: Option<BTreeMap<HalfPowers, Rational>>) -> LaurentPolynomial {
        let terms = terms.filter(|terms| terms.len() <= MOST_TERMS);
        LaurentPolynomial { letters: Arc::clone(&self.letters), terms }
    }

    fn map(&self, a: &LaurentPolynomial, change: &dyn Fn(&Rational) -> Rational) -> LaurentPolynomial {
        let changed = |terms: &BTreeMap<HalfPowers, Rational>| {
            ordered_map(terms.iter().map(|(powers, factor)| (powers.clone(), change(factor))))
        };
        self.element(a.terms.as_ref().map(changed))
    }

    fn sum(
        &self,
        a: &LaurentPolynomial,
        b: &LaurentPolynomial,
        of: impl Fn(&Rational) -> Rational,
    ) -> LaurentPolynomial {
        let terms = a.terms.clone().zip(b.terms.as_ref()).map(|(mut sum, terms)| {
            for (powers, factor) in terms {
                add_term(&mut sum, powers.clone(), of(factor));
            }
            sum
        });
        self.element(terms)
    }

    /// A single term raised to a power, if the exponents of the result are multiples of one half.
    fn power_of_term(
        &self,
        (powers, factor): (&HalfPowers, &Rational),
        exponent: &Rational,
    ) -> Option<LaurentPolynomial> {
        let raised = powers.iter().map(|&power| {
            let raised = Rationals.multiply(&Rational::from(power), exponent);
            let size = raised.magnitude().to_natural().and_then(|size| i64::try_from(size).ok())?;
            Some(if raised.is_negative() { -size } else { size })
        });
        let raised: HalfPowers = raised.collect::<Option<Vec<_>>>()?.into();
        Some(self.term(raised, Rationals.power(factor, exponent)?))
    }

    /// Long division, beginning at the last terms, until the remainder is smaller than the divisor.
    fn divide_exactly(
        &self,
        a: &LaurentPolynomial,
        divisor: &LaurentPolynomial,
    ) -> Option<LaurentPolynomial> {
        let (leading, factor) = divisor.terms.as_ref()?.last_key_value()?;
        let (mut rest, mut quotient) = (a.clone(), self.zero());
        // Each step removes the last term and adds only terms that come before it.
        for _ in 0..MOST_TERMS {
            let Some((powers, above)) = rest.terms.as_ref()?.last_key_value() else { return Some(quotient) };
            let powers = powers.iter().zip(leading.iter()).map(|(a, b)| a - b).collect();
            let term = self.term(powers, above.checked_div(factor)?);
            if !self.may_divide(&term, a, divisor) {
                return None;
            }
            rest = self.subtract(&rest, &self.multiply(&term, divisor));
            quotient = self.add(&quotient, &term);
        }
        None
    }

    /// Returns `false` if numerator and divisor exclude a power in this term of the quotient: for each letter, the extreme powers of a product
    /// are the sums of those of its factors.
    fn may_divide(
        &self,
        term: &LaurentPolynomial,
        a: &LaurentPolynomial,
        divisor: &LaurentPolynomial,
    ) -> bool {
        let Some((powers, _)) = term.as_single_term() else { return false };
        powers.iter().enumerate().all(|(letter, power)| {
            let (low, high) = extremes(a, letter);
            let (low_divisor, high_divisor) = extremes(divisor, letter);
            (low - low_divisor..=high - high_divisor).contains(power)
        })
    }
}

/// The smallest and the largest power of a letter.
fn extremes(of: &LaurentPolynomial, letter: usize) -> (i64, i64) {
    let powers = || of.half_powers().map(|(powers, _)| powers[letter]);
    (powers().min().unwrap_or(0), powers().max().unwrap_or(0))
}

impl Ring for LaurentPolynomials {
    type Element = LaurentPolynomial;

    fn zero(&self) -> LaurentPolynomial {
        self.element(Some(BTreeMap::new()))
    }

    fn is_zero(&self, a: &LaurentPolynomial) -> bool {
        a.is_zero()
    }

    fn rational(&self, value: &Rational) -> Option<LaurentPolynomial> {
        Some(self.term(self.no_powers(), value.clone()))
    }

    fn add(&self, a: &LaurentPolynomial, b: &LaurentPolynomial) -> LaurentPolynomial {
        self.sum(a, b, Clone::clone)
    }

    fn subtract(&self, a: &LaurentPolynomial, b: &LaurentPolynomial) -> LaurentPolynomial {
        self.sum(a, b, |factor| Rationals.negate(factor))
    }

    fn negate(&self, a: &LaurentPolynomial) -> LaurentPolynomial {
        self.map(a, &|factor| Rationals.negate(factor))
    }

    fn multiply(&self, a: &LaurentPolynomial, b: &LaurentPolynomial) -> LaurentPolynomial {
        let pair = a.terms.as_ref().zip(b.terms.as_ref());
        let is_short = |(a, b): &(&Terms, &Terms)| {
            let products = a.len().saturating_mul(b.len());
            let in_words = products.saturating_mul(words(a)).saturating_mul(words(b));
            products <= MOST_PRODUCTS && in_words <= MOST_WORD_PRODUCTS
        };
        let Some((a, b)) = pair.filter(is_short) else {
            return self.element(None);
        };
        let mut sum = BTreeMap::new();
        for (x, p) in a {
            for (y, q) in b {
                let powers: HalfPowers = x.iter().zip(y.iter()).map(|(i, j)| i + j).collect();
                if powers.iter().any(|power| power.abs() > LARGEST_HALF_POWER) {
                    return self.element(None);
                }
                add_term(&mut sum, powers, Rationals.multiply(p, q));
            }
        }
        self.element(Some(sum))
    }

    fn times_integer(&self, a: &LaurentPolynomial, factor: i64) -> LaurentPolynomial {
        if factor == 0 {
            return self.zero();
        }
        self.map(a, &|coefficient| Rationals.times_integer(coefficient, factor))
    }

    fn divide(&self, a: &LaurentPolynomial, divisor: &LaurentPolynomial) -> Option<LaurentPolynomial> {
        match divisor.as_single_term() {
            Some(term) => Some(self.multiply(a, &self.power_of_term(term, &Rational::from(-1))?)),
            None => self.divide_exactly(a, divisor),
        }
    }

    fn over_integer(&self, a: &LaurentPolynomial, divisor: u64) -> Option<LaurentPolynomial> {
        let inverse = Rationals.over_integer(&Rational::from(1), divisor)?;
        Some(self.map(a, &|factor| Rationals.multiply(factor, &inverse)))
    }

    /// Values at constants, if the value is a fraction; for single terms also the square root.
    fn value(&self, function: Function, at: &LaurentPolynomial) -> Option<LaurentPolynomial> {
        if function == Function::Sqrt {
            return self.power(at, &Rational::new(1, 2)?);
        }
        self.rational(&Rationals.value(function, &at.to_constant()?)?)
    }

    fn power(&self, a: &LaurentPolynomial, exponent: &Rational) -> Option<LaurentPolynomial> {
        if let Some(term) = a.as_single_term() {
            return self.power_of_term(term, exponent);
        }
        if a.is_zero() {
            return self.rational(&Rationals.power(&Rational::from(0), exponent)?);
        }
        // As a rule the number of terms doubles until the limit is reached.
        let (one, times) = (self.rational(&Rational::from(1))?, exponent.to_natural()?);
        let product = |power: LaurentPolynomial, _| {
            let next = self.multiply(&power, a);
            if next.is_beyond_limit() { Err(next) } else { Ok(next) }
        };
        Some(
            (0..times.min(u64::try_from(MOST_TERMS).ok()?))
                .try_fold(one, product)
                .unwrap_or_else(|beyond| beyond),
        )
    }

    fn pi(&self) -> Option<LaurentPolynomial> {
        None
    }
}
