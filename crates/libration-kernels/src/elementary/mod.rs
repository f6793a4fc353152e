//! Sine, hyperbolic sine, arctangent, logarithm and polynomials: branch-free double-precision kernels that the compiler can vectorise, and
//! two-word versions.
//!
//! The results have the same bits on every platform, since no function of the platform's C library is called. Tables of coefficients are printed
//! by `reference/kernel_coefficients.py`.
//!
//! # Method
//! Kernels take and return two words. Each reduces its argument, exactly or with the rounding error in the second word, and evaluates a
//! polynomial that was fitted on the reduced interval. There are no branches and no table look-ups, so that loops over the kernels become vector
//! code. Each table of coefficients states its largest relative error.

use crate::fused::FusedMultiplyAdd;

pub mod rough;
pub mod two_word;
mod arctangent;
mod exponential;
mod fine_logarithm;
mod fine_sine;
mod hyperbolic;
pub(crate) mod logarithm;
mod sine;

pub use arctangent::{ReducedArctangent, atan_of_ratio};
pub use exponential::exp;
pub use fine_logarithm::{FineLogarithm, FineLogarithms, fine_logarithm};
pub use fine_sine::fine_sin_cos;
pub use hyperbolic::sinh_cosh;
pub use logarithm::{Logarithm, ReducedLogarithm, split_logarithm};
pub use sine::{LARGEST_ANGLE, sin_cos, sin_cos_of_turns};

/// A number of items, an order or a degree as an `f64`.
#[inline(always)]
#[expect(clippy::cast_precision_loss, reason = "nothing in memory has 2⁵³ parts")]
pub const fn count(things: usize) -> f64 {
    things as f64
}

/// Σ coefficients\[i\]·xⁱ; even and odd powers are summed separately to shorten the chain of dependent operations.
#[inline(always)]
pub fn polynomial<const N: usize>(x: f64, coefficients: &[f64; N]) -> f64 {
    let y = x * x;
    let (mut even, mut odd) = (0.0, 0.0);
    let mut i = N;
    while i > 0 {
        i -= 1;
        if i.is_multiple_of(2) {
            even = y.fma(even, coefficients[i]);
        } else {
            odd = y.fma(odd, coefficients[i]);
        }
    }
    x.fma(odd, even)
}

/// The nearest integer for |x| < 2⁵¹, by adding and subtracting a number that leaves no bits for the fraction.
#[inline(always)]
pub fn nearest_integer(x: f64) -> f64 {
    (x + ROUNDER) - ROUNDER
}

/// The low bits of the nearest integer, in two's complement; |x| < 2⁵¹.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "only low bits are wanted")]
pub fn nearest_integer_bits(x: f64) -> usize {
    (x + ROUNDER).to_bits() as usize
}

/// 1.5·2⁵²: added to a small number it leaves the nearest integer in the low bits.
const ROUNDER: f64 = 6755399441055744.0;

/// 2ⁿ for an integer −1022 ≤ n ≤ 1023 held in an `f64`.
#[inline(always)]
fn power_of_two(n: f64) -> f64 {
    f64::from_bits((n + (ROUNDER + 1023.0)).to_bits() << 52)
}
