//! Sine and cosine of an angle, or of one given as a fraction of a turn.

use super::{nearest_integer, nearest_integer_bits, polynomial};
use crate::double_double::{DoubleDouble, fast_two_sum, two_sum};
use crate::fused::FusedMultiplyAdd;

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
pub fn sin_cos_of_turns(y: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let r = y.hi * TAU.hi;
    let r_lo = y.hi.fma(TAU.hi, -r) + y.hi.fma(TAU.lo, y.lo * TAU.hi);
    sin_cos_of_part(r, r_lo)
}

/// Sine and cosine of `r + r_lo` in two words, |r| ≤ π/4.
#[inline(always)]
fn sin_cos_of_part(r: f64, r_lo: f64) -> (DoubleDouble, DoubleDouble) {
    let x = r * r;
    let half = 0.5 * x;
    let sine = fast_two_sum(r, (r * x).fma(polynomial(x, &SINE), r_lo * (1.0 - half)));
    let leading = 1.0 - half;
    let square_lo = r.fma(r, -x);
    let rounding = ((1.0 - leading) - half) - 0.5 * square_lo;
    let cosine = fast_two_sum(leading, (x * x).fma(polynomial(x, &COSINE), rounding - r * r_lo));
    (sine, cosine)
}

/// Largest angle of [`sin_cos`].
pub const LARGEST_ANGLE: f64 = 1048576.0;

/// sin x and cos x for |x| ≤ [`LARGEST_ANGLE`], within 0.8 ulp; 98 % of the results are correctly rounded.
#[inline(always)]
pub fn sin_cos(x: f64) -> (f64, f64) {
    const FRAC_PI_2: [f64; 3] =
        [DoubleDouble::FRAC_PI_2.hi, DoubleDouble::FRAC_PI_2.lo, 0.5 * DoubleDouble::PI_TAIL.lo];
    let quarters = x * std::f64::consts::FRAC_2_PI;
    let whole = nearest_integer(quarters);
    // Exact: a multiple of 2⁻⁵³ below one.
    let first = whole.fma(-FRAC_PI_2[0], x);
    let product = whole * FRAC_PI_2[1];
    let product_lo = whole.fma(FRAC_PI_2[1], -product);
    let r = two_sum(first, -product);
    let (sine, cosine) = sin_cos_of_part(r.hi, r.lo - whole.fma(FRAC_PI_2[2], product_lo));
    let quarter = nearest_integer_bits(quarters) as u64;
    let (sine, cosine) = if quarter & 1 == 0 { (sine.hi, cosine.hi) } else { (cosine.hi, sine.hi) };
    let signed = |value: f64, half_turns: u64| f64::from_bits(value.to_bits() ^ ((half_turns & 2) << 62));
    // Zero keeps its sign.
    (if x == 0.0 { x } else { signed(sine, quarter) }, signed(cosine, quarter + 1))
}
