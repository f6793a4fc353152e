//! Numbers in two words: an unevaluated sum `hi + lo` of two `f64`, good to about 106 bits.
//!
//! The error-free transformations are Knuth's two-sum and the product by fused multiply-add. Sums and products follow M. Joldes, J.-M. Muller
//! and V. Popescu, *Tight and rigorous error bounds for basic building blocks of double-word arithmetic*, ACM TOMS 44 (2017),
//! doi:10.1145/3121432; each operation states its relative error bound from there (u = 2⁻⁵³).
//!
//! # Method
//! A number takes two words where one `f64` is not enough. Values that are computed once for a motion or a modulus are kept in two words: k, k′,
//! K, E, the incomplete integrals by Carlson's duplication, and the factors of the theta quotients. Values that are computed a million times
//! (period, phase, theta values, quotients, angle) keep their leading terms in two words until the last rounding; the small terms added to them,
//! such as those that follow the first term of a polynomial, are plain `f64`. Where π itself is subtracted, the third word of π is used
//! (`DoubleDouble::PI_TAIL`). Squares of complements are not formed where they would underflow, so that k′ down to 1e-300 needs no special case.

pub mod block;

use crate::fused::FusedMultiplyAdd;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// An unevaluated sum of two `f64` with `|lo| ≤ ulp(hi)/2`.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    /// The leading word: the sum rounded to nearest.
    pub hi: f64,
    /// The remainder, at most half an ulp of the leading word.
    pub lo: f64,
}

/// Number below which the rounding error of a square root underflows.
const TINY: f64 = 1e-270;
/// 2¹⁰⁰.
const TWO_TO_100: f64 = 1267650600228229401496703205376.0;
const TWO_TO_200: f64 = TWO_TO_100 * TWO_TO_100;

/// `a + b` and its rounding error, exactly.
#[inline(always)]
pub fn two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    let bb = hi - a;
    DoubleDouble { hi, lo: (a - (hi - bb)) + (b - bb) }
}

/// `a + b` and its rounding error, exactly, provided `|a| ≥ |b|` or `a = 0`.
#[inline(always)]
pub fn fast_two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    DoubleDouble { hi, lo: b - (hi - a) }
}

/// `a · b` and its rounding error, exactly unless the error underflows.
#[inline(always)]
pub fn two_prod(a: f64, b: f64) -> DoubleDouble {
    let hi = a * b;
    DoubleDouble { hi, lo: a.fma(b, -hi) }
}

/// Selects one of two numbers word by word, which the compiler turns into selections without branches.
#[inline(always)]
pub fn pick(condition: bool, yes: DoubleDouble, no: DoubleDouble) -> DoubleDouble {
    DoubleDouble::new(if condition { yes.hi } else { no.hi }, if condition { yes.lo } else { no.lo })
}

/// |x|.
#[inline(always)]
pub fn magnitude(x: DoubleDouble) -> DoubleDouble {
    DoubleDouble::new(x.hi.abs(), 1f64.copysign(x.hi) * x.lo)
}

impl DoubleDouble {
    /// Zero.
    pub const ZERO: Self = Self::new(0.0, 0.0);
    /// One.
    pub const ONE: Self = Self::new(1.0, 0.0);
    /// π to 2⁻¹⁰⁷ (DLMF 3.12.1).
    pub const PI: Self = Self::new(3.141592653589793, 1.2246467991473532e-16);
    /// π − `PI.hi` to 2⁻¹⁶⁰: the second and the third word of π.
    pub const PI_TAIL: Self = Self::new(Self::PI.lo, -2.9947698097183397e-33);
    /// π/2.
    pub const FRAC_PI_2: Self = Self::new(1.5707963267948966, 6.123233995736766e-17);
    /// 2/π.
    pub const FRAC_2_PI: Self = Self::new(0.6366197723675814, -3.935735335036497e-17);
    /// ln 2.
    pub const LN_2: Self = Self::new(0.6931471805599453, 2.3190468138462996e-17);

    /// The number with these words; the caller ensures `|lo| ≤ ulp(hi)/2`.
    #[inline(always)]
    pub const fn new(hi: f64, lo: f64) -> Self {
        Self { hi, lo }
    }

    /// The sum rounded to one word.
    #[inline(always)]
    pub fn to_f64(self) -> f64 {
        self.hi + self.lo
    }

