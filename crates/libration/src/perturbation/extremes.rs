//! The turning points of a limit cycle, which are not at τ = 0 and τ = π because its harmonics have sines.
//!
//! About either of these phases x = Σ cⱼ(μ)·σʲ, and the root σ(μ) of dx/dσ next to it has no constant term, so that
//! each of its coefficients follows from those before it.

use super::half_turns::{BothTurns, half_turns};
use super::lindstedt::Family;
use crate::algebra::{HarmonicPair, Rational, Ring};
use crate::series::truncated::product;

/// The largest and the smallest displacement of a motion that has them at τ = 0 and τ = π when the variable is zero.
/// `None` when a number is not in the ring.
pub(crate) fn extremes<R: Ring>(ring: &R, family: &Family<R::Element>) -> Option<BothTurns<R::Element>> {
    let (at_zero, at_pi): (Vec<_>, Vec<_>) = taylor(ring, family)?.into_iter().unzip();
    Some((extreme(ring, &at_zero)?, extreme(ring, &at_pi)?))
}

/// The displacement and its first derivatives dʲx/dτʲ/j! at τ = 0 and τ = π: one more than the series has powers.
fn taylor<R: Ring>(ring: &R, family: &Family<R::Element>) -> Option<Vec<BothTurns<R::Element>>> {
    let mut derivative = family.clone();
    let mut inverse_factorial = ring.rational(&Rational::from(1))?;
    let mut taylor = vec![half_turns(ring, family)];
    for j in 1..=family.frequency.len() {
        differentiate(ring, &mut derivative)?;
        inverse_factorial = ring.over_integer(&inverse_factorial, u64::try_from(j).ok()?)?;
        let scaled = |series: Vec<R::Element>| -> Vec<R::Element> {
            series.iter().map(|c| ring.multiply(c, &inverse_factorial)).collect()
        };
        let (at_zero, at_pi) = half_turns(ring, &derivative);
        taylor.push((scaled(at_zero), scaled(at_pi)));
    }
    Some(taylor)
}

/// dx/dτ in the place of x.
fn differentiate<R: Ring>(ring: &R, family: &mut Family<R::Element>) -> Option<()> {
    let absent = |h: &HarmonicPair<R::Element>| ring.is_zero(&h.cosine) && ring.is_zero(&h.sine);
    for (k, harmonic) in family.harmonics.iter_mut().enumerate() {
        let k = i64::try_from(k).ok()?;
        for coefficient in harmonic.iter_mut().filter(|coefficient| !absent(coefficient)) {
            let cosine = ring.times_integer(&coefficient.sine, k);
            let sine = ring.times_integer(&coefficient.cosine, -k);
            *coefficient = HarmonicPair { cosine, sine };
        }
    }
    Some(())
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
