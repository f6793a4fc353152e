//! Polynomials in several variables with exact coefficients.

mod expansion;
mod monomial;
mod polynomials;
mod text;
mod variable;

use super::ordered_map::ordered_map;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::{Add, Mul, Neg, Sub};

use dashu_base::{Gcd, UnsignedAbs};
use dashu_int::UBig;

pub use monomial::Monomial;
pub use polynomials::Polynomials;
pub use variable::Variable;

use super::Rational;

/// An exact polynomial with rational coefficients, in named variables or in other ordered ones.
///
/// # Domain
/// Exponents below 2³²; terms of a product beyond that are dropped.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::algebra::{Polynomial, Rational};
/// let (x, y) = (Polynomial::variable("x"), Polynomial::variable("y"));
/// let square = (x.clone() - y.clone()).pow(2);
/// assert_eq!(square.to_string(), "x^2 - 2*x*y + y^2");
/// assert_eq!(square.divide_exactly(&(x.clone() - y.clone())), Some(x - y));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Polynomial<V: Ord = Variable> {
    /// The terms, all with nonzero coefficients.
    terms: BTreeMap<Monomial<V>, Rational>,
}

impl<V: Ord> Default for Polynomial<V> {
    fn default() -> Self {
        Self { terms: BTreeMap::new() }
    }
}

impl Polynomial {
    /// The polynomial without terms.
    #[must_use]
    pub fn zero() -> Self {
        Self::default()
    }

    /// A number as a polynomial.
    #[must_use]
    pub fn constant(value: Rational) -> Self {
        Self::from_number(value)
    }

    /// A variable as a polynomial.
    #[must_use]
    pub fn variable(variable: impl Into<Variable>) -> Self {
        Self::from_variable(variable.into())
    }

    /// The multiple whose coefficients are integers without a common divisor; signs are kept.
    #[must_use]
    pub fn primitive(&self) -> Self {
        let parts = || self.terms.values().map(Rational::parts);
        let multiple =
            parts().fold(UBig::ONE, |multiple, (_, below)| &multiple / (&multiple).gcd(below) * below);
        let common = parts().fold(UBig::ZERO, |common, (above, below)| {
            let whole = above.unsigned_abs() * (&multiple / below);
            if common.is_zero() { whole } else { common.gcd(whole) }
        });
        if common.is_zero() {
            Self::zero()
        } else {
            self.scaled(&Rational::from_parts(multiple.into(), common))
        }
    }
}

impl<V: Ord + Clone> Polynomial<V> {
    /// A number as a polynomial in variables of any kind.
    pub(crate) fn from_number(value: Rational) -> Self {
        Self::term(Monomial::default(), value)
    }

    /// A variable of any kind as a polynomial.
    pub(crate) fn from_variable(variable: V) -> Self {
        Self::term(Monomial::variable(variable), Rational::from(1))
    }

    /// Returns `true` if the polynomial has no terms.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The value of a constant polynomial; `None` if a variable occurs.
    #[must_use]
    pub fn to_constant(&self) -> Option<Rational> {
        (self.degree() == 0).then(|| self.constant_term())
    }

    /// The terms with nonzero coefficients, lower degrees first.
    pub fn terms(&self) -> impl Iterator<Item = (&Monomial<V>, &Rational)> {
        self.terms.iter()
    }

    /// The variables that occur, in their order.
    #[must_use]
    pub fn variables(&self) -> BTreeSet<V> {
        let factors = self.terms.keys().flat_map(Monomial::factors);
        factors.map(|(variable, _)| variable.clone()).collect()
    }

    /// The largest sum of exponents; 0 for the zero polynomial.
    #[must_use]
    pub fn degree(&self) -> u32 {
        self.terms.keys().next_back().map_or(0, Monomial::degree)
    }

    /// The largest exponent of a variable.
    #[must_use]
    pub fn degree_in(&self, variable: &V) -> u32 {
        self.terms.keys().map(|monomial| monomial.exponent(variable)).max().unwrap_or(0)
    }

    /// The factor of a power of this variable, a polynomial in the other variables.
    #[must_use]
    pub fn coefficient(&self, variable: &V, power: u32) -> Self {
        let chosen = self.terms.iter().filter(|(monomial, _)| monomial.exponent(variable) == power);
        Self {
            terms: ordered_map(chosen.map(|(monomial, factor)| (monomial.without(variable), factor.clone()))),
        }
    }

