//! The natural logarithm of a two-word number, split so that sums with it keep their last bits.

use super::polynomial;
use crate::double_double::DoubleDouble;
use crate::fused::FusedMultiplyAdd;

/// (2 atanh q − 2q)/q³ in q² for |q| ≤ (√2−1)/(√2+1), relative error 5.5e-17 (of a term below 1 %).
const ATANH: [f64; 8] = [
    0.6666666666666666,
    0.4000000000000088,
    0.28571428570803614,
    0.22222222391713917,
    0.18181795640132906,
    0.15386239702814664,
    0.13268773138656761,
    0.13086626147841382,
];

/// ln x = exponent·ln 2 + leading + tail, with |leading| ≤ ln 2/2 and |tail| below 1 % of |leading|.
#[derive(Debug)]
pub struct Logarithm {
    /// An integer.
    pub exponent: f64,
    /// The leading part of the fraction, an exact `f64`.
    pub leading: f64,
    /// The rest of the fraction, with an absolute error of 2⁻⁵⁸.
    pub tail: f64,
}

/// The parts of ln x for a normal positive x.
#[inline(always)]
pub fn split_logarithm(x: DoubleDouble) -> Logarithm {
    let reduced = ReducedLogarithm::from_number(x);
    Logarithm { exponent: reduced.exponent, leading: reduced.leading(), tail: reduced.tail() }
}

/// A number reduced for its logarithm: x = 2ᵉf, with ln f = 2 artanh q and q = (f − 1)/(f + 1).
#[derive(Debug)]
pub struct ReducedLogarithm {
    /// The exponent e of the power of two, an integer.
    pub exponent: f64,
    /// q to the nearest word.
    pub q: f64,
    /// The remainder of q.
    pub q_lo: f64,
}

impl ReducedLogarithm {
    /// The reduction of a positive number.
    #[inline(always)]
    pub fn from_number(x: DoubleDouble) -> Self {
        let (exponent, scale) = exponent_and_scale(x.hi);
        let (f, f_lo) = (x.hi * scale, x.lo * scale);
        let numerator = f - 1.0;
        let denominator = f + 1.0;
        let denominator_lo = (f - (denominator - 1.0)) + f_lo;
        let inverse = reciprocal(denominator);
        let q = numerator * inverse;
        let residual = (-q).fma(denominator, numerator) + (f_lo - q * denominator_lo);
        Self { exponent, q, q_lo: residual * inverse }
    }

    /// The leading part of the logarithm.
    #[inline(always)]
    pub fn leading(&self) -> f64 {
        2.0 * self.q
    }

    /// The later part of the logarithm.
    #[inline(always)]
    pub fn tail(&self) -> f64 {
        let square = self.q * self.q;
        (self.q * square).fma(polynomial(square, &ATANH), 2.0 * self.q_lo)
    }
}

/// 1/x for 1 + √½ ≤ x ≤ 1 + √2, relative error 1.1e-4.
const RECIPROCAL: [f64; 4] = [1.97034285, -1.44853978, 0.470943465, -0.057135023];

/// 1/x for 1 + √½ ≤ x ≤ 1 + √2 with a relative error below 1.2·2⁻⁵², by Newton's method: a division would make eight periods side by side wait
/// for a sixth of their time.
#[inline(always)]
#[doc(hidden)]
pub fn reciprocal(x: f64) -> f64 {
    let start = polynomial(x, &RECIPROCAL);
    let better = start * (2.0 - x * start);
    better.fma((-x).fma(better, 1.0), better)
}

/// e and 2⁻ᵉ with x·2⁻ᵉ within [√½, √2), for a normal positive x; arbitrary values for other x.
#[inline(always)]
pub(super) fn exponent_and_scale(x: f64) -> (f64, f64) {
    /// The bits of √½: after their subtraction the exponent field changes where the mantissa passes √2.
    const SQRT_HALF: u64 = 0x3fe6_a09e_667f_3bcd;
    /// 2⁵² as bits; with an integer below 2⁵² in its low bits it becomes 2⁵² + that integer.
    const BIG: u64 = 0x4330_0000_0000_0000;
    // Biased by 1024 so that it is positive.
    let biased = x.to_bits().wrapping_sub(SQRT_HALF).wrapping_add(1024 << 52) >> 52;
    let exponent = f64::from_bits(biased | BIG) - (4503599627370496.0 + 1024.0);
    (exponent, f64::from_bits((1023u64 + 1024).wrapping_sub(biased) << 52))
}
