//! Polynomials in many variables with fractions for coefficients.

use std::collections::BTreeMap;

use crate::algebra::{Rational, Rationals, Ring};

/// Powers of variables, none of them zero.
type Monomial<V> = BTreeMap<V, u32>;

/// A sum of monomials with coefficients that are not zero.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Polynomial<V: Ord>(BTreeMap<Monomial<V>, Rational>);

impl<V: Ord + Clone> Polynomial<V> {
    pub(super) fn number(value: Rational) -> Self {
        let mut terms = BTreeMap::new();
        if !value.is_zero() {
            terms.insert(Monomial::new(), value);
        }
        Self(terms)
    }

    pub(super) fn atom(variable: V) -> Self {
        Self(BTreeMap::from([(Monomial::from([(variable, 1)]), Rational::from(1))]))
    }

    pub(super) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn terms(&self) -> usize {
        self.0.len()
    }

    /// What a product or a sum with this costs for each of the other's terms.
    pub(super) fn cost(&self) -> usize {
        const BITS: usize = 256;
        self.0.values().map(|coefficient| 1 + coefficient.bits() / BITS).sum()
    }

    /// The coefficient of the monomial that comes last, `None` for zero.
    pub(super) fn leading(&self) -> Option<&Rational> {
        self.0.values().next_back()
    }

    /// The value of what has no variables.
    pub(super) fn to_number(&self) -> Option<Rational> {
        match self.terms() {
            0 => Some(Rational::from(0)),
            1 => self.0.get(&Monomial::new()).cloned(),
            _ => None,
        }
    }

    pub(super) fn scaled(&self, factor: &Rational) -> Self {
        Self(self.0.iter().map(|(it, a)| (it.clone(), Rationals.multiply(a, factor))).collect())
    }

    pub(super) fn negated(&self) -> Self {
        self.scaled(&Rational::from(-1))
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        for (monomial, coefficient) in &other.0 {
            sum.add_term(monomial.clone(), coefficient);
        }
        sum
    }

    fn add_term(&mut self, monomial: Monomial<V>, coefficient: &Rational) {
        let known = self.0.remove(&monomial).unwrap_or_else(|| Rational::from(0));
        let sum = Rationals.add(&known, coefficient);
        if !sum.is_zero() {
            self.0.insert(monomial, sum);
        }
    }

    /// `None` for powers beyond `u32`.
    pub(super) fn times(&self, other: &Self) -> Option<Self> {
        let mut product = Self(BTreeMap::new());
        for (a, p) in &self.0 {
            for (b, q) in &other.0 {
                product.add_term(joined(a, b)?, &Rationals.multiply(p, q));
            }
        }
        Some(product)
    }

    /// The power of one term with a coefficient of ±1, or of zero; `None` when it is anything else, and in it for
    /// powers beyond `u32`.
    pub(super) fn power_of_one_term(&self, times: u32) -> Option<Option<Self>> {
        if self.is_zero() {
            return Some(Some(Self::number(Rational::from(i64::from(times == 0)))));
        }
        let (monomial, coefficient) = self.0.first_key_value().filter(|_| self.terms() == 1)?;
        if coefficient.magnitude() != Rational::from(1) {
            return None;
        }
        let powers = monomial.iter().filter(|_| times > 0);
        let powers = powers.map(|(it, power)| Some((it.clone(), power.checked_mul(times)?)));
        let sign = if times.is_multiple_of(2) { Rational::from(1) } else { coefficient.clone() };
        Some(powers.collect::<Option<Monomial<V>>>().map(|powers| Self(BTreeMap::from([(powers, sign)]))))
    }

    /// Whether a variable of this kind occurs.
    pub(super) fn has(&self, kind: impl Fn(&V) -> bool) -> bool {
        self.0.keys().any(|monomial| monomial.keys().any(&kind))
    }

    /// The total degree in the variables of this kind.
    pub(super) fn degree(&self, kind: impl Fn(&V) -> bool) -> u32 {
        let of = |monomial: &Monomial<V>| {
            let powers = monomial.iter().filter(|(it, _)| kind(it)).map(|(_, power)| *power);
            powers.fold(0, u32::saturating_add)
        };
        self.0.keys().map(of).max().unwrap_or(0)
    }

    /// The coefficients, constant term first, of a polynomial in one variable; `None` when others occur or the degree
    /// is above 1000.
    pub(super) fn in_one(&self, variable: &V) -> Option<Vec<Rational>> {
        const LARGEST_DEGREE: u32 = 1000;
        let degree = self.degree(|_| true);
        if degree > LARGEST_DEGREE || self.has(|it| it != variable) {
            return None;
        }
        let power = |n: u32| Monomial::from_iter((n > 0).then(|| (variable.clone(), n)));
        let zero = || Rational::from(0);
        Some((0..=degree).map(|n| self.0.get(&power(n)).cloned().unwrap_or_else(zero)).collect())
    }
}

fn joined<V: Ord + Clone>(a: &Monomial<V>, b: &Monomial<V>) -> Option<Monomial<V>> {
    let mut product = a.clone();
    for (variable, power) in b {
        let sum = product.entry(variable.clone()).or_insert(0);
        *sum = sum.checked_add(*power)?;
    }
    Some(product)
}
