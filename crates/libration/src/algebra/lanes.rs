//! Several double-precision numbers at once as a ring, for motions in time.

use super::{Doubles, Function, Rational, Ring};

/// N independent `f64`s; NaN where there is no value. Each lane has the bits that it has alone.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lanes<const N: usize>;

/// Divisions by the orders from the first of these on and below the second are made products, which take a fifth of the
/// time. Their second rounding is the same in every step, so that it does not average out; below, it would be felt.
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

/// One number for each lane. Other than `std::array::from_fn` it is always compiled into its caller, and so for the same
/// instruction set.
#[inline(always)]
pub(crate) fn lanes<const N: usize>(mut number: impl FnMut(usize) -> f64) -> [f64; N] {
    let mut all = [0.0; N];
    for (lane, one) in all.iter_mut().enumerate() {
        *one = number(lane);
    }
    all
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
        let prepared = usize::try_from(divisor).ok().filter(|n| PREPARED.contains(n)).map(|n| RECIPROCALS[n]);
        Some(match prepared {
            Some(reciprocal) => lanes(|lane| a[lane] * reciprocal),
            None => lanes(|lane| a[lane] / divisor as f64),
        })
    }

    #[inline(always)]
    fn value(&self, function: Function, at: &[f64; N]) -> Option<[f64; N]> {
        Some(lanes(|lane| Doubles.value(function, &at[lane]).unwrap_or(f64::NAN)))
    }

    #[inline(always)]
    fn power(&self, a: &[f64; N], exponent: &Rational) -> Option<[f64; N]> {
        Some(lanes(|lane| Doubles.power(&a[lane], exponent).unwrap_or(f64::NAN)))
    }

    fn pi(&self) -> Option<[f64; N]> {
        Some([std::f64::consts::PI; N])
    }

    /// In four sums, which a processor forms at the same time. The products of the first and the last, which hold the
    /// newest coefficients, come last: all else can be under way before these are known.
    #[inline(always)]
    fn convolution(&self, a: &[[f64; N]], b: &[[f64; N]]) -> [f64; N] {
        let n = a.len().min(b.len());
        let (a, b) = (&a[..n], &b[..n]);
        if n < 2 {
            return if n == 0 { [0.0; N] } else { lanes(|lane| a[0][lane] * b[0][lane]) };
        }
        let inner = self.inner(&a[1..n - 1], &b[1..n - 1]);
        lanes(|lane| inner[lane] + (a[0][lane] * b[n - 1][lane] + a[n - 1][lane] * b[0][lane]))
    }
}

impl<const N: usize> Lanes<N> {
    #[inline(always)]
    fn inner(&self, a: &[[f64; N]], b: &[[f64; N]]) -> [f64; N] {
        let (fours, rest) = a.as_chunks::<4>();
        let (rest_of_b, fours_of_b) = b.as_rchunks::<4>();
        let mut sums = [[0.0; N]; 4];
        for (a, b) in fours.iter().zip(fours_of_b.iter().rev()) {
            for k in 0..4 {
                for lane in 0..N {
                    sums[k][lane] += a[k][lane] * b[3 - k][lane];
                }
            }
        }
        let mut last = [0.0; N];
        for (a, b) in rest.iter().zip(rest_of_b.iter().rev()) {
            for lane in 0..N {
                last[lane] += a[lane] * b[lane];
            }
        }
        lanes(|lane| (sums[0][lane] + sums[2][lane]) + (sums[1][lane] + sums[3][lane]) + last[lane])
    }
}
