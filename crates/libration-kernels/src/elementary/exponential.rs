//! The exponential function, without branches.

use super::{nearest_integer, polynomial, power_of_two};
use crate::double_double::{DoubleDouble, two_prod};

/// 1/n! from n = 0, for the terms that need the second word.
const LEADING: [DoubleDouble; 8] = [
    DoubleDouble::new(1.0, 0.0),
    DoubleDouble::new(1.0, 0.0),
    DoubleDouble::new(0.5, 0.0),
    DoubleDouble::new(0.16666666666666666, 9.25185853854297e-18),
    DoubleDouble::new(0.041666666666666664, 2.3129646346357427e-18),
    DoubleDouble::new(0.008333333333333333, 1.1564823173178714e-19),
    DoubleDouble::new(0.001388888888888889, -5.300543954373577e-20),
    DoubleDouble::new(0.0001984126984126984, 1.7209558293420705e-22),
];
/// 1/n! for the later terms: for |r| ≤ ln 2/2 they are below 1e-8 of the sum, and the omitted terms below 3e-28.
const TAIL: [f64; 12] = [
    2.48015873015873e-05,
    2.7557319223985893e-06,
    2.755731922398589e-07,
    2.505210838544172e-08,
    2.08767569878681e-09,
    1.6059043836821613e-10,
    1.1470745597729725e-11,
    7.647163731819816e-13,
    4.779477332387385e-14,
    2.8114572543455206e-15,
    1.5619206968586225e-16,
    8.22063524662433e-18,
];

/// eˣ for |x| ≤ 700 in two words, relative error below 2⁻⁷⁸.
#[inline(always)]
pub fn exp(x: DoubleDouble) -> DoubleDouble {
    let n = nearest_integer(x.hi * std::f64::consts::LOG2_E);
    let r = x - two_prod(DoubleDouble::LN_2.hi, n) - two_prod(DoubleDouble::LN_2.lo, n);
    let mut sum = DoubleDouble::from(polynomial(r.hi, &TAIL));
    let mut i = LEADING.len();
    while i > 0 {
        i -= 1;
        sum = LEADING[i].plus_smaller(r * sum);
    }
    sum.scaled(power_of_two(n))
}
