//! The next coefficient of a power series that is a function of other series, over any ring.
//!
//! A series is the slice of its first coefficients. A *weighted* series has n·aₙ in place of aₙ: it is the series of the derivative, shifted by
//! one. Every recurrence below is the differential equation of the function at one power of the variable, as in A. Griewank, A. Walther,
//! *Evaluating Derivatives*, 2nd ed., SIAM 2008, section 13.2.

use crate::algebra::Ring;

/// cₙ of c = a/b, from aₙ, c₀ … cₙ₋₁ and b₀ … bₙ; `None` if b₀ has no inverse.
#[inline(always)]
pub(crate) fn quotient<R: Ring>(
    ring: &R,
    a_n: &R::Element,
    c: &[R::Element],
    b: &[R::Element],
) -> Option<R::Element> {
    let sum = ring.convolution(c, &b[1..]);
    ring.divide(&ring.subtract(a_n, &sum), &b[0])
}

/// n·cₙ of the c with c′ = a′·b, from the weighted a₁ … aₙ and b₀ … bₙ₋₁.
#[inline(always)]
pub(crate) fn weighted_integral<R: Ring>(
    ring: &R,
    weighted_a: &[R::Element],
    b: &[R::Element],
) -> R::Element {
    ring.convolution(weighted_a, b)
}

/// n·cₙ of the c with c′ = a′/r, from the weighted aₙ, the weighted c₁ … cₙ₋₁ and r₀ … rₙ₋₁.
#[inline(always)]
pub(crate) fn weighted_integral_of_quotient<R: Ring>(
    ring: &R,
    weighted_a_n: &R::Element,
    weighted_c: &[R::Element],
    r: &[R::Element],
) -> Option<R::Element> {
    quotient(ring, weighted_a_n, weighted_c, r)
}

/// A series with its weighted form.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Both<'a, E> {
    pub(crate) plain: &'a [E],
    pub(crate) weighted: &'a [E],
}

/// n·a₀·cₙ of c = aᵖ, from a₀ … aₙ and c₀ … cₙ₋₁: a·c′ = p·a′·c.
#[inline(always)]
pub(crate) fn weighted_power<R: Ring>(
    ring: &R,
    exponent: &R::Element,
    a: Both<'_, R::Element>,
    c: Both<'_, R::Element>,
) -> R::Element {
    let driven = ring.convolution(&a.weighted[1..], c.plain);
    let lower_terms = ring.convolution(&c.weighted[1..], &a.plain[1..c.plain.len()]);
    ring.subtract(&ring.multiply(exponent, &driven), &lower_terms)
}
