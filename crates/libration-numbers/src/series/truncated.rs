//! Truncated power series over any ring: product, reciprocal, square root, composition, reversion.
//!
//! A series is the slice of its first coefficients; later coefficients are unknown, so that a result has no more coefficients than the operands
//! determine.

use crate::algebra::Ring;

/// The parity of a series whose every second coefficient is zero: `Some(0)` for an even series, `Some(1)` for an odd one.
fn parity<R: Ring>(ring: &R, a: &[R::Element]) -> Option<usize> {
    let vanishes = |start: usize| a.iter().skip(start).step_by(2).all(|a| ring.is_zero(a));
    [0, 1].into_iter().find(|&parity| vanishes(1 - parity))
}

fn every_second<E: Clone>(a: &[E], parity: usize) -> Vec<E> {
    a.iter().skip(parity).step_by(2).cloned().collect()
}

/// The first `length` coefficients of a·b.
pub fn product<R: Ring>(ring: &R, a: &[R::Element], b: &[R::Element], length: usize) -> Vec<R::Element> {
    let (Some(p), Some(q)) = (parity(ring, a), parity(ring, b)) else {
        return ring.series_product(a, b, length);
    };
    let half = length.saturating_sub(p + q).div_ceil(2);
    let halves = ring.series_product(&every_second(a, p), &every_second(b, q), half);
    spread(ring, halves, p + q, length)
}

/// The given coefficients at every second position from `first` on, with zeros in between.
fn spread<R: Ring>(ring: &R, halves: Vec<R::Element>, first: usize, length: usize) -> Vec<R::Element> {
    let mut all = vec![ring.zero(); length];
    for (entry, coefficient) in all.iter_mut().skip(first).step_by(2).zip(halves) {
        *entry = coefficient;
    }
    all
}

/// The first `length` coefficients of outer(inner(x)), the inner series without constant term. `go_on` is checked at each step; `None` if it
/// returns `false`.
pub fn composition<R: Ring>(
    ring: &R,
    outer: &[R::Element],
    inner: &[R::Element],
    length: usize,
    go_on: &dyn Fn() -> bool,
) -> Option<Vec<R::Element>> {
    if parity(ring, inner) != Some(0) {
        return ring.series_composition(outer, inner, length, go_on);
    }
    let halves = ring.series_composition(outer, &every_second(inner, 0), length.div_ceil(2), go_on)?;
    Some(spread(ring, halves, 0, length))
}

/// Coefficients of 1/a, as many as those of a; `None` if a₀ has no inverse.
pub fn reciprocal<R: Ring>(ring: &R, a: &[R::Element]) -> Option<Vec<R::Element>> {
    let one = ring.rational(&1.into())?;
    let first = ring.divide(&one, a.first()?)?;
    let mut b = vec![first.clone()];
    for n in 1..a.len() {
        let sum = ring.convolution(&a[1..=n], &b);
        b.push(ring.negate(&ring.multiply(&sum, &first)));
    }
    Some(b)
}

/// Coefficients of √a, as many as those of a, for a₀ = 1 and the root that begins with 1.
pub fn square_root_of_unit<R: Ring>(ring: &R, a: &[R::Element]) -> Option<Vec<R::Element>> {
    let mut b = vec![ring.rational(&1.into())?];
    for a_n in a.iter().skip(1) {
        b.push(next_square_root(ring, a_n, &b)?);
    }
    Some(b)
}

/// bₙ of b = √a with b₀ = 1, from aₙ and b₀ … bₙ₋₁.
pub fn next_square_root<R: Ring>(ring: &R, a_n: &R::Element, b: &[R::Element]) -> Option<R::Element> {
    let sum = ring.convolution(&b[1..], &b[1..]);
    ring.over_integer(&ring.subtract(a_n, &sum), 2)
}

/// The powers 1, a, a², … of a series without constant term, up to the last that is not zero in the given coefficients.
pub fn powers<R: Ring>(ring: &R, a: &[R::Element]) -> Option<SeriesPowers<R::Element>> {
    let one = ring.rational(&1.into())?;
    let length = a.len();
    let mut unit = vec![ring.zero(); length];
    if let Some(first) = unit.first_mut() {
        *first = one;
    }
    let mut powers = vec![unit];
    for _ in 1..length {
        let next = product(ring, a, &powers[powers.len() - 1], length);
        powers.push(next);
    }
    Some(SeriesPowers::new(ring, &powers))
}

/// The powers 1, y, y², … of y = (a₁x + a₂x² + …)⁻¹, the inverse function of a series, by Lagrange's formula \[xⁿ\] yʲ = (j/n) \[xⁿ⁻ʲ\]
/// (x/a(x))ⁿ; `None` if a₁ has no inverse.
///
/// Reference: P. Henrici, *Applied and Computational Complex Analysis*, vol. 1, Wiley 1974, section 1.9.
pub fn powers_of_inverse<R: Ring>(ring: &R, a: &[R::Element]) -> Option<SeriesPowers<R::Element>> {
    let length = a.len();
    let phi = reciprocal(ring, a.get(1..)?)?;
    let mut powers = vec![vec![ring.zero(); length]; length];
    *powers.first_mut()?.first_mut()? = ring.rational(&1.into())?;
    let mut phi_n = vec![ring.rational(&1.into())?];
    for n in 1..length {
        phi_n = product(ring, &phi_n, &phi, length - 1);
        for j in (1..=n).filter(|j| !ring.is_zero(&phi_n[n - j])) {
            let scaled = ring.times_integer(&phi_n[n - j], i64::try_from(j).ok()?);
            powers[j][n] = ring.over_integer(&scaled, u64::try_from(n).ok()?)?;
        }
    }
    Some(SeriesPowers::new(ring, &powers))
}

/// The powers of a series without constant term, for compositions with it.
#[derive(Clone, Debug)]
pub struct SeriesPowers<E> {
    /// For each power of the variable, its coefficients in the powers of the series, from the highest power down; if the series is odd, only
    /// those of one parity.
    columns: Vec<Vec<E>>,
    odd: bool,
    first: Vec<E>,
}

impl<E: Clone> SeriesPowers<E> {
    fn new<R: Ring<Element = E>>(ring: &R, powers: &[Vec<E>]) -> Self {
        let odd = powers.get(1).is_some_and(|first| parity(ring, first) == Some(1));
        let step = if odd { 2 } else { 1 };
        let column = |n: usize| (0..=n).rev().step_by(step).map(|j| powers[j][n].clone()).collect();
        let length = powers.first().map_or(0, Vec::len).min(powers.len());
        let first = powers.get(1).cloned().unwrap_or_default();
        Self { columns: (0..length).map(column).collect(), odd, first }
    }

    /// The series itself.
    pub fn first(&self) -> Vec<E> {
        self.first.clone()
    }

    /// outer(inner(x)), with as many coefficients as both determine.
    pub fn composed<R: Ring<Element = E>>(&self, ring: &R, outer: &[E]) -> Vec<E> {
        let length = outer.len().min(self.columns.len());
        let parts = if self.odd { [0, 1].map(|p| every_second(outer, p)) } else { [outer.to_vec(), vec![]] };
        let vanish = [0, 1].map(|p| parts[p].iter().all(|factor| ring.is_zero(factor)));
        let coefficient = |(n, column): (usize, &Vec<E>)| {
            let part = if self.odd { n % 2 } else { 0 };
            if vanish[part] { ring.zero() } else { ring.convolution(&parts[part][..column.len()], column) }
        };
        self.columns.iter().enumerate().take(length).map(coefficient).collect()
    }
}
