//! Operations of a tape: computation of values and of further series coefficients, in any ring and for any storage of the series.

use super::tape::Operation;
use crate::algebra::{Function, Pair, Rational, Ring, Rule, Slope};
use crate::series::recurrences::{
    Both, quotient, weighted_integral, weighted_integral_of_quotient, weighted_power,
};

/// Order from which a quotient by a constant is computed as a product with its reciprocal, if that is available: four hundred driven pendulums,
/// with θ′/2 among their terms, then take 0.95 of the time. The rounding error of the reciprocal is the same at all orders; at lower orders it
/// would matter.
const RECIPROCAL_FROM: usize = 8;

/// Computation of a zeroth coefficient from those in rows P, with exponents X.
#[derive(Clone, Copy, Debug)]
pub enum Value<P, X> {
    Negate(P),
    Add(P, P),
    Subtract(P, P),
    Multiply(P, P),
    Divide(P, P),
    Power(P, X),
    Of(Function, P),
}

/// Computation of the next coefficient of a row. A weighted row holds n times the coefficients of another row.
#[derive(Clone, Copy, Debug)]
pub enum Instruction<P, X> {
    Weight {
        a: P,
        out: P,
    },
    Negate {
        a: P,
        out: P,
    },
    Add {
        a: P,
        b: P,
        out: P,
    },
    Subtract {
        a: P,
        b: P,
        out: P,
    },
    /// Product with a constant factor.
    Scale {
        factor: P,
        a: P,
        out: P,
    },
    Multiply {
        a: P,
        b: P,
        out: P,
    },
    Square {
        a: P,
        out: P,
    },
    /// Quotient by a constant divisor; the reciprocal is the first element of its row.
    Unscale {
        a: P,
        divisor: P,
        reciprocal: Option<P>,
        out: P,
    },
    Divide {
        a: P,
        b: P,
        out: P,
    },
    Power {
        exponent: X,
        a: Weighted<P>,
        out: Weighted<P>,
    },
    Exp {
        a: Weighted<P>,
        out: P,
    },
    /// The derivative is `other`, with a sign, times the derivative of a series of this degree.
    Paired {
        a: Weighted<P>,
        degree: usize,
        other: P,
        slope: Slope,
        out: P,
    },
    /// The derivative is one plus or minus the square, times the derivative of a series.
    Tangent {
        slope: Slope,
        a: P,
        square: P,
        out: P,
    },
    Inverse {
        a: P,
        divisor: P,
        out: Weighted<P>,
    },
    Abs {
        a: P,
        out: P,
    },
    Sign {
        a: P,
        out: P,
    },
}

/// A row and its weighted form.
#[derive(Clone, Copy, Debug)]
pub struct Weighted<P> {
    pub plain: P,
    pub weighted: P,
}

/// Storage of series, with the operations that depend on it.
pub trait Evaluator<P, X> {
    type Ring: Ring;

    fn ring(&self) -> &Self::Ring;
    fn row(&self, row: P) -> &[<Self::Ring as Ring>::Element];
    fn exponent(&self, exponent: &X) -> Option<<Self::Ring as Ring>::Element>;
    fn power(
        &self,
        base: &<Self::Ring as Ring>::Element,
        exponent: &X,
    ) -> Option<<Self::Ring as Ring>::Element>;
    /// Returns `true` if this power of a series without constant term has no coefficient n yet.
    fn begins_beyond(&self, exponent: &X, n: usize) -> bool;
    /// The last coefficient of the square of a₀ … aₙ.
    #[inline(always)]
    fn square(&self, a: &[<Self::Ring as Ring>::Element]) -> <Self::Ring as Ring>::Element {
        self.ring().convolution(a, a)
    }
    /// cₙ of c = a/b, from aₙ, c₀ … cₙ₋₁ and b₀ … bₙ.
    #[inline(always)]
    fn quotient(
        &self,
        a_n: &<Self::Ring as Ring>::Element,
        c: &[<Self::Ring as Ring>::Element],
        b: &[<Self::Ring as Ring>::Element],
    ) -> Option<<Self::Ring as Ring>::Element> {
        quotient(self.ring(), a_n, c, b)
    }
    /// cₙ of the c with c′ = a′·b, from aₙ, the weighted a₁ … aₙ and b₀ … bₙ₋₁.
    #[inline(always)]
    fn integral(
        &self,
        _: &<Self::Ring as Ring>::Element,
        weighted_a: &[<Self::Ring as Ring>::Element],
        b: &[<Self::Ring as Ring>::Element],
    ) -> Option<<Self::Ring as Ring>::Element> {
        over_integer(self.ring(), &weighted_integral(self.ring(), weighted_a, b), b.len())
    }
    /// A quotient by the base of a power; if the base is zero, zero for a power that begins at a later order.
    fn over_base(
        &self,
        value: &<Self::Ring as Ring>::Element,
        base: &<Self::Ring as Ring>::Element,
        begins_later: bool,
    ) -> Option<<Self::Ring as Ring>::Element>;
}

