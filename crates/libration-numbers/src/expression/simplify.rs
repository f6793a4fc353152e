//! Simplification of formulas: exact arithmetic of numbers, and removal of zeros, ones and double signs.

use super::{Expression, Function, Symbol};
use crate::algebra::{Rational, Rationals, Ring};

/// Largest size of a power of numbers that is computed.
const LARGEST_POWER_BITS: usize = 1 << 14;

impl Expression {
    /// The same formula with its arithmetic done exactly and without 0 + a, 1·a, a⁰, −(−a) and the like. Other terms are neither collected nor
    /// expanded. The result may have a value where the formula has none: 0·(1/x) becomes 0.
    #[must_use]
    pub fn simplified(&self) -> Self {
        match self {
            Self::Number(_) | Self::Pi | Self::Symbol(_) => self.clone(),
            Self::Negate(a) => negative(a.simplified()),
            Self::Add(a, b) => sum(a.simplified(), b.simplified()),
            Self::Subtract(a, b) => difference(a.simplified(), b.simplified()),
            Self::Multiply(a, b) => product(a.simplified(), b.simplified()),
            Self::Divide(a, b) => quotient(a.simplified(), b.simplified()),
            Self::Power(a, b) => power(a.simplified(), b.simplified()),
            Self::Call(function, a) => call(*function, a.simplified()),
        }
    }

    /// The formula with a constant in place of a symbol; only the parts that contain the symbol are simplified.
    pub(super) fn with_value(&self, symbol: &Symbol, value: &Self) -> Self {
        if !self.contains(symbol) {
            return self.clone();
        }
        let with = |a: &Self| a.with_value(symbol, value);
        match self {
            Self::Symbol(_) => value.simplified(),
            Self::Number(_) | Self::Pi => self.clone(),
            Self::Negate(a) => negative(with(a)),
            Self::Add(a, b) => sum(with(a), with(b)),
            Self::Subtract(a, b) => difference(with(a), with(b)),
            Self::Multiply(a, b) => product(with(a), with(b)),
            Self::Divide(a, b) => quotient(with(a), with(b)),
            Self::Power(a, b) => power(with(a), with(b)),
            Self::Call(function, a) => call(*function, with(a)),
        }
    }

    /// The value, if the formula is a constant that is rational.
    #[must_use]
    pub fn to_rational(&self) -> Option<Rational> {
        self.simplified().number().cloned()
    }

    pub(super) fn number(&self) -> Option<&Rational> {
        if let Self::Number(value) = self { Some(value) } else { None }
    }

    pub(super) fn is_zero(&self) -> bool {
        self.number().is_some_and(Rational::is_zero)
    }

    fn is_one(&self) -> bool {
        self.number().is_some_and(|value| *value == Rational::from(1))
    }

    /// The formula without its leading sign; `None` if it has none.
    fn without_sign(&self) -> Option<Self> {
        match self {
            Self::Negate(a) => Some((**a).clone()),
            Self::Number(value) if value.is_negative() => Some(Self::Number(value.magnitude())),
            _ => None,
        }
    }
}

pub(super) fn negative(a: Expression) -> Expression {
    match a {
        Expression::Number(value) => Expression::Number(-value),
        Expression::Negate(inner) => *inner,
        _ => Expression::Negate(Box::new(a)),
    }
}

pub(super) fn sum(a: Expression, b: Expression) -> Expression {
    if let (Expression::Number(a), Expression::Number(b)) = (&a, &b) {
        return Expression::Number(Rationals.add(a, b));
    }
    if a.is_zero() {
        return b;
    }
    if b.is_zero() {
        return a;
    }
    match b.without_sign() {
        Some(b) => Expression::Subtract(Box::new(a), Box::new(b)),
        None => Expression::Add(Box::new(a), Box::new(b)),
    }
}

pub fn difference(a: Expression, b: Expression) -> Expression {
    if a == b {
        return Expression::from(0);
    }
    if b.is_zero() {
        return a;
    }
    match b.without_sign() {
        Some(magnitude) => sum(a, magnitude),
        None if a.number().is_some() && b.number().is_some() => sum(a, negative(b)),
        None if a.is_zero() => negative(b),
        None => Expression::Subtract(Box::new(a), Box::new(b)),
    }
}

