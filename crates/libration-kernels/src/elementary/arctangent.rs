//! The arctangent of a ratio of two positive numbers.

use super::polynomial;
use crate::double_double::{DoubleDouble, fast_two_sum, two_sum};
use crate::fused::FusedMultiplyAdd;

/// (atan t − t)/t³ in t² for |t| ≤ √2 − 1, relative error 1.3e-16 (the term is below 6 % of the arctangent).
const ARCTANGENT: [f64; 11] = [
    -0.3333333333333333,
    0.1999999999999552,
    -0.14285714284666542,
    0.11111111015256361,
    -0.09090904578123901,
    0.07692183190826087,
    -0.06664511447381939,
    0.05858148912802137,
    -0.05085449737939879,
    0.039231658295576184,
    -0.019176887119048774,
];

const FRAC_PI_4: DoubleDouble = DoubleDouble::new(0.7853981633974483, 3.061616997868383e-17);

/// tan(π/8) = √2 − 1.
const TAN_PI_8: f64 = 0.41421356237309503;

/// atan(small/large) for 0 ≤ small ≤ large, within [0, π/4], in two words, relative error below 2⁻⁵⁴.
#[inline(always)]
pub fn atan_of_ratio(small: DoubleDouble, large: DoubleDouble) -> DoubleDouble {
    ReducedArctangent::from_quotient(small, large).angle()
}

/// An arctangent as upper·π/4 + atan t, |t| ≤ √2 − 1.
#[derive(Clone, Copy, Debug)]
pub struct ReducedArctangent {
    /// One or zero.
    pub upper: f64,
    /// t to the nearest word.
    pub t: f64,
    /// The remainder of t.
    pub t_lo: f64,
}

impl ReducedArctangent {
    /// The reduction of `small/large`, a quotient between 0 and 1.
    #[inline(always)]
    pub fn from_quotient(small: DoubleDouble, large: DoubleDouble) -> Self {
        // A weight of one or zero replaces a selection, which the compiler would turn into a selection between two divisions.
        let upper = if small.hi > TAN_PI_8 * large.hi { 1.0 } else { 0.0 };
        // tan(a − π/4) = (small − large)/(small + large); the difference of the first words is exact.
        let numerator = large.hi.fma(-upper, small.hi);
        let numerator_lo = large.lo.fma(-upper, small.lo);
        let denominator = fast_two_sum(large.hi, upper * small.hi);
        let denominator_lo = denominator.lo + small.lo.fma(upper, large.lo);
        let inverse = 1.0 / denominator.hi;
        let t = numerator * inverse;
        let residual = (-t).fma(denominator.hi, numerator) + (-t).fma(denominator_lo, numerator_lo);
        Self { upper, t, t_lo: residual * inverse }
    }

    /// The arctangent in radians.
    #[inline(always)]
    pub fn angle(&self) -> DoubleDouble {
        let x = self.t * self.t;
        let tail = (self.t * x).fma(polynomial(x, &ARCTANGENT), self.upper.fma(FRAC_PI_4.lo, self.t_lo));
        // For `upper` = 1, π/4 is the larger term; otherwise it is absent.
        let leading = two_sum(self.upper * FRAC_PI_4.hi, self.t);
        fast_two_sum(leading.hi, leading.lo + tail)
    }
}
