//! Several double-precision numbers at once as a ring, for motions in time.

use std::cmp::Ordering;

use libration_jit::{MultiplyAdd, inner_product};

use super::lanewise::{Rounded, any, convolution, lanes};
use super::{Doubles, Function, Rational, Ring};
use libration_kernels::elementary::{LARGEST_ANGLE, sin_cos};
use libration_kernels::fused::FusedMultiplyAdd;

/// N independent `f64`s; NaN where a value does not exist. Each lane has the same bits as in a computation of that lane alone.
#[derive(Clone, Copy, Debug)]
pub struct Lanes<const N: usize>;

/// Range of divisors (orders) for which a division is replaced by a product, in a fifth of the time. The second rounding is the same in every
/// step and so does not average out. For smaller divisors it would matter; for powers of two it does not exist.
const PREPARED: std::ops::Range<usize> = 8..64;

static RECIPROCALS: [f64; PREPARED.end] = reciprocals();

#[expect(clippy::cast_precision_loss, reason = "the integers are below 64")]
const fn reciprocals() -> [f64; PREPARED.end] {
    let mut reciprocals = [0.0; PREPARED.end];
    let mut n = 1;
    while n < PREPARED.end {
        reciprocals[n] = 1.0 / n as f64;
        n += 1;
    }
    reciprocals
}

/// The reciprocal by which a division by this integer is replaced, if one is prepared.
#[inline(always)]
pub fn prepared_reciprocal(divisor: u64) -> Option<f64> {
    let is_prepared = |n: &usize| PREPARED.contains(n) || n.is_power_of_two() && *n < PREPARED.end;
    usize::try_from(divisor).ok().filter(is_prepared).map(|n| RECIPROCALS[n])
}

impl<const N: usize> Ring for Lanes<N> {
    type Element = [f64; N];

    #[inline(always)]
    fn zero(&self) -> [f64; N] {
        [0.0; N]
    }

    fn is_zero(&self, a: &[f64; N]) -> bool {
        a.iter().all(|a| *a == 0.0)
    }

    #[inline(always)]
    fn rational(&self, value: &Rational) -> Option<[f64; N]> {
        Some([value.to_f64(); N])
    }

    #[inline(always)]
    fn add(&self, a: &[f64; N], b: &[f64; N]) -> [f64; N] {
        lanes(|lane| a[lane] + b[lane])
    }

    #[inline(always)]
    fn subtract(&self, a: &[f64; N], b: &[f64; N]) -> [f64; N] {
        lanes(|lane| a[lane] - b[lane])
    }

    #[inline(always)]
    fn negate(&self, a: &[f64; N]) -> [f64; N] {
        lanes(|lane| -a[lane])
    }

    #[inline(always)]
    fn multiply(&self, a: &[f64; N], b: &[f64; N]) -> [f64; N] {
        lanes(|lane| a[lane] * b[lane])
    }

    #[inline(always)]
    #[expect(clippy::cast_precision_loss, reason = "rounded as every product is")]
    fn times_integer(&self, a: &[f64; N], factor: i64) -> [f64; N] {
        lanes(|lane| a[lane] * factor as f64)
    }

    #[inline(always)]
    fn divide(&self, a: &[f64; N], divisor: &[f64; N]) -> Option<[f64; N]> {
        Some(lanes(|lane| a[lane] / divisor[lane]))
    }

    #[inline(always)]
    #[expect(clippy::cast_precision_loss, reason = "rounded as every quotient is")]
    fn over_integer(&self, a: &[f64; N], divisor: u64) -> Option<[f64; N]> {
        Some(match prepared_reciprocal(divisor) {
            Some(reciprocal) => lanes(|lane| a[lane] * reciprocal),
            None => lanes(|lane| a[lane] / divisor as f64),
        })
    }

    #[inline(always)]
    fn value(&self, function: Function, at: &[f64; N]) -> Option<[f64; N]> {
        Some(match function {
            Function::Sin => sin_cos_in_lanes(at)[0],
            Function::Cos => sin_cos_in_lanes(at)[1],
            _ => lanes(|lane| Doubles.value(function, &at[lane]).unwrap_or(f64::NAN)),
        })
    }

    #[inline(always)]
    fn power(&self, a: &[f64; N], exponent: &Rational) -> Option<[f64; N]> {
        Some(lanes(|lane| Doubles.power(&a[lane], exponent).unwrap_or(f64::NAN)))
    }

    fn pi(&self) -> Option<[f64; N]> {
        Some([std::f64::consts::PI; N])
    }

    #[inline(always)]
    fn convolution(&self, a: &[[f64; N]], b: &[[f64; N]]) -> [f64; N] {
        convolution(self, a, b)
    }
}

/// The sines and the cosines.
#[inline(always)]
pub fn sin_cos_in_lanes<const N: usize>(at: &[f64; N]) -> [[f64; N]; 2] {
    let mut both = [[0.0; N]; 2];
    for lane in 0..N {
        (both[0][lane], both[1][lane]) = sin_cos(at[lane]);
    }
    let is_large = |x: f64| !matches!(x.abs().partial_cmp(&LARGEST_ANGLE), Some(Ordering::Less));
    if any(at, is_large) {
        for lane in (0..N).filter(|lane| is_large(at[*lane])) {
            (both[0][lane], both[1][lane]) = (libm::sin(at[lane]), libm::cos(at[lane]));
        }
    }
    both
}

impl<const N: usize> Rounded<[f64; N]> for Lanes<N> {
    #[inline(always)]
    fn inner_product(&self, a: &[[f64; N]], b: &[[f64; N]]) -> [f64; N] {
        inner_product(self, a, b)
    }
}

impl<const N: usize> MultiplyAdd for Lanes<N> {
    type Element = [f64; N];

    #[inline(always)]
    fn nothing(&self) -> [f64; N] {
        [0.0; N]
    }

    #[inline(always)]
    fn sum(&self, a: [f64; N], b: [f64; N]) -> [f64; N] {
        lanes(|lane| a[lane] + b[lane])
    }

    #[inline(always)]
    fn product(&self, a: [f64; N], b: [f64; N]) -> [f64; N] {
        lanes(|lane| a[lane] * b[lane])
    }

    #[inline(always)]
    fn multiply_add(&self, a: [f64; N], b: [f64; N], c: [f64; N]) -> [f64; N] {
        lanes(|lane| a[lane].fma(b[lane], c[lane]))
    }
}
