//! Sine and cosine of a phase that is a series.

use libration_numbers::algebra::Ring;

/// The series of cos kδ and sin kδ for a series δ without constant term, as long as it.
pub(super) fn turned<R: Ring>(ring: &R, k: usize, delta: &[R::Element]) -> Option<[Vec<R::Element>; 2]> {
    let weighted: Option<Vec<R::Element>> = delta
        .iter()
        .enumerate()
        .map(|(j, part)| Some(ring.times_integer(part, i64::try_from(j * k).ok()?)))
        .collect();
    let weighted = weighted?;
    let (mut cosine, mut sine) = (vec![ring.rational(&1.into())?], vec![ring.zero()]);
    for n in 1..delta.len() {
        let divisor = u64::try_from(n).ok()?;
        let next_cosine =
            ring.negate(&ring.over_integer(&ring.convolution(&weighted[1..=n], &sine), divisor)?);
        let next_sine = ring.over_integer(&ring.convolution(&weighted[1..=n], &cosine), divisor)?;
        cosine.push(next_cosine);
        sine.push(next_sine);
    }
    Some([cosine, sine])
}
