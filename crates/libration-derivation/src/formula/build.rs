//! Constructors with which formulas in Rust read like mathematics.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Decimal, DecimalUnit, Formula, Name};
use libration::algebra::{Function, Polynomial, Rational};

/// An integer.
pub fn number(integer: i64) -> Formula {
    Formula::Number(Rational::from(integer))
}

/// A number of tenths, as a sample value.
pub fn tenths(numerator: i64) -> Formula {
    Rational::new(numerator, 10).map_or_else(|| number(1), Formula::from)
}

/// A symbol.
pub fn letter(letter: &str) -> Formula {
    Formula::Name(Name::new(letter))
}

/// An elementary function.
pub fn call(function: Function, argument: impl Into<Formula>) -> Formula {
    Formula::Call(function, Box::new(argument.into()))
}

/// The sine.
pub fn sin(argument: impl Into<Formula>) -> Formula {
    call(Function::Sin, argument)
}

pub(crate) fn cos(argument: impl Into<Formula>) -> Formula {
    call(Function::Cos, argument)
}

/// The square root.
pub fn sqrt(argument: impl Into<Formula>) -> Formula {
    call(Function::Sqrt, argument)
}

pub(crate) fn ln(argument: impl Into<Formula>) -> Formula {
    call(Function::Ln, argument)
}

/// An application of a function that the derivation has defined.
pub(crate) fn apply<const N: usize>(name: &str, arguments: [Formula; N]) -> Formula {
    Formula::Apply(Name::new(name), arguments.into())
}

/// The arithmetic–geometric mean.
pub(crate) fn agm(a: impl Into<Formula>, b: impl Into<Formula>) -> Formula {
    Formula::Agm(Box::new(a.into()), Box::new(b.into()))
}

/// Σ from an index to infinity.
pub fn series(index: &str, from: i64, term: Formula) -> Formula {
    Formula::Series { index: Name::new(index), from: Box::new(number(from)), to: None, term: Box::new(term) }
}

/// ∫ over a variable between two limits.
pub fn integral(
    variable: &str,
    from: impl Into<Formula>,
    to: impl Into<Formula>,
    integrand: Formula,
) -> Formula {
    let (from, to) = (Box::new(from.into()), Box::new(to.into()));
    Formula::Integral { variable: Name::new(variable), from, to, integrand: Box::new(integrand) }
}

/// The derivative with respect to a variable.
pub(crate) fn derivative(of: impl Into<Formula>, by: &str) -> Formula {
    Formula::Derivative { of: Box::new(of.into()), by: Name::new(by) }
}

/// n!!.
pub fn double_factorial(of: impl Into<Formula>) -> Formula {
    Formula::DoubleFactorial(Box::new(of.into()))
}

/// O(…).
pub fn order(of: impl Into<Formula>) -> Formula {
    Formula::Order(Box::new(of.into()))
}

/// A number rounded to `digits` digits.
pub(crate) fn rounded(value: f64, digits: usize, unit: DecimalUnit) -> Formula {
    Formula::Decimal(Decimal::rounded(value, digits, unit))
}

/// A coefficient in a printed series: a number, or a polynomial in symbols.
pub(crate) trait Coefficient {
    fn is_absent(&self) -> bool;
    /// The coefficient alone.
    fn to_formula(&self) -> Formula;
    /// coefficient·formula, without factors of one.
    fn times(&self, formula: Formula) -> Formula;
}

impl Coefficient for Rational {
    fn is_absent(&self) -> bool {
        self.is_zero()
    }

    fn to_formula(&self) -> Formula {
        Formula::Number(self.clone())
    }

    fn times(&self, formula: Formula) -> Formula {
        scaled(self, formula)
    }
}

impl Coefficient for Polynomial {
    fn is_absent(&self) -> bool {
        self.is_zero()
    }

    fn to_formula(&self) -> Formula {
        self.into()
    }

    fn times(&self, formula: Formula) -> Formula {
        match self.to_constant() {
            Some(number) => scaled(&number, formula),
            None => Formula::from(self) * formula,
        }
    }
}

/// Σ coefficientₙ·xⁿ over nonzero coefficients, with O(…) of the next possible power.
pub(crate) fn polynomial<C: Coefficient>(coefficients: &[C], variable: &Formula) -> Formula {
    let powers = coefficients.iter().enumerate().filter(|(_, coefficient)| !coefficient.is_absent());
    let terms: Vec<Formula> = powers.map(|(n, coefficient)| monomial(coefficient, variable, n)).collect();
    if terms.is_empty() { number(0) } else { sum(terms) }
}

