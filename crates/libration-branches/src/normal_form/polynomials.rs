//! Polynomials in complex amplitudes and their conjugates, over any field.

use libration_numbers::algebra::{Function, Rational, Ring};
use libration_numbers::internals::algebra::{ordered_map, ordered_map_of_all};
use std::collections::BTreeMap;

/// Powers of a₁, a₂, …, followed by those of their conjugates.
pub(super) type Powers = Vec<u8>;

/// Nonzero coefficients by monomial.
pub(super) type Polynomial<E> = BTreeMap<Powers, E>;

/// The ring of such polynomials.
#[derive(Clone, Debug)]
pub(super) struct AmplitudePolynomials<F: Ring> {
    pub(super) numbers: F,
    /// Number of amplitudes and conjugates.
    pub(super) generators: usize,
}

impl<F: Ring> AmplitudePolynomials<F> {
    pub(super) fn constant(&self, value: F::Element) -> Polynomial<F::Element> {
        self.term(vec![0; self.generators], value)
    }

    pub(super) fn term(&self, powers: Powers, value: F::Element) -> Polynomial<F::Element> {
        if self.numbers.is_zero(&value) {
            BTreeMap::new()
        } else {
            ordered_map(std::iter::once((powers, value)))
        }
    }

    /// The generator with this index times a constant.
    pub(super) fn generator(&self, number: usize, value: F::Element) -> Polynomial<F::Element> {
        let mut powers = vec![0; self.generators];
        powers[number] = 1;
        self.term(powers, value)
    }

    pub(super) fn scaled(&self, a: &Polynomial<F::Element>, factor: &F::Element) -> Polynomial<F::Element> {
        let scaled = a.iter().map(|(powers, value)| (powers.clone(), self.numbers.multiply(value, factor)));
        ordered_map(scaled.filter(|(_, value)| !self.numbers.is_zero(value)))
    }

    /// The derivative with respect to a generator.
    pub(super) fn derivative(&self, a: &Polynomial<F::Element>, by: usize) -> Polynomial<F::Element> {
        let terms = a.iter().filter(|(powers, _)| powers[by] > 0);
        let lowered = |(powers, value): (&Powers, &F::Element)| {
            let mut lower = powers.clone();
            lower[by] -= 1;
            (lower, self.numbers.times_integer(value, i64::from(powers[by])))
        };
        ordered_map(terms.map(lowered))
    }

    fn as_constant<'a>(&self, a: &'a Polynomial<F::Element>) -> Option<Option<&'a F::Element>> {
        match a.first_key_value() {
            None => Some(None),
            Some((powers, value)) if a.len() == 1 && powers.iter().all(|power| *power == 0) => {
                Some(Some(value))
            }
            Some(_) => None,
        }
    }

    fn of_constant(
        &self,
        a: &Polynomial<F::Element>,
        function: impl FnOnce(&F::Element) -> Option<F::Element>,
    ) -> Option<Polynomial<F::Element>> {
        let zero = self.numbers.zero();
        function(self.as_constant(a)?.unwrap_or(&zero)).map(|value| self.constant(value))
    }

    fn add_to(&self, sum: &mut Polynomial<F::Element>, powers: Powers, value: F::Element) {
        let total = match sum.get(&powers) {
            Some(present) => self.numbers.add(present, &value),
            None => value,
        };
        if self.numbers.is_zero(&total) {
            sum.remove(&powers);
        } else {
            sum.insert(powers, total);
        }
    }
}

impl<F: Ring> Ring for AmplitudePolynomials<F> {
    type Element = Polynomial<F::Element>;

    fn zero(&self) -> Self::Element {
        BTreeMap::new()
    }

    fn is_zero(&self, a: &Self::Element) -> bool {
        a.is_empty()
    }

    fn rational(&self, value: &Rational) -> Option<Self::Element> {
        self.numbers.rational(value).map(|value| self.constant(value))
    }

    fn add(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        let mut sum = a.clone();
        for (powers, value) in b {
            self.add_to(&mut sum, powers.clone(), value.clone());
        }
        sum
    }

    fn subtract(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        self.add(a, &self.negate(b))
    }

    fn negate(&self, a: &Self::Element) -> Self::Element {
        ordered_map(a.iter().map(|(powers, value)| (powers.clone(), self.numbers.negate(value))))
    }

    fn multiply(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        let mut product = BTreeMap::new();
        for (first, x) in a {
            for (other, y) in b {
                let powers = first.iter().zip(other).map(|(p, q)| p + q).collect();
                self.add_to(&mut product, powers, self.numbers.multiply(x, y));
            }
        }
        product
    }

    fn times_integer(&self, a: &Self::Element, factor: i64) -> Self::Element {
        let terms =
            a.iter().map(|(powers, value)| (powers.clone(), self.numbers.times_integer(value, factor)));
        ordered_map(terms.filter(|(_, value)| !self.numbers.is_zero(value)))
    }

    /// Division by constants only.
    fn divide(&self, a: &Self::Element, divisor: &Self::Element) -> Option<Self::Element> {
        let divisor = self.as_constant(divisor)??;
        let terms =
            a.iter().map(|(powers, value)| Some((powers.clone(), self.numbers.divide(value, divisor)?)));
        ordered_map_of_all(terms)
    }

    fn over_integer(&self, a: &Self::Element, divisor: u64) -> Option<Self::Element> {
        let terms = a
            .iter()
            .map(|(powers, value)| Some((powers.clone(), self.numbers.over_integer(value, divisor)?)));
        ordered_map_of_all(terms)
    }

    fn value(&self, function: Function, at: &Self::Element) -> Option<Self::Element> {
        self.of_constant(at, |value| self.numbers.value(function, value))
    }

    fn power(&self, a: &Self::Element, exponent: &Rational) -> Option<Self::Element> {
        self.of_constant(a, |value| self.numbers.power(value, exponent))
    }

    fn pi(&self) -> Option<Self::Element> {
        self.numbers.pi().map(|value| self.constant(value))
    }
}
