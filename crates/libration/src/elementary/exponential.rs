//! The exponential function.

use super::{nearest_integer, polynomial, power_of_two};
use crate::double_double::{DoubleDouble, fast_two_sum, two_prod};

/// (exp r − 1 − r − r²/2)/r³ for |r| ≤ ln 2/2, relative error 1.3e-16 (of a term below 1 %).
const EXPONENTIAL: [f64; 10] = [
    0.16666666666666669,
    0.041666666666666664,
    0.008333333333330065,
    0.0013888888888886554,
    0.00019841269863040545,
    2.4801587317135164e-05,
    2.7557268480310024e-06,
    2.755728298405588e-07,
    2.5100375832561277e-08,
    2.0911229729758595e-09,
];

/// eˣ for |x| ≤ 700 in two words, relative error below 2⁻⁵⁷.
#[inline(always)]
pub(crate) fn exp(x: DoubleDouble) -> DoubleDouble {
    let n = nearest_integer(x.hi * std::f64::consts::LOG2_E);
    let r = x - two_prod(DoubleDouble::LN_2.hi, n) - DoubleDouble::LN_2.lo * n;
    let half_square = two_prod(r.hi, r.hi).scaled(0.5);
    let first = fast_two_sum(1.0, r.hi);
    let second = fast_two_sum(first.hi, half_square.hi);
    let tail = (r.hi * r.hi * r.hi).mul_add(polynomial(r.hi, &EXPONENTIAL), half_square.lo + first.lo);
    fast_two_sum(second.hi, second.lo + (tail + r.lo.mul_add(r.hi, r.lo))).scaled(power_of_two(n))
}
