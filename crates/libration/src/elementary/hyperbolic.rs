//! Hyperbolic sine and cosine together.

use super::{nearest_integer, polynomial, power_of_two};
use crate::double_double::DoubleDouble;

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

/// sinh z and cosh z for |z| ≤ 700, about 1 ulp; the sine with full relative accuracy.
#[inline(always)]
pub(crate) fn sinh_cosh(z: DoubleDouble) -> (f64, f64) {
    let n = nearest_integer(z.hi * std::f64::consts::LOG2_E);
    // Exact: both words are multiples of 2⁻⁵⁴ whenever n ≠ 0.
    let r = (-n).mul_add(DoubleDouble::LN_2.hi, z.hi);
    let r_lo = (-n).mul_add(DoubleDouble::LN_2.lo, z.lo);
    let x = r * r;
    let sinh = r + (r * x).mul_add(polynomial(x, &SINH), 0.5f64.mul_add(x, 1.0) * r_lo);
    // cosh r − 1, so that what is multiplied by 2ⁿ is rounded below the leading term.
    let cosh = (x * x).mul_add(polynomial(x, &COSH), r.mul_add(r_lo, 0.5 * x));
    let (up, down) = (0.5 * power_of_two(n), 0.5 * power_of_two(-n));
    let (difference, sum) = (up - down, up + down);
    (difference + difference.mul_add(cosh, sum * sinh), sum + sum.mul_add(cosh, difference * sinh))
}