#[inline(always)]
fn over_integer<R: Ring>(ring: &R, a: &R::Element, n: usize) -> Option<R::Element> {
    ring.over_integer(a, u64::try_from(n).unwrap_or(u64::MAX))
}

impl<P: Copy, X> Value<P, X> {
    /// The computation for an operation; `None` for inputs and constants.
    pub fn new<'a>(
        operation: &'a Operation,
        at: impl Fn(usize) -> P,
        exponent: impl Fn(&'a Rational) -> X,
    ) -> Option<Self> {
        Some(match *operation {
            Operation::Input(_) | Operation::Number(_) | Operation::Pi => return None,
            Operation::Negate(a) => Self::Negate(at(a)),
            Operation::Add(a, b) => Self::Add(at(a), at(b)),
            Operation::Subtract(a, b) => Self::Subtract(at(a), at(b)),
            Operation::Multiply(a, b) => Self::Multiply(at(a), at(b)),
            Operation::Divide(a, b) => Self::Divide(at(a), at(b)),
            Operation::Power(a, ref power) => Self::Power(at(a), exponent(power)),
            Operation::Exp(a) => Self::Of(Function::Exp, at(a)),
            Operation::Abs(a) => Self::Of(Function::Abs, at(a)),
            Operation::Sign(a) => Self::Of(Function::Sign, at(a)),
            Operation::Paired { function, of, .. }
            | Operation::Tangent { function, of }
            | Operation::Inverse { function, of, .. } => Self::Of(function, at(of)),
        })
    }

    /// Returns `true` if the value requires more than arithmetic.
    pub fn is_function(&self) -> bool {
        matches!(self, Self::Power(..) | Self::Of(..))
    }

    /// Operands of the value.
    pub fn operands(&self) -> [Option<P>; 2] {
        match *self {
            Self::Negate(a) | Self::Power(a, _) | Self::Of(_, a) => [Some(a), None],
            Self::Add(a, b) | Self::Subtract(a, b) | Self::Multiply(a, b) | Self::Divide(a, b) => {
                [Some(a), Some(b)]
            }
        }
    }

    /// Computes the value; `None` if it is not in the ring.
    #[inline(always)]
    pub fn evaluate<E: Evaluator<P, X>>(&self, on: &E) -> Option<<E::Ring as Ring>::Element> {
        let ring = on.ring();
        let at = |row: P| &on.row(row)[0];
        match *self {
            Self::Negate(a) => Some(ring.negate(at(a))),
            Self::Add(a, b) => Some(ring.add(at(a), at(b))),
            Self::Subtract(a, b) => Some(ring.subtract(at(a), at(b))),
            Self::Multiply(a, b) => Some(ring.multiply(at(a), at(b))),
            Self::Divide(a, b) => ring.divide(at(a), at(b)),
            Self::Power(a, ref exponent) => on.power(at(a), exponent),
            Self::Of(function, a) => ring.value(function, at(a)),
        }
    }
}

impl<P: Copy, X> Instruction<P, X> {
    /// The instruction for the operation at a position; `None` for inputs and constants. A row of degree zero is constant.
    pub fn new<'a>(
        operation: &'a Operation,
        position: usize,
        rows: impl Fn(usize) -> Weighted<P>,
        reciprocal: impl Fn(usize) -> Option<P>,
        degree: impl Fn(usize) -> usize,
        exponent: impl Fn(&'a Rational) -> X,
    ) -> Option<Self> {
        let (at, weighted) = (|index: usize| rows(index).plain, |index: usize| rows(index).weighted);
        let constant = |index: usize| degree(index) == 0;
        let out = at(position);
        Some(match *operation {
            Operation::Input(_) | Operation::Number(_) | Operation::Pi => return None,
            Operation::Negate(a) => Self::Negate { a: at(a), out },
            Operation::Add(a, b) => Self::Add { a: at(a), b: at(b), out },
            Operation::Subtract(a, b) => Self::Subtract { a: at(a), b: at(b), out },
            Operation::Multiply(a, b) if constant(a) => Self::Scale { factor: at(a), a: at(b), out },
            Operation::Multiply(a, b) if constant(b) => Self::Scale { factor: at(b), a: at(a), out },
            Operation::Multiply(a, b) if a == b => Self::Square { a: at(a), out },
            Operation::Multiply(a, b) => Self::Multiply { a: at(a), b: at(b), out },
            Operation::Divide(a, b) if constant(b) => {
                Self::Unscale { a: at(a), divisor: at(b), reciprocal: reciprocal(b), out }
            }
            Operation::Divide(a, b) => Self::Divide { a: at(a), b: at(b), out },
            Operation::Power(a, ref power) => {
                Self::Power { exponent: exponent(power), a: rows(a), out: rows(position) }
            }
            Operation::Exp(a) => Self::Exp { a: rows(a), out },
            Operation::Paired { of, other, slope, .. } => {
                Self::Paired { a: rows(of), degree: degree(of), other: at(other), slope, out }
            }
            Operation::Tangent { function, of } => {
                let circular = matches!(function.rule(), Rule::Quotient(Pair { slope: Slope::Minus, .. }));
                let slope = if circular { Slope::Plus } else { Slope::Minus };
                Self::Tangent { slope, a: weighted(of), square: at(position + 1), out }
            }
            Operation::Inverse { of, divisor, .. } => {
                Self::Inverse { a: weighted(of), divisor: at(divisor), out: rows(position) }
            }
            Operation::Abs(a) => Self::Abs { a: at(a), out },
            Operation::Sign(a) => Self::Sign { a: at(a), out },
        })
    }

