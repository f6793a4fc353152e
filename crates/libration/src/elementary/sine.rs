//! Sine and cosine of an angle given as a fraction of a turn.

use super::polynomial;
use crate::double_double::{DoubleDouble, fast_two_sum};

const TAU: DoubleDouble = DoubleDouble::new(6.283185307179586, 2.4492935982947064e-16);

/// (sin r − r)/r³ in r² for |r| ≤ π/4, relative error 2.0e-16 (of a term below 11 % of the sine).
const SINE: [f64; 6] = [
    -0.16666666666666666,
    0.008333333333330948,
    -0.00019841269836758574,
    2.755731610255244e-06,
    -2.5051131845003624e-08,
    1.591812929486648e-10,
];

/// (cos r − 1 + r²/2)/r⁴ in r² for |r| ≤ π/4, relative error 5.7e-17.
const COSINE: [f64; 6] = [
    0.041666666666666664,
    -0.0013888888888887398,
    2.480158729876569e-05,
    -2.7557317271729793e-07,
    2.0876146268403195e-09,
    -1.1382632425521638e-11,
];

/// sin 2πy and cos 2πy for |y| ≤ 1/8 in two words, relative error below 2⁻⁵⁴.
#[inline(always)]
pub(crate) fn sin_cos_of_turns(y: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let r = y.hi * TAU.hi;
    let r_lo = y.hi.mul_add(TAU.hi, -r) + y.hi.mul_add(TAU.lo, y.lo * TAU.hi);
    let x = r * r;
    let half = 0.5 * x;
    let sine = fast_two_sum(r, (r * x).mul_add(polynomial(x, &SINE), r_lo * (1.0 - half)));
    let leading = 1.0 - half;
    let square_lo = r.mul_add(r, -x);
    let rounding = ((1.0 - leading) - half) - 0.5 * square_lo;
    let cosine = fast_two_sum(leading, (x * x).mul_add(polynomial(x, &COSINE), rounding - r * r_lo));
    (sine, cosine)
}
