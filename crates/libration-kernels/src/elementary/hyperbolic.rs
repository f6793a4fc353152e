//! Hyperbolic sine and cosine together.

use super::{nearest_integer, polynomial, power_of_two};
use crate::double_double::{DoubleDouble, fast_two_sum, two_prod};
use crate::fused::FusedMultiplyAdd;

/// (sinh r − r)/r³ in r² for |r| ≤ ln 2/2, relative error 1.1e-16 (of a term below 2 % of the sine).
const SINH: [f64; 5] = [
    0.16666666666666669,
    0.008333333333330065,
    0.00019841269863040545,
    2.7557268480310024e-06,
    2.5100375832561277e-08,
];

/// (cosh r − 1 − r²/2)/r⁴ in r² for |r| ≤ ln 2/2, relative error 8.2e-17.
const COSH: [f64; 5] = [
    0.041666666666666664,
    0.0013888888888886554,
    2.4801587317135164e-05,
    2.755728298405588e-07,
    2.0911229729758595e-09,
];

/// sinh z and cosh z for |z| ≤ 700 in two words, relative error below 2⁻⁵²·⁵; the sine with full relative
/// accuracy.
#[inline(always)]
pub fn sinh_cosh(z: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let n = nearest_integer(z.hi * std::f64::consts::LOG2_E);
    // Exact, since both words are multiples of 2⁻⁵⁴ whenever n ≠ 0.
    let r = (-n).fma(DoubleDouble::LN_2.hi, z.hi);
    let r_lo = (-n).fma(DoubleDouble::LN_2.lo, z.lo);
    let x = r * r;
    let sinh_tail = (r * x).fma(polynomial(x, &SINH), 0.5f64.fma(x, 1.0) * r_lo);
    // cosh r − 1, with the rounding error of its leading term r²/2.
    let square_lo = r.fma(r, -x);
    let half = 0.5 * x;
    let cosh_tail = (x * x).fma(polynomial(x, &COSH), r.fma(r_lo, 0.5 * square_lo));
    let (up, down) = (0.5 * power_of_two(n), 0.5 * power_of_two(-n));
    let (difference, sum) = (up - down, up + down);
    (
        combination(difference, sum, half, cosh_tail, r, sinh_tail),
        combination(sum, difference, half, cosh_tail, r, sinh_tail),
    )
}

/// a·(1 + half + `cosh_tail`) + b·(r + `sinh_tail`) in two words; a is zero or above |b·r|, and the terms added last are below a fifth of the
/// sum.
#[inline(always)]
fn combination(a: f64, b: f64, half: f64, cosh_tail: f64, r: f64, sinh_tail: f64) -> DoubleDouble {
    let product = two_prod(b, r);
    let leading = fast_two_sum(a, product.hi);
    let rest = a.fma(half, leading.lo + a.fma(cosh_tail, b.fma(sinh_tail, product.lo)));
    fast_two_sum(leading.hi, rest)
}
