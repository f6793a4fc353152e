//! Numbers that are rounded, lane by lane, and sums of products in an order that many of them can be formed in.
//!
//! The newest coefficients come last, so that all else can be under way before these are known.

use libration_jit::MultiplyAdd;

use super::Ring;

/// One number for each lane. Other than `std::array::from_fn` it is always compiled into its caller, and so for the same
/// instruction set.
#[inline(always)]
pub fn lanes<const N: usize>(mut number: impl FnMut(usize) -> f64) -> [f64; N] {
    let mut all = [0.0; N];
    for (lane, one) in all.iter_mut().enumerate() {
        *one = number(lane);
    }
    all
}

/// Returns whether a condition holds in one of the lanes: evaluated in all of them, without a branch for each.
#[inline(always)]
pub fn any<const N: usize>(numbers: &[f64; N], is_so: impl Fn(f64) -> bool) -> bool {
    let mut any = false;
    for number in numbers {
        any |= is_so(*number);
    }
    any
}

/// A ring whose operations are those of rounded numbers.
pub trait Rounded<E>: Ring<Element = E> + MultiplyAdd<Element = E> {
    /// Σ aᵢ·b_{n−1−i} over two slices of the same length n, which [`libration_jit::inner_product`] forms.
    fn inner_product(&self, a: &[E], b: &[E]) -> E;
}

/// Σ aᵢ·b_{n−1−i}, where the sum of what lies between the ends is formed as an inner product. The last product is that of the last a.
#[inline(always)]
pub fn convolution<E: Copy>(on: &impl Rounded<E>, a: &[E], b: &[E]) -> E {
    let n = a.len().min(b.len());
    let (a, b) = (&a[..n], &b[..n]);
    match n {
        0 => on.nothing(),
        1 => on.product(a[0], b[0]),
        _ => {
            let inner = before_the_last(on, &a[1..n - 1], &b[1..n - 1]);
            on.multiply_add(a[n - 1], b[0], on.multiply_add(a[0], b[n - 1], inner))
        }
    }
}

/// The same of coefficients 1 to n − 1, of which the last ones are known when an order begins, but only just.
#[inline(always)]
fn before_the_last<E: Copy>(on: &impl Rounded<E>, a: &[E], b: &[E]) -> E {
    let n = a.len();
    match n {
        0 => on.nothing(),
        1 => on.product(a[0], b[0]),
        _ => {
            let inner = on.inner_product(&a[1..n - 1], &b[1..n - 1]);
            on.multiply_add(a[n - 1], b[0], on.multiply_add(a[0], b[n - 1], inner))
        }
    }
}

/// The last coefficient of the square of a₀ … aₙ, for which the newest one enters once.
#[inline(always)]
pub fn square<E: Copy>(on: &impl Rounded<E>, a: &[E]) -> E {
    match *a {
        [] => on.nothing(),
        [only] => on.product(only, only),
        [first, ref middle @ .., last] => {
            on.multiply_add(last, on.sum(first, first), before_the_last(on, middle, middle))
        }
    }
}

/// cₙ of c = a/b, from aₙ, c₀ … cₙ₋₁ and b₀ … bₙ.
#[inline(always)]
pub fn quotient<E: Copy>(on: &impl Rounded<E>, a_n: E, c: &[E], b: &[E]) -> Option<E> {
    let n = c.len();
    let known = on.multiply_add(b[n], c[0], before_the_last(on, &b[1..n], &c[1..]));
    on.divide(&on.subtract(&a_n, &known), &b[0])
}

/// cₙ of the c with c′ = a′·b, from aₙ, the weighted a₁ … aₙ and b₀ … bₙ₋₁: what aₙ contributes is not weighted.
#[inline(always)]
pub fn integral<E: Copy>(on: &impl Rounded<E>, a_n: E, weighted_a: &[E], b: &[E]) -> Option<E> {
    let n = b.len();
    let known = before_the_last(on, &weighted_a[..n - 1], &b[1..]);
    let known = on.over_integer(&known, u64::try_from(n).unwrap_or(u64::MAX))?;
    Some(on.multiply_add(a_n, b[0], known))
}
