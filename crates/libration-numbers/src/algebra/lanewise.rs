//! Rounded numbers lane by lane, and sums of products in an order that lets many of them be formed at once.
//!
//! The newest coefficients are added last, so that all other products can start before these are known.

use libration_jit::MultiplyAdd;

use super::Ring;

/// One number for each lane. In contrast to `std::array::from_fn` it is always inlined into its caller, and thus compiled for the same
/// instruction set.
#[inline(always)]
pub fn lanes<const N: usize>(mut number: impl FnMut(usize) -> f64) -> [f64; N] {
    let mut all = [0.0; N];
    for (lane, one) in all.iter_mut().enumerate() {
        *one = number(lane);
    }
    all
}

/// Returns `true` if a condition holds in one of the lanes; it is evaluated in all of them, without branches.
#[inline(always)]
pub fn any<const N: usize>(numbers: &[f64; N], is_so: impl Fn(f64) -> bool) -> bool {
    let mut any = false;
    for number in numbers {
        any |= is_so(*number);
    }
    any
}

/// A ring whose operations are rounded.
pub trait Rounded<E>: Ring<Element = E> + MultiplyAdd<Element = E> {
    /// Σ aᵢ·b_{n−1−i} over two slices of the same length n, formed by [`libration_jit::inner_product`].
    fn inner_product(&self, a: &[E], b: &[E]) -> E;
}

/// Σ aᵢ·b_{n−1−i}. The products at the ends are added to the inner product of the others, the product of the last a at the very end.
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

/// Σ aᵢ·b_{n−1−i} over slices whose last coefficients have become known only just before the order begins: their products are added last.
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

/// The last coefficient of the square of a₀ … aₙ, in which the newest coefficient occurs once.
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
    let sum = on.multiply_add(b[n], c[0], before_the_last(on, &b[1..n], &c[1..]));
    on.divide(&on.subtract(&a_n, &sum), &b[0])
}

/// cₙ of the c with c′ = a′·b, from aₙ, the weighted a₁ … aₙ and b₀ … bₙ₋₁; the contribution of aₙ uses its unweighted value.
#[inline(always)]
pub fn integral<E: Copy>(on: &impl Rounded<E>, a_n: E, weighted_a: &[E], b: &[E]) -> Option<E> {
    let n = b.len();
    let sum = before_the_last(on, &weighted_a[..n - 1], &b[1..]);
    let mean = on.over_integer(&sum, u64::try_from(n).unwrap_or(u64::MAX))?;
    Some(on.multiply_add(a_n, b[0], mean))
}