    /// The absolute value.
    #[inline(always)]
    pub fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }

    /// Multiplication by a power of two, exact unless the result underflows.
    #[inline(always)]
    pub fn scaled(self, power_of_two: f64) -> Self {
        Self::new(self.hi * power_of_two, self.lo * power_of_two)
    }

    /// Multiplication by 2^exponent, exact unless the result underflows.
    pub fn times_power_of_two(self, exponent: i32) -> Self {
        Self::new(libm::scalbn(self.hi, exponent), libm::scalbn(self.lo, exponent))
    }

    /// The square.
    #[inline(always)]
    pub fn square(self) -> Self {
        self * self
    }

    /// The square rounded to one word, correct even if the two-word square would overflow or underflow.
    pub fn square_to_f64(self) -> f64 {
        let (_, exponent) = libm::frexp(self.hi);
        libm::scalbn(self.times_power_of_two(-exponent).square().to_f64(), 2 * exponent)
    }

    /// The square root, relative error below 4u² (one Newton step from the one-word root); zero for zero, NaN for a negative number. It has no
    /// branches.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        let tiny = self.hi < TINY;
        let raised = if tiny { self.scaled(TWO_TO_200) } else { self };
        let root = raised.hi.sqrt();
        let residual = (-root).fma(root, raised.hi) + raised.lo;
        let correction = residual / (2.0 * root);
        let sum = fast_two_sum(root, if root == 0.0 { 0.0 } else { correction });
        if tiny { sum.scaled(1.0 / TWO_TO_100) } else { sum }
    }

    /// self/other, relative error below 12u², with one division instead of the two of `/`; 1/`other` must be a normal number.
    #[inline(always)]
    pub fn over(self, other: Self) -> Self {
        let inverse = 1.0 / other.hi;
        let quotient = self.hi * inverse;
        let residual = (-quotient).fma(other.lo, (-quotient).fma(other.hi, self.hi) + self.lo);
        fast_two_sum(quotient, residual * inverse)
    }

    /// self + smaller for |self| ≥ |smaller|, relative error below 3u² of |self| + |smaller|.
    #[inline(always)]
    pub fn plus_smaller(self, smaller: Self) -> Self {
        let sum = fast_two_sum(self.hi, smaller.hi);
        fast_two_sum(sum.hi, sum.lo + (self.lo + smaller.lo))
    }

    /// self + a·b for |a·b| ≤ |self|/16, relative error below 2⁻¹⁰⁴; the second word of the sum may exceed half an ulp by a sixteenth.
    #[inline(always)]
    pub fn plus_product(self, a: Self, b: Self) -> Self {
        let product = two_prod(a.hi, b.hi);
        let cross = a.hi.fma(b.lo, a.lo.fma(b.hi, product.lo));
        let sum = fast_two_sum(self.hi, product.hi);
        Self::new(sum.hi, sum.lo + (self.lo + cross))
    }

    /// The reciprocal.
    #[inline(always)]
    pub fn recip(self) -> Self {
        Self::ONE / self
    }

    /// Returns `true` if the leading word is finite.
    #[inline(always)]
    pub fn is_finite(self) -> bool {
        self.hi.is_finite()
    }
}

impl From<f64> for DoubleDouble {
    #[inline(always)]
    fn from(x: f64) -> Self {
        Self::new(x, 0.0)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.hi, -self.lo)
    }
}

/// Relative error at most 3u²/(1−4u), even with cancellation (`AccurateDWPlusDW`).
impl Add for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let s = two_sum(self.hi, other.hi);
        let t = two_sum(self.lo, other.lo);
        let v = fast_two_sum(s.hi, s.lo + t.hi);
        fast_two_sum(v.hi, t.lo + v.lo)
    }
}

/// Relative error at most 2u².
impl Add<f64> for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: f64) -> Self {
        let s = two_sum(self.hi, other);
        fast_two_sum(s.hi, self.lo + s.lo)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Sub<f64> for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: f64) -> Self {
        self + -other
    }
}

/// Relative error at most 4u² (`DWTimesDW3`).
impl Mul for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let p = two_prod(self.hi, other.hi);
        let cross = self.lo.fma(other.hi, self.hi.fma(other.lo, self.lo * other.lo));
        fast_two_sum(p.hi, p.lo + cross)
    }
}

/// Relative error at most 2u².
impl Mul<f64> for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        let p = two_prod(self.hi, other);
        fast_two_sum(p.hi, self.lo.fma(other, p.lo))
    }
}

/// Relative error at most 10u².
impl Div for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let q = self.hi / other.hi;
        let r = self - other * q;
        fast_two_sum(q, r.to_f64() / other.hi)
    }
}

/// Relative error at most 3u².
impl Div<f64> for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: f64) -> Self {
        self / Self::from(other)
    }
}
