//! The arctangent of a ratio of two positive numbers.

use super::polynomial;
use crate::double_double::{DoubleDouble, fast_two_sum};

/// (atan t − t)/t³ in t² for |t| ≤ √2 − 1, relative error 1.3e-16 (of a term below 6 % of the arctangent).
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

/// atan(small/large) for 0 ≤ small ≤ large, within [0, π/4], about 1.5 ulp.
#[inline(always)]
pub(crate) fn atan_of_ratio(small: f64, large: f64) -> DoubleDouble {
    let upper = small > TAN_PI_8 * large;
    let numerator = if upper { small - large } else { small };
    let denominator = if upper { small + large } else { large };
    let base = if upper { FRAC_PI_4.hi } else { 0.0 };
    let base_lo = if upper { FRAC_PI_4.lo } else { 0.0 };
    let t = numerator / denominator;
    let x = t * t;
    let tail = (t * x).mul_add(polynomial(x, &ARCTANGENT), base_lo);
    let leading = if upper { fast_two_sum(base, t) } else { DoubleDouble::from(t) };
    fast_two_sum(leading.hi, leading.lo + tail)
}
