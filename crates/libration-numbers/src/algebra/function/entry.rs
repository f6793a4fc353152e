//! Properties of an elementary function f with argument u.

use super::Function;
use crate::algebra::{BigFloat, Rational};

pub(super) struct Entry {
    pub(super) name: &'static str,
    pub(super) word: &'static str,
    pub(super) latex: [&'static str; 2],
    pub(super) parity: Option<Parity>,
    pub(super) growth: Growth,
    pub(super) has_zeros: bool,
    pub(super) domain: Option<Domain>,
    pub(super) rule: Rule,
    pub(super) double: fn(f64) -> f64,
    /// Value at a number, to this precision.
    pub(super) float: fn(&BigFloat, usize) -> Option<BigFloat>,
    pub(super) rational: fn(&Rational) -> Option<Rational>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parity {
    Even,
    Odd,
}

/// Growth of a function and cost of its large arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Growth {
    /// At most a power of the argument; the cost does not depend on the size of the argument.
    Power,
    /// Bounded, but large arguments have to be reduced.
    Bounded,
    /// Exponential on one side.
    Exponential,
    /// Exponential, or with an exponential approach to a limit, on both sides.
    Hyperbolic,
}

/// Interval in which a function has real values.
#[derive(Clone, Copy, Debug)]
pub struct Domain {
    pub low: Option<i64>,
    pub high: Option<i64>,
    pub(crate) why: &'static str,
}

/// Rule for f′, from which derivatives, tape operations and power series follow.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Rule {
    /// u′/(2f), for the square root.
    Root,
    /// f·u′.
    Itself,
    /// f is one function of a pair.
    Paired(Pair),
    /// f is the quotient of the first function of a pair and the second.
    Quotient(Pair),
    /// f′ is u′ over the divisor, with the sign.
    Inverse(Slope, Divisor),
    /// f′ = sign(u)·u′.
    Modulus,
    /// f′ = 0.
    Step,
}

/// Two functions: the derivative of the first is the second; that of the second is the first, with a sign.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    pub(crate) functions: [Function; 2],
    pub(crate) slope: Slope,
}

impl Pair {
    pub(super) const CIRCULAR: Self = Self { functions: [Function::Sin, Function::Cos], slope: Slope::Minus };
    pub(super) const HYPERBOLIC: Self =
        Self { functions: [Function::Sinh, Function::Cosh], slope: Slope::Plus };
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Slope {
    Plus,
    Minus,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Divisor {
    /// u.
    Argument,
    /// 1 + u².
    OneAndSquare,
    /// √(1 − u²).
    RootOfOneLessSquare,
}

/// An integer at zero; no fraction elsewhere.
pub(super) fn at_zero(x: &Rational, value: i64) -> Option<Rational> {
    x.is_zero().then(|| Rational::from(value))
}

/// Zero at one; no fraction elsewhere.
pub(super) fn zero_at_one(x: &Rational) -> Option<Rational> {
    (*x == Rational::from(1)).then(|| Rational::from(0))
}

/// Domain of the inverses of sine and cosine.
pub(super) const BETWEEN_ONES: Domain =
    Domain { low: Some(-1), high: Some(1), why: "sines and cosines lie between -1 and 1" };

pub(super) fn is_between_ones(x: &BigFloat, precision: usize) -> bool {
    let [below, above] = [-1, 1].map(|one| BigFloat::from_integer(one, precision));
    (below..=above).contains(x)
}