    /// The row and its coefficient n, from the earlier coefficients and those of the operands; `None` if it is not in the ring.
    #[inline(always)]
    pub fn evaluate<E: Evaluator<P, X>>(&self, on: &E, n: usize) -> Option<(P, <E::Ring as Ring>::Element)> {
        let ring = on.ring();
        let at = |row: P| &on.row(row)[n];
        let first = |row: P| &on.row(row)[0];
        let before = |row: P| &on.row(row)[..n];
        let through = |row: P| &on.row(row)[..=n];
        let behind = |row: P| &on.row(row)[1..=n];
        let over_n = |weighted| over_integer(ring, &weighted, n);
        let signed = |slope: Slope, value| if slope == Slope::Plus { value } else { ring.negate(&value) };
        Some(match *self {
            Self::Weight { a, out } => (out, ring.times_integer(at(a), i64::try_from(n).unwrap_or(i64::MAX))),
            Self::Negate { a, out } => (out, ring.negate(at(a))),
            Self::Add { a, b, out } => (out, ring.add(at(a), at(b))),
            Self::Subtract { a, b, out } => (out, ring.subtract(at(a), at(b))),
            Self::Scale { factor, a, out } => (out, ring.multiply(first(factor), at(a))),
            Self::Multiply { a, b, out } => (out, ring.convolution(through(a), through(b))),
            Self::Square { a, out } => (out, on.square(through(a))),
            Self::Unscale { a, divisor, reciprocal, out } => {
                match reciprocal.filter(|_| n >= RECIPROCAL_FROM) {
                    Some(reciprocal) => (out, ring.multiply(at(a), first(reciprocal))),
                    None => (out, ring.divide(at(a), first(divisor))?),
                }
            }
            Self::Divide { a, b, out } => (out, on.quotient(at(a), before(out), through(b))?),
            Self::Power { ref exponent, a, out } => {
                let lower = Both { plain: before(out.plain), weighted: before(out.weighted) };
                let of = Both { plain: through(a.plain), weighted: through(a.weighted) };
                let value = weighted_power(ring, &on.exponent(exponent)?, of, lower);
                let later = on.begins_beyond(exponent, n);
                (out.plain, over_n(on.over_base(&value, first(a.plain), later)?)?)
            }
            Self::Exp { a, out } => (out, on.integral(at(a.plain), behind(a.weighted), before(out))?),
            Self::Paired { a, degree, other, slope, out } if degree < n => {
                let (weighted, other) = (&on.row(a.weighted)[1..=degree], &on.row(other)[n - degree..n]);
                (out, over_n(signed(slope, weighted_integral(ring, weighted, other)))?)
            }
            Self::Paired { a, other, slope, out, .. } => {
                (out, signed(slope, on.integral(at(a.plain), behind(a.weighted), before(other))?))
            }
            Self::Tangent { slope, a, square, out } => {
                let driven = weighted_integral(ring, behind(a), before(square));
                (out, over_n(ring.add(at(a), &signed(slope, driven)))?)
            }
            Self::Inverse { a, divisor, out } => {
                let lower = &on.row(out.weighted)[1..n];
                (out.plain, over_n(weighted_integral_of_quotient(ring, at(a), lower, before(divisor))?)?)
            }
            Self::Abs { a, out } => (out, ring.multiply(&ring.divide(first(out), first(a))?, at(a))),
            // The sign is constant on either side of zero; at zero it has no series.
            Self::Sign { a, .. } if ring.is_zero(first(a)) => return None,
            Self::Sign { out, .. } => (out, ring.zero()),
        })
    }
}