/// The sum of the terms, or the term itself if there is only one.
pub fn sum(mut terms: Vec<Formula>) -> Formula {
    match terms.len() {
        1 => terms.remove(0),
        _ => Formula::Sum(terms),
    }
}

/// coefficient·xⁿ, without factors of one.
pub(crate) fn monomial<C: Coefficient>(coefficient: &C, variable: &Formula, n: usize) -> Formula {
    let power = match n {
        0 => return coefficient.to_formula(),
        1 => variable.clone(),
        _ => variable.clone().pow(i64::try_from(n).unwrap_or(i64::MAX)),
    };
    coefficient.times(power)
}

/// coefficient·formula, without factors of one.
pub(crate) fn scaled(coefficient: &Rational, formula: Formula) -> Formula {
    if *coefficient == Rational::from(1) {
        formula
    } else if *coefficient == Rational::from(-1) {
        -formula
    } else {
        Formula::Number(coefficient.clone()) * formula
    }
}

impl Formula {
    /// The formula raised to a power.
    #[doc(hidden)]
    pub fn pow(self, exponent: impl Into<Self>) -> Self {
        Self::Power(Box::new(self), Box::new(exponent.into()))
    }

    /// The negative of the formula, with the sign moved into its summands.
    pub(crate) fn negated(self) -> Self {
        match self {
            Self::Negate(inner) => *inner,
            Self::Sum(terms) => Self::Sum(terms.into_iter().map(Self::negated).collect()),
            Self::Product(mut factors)
                if matches!(factors.first(), Some(Self::Number(_) | Self::Negate(_))) =>
            {
                let first = factors.remove(0).negated();
                let rest = factors.into_iter().reduce(|product, factor| product * factor);
                match (first, rest) {
                    (Self::Number(one), Some(rest)) => scaled(&one, rest),
                    (first, Some(rest)) => first * rest,
                    (first, None) => first,
                }
            }
            Self::Fraction(over, under) => Self::Fraction(Box::new(over.negated()), under),
            formula => -formula,
        }
    }

    #[doc(hidden)]
    pub fn squared(self) -> Self {
        self.pow(2)
    }
}

impl From<i64> for Formula {
    fn from(integer: i64) -> Self {
        number(integer)
    }
}

impl From<Rational> for Formula {
    fn from(value: Rational) -> Self {
        Self::Number(value)
    }
}

impl<T: Into<Self>> Add<T> for Formula {
    type Output = Self;
    fn add(self, other: T) -> Self {
        let mut terms = match self {
            Self::Sum(terms) => terms,
            term => vec![term],
        };
        match other.into() {
            Self::Sum(more) => terms.extend(more),
            term => terms.push(term),
        }
        Self::Sum(terms)
    }
}

impl<T: Into<Self>> Sub<T> for Formula {
    type Output = Self;
    fn sub(self, other: T) -> Self {
        self + -other.into()
    }
}

impl<T: Into<Self>> Mul<T> for Formula {
    type Output = Self;
    fn mul(self, other: T) -> Self {
        let mut factors = match self {
            Self::Product(factors) => factors,
            factor => vec![factor],
        };
        match other.into() {
            Self::Product(more) => factors.extend(more),
            factor => factors.push(factor),
        }
        Self::Product(factors)
    }
}

impl<T: Into<Self>> Div<T> for Formula {
    type Output = Self;
    fn div(self, other: T) -> Self {
        Self::Fraction(Box::new(self), Box::new(other.into()))
    }
}

impl Neg for Formula {
    type Output = Self;
    fn neg(self) -> Self {
        match self {
            Self::Number(value) => Self::Number(-value),
            formula => Self::Negate(Box::new(formula)),
        }
    }
}

impl Mul<Formula> for i64 {
    type Output = Formula;
    fn mul(self, other: Formula) -> Formula {
        number(self) * other
    }
}

impl Add<Formula> for i64 {
    type Output = Formula;
    fn add(self, other: Formula) -> Formula {
        number(self) + other
    }
}

impl Sub<Formula> for i64 {
    type Output = Formula;
    fn sub(self, other: Formula) -> Formula {
        number(self) - other
    }
}

impl Div<Formula> for i64 {
    type Output = Formula;
    fn div(self, other: Formula) -> Formula {
        number(self) / other
    }
}
