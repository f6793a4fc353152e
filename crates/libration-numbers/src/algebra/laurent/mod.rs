//! Sums of products of powers of symbols, including negative powers and square roots.
//!
//! # Method
//! Coefficients are plain fractions. In units of ω0 a coefficient of order n in the mixed quadratic–cubic oscillator has n/2 terms, since each
//! force has a weight, so that arithmetic modulo primes would save nothing. Exponents are multiples of one half, so that roots of single symbols
//! are included.

mod ring;
mod text;

use super::in_order::InOrder;
use std::collections::BTreeMap;
use std::sync::Arc;

use super::{Rational, Rationals, Ring};

pub use ring::LaurentPolynomials;

/// An exact sum of products of powers of letters with rational factors: `3*b/(8*w^2) - 5*a^2/(12*w^4)`. Exponents are multiples of one half; a
/// letter with an odd multiple stands for a positive number.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::algebra::{LaurentPolynomials, Ring};
/// let ring = LaurentPolynomials::new(vec!["a".into(), "w".into()]);
/// let (a, w) = (ring.letter(0), ring.letter(1));
/// let quotient = ring.divide(&ring.add(&a, &w), &ring.multiply(&w, &w)).ok_or("no quotient")?;
/// assert_eq!(quotient.to_string(), "1/w + a/w^2");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LaurentPolynomial {
    letters: Arc<[String]>,
    /// Terms with nonzero coefficients. `None` if the sum has grown beyond a limit, and for every result computed from such a sum.
    terms: Option<BTreeMap<HalfPowers, Rational>>,
}

/// Twice the exponent of each letter.
pub(crate) type HalfPowers = Box<[i64]>;

/// A power of a letter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LetterPower<'a> {
    /// The letter.
    pub letter: &'a str,
    /// The exponent, a nonzero multiple of one half.
    pub exponent: Rational,
}

impl LaurentPolynomial {
    /// The letters that may occur.
    #[must_use]
    pub fn letters(&self) -> &[String] {
        &self.letters
    }

    /// Returns `true` if the polynomial has no terms.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.terms.as_ref().is_some_and(BTreeMap::is_empty)
    }

    /// The value of a constant polynomial; `None` if a letter occurs.
    #[must_use]
    pub fn to_constant(&self) -> Option<Rational> {
        match self.as_single_term() {
            Some((powers, factor)) => powers.iter().all(|&power| power == 0).then(|| factor.clone()),
            None => self.is_zero().then(|| Rational::from(0)),
        }
    }

    /// The terms: each with its rational factor and its powers, in the order of the letters. Terms with fewer letters in the numerator come
    /// first, among these the ones with larger powers of the first letter.
    pub fn terms(&self) -> impl Iterator<Item = (&Rational, Vec<LetterPower<'_>>)> {
        let above = |powers: &HalfPowers| powers.iter().filter(|power| **power > 0).sum::<i64>();
        let mut terms: Vec<_> = self.half_powers().collect();
        terms.put_in_order(|(a, _), (b, _)| above(a).cmp(&above(b)).then_with(|| b.cmp(a)));
        terms.into_iter().map(|(powers, factor)| {
            let present = self.letters.iter().zip(powers.iter()).filter(|(_, power)| **power != 0);
            let exponent = |power: i64| Rational::new(power, 2).expect("two is not zero");
            let powers = present.map(|(letter, &power)| LetterPower { letter, exponent: exponent(power) });
            (factor, powers.collect())
        })
    }

    /// The letters that occur, in their order.
    #[must_use]
    pub fn letters_present(&self) -> Vec<&str> {
        let present = |letter: &usize| self.half_powers().any(|(powers, _)| powers[*letter] != 0);
        (0..self.letters.len()).filter(present).map(|letter| self.letters[letter].as_str()).collect()
    }

    /// Returns `true` if a letter occurs under a root.
    #[must_use]
    pub fn has_roots(&self) -> bool {
        self.half_powers().any(|(powers, _)| powers.iter().any(|power| power % 2 != 0))
    }

    /// Returns `true` if the polynomial has grown beyond the limit of the ring, so that its terms are not known.
    #[must_use]
    pub fn is_beyond_limit(&self) -> bool {
        self.terms.is_none()
    }

    /// The value for these values of powers of letters; `power` receives the index of the letter and twice the exponent.
    #[doc(hidden)]
    pub fn value(&self, power: impl Fn(usize, i64) -> Option<Rational>) -> Option<Rational> {
        self.terms.as_ref()?.iter().try_fold(Rational::from(0), |sum, (powers, factor)| {
            let present = powers.iter().enumerate().filter(|(_, half_power)| **half_power != 0);
            let mut powers = present.map(|(letter, half_power)| power(letter, *half_power));
            let term =
                powers.try_fold(factor.clone(), |term, power| Some(Rationals.multiply(&term, &power?)))?;
            Some(Rationals.add(&sum, &term))
        })
    }

    /// Twice the largest absolute value of an exponent.
    #[doc(hidden)]
    pub fn largest_half_power(&self) -> i64 {
        self.half_powers().flat_map(|(powers, _)| powers.iter()).map(|power| power.abs()).max().unwrap_or(0)
    }

    #[doc(hidden)]
    pub fn half_powers(&self) -> impl Iterator<Item = (&HalfPowers, &Rational)> {
        self.terms.iter().flatten()
    }

    /// The term, if it is the only one.
    #[doc(hidden)]
    pub fn as_single_term(&self) -> Option<(&HalfPowers, &Rational)> {
        let mut terms = self.half_powers();
        terms.next().filter(|_| self.terms.as_ref().is_some_and(|terms| terms.len() == 1))
    }
}

fn add_term(terms: &mut BTreeMap<HalfPowers, Rational>, powers: HalfPowers, factor: Rational) {
    match terms.remove(&powers) {
        None => {
            terms.insert(powers, factor);
        }
        Some(present) => {
            let sum = Rationals.add(&present, &factor);
            if !sum.is_zero() {
                terms.insert(powers, sum);
            }
        }
    }
}
