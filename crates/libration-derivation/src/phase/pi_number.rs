//! Sums of powers of π with rational coefficients, such as −4/(3π).

use std::collections::BTreeMap;

use libration::algebra::{PiSum, Rational};

/// Σ cₑ·πᵉ.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PiNumber {
    /// Nonzero coefficients by the exponent.
    terms: BTreeMap<i32, Rational>,
}

impl From<Rational> for PiNumber {
    fn from(value: Rational) -> Self {
        let mut number = Self::default();
        number.add(0, value);
        number
    }
}

impl PiNumber {
    /// The powers of π with their coefficients, the lowest first.
    pub(crate) fn terms(&self) -> impl Iterator<Item = (i32, &Rational)> {
        self.terms.iter().map(|(power, coefficient)| (*power, coefficient))
    }

    /// Returns `true` if the number is zero.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The value as a fraction; `None` if powers of π occur.
    pub(crate) fn to_rational(&self) -> Option<Rational> {
        match self.terms.len() {
            0 => Some(Rational::from(0)),
            1 => self.terms.get(&0).cloned(),
            _ => None,
        }
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        other.terms.iter().for_each(|(power, coefficient)| sum.add(*power, coefficient.clone()));
        sum
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        let mut product = Self::default();
        for (p, a) in &self.terms {
            for (q, b) in &other.terms {
                product.add(p + q, a.clone() * b.clone());
            }
        }
        product
    }

    /// The product with a fraction.
    pub fn scaled(&self, factor: &Rational) -> Self {
        self.times(&Self::from(factor.clone()))
    }

    pub(crate) fn negated(&self) -> Self {
        self.scaled(&Rational::from(-1))
    }

    /// The number times a power of π.
    pub fn times_power_of_pi(&self, power: i32) -> Self {
        let mut product = Self::default();
        for (exponent, coefficient) in &self.terms {
            product.terms.insert(exponent + power, coefficient.clone());
        }
        product
    }

    /// Returns `true` if the number equals this one of the library.
    pub(crate) fn is(&self, other: &PiSum) -> bool {
        let mut terms = BTreeMap::new();
        for (power, surd) in other.terms() {
            let Some(fraction) = surd.to_rational() else { return false };
            terms.insert(*power, fraction.clone());
        }
        terms == self.terms
    }

    fn add(&mut self, power: i32, coefficient: Rational) {
        let sum =
            self.terms.remove(&power).map_or_else(|| coefficient.clone(), |old| old + coefficient.clone());
        if !sum.is_zero() {
            self.terms.insert(power, sum);
        }
    }
}