pub(super) fn product(a: Expression, b: Expression) -> Expression {
    if let (Expression::Number(a), Expression::Number(b)) = (&a, &b) {
        return Expression::Number(Rationals.multiply(a, b));
    }
    if a.is_zero() || b.is_zero() {
        return Expression::from(0);
    }
    if a.is_one() {
        return b;
    }
    if b.is_one() {
        return a;
    }
    match (a.without_sign(), b.without_sign()) {
        (Some(a), Some(b)) => product(a, b),
        (Some(a), None) => negative(product(a, b)),
        (None, Some(b)) => negative(product(a, b)),
        (None, None) => product_of_unsigned(a, b),
    }
}

/// Joins numerical factors of two products, and |u|ⁿ with sign(u).
fn product_of_unsigned(a: Expression, b: Expression) -> Expression {
    if let Some(power) = signed_power(&a, &b) {
        return power;
    }
    if let (Expression::Number(n), Expression::Multiply(m, rest)) = (&a, &b)
        && let Expression::Number(m) = &**m
    {
        return product(Expression::Number(Rationals.multiply(n, m)), (**rest).clone());
    }
    Expression::Multiply(Box::new(a), Box::new(b))
}

/// |u|ⁿ·sign(u) for an integer n > 0: uⁿ for odd n, uⁿ⁻¹·|u| for even n.
fn signed_power(modulus: &Expression, sign: &Expression) -> Option<Expression> {
    let Expression::Call(Function::Sign, u) = sign else { return None };
    let (base, exponent) = match modulus {
        Expression::Power(base, exponent) => (&**base, exponent.number()?.clone()),
        base => (base, Rational::from(1)),
    };
    let whole = exponent.is_integer() && !exponent.is_negative() && !exponent.is_zero();
    if !whole || *base != Expression::Call(Function::Abs, u.clone()) {
        return None;
    }
    let half = Rationals.over_integer(&exponent, 2)?;
    if !half.is_integer() {
        return Some(power((**u).clone(), Expression::Number(exponent)));
    }
    let lower = Expression::Number(Rationals.subtract(&exponent, &Rational::from(1)));
    Some(product(power((**u).clone(), lower), base.clone()))
}

pub(super) fn quotient(a: Expression, b: Expression) -> Expression {
    if let (Expression::Number(a), Expression::Number(b)) = (&a, &b)
        && let Some(value) = a.checked_div(b)
    {
        return Expression::Number(value);
    }
    if b.is_zero() {
        return Expression::Divide(Box::new(a), Box::new(b));
    }
    if a.is_zero() {
        return Expression::from(0);
    }
    if b.is_one() {
        return a;
    }
    match (a.without_sign(), b.without_sign()) {
        (Some(a), Some(b)) => quotient(a, b),
        (Some(a), None) => negative(quotient(a, b)),
        (None, Some(b)) => negative(quotient(a, b)),
        (None, None) => Expression::Divide(Box::new(a), Box::new(b)),
    }
}

pub(super) fn power(a: Expression, b: Expression) -> Expression {
    if b.is_zero() || a.is_one() {
        return Expression::from(1);
    }
    if b.is_one() {
        return a;
    }
    if let (Expression::Number(base), Expression::Number(exponent)) = (&a, &b)
        && let Some(value) = number_power(base, exponent)
    {
        return Expression::Number(value);
    }
    Expression::Power(Box::new(a), Box::new(b))
}

/// The power of a number, if it is a fraction of moderate size.
fn number_power(base: &Rational, exponent: &Rational) -> Option<Rational> {
    let times = u64::try_from(exponent.parts().0.clone().into_parts().1).unwrap_or(u64::MAX);
    if has_too_many_bits(base, times) { None } else { Rationals.power(base, exponent) }
}

/// Returns `true` if a power of a number has more bits than are computed.
pub(super) fn has_too_many_bits(base: &Rational, exponent: u64) -> bool {
    let bits = base.bits();
    bits > 1 && bits.saturating_mul(usize::try_from(exponent).unwrap_or(usize::MAX)) > LARGEST_POWER_BITS
}

pub(super) fn call(function: Function, a: Expression) -> Expression {
    let value = a.number().and_then(|at| Rationals.value(function, at));
    value.map_or_else(|| Expression::Call(function, Box::new(a)), Expression::Number)
}
