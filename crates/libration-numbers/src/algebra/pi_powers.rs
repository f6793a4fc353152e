//! Sums of integer powers of π, including negative ones, as a ring in which π is treated as an indeterminate.

use super::ordered_map::{ordered_map, ordered_map_of_all};
use std::collections::BTreeMap;

use super::{Function, Rational, Ring};

/// All Σ cₚπᵖ with coefficients cₚ in a field. Only single terms have an inverse.
#[derive(Clone, Debug)]
pub struct PiPowers<F> {
    pub numbers: F,
}

/// The nonzero coefficients cₚ by p.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PiPolynomial<E> {
    terms: BTreeMap<i32, E>,
}

impl<E> PiPolynomial<E> {
    /// The powers of π with their coefficients.
    pub fn terms(&self) -> impl Iterator<Item = (i32, &E)> {
        self.terms.iter().map(|(&power, number)| (power, number))
    }
}

impl<F: Ring> PiPowers<F> {
    /// c·πᵖ.
    pub fn term(&self, power: i32, number: F::Element) -> PiPolynomial<F::Element> {
        let mut sum = self.zero();
        self.add_term(&mut sum, power, number);
        sum
    }

    fn add_term(&self, sum: &mut PiPolynomial<F::Element>, power: i32, number: F::Element) {
        let total = match sum.terms.remove(&power) {
            Some(present) => self.numbers.add(&present, &number),
            None => number,
        };
        if !self.numbers.is_zero(&total) {
            sum.terms.insert(power, total);
        }
    }

    fn map(
        a: &PiPolynomial<F::Element>,
        f: impl Fn(&F::Element) -> Option<F::Element>,
    ) -> Option<PiPolynomial<F::Element>> {
        let terms = a.terms.iter().map(|(&power, number)| Some((power, f(number)?)));
        Some(PiPolynomial { terms: ordered_map_of_all(terms)? })
    }

    /// The value, if no power of π occurs.
    fn as_number(&self, a: &PiPolynomial<F::Element>) -> Option<F::Element> {
        if a.terms.is_empty() {
            return Some(self.numbers.zero());
        }
        a.terms.get(&0).filter(|_| a.terms.len() == 1).cloned()
    }
}

impl<F: Ring> Ring for PiPowers<F> {
    type Element = PiPolynomial<F::Element>;

    fn zero(&self) -> Self::Element {
        PiPolynomial { terms: BTreeMap::new() }
    }

    fn is_zero(&self, a: &Self::Element) -> bool {
        a.terms.is_empty()
    }

    fn rational(&self, value: &Rational) -> Option<Self::Element> {
        self.numbers.rational(value).map(|number| self.term(0, number))
    }

    fn add(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        let mut sum = a.clone();
        for (power, number) in b.terms() {
            self.add_term(&mut sum, power, number.clone());
        }
        sum
    }

    fn subtract(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        self.add(a, &self.negate(b))
    }

    fn negate(&self, a: &Self::Element) -> Self::Element {
        let terms = a.terms.iter().map(|(&power, number)| (power, self.numbers.negate(number)));
        PiPolynomial { terms: ordered_map(terms) }
    }

    fn multiply(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        let mut sum = self.zero();
        for (p, x) in a.terms() {
            for (q, y) in b.terms() {
                self.add_term(&mut sum, p + q, self.numbers.multiply(x, y));
            }
        }
        sum
    }

    fn times_integer(&self, a: &Self::Element, factor: i64) -> Self::Element {
        let times = |number: &F::Element| Some(self.numbers.times_integer(number, factor));
        if factor == 0 { self.zero() } else { Self::map(a, times).unwrap_or_else(|| self.zero()) }
    }

    fn divide(&self, a: &Self::Element, divisor: &Self::Element) -> Option<Self::Element> {
        let mut terms = divisor.terms();
        let ((shift, number), None) = (terms.next()?, terms.next()) else { return None };
        let quotient = Self::map(a, |x| self.numbers.divide(x, number))?;
        Some(PiPolynomial { terms: ordered_map(quotient.terms.into_iter().map(|(p, x)| (p - shift, x))) })
    }

    fn over_integer(&self, a: &Self::Element, divisor: u64) -> Option<Self::Element> {
        Self::map(a, |number| self.numbers.over_integer(number, divisor))
    }

    fn value(&self, function: Function, at: &Self::Element) -> Option<Self::Element> {
        self.numbers.value(function, &self.as_number(at)?).map(|number| self.term(0, number))
    }

    fn power(&self, a: &Self::Element, exponent: &Rational) -> Option<Self::Element> {
        self.numbers.power(&self.as_number(a)?, exponent).map(|number| self.term(0, number))
    }

    fn pi(&self) -> Option<Self::Element> {
        self.numbers.rational(&Rational::from(1)).map(|one| self.term(1, one))
    }
}
