//! Elementary functions in two words, relative error about 2⁻¹⁰⁰. They are slow and serve values that are prepared once.

use crate::dispatch::{Kernel, dispatch};
use crate::double_double::block::{BLOCK, Words};
use crate::double_double::{DoubleDouble, fast_two_sum};

/// sin x and cos x for |x| up to slightly above π/2; each is relatively accurate except next to its far zero.
pub fn sin_cos(x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    dispatch(SinCos(x))
}

struct SinCos(DoubleDouble);

impl Kernel for SinCos {
    type Output = (DoubleDouble, DoubleDouble);
    #[inline(always)]
    fn run(self) -> (DoubleDouble, DoubleDouble) {
        sin_cos_inline(self.0)
    }
}

/// [`sin_cos`] inside a kernel.
#[inline(always)]
pub fn sin_cos_inline(x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    if x.hi.abs() > std::f64::consts::FRAC_PI_4 {
        let rest = if x.hi > 0.0 { DoubleDouble::FRAC_PI_2 - x } else { DoubleDouble::FRAC_PI_2 + x };
        let (c, s) = sin_cos_series(rest);
        return (if x.hi > 0.0 { s } else { -s }, c);
    }
    sin_cos_series(x)
}

/// 1/(2n(2n − 1)) for n = 1, 2, ….
const OF_COSINE: [DoubleDouble; 14] = [
    DoubleDouble::new(0.5, 0.0),
    DoubleDouble::new(0.08333333333333333, 4.625929269271485e-18),
    DoubleDouble::new(0.03333333333333333, 4.625929269271486e-19),
    DoubleDouble::new(0.017857142857142856, 9.912705577010326e-19),
    DoubleDouble::new(0.011111111111111112, -4.2404351634988616e-19),
    DoubleDouble::new(0.007575757575757576, -2.1026951223961299e-19),
    DoubleDouble::new(0.005494505494505495, -4.2891514515910067e-19),
    DoubleDouble::new(0.004166666666666667, 5.782411586589357e-20),
    DoubleDouble::new(0.0032679738562091504, -9.920804192677818e-20),
    DoubleDouble::new(0.002631578947368421, 5.934580312552235e-20),
    DoubleDouble::new(0.0021645021645021645, 1.8774063592822588e-21),
    DoubleDouble::new(0.0018115942028985507, -2.199830494898125e-20),
    DoubleDouble::new(0.0015384615384615385, 1.3344026738283131e-21),
    DoubleDouble::new(0.0013227513227513227, 7.3427448718595e-20),
];
/// 1/(2n(2n + 1)).
const OF_SINE: [DoubleDouble; 14] = [
    DoubleDouble::new(0.16666666666666666, 9.25185853854297e-18),
    DoubleDouble::new(0.05, -2.7755575615628915e-18),
    DoubleDouble::new(0.023809523809523808, 1.32169407693471e-18),
    DoubleDouble::new(0.013888888888888888, 7.709882115452476e-19),
    DoubleDouble::new(0.00909090909090909, 4.415659757031872e-19),
    DoubleDouble::new(0.00641025641025641, 2.2240044563805217e-19),
    DoubleDouble::new(0.004761904761904762, -4.295505750037808e-19),
    DoubleDouble::new(0.003676470588235294, 5.102127870520021e-20),
    DoubleDouble::new(0.0029239766081871343, 1.6231330769373633e-19),
    DoubleDouble::new(0.002380952380952381, -2.147752875018904e-19),
    DoubleDouble::new(0.001976284584980237, 1.3370398332627564e-19),
    DoubleDouble::new(0.0016666666666666668, -1.0697461435190311e-19),
    DoubleDouble::new(0.0014245014245014246, -7.104458680104445e-20),
    DoubleDouble::new(0.0012315270935960591, -1.3886333243656708e-20),
];
/// 1/n.
const OF_EXPONENTIAL: [DoubleDouble; 24] = [
    DoubleDouble::new(1.0, 0.0),
    DoubleDouble::new(0.5, 0.0),
    DoubleDouble::new(0.3333333333333333, 1.850371707708594e-17),
    DoubleDouble::new(0.25, 0.0),
    DoubleDouble::new(0.2, -1.1102230246251566e-17),
    DoubleDouble::new(0.16666666666666666, 9.25185853854297e-18),
    DoubleDouble::new(0.14285714285714285, 7.93016446160826e-18),
    DoubleDouble::new(0.125, 0.0),
    DoubleDouble::new(0.1111111111111111, 6.1679056923619804e-18),
    DoubleDouble::new(0.1, -5.551115123125783e-18),
    DoubleDouble::new(0.09090909090909091, -2.523234146875356e-18),
    DoubleDouble::new(0.08333333333333333, 4.625929269271485e-18),
    DoubleDouble::new(0.07692307692307693, -4.270088556250602e-18),
    DoubleDouble::new(0.07142857142857142, 3.96508223080413e-18),
    DoubleDouble::new(0.06666666666666667, 9.251858538542971e-19),
    DoubleDouble::new(0.0625, 0.0),
    DoubleDouble::new(0.058823529411764705, 8.163404592832033e-19),
    DoubleDouble::new(0.05555555555555555, 3.0839528461809902e-18),
    DoubleDouble::new(0.05263157894736842, 2.921639538487254e-18),
    DoubleDouble::new(0.05, -2.7755575615628915e-18),
    DoubleDouble::new(0.047619047619047616, 2.64338815386942e-18),
    DoubleDouble::new(0.045454545454545456, -1.261617073437678e-18),
    DoubleDouble::new(0.043478260869565216, 1.206764157201257e-18),
    DoubleDouble::new(0.041666666666666664, 2.3129646346357427e-18),
];

