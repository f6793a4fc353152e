//! The turning points of a limit cycle, which are not at τ = 0 and τ = π because its harmonics have sines.
//!
//! About either of these phases x = Σ cⱼ(μ)·σʲ, and the root σ(μ) of dx/dσ next to it has no constant term, so that
//! each of its coefficients follows from those before it.

use super::half_turns::BothTurns;
use super::lindstedt::Family;
use libration_numbers::internals::series::truncated::product;
use libration_numbers::{
    algebra::{Rational, Ring},
    internals::algebra::HarmonicPair,
};

/// The largest and the smallest displacement of a motion that has them at τ = 0 and τ = π when the variable is zero.
/// `None` when a number is not in the ring.
pub(crate) fn extremes<R: Ring>(ring: &R, family: &Family<R::Element>) -> Option<BothTurns<R::Element>> {
    let [even, odd] = [Harmonics::new(ring, family, 0), Harmonics::new(ring, family, 1)];
    let odd = taylor(ring, family, odd)?;
    if even.vanish() {
        let x_max = extreme(ring, &odd)?;
        let x_min = x_max.iter().map(|a| ring.negate(a)).collect();
        return Some((x_max, x_min));
    }
    let even = taylor(ring, family, even)?;
    // Half a turn on, the odd harmonics have the other sign.
    let combined = |combine: fn(&R, &R::Element, &R::Element) -> R::Element| -> Vec<Vec<R::Element>> {
        let row = |(a, b): (&Vec<_>, &Vec<_>)| a.iter().zip(b).map(|(a, b)| combine(ring, a, b)).collect();
        even.iter().zip(&odd).map(row).collect()
    };
    Some((extreme(ring, &combined(R::add))?, extreme(ring, &combined(R::subtract))?))
}

/// The even or the odd harmonics.
struct Harmonics<E> {
    k: Vec<i64>,
    /// Cosines and sines by order, from the highest harmonic down; empty if all are zero.
    coefficients: [Vec<Vec<E>>; 2],
}

impl<E: Clone> Harmonics<E> {
    fn new<R: Ring<Element = E>>(ring: &R, family: &Family<E>, parity: usize) -> Self {
        let present: Vec<usize> = (parity..family.harmonics.len()).step_by(2).collect();
        let of_order = |n: usize, part: fn(&HarmonicPair<E>) -> &E| -> Vec<E> {
            let list: Vec<E> = present.iter().rev().map(|&k| part(&family.harmonics[k][n]).clone()).collect();
            if list.iter().all(|a| ring.is_zero(a)) { vec![] } else { list }
        };
        let orders = family.harmonics.first().map_or(0, Vec::len);
        let all = |part| (0..orders).map(|n| of_order(n, part)).collect();
        let coefficients = [all(|pair| &pair.cosine), all(|pair| &pair.sine)];
        Self { k: present.into_iter().filter_map(|k| i64::try_from(k).ok()).collect(), coefficients }
    }

    fn vanish(&self) -> bool {
        self.coefficients.iter().flatten().all(Vec::is_empty)
    }
}

/// The contribution of some harmonics to displacement and derivatives dʲx/dτʲ/j! at τ = 0: one derivative more than the series has powers.
fn taylor<R: Ring>(
    ring: &R,
    family: &Family<R::Element>,
    harmonics: Harmonics<R::Element>,
) -> Option<Vec<Vec<R::Element>>> {
    // kʲ/j!
    let mut weights = vec![ring.rational(&Rational::from(1))?; harmonics.k.len()];
    let mut taylor = vec![];
    for j in 0..=family.frequency.len() {
        let sum = |list: &Vec<R::Element>| {
            let sum = if list.is_empty() { ring.zero() } else { ring.convolution(&weights, list) };
            // Derivatives of a cosine are −sin, −cos, sin, those of a sine cos, −sin, −cos.
            if j % 4 < 2 { sum } else { ring.negate(&sum) }
        };
        taylor.push(harmonics.coefficients[j % 2].iter().map(sum).collect());
        for (weight, &k) in weights.iter_mut().zip(&harmonics.k) {
            *weight = ring.over_integer(&ring.times_integer(weight, k), u64::try_from(j + 1).ok()?)?;
        }
    }
    Some(taylor)
}

/// Σ cⱼσʲ where its derivative vanishes.
fn extreme<R: Ring>(ring: &R, taylor: &[Vec<R::Element>]) -> Option<Vec<R::Element>> {
    let powers = powers_of_root(ring, taylor)?;
    let length = taylor.first()?.len();
    let terms = taylor.iter().zip(&powers).map(|(c, power)| product(ring, c, power, length));
    Some(terms.fold(vec![ring.zero(); length], |sum, term| {
        sum.iter().zip(&term).map(|(sum, term)| ring.add(sum, term)).collect()
    }))
}

/// The powers 1, σ, σ², … of the root of Σ j·cⱼσʲ⁻¹.
fn powers_of_root<R: Ring>(ring: &R, taylor: &[Vec<R::Element>]) -> Option<Vec<Vec<R::Element>>> {
    let curvature = ring.times_integer(taylor.get(2)?.first()?, 2);
    let mut powers = vec![vec![ring.zero()]; taylor.len()];
    powers[0] = vec![ring.rational(&Rational::from(1))?];
    for n in 1..taylor[0].len() {
        // σ has no constant term, so that no higher power needs σₙ, which counts as zero until it is known.
        powers[0].push(ring.zero());
        powers[1].push(ring.zero());
        for j in 2..powers.len() {
            let next = ring.convolution(&powers[1][1..n], &powers[j - 1][1..n]);
            powers[j].push(next);
        }
        let mut slope = ring.zero();
        for (j, (c, power)) in (1..).zip(taylor[1..].iter().zip(&powers)) {
            let term = ring.convolution(&c[..=n], &power[..=n]);
            slope = ring.add(&slope, &ring.times_integer(&term, j));
        }
        powers[1][n] = ring.negate(&ring.divide(&slope, &curvature)?);
    }
    Some(powers)
}
