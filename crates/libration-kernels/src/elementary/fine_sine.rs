//! Sine and cosine of an angle in two words, more accurate than the last bit of the first word.

use super::polynomial;
use crate::double_double::{DoubleDouble, fast_two_sum};

/// (sin r − r)/r³ in r² for |r| ≤ π/4, relative error 4.4e-19 (of a term below 11 % of the sine); the first coefficient
/// is −1/6, kept in two words.
const SINE_LEADING: DoubleDouble = DoubleDouble::new(-0.16666666666666666, -9.25185853854297e-18);
const SINE: [f64; 6] = [
    0.008333333333333333,
    -0.00019841269841268963,
    2.755731922232509e-06,
    -2.5052107236381626e-08,
    1.6058684400905804e-10,
    -7.595311845794912e-13,
];

/// (cos r − 1 + r²/2)/r⁴ in r² for |r| ≤ π/4, relative error 8.7e-19; the first coefficient is 1/24, kept in two words.
const COSINE_LEADING: DoubleDouble = DoubleDouble::new(0.041666666666666664, 2.3129646346357427e-18);
const COSINE: [f64; 6] = [
    -0.001388888888888889,
    2.4801587301586814e-05,
    -2.755731922306274e-07,
    2.087675634918288e-09,
    -1.1470545821738428e-11,
    4.7506609934372764e-14,
];

/// sin r and cos r for |r| up to slightly above π/4, relative error below 2⁻⁵⁹.
#[inline(always)]
pub fn fine_sin_cos(r: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let square = r.square();
    let x = square.hi;
    let sine = SINE_LEADING.plus_smaller(DoubleDouble::from(x * polynomial(x, &SINE)));
    let cosine = COSINE_LEADING.plus_smaller(DoubleDouble::from(x * polynomial(x, &COSINE)));
    let half = fast_two_sum(1.0, -0.5 * square.hi);
    let leading = fast_two_sum(half.hi, half.lo - 0.5 * square.lo);
    (r.plus_smaller(r * square * sine), leading.plus_smaller(square.square() * cosine))
}