/// Taylor's series in nested form for |x| ≤ π/4.
#[inline(always)]
pub fn sin_cos_series(x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let y = -x.square();
    let (mut sine, mut cosine) = (DoubleDouble::ONE, DoubleDouble::ONE);
    for (of_cosine, of_sine) in OF_COSINE.iter().zip(&OF_SINE).rev() {
        cosine = next_sum(y, cosine, *of_cosine);
        sine = next_sum(y, sine, *of_sine);
    }
    (x * sine, cosine)
}

/// 1 + y·sum·factor.
#[inline(always)]
fn next_sum(y: DoubleDouble, sum: DoubleDouble, factor: DoubleDouble) -> DoubleDouble {
    DoubleDouble::ONE.plus_smaller(y * sum * factor)
}

/// [`sin_cos_series`] of a block, bit for bit. The loop over terms is outermost, because a loop over terms inside a loop over elements is not
/// vectorised.
#[inline(always)]
pub fn sin_cos_series_of_block(angles: &Words, sines: &mut Words, cosines: &mut Words) {
    let mut squares = Words::ZERO;
    (*sines, *cosines) = (Words::ONE, Words::ONE);
    for i in 0..BLOCK {
        squares.set(i, -angles.get(i).square());
    }
    for (of_cosine, of_sine) in OF_COSINE.iter().zip(&OF_SINE).rev() {
        for i in 0..BLOCK {
            cosines.set(i, next_sum(squares.get(i), cosines.get(i), *of_cosine));
            sines.set(i, next_sum(squares.get(i), sines.get(i), *of_sine));
        }
    }
    for i in 0..BLOCK {
        sines.set(i, angles.get(i) * sines.get(i));
    }
}

/// eˣ for −745.2 ≤ x ≤ 709; below −700 the second word begins to underflow, which does not affect the value rounded to one word.
pub fn exp(x: DoubleDouble) -> DoubleDouble {
    let n = (x.hi * std::f64::consts::LOG2_E).round();
    let r = x - DoubleDouble::LN_2 * n;
    let mut sum = DoubleDouble::ONE;
    for of_exponential in OF_EXPONENTIAL.iter().rev() {
        sum = DoubleDouble::ONE.plus_smaller(r * sum * *of_exponential);
    }
    // Two factors, so that neither overflows or becomes subnormal.
    let half = (n / 2.0).round();
    sum.scaled(libm::exp2(half)).scaled(libm::exp2(n - half))
}

/// ln x for a positive x, however small.
pub fn ln(x: DoubleDouble) -> DoubleDouble {
    let (half_to_one, above) = libm::frexp(x.hi);
    // Within [√½, √2): nothing cancels near one, and the power computed below keeps its second word.
    let exponent = if half_to_one < std::f64::consts::FRAC_1_SQRT_2 { above - 1 } else { above };
    let fraction = x.times_power_of_two(-exponent);
    let first = DoubleDouble::from(libm::log(fraction.hi));
    // With y the first guess, ln x = y + 2 artanh((x − eʸ)/(x + eʸ)), and the argument is of order 2⁻⁵³.
    let guess = exp(first);
    let missing = ((fraction - guess) / (fraction + guess)).scaled(2.0);
    DoubleDouble::LN_2 * f64::from(exponent) + (first + missing)
}

/// The angle of the point (x, y), within [−π, π].
pub fn atan2(y: DoubleDouble, x: DoubleDouble) -> DoubleDouble {
    let size = if y.hi.abs() > x.hi.abs() { y.abs() } else { x.abs() };
    if size.hi == 0.0 || !size.is_finite() {
        return DoubleDouble::from(libm::atan2(y.hi, x.hi));
    }
    let (y, x) = (y / size, x / size);
    let (ay, ax) = (y.abs(), x.abs());
    let small = ay.hi <= ax.hi;
    let acute = if small { atan_unit(ay, ax) } else { DoubleDouble::FRAC_PI_2 - atan_unit(ax, ay) };
    let angle = if x.hi < 0.0 { DoubleDouble::PI - acute } else { acute };
    if y.hi < 0.0 { -angle } else { angle }
}

/// atan(y/x) for 0 ≤ y ≤ x.
fn atan_unit(y: DoubleDouble, x: DoubleDouble) -> DoubleDouble {
    let first = DoubleDouble::from(libm::atan2(y.hi, x.hi));
    let (s, c) = sin_cos(first);
    // The tangent of the remaining angle, which is so small that it equals the angle.
    let correction = (y * c - x * s) / (x * c + y * s);
    let sum = first + correction;
    fast_two_sum(sum.hi, sum.lo)
}