    /// The derivative with respect to a variable.
    #[must_use]
    pub fn derivative(&self, variable: &V) -> Self {
        let x = Monomial::variable(variable.clone());
        let terms = self.terms.iter().filter_map(|(monomial, factor)| {
            let exponent = Rational::from(i64::from(monomial.exponent(variable)));
            monomial.divided_by(&x).map(|rest| (rest, factor.clone() * exponent))
        });
        Self { terms: ordered_map(terms) }
    }

    /// The polynomial times a number.
    #[must_use]
    pub fn scaled(&self, factor: &Rational) -> Self {
        if factor.is_zero() {
            return Self::default();
        }
        let scale =
            |(monomial, other): (&Monomial<V>, &Rational)| (monomial.clone(), other.clone() * factor.clone());
        Self { terms: ordered_map(self.terms.iter().map(scale)) }
    }

    /// The power with a natural exponent.
    #[must_use]
    pub fn pow(&self, exponent: u32) -> Self {
        let one = Self::from_number(Rational::from(1));
        (0..exponent).fold(one, |power, _| product(&power, self))
    }

    /// The polynomial after substitution of another one for a variable.
    #[must_use]
    pub fn substitute(&self, variable: &V, by: &Self) -> Self {
        // Horner's scheme in the variable.
        let powers = (0..=self.degree_in(variable)).rev();
        powers.fold(Self::default(), |value, power| product(&value, by) + self.coefficient(variable, power))
    }

    /// The value for these values of the variables; `None` if a variable has no value.
    #[must_use]
    pub fn value(&self, of: impl Fn(&V) -> Option<Rational>) -> Option<Rational> {
        let replace = |polynomial: Self, variable: V| {
            Some(polynomial.substitute(&variable, &Self::from_number(of(&variable)?)))
        };
        self.variables().into_iter().try_fold(self.clone(), replace)?.to_constant()
    }

    /// The quotient, if the division has no remainder; `None` otherwise, and for the divisor zero.
    #[must_use]
    pub fn divide_exactly(&self, divisor: &Self) -> Option<Self> {
        let (leading, leading_factor) = divisor.terms.last_key_value()?;
        let (mut rest, mut quotient) = (self.clone(), Self::default());
        while let Some((monomial, factor)) = rest.terms.last_key_value() {
            let term = Self::term(monomial.divided_by(leading)?, factor.checked_div(leading_factor)?);
            rest = rest - product(&term, divisor);
            quotient = quotient + term;
        }
        Some(quotient)
    }

    fn term(monomial: Monomial<V>, factor: Rational) -> Self {
        let mut polynomial = Self::default();
        polynomial.add_term(monomial, factor);
        polynomial
    }

    fn constant_term(&self) -> Rational {
        self.terms.get(&Monomial::default()).cloned().unwrap_or_else(|| Rational::from(0))
    }

    fn add_term(&mut self, monomial: Monomial<V>, factor: Rational) {
        let sum = self.terms.remove(&monomial).map_or(factor.clone(), |present| present + factor);
        if !sum.is_zero() {
            self.terms.insert(monomial, sum);
        }
    }
}

fn product<V: Ord + Clone>(a: &Polynomial<V>, b: &Polynomial<V>) -> Polynomial<V> {
    let mut sum = Polynomial::default();
    for (x, p) in &a.terms {
        for (y, q) in &b.terms {
            if let Some(monomial) = x.times(y) {
                sum.add_term(monomial, p.clone() * q.clone());
            }
        }
    }
    sum
}

impl<V: Ord + Clone> Add for Polynomial<V> {
    type Output = Self;
    fn add(mut self, other: Self) -> Self {
        for (monomial, factor) in other.terms {
            self.add_term(monomial, factor);
        }
        self
    }
}

impl<V: Ord + Clone> Sub for Polynomial<V> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<V: Ord + Clone> Mul for Polynomial<V> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        product(&self, &other)
    }
}

impl<V: Ord + Clone> Neg for Polynomial<V> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { terms: ordered_map(self.terms.into_iter().map(|(monomial, factor)| (monomial, -factor))) }
    }
}
