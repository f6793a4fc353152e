//! The displacements half a turn apart.

use super::lindstedt::Family;
use libration_numbers::algebra::Ring;

/// Two series: that at τ = 0 and that at τ = π.
pub(crate) type BothTurns<E> = (Vec<E>, Vec<E>);

/// The displacements at τ = 0 and τ = π: about a centre, the turning points.
pub(crate) fn half_turns<R: Ring>(ring: &R, family: &Family<R::Element>) -> BothTurns<R::Element> {
    let order = family.harmonics.first().map_or(0, Vec::len);
    let at = |n: usize, alternating: bool| {
        family.harmonics.iter().enumerate().fold(ring.zero(), |sum, (k, series)| {
            let cosine = &series[n].cosine;
            if alternating && k % 2 == 1 { ring.subtract(&sum, cosine) } else { ring.add(&sum, cosine) }
        })
    };
    ((0..order).map(|n| at(n, false)).collect(), (0..order).map(|n| at(n, true)).collect())
}
