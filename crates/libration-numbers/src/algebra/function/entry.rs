//! Properties of an elementary function f, u being its argument.

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
    /// Value for a number of this precision.
    pub(super) float: fn(&BigFloat, usize) -> Option<BigFloat>,
    pub(super) rational: fn(&Rational) -> Option<Rational>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parity {
    Even,
    Odd,
}

/// Growth of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Growth {
    /// At most as a power, with digits that cost the same for arguments of any size.
    Power,
    /// The same, but large arguments have to be reduced.
    Bounded,
    /// Exponentially to one side.
    Exponential,
    /// Exponentially, or to its limit exponentially, to both sides.
    Hyperbolic,
}

/// Interval in which a function has real values.
#[derive(Clone, Copy, Debug)]
pub struct Domain {
    pub low: Option<i64>,
    pub high: Option<i64>,
    pub(crate) why: &'static str,
}

/// Rule for f′, from which derivatives, operations on tapes and power series follow.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Rule {
    /// u′/(2f): the power 1/2.
    Root,
    /// f·u′.
    Itself,
    /// One of a pair.
    Paired(Pair),
    /// Quotient of the first of a pair and the second.
    Quotient(Pair),
    /// u′ over the divisor, with the sign.
    Inverse(Slope, Divisor),
    /// sign(u)·u′.
    Modulus,
    /// Zero.
    Step,
}

/// Two functions of which the first has the second for its derivative, and the second the first, with a sign.
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

/// A fraction at zero, and nowhere else.
pub(super) fn at_zero(x: &Rational, value: i64) -> Option<Rational> {
    x.is_zero().then(|| Rational::from(value))
}

/// Zero at one, and no fraction elsewhere.
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
