//! Operations on polynomials for the expansion of formulas, in addition to arithmetic.

use super::{Monomial, Polynomial};
use crate::algebra::{Rational, Rationals, Ring};

impl<V: Ord + Clone> Polynomial<V> {
    /// Cost of a product or sum with this polynomial, per term of the other operand: one, and more for long coefficients.
    pub(crate) fn cost(&self) -> usize {
        const BITS: usize = 256;
        self.terms.values().map(|coefficient| 1 + coefficient.bits() / BITS).sum()
    }

    /// The coefficient of the last monomial; `None` for zero.
    pub(crate) fn leading(&self) -> Option<&Rational> {
        self.terms.values().next_back()
    }

    /// The sum, by reference.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        for (monomial, coefficient) in &other.terms {
            sum.add_term(monomial.clone(), coefficient.clone());
        }
        sum
    }

    /// The product; `None` for exponents beyond `u32`.
    pub(crate) fn checked_times(&self, other: &Self) -> Option<Self> {
        let mut product = Self::default();
        for (a, p) in &self.terms {
            for (b, q) in &other.terms {
                product.add_term(a.times(b)?, Rationals.multiply(p, q));
            }
        }
        Some(product)
    }

    /// The power of zero or of one term with coefficient ±1; `None` for any other polynomial, and `Some(None)` for exponents beyond `u32`.
    pub(crate) fn power_of_one_term(&self, times: u32) -> Option<Option<Self>> {
        if self.is_zero() {
            return Some(Some(Self::from_number(Rational::from(i64::from(times == 0)))));
        }
        let (monomial, coefficient) = self.terms.first_key_value().filter(|_| self.terms.len() == 1)?;
        if coefficient.magnitude() != Rational::from(1) {
            return None;
        }
        let sign = if times.is_multiple_of(2) { Rational::from(1) } else { coefficient.clone() };
        Some(monomial.power(times).map(|monomial| Self::term(monomial, sign)))
    }

    /// Returns `true` if a variable of this kind occurs.
    pub(crate) fn has(&self, kind: impl Fn(&V) -> bool) -> bool {
        self.terms.keys().flat_map(Monomial::factors).any(|(variable, _)| kind(variable))
    }

    /// The total degree in the variables of this kind.
    pub(crate) fn degree_in_kind(&self, kind: impl Fn(&V) -> bool) -> u32 {
        self.terms.keys().map(|monomial| monomial.degree_in(&kind)).max().unwrap_or(0)
    }

    /// The coefficients, constant term first, of a polynomial in one variable; `None` if other variables occur or the degree is above 1000.
    pub(crate) fn coefficients_in(&self, variable: &V) -> Option<Vec<Rational>> {
        const LARGEST_DEGREE: u32 = 1000;
        let degree = self.degree();
        if degree > LARGEST_DEGREE || self.has(|other| other != variable) {
            return None;
        }
        let mut coefficients = vec![Rational::from(0); degree as usize + 1];
        for (monomial, coefficient) in &self.terms {
            coefficients[monomial.degree() as usize] = coefficient.clone();
        }
        Some(coefficients)
    }
}
