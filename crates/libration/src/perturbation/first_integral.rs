//! The independent road for odd oscillators whose acceleration depends on the velocity, x″ = F(x, x′) with
//! F(x, −x′) = F(x, x′) = −F(−x, x′): the velocity as a function of the displacement.
//!
//! With x = A cos φ and G = dφ/dt the equation becomes −d(H sin²φ)/dφ = (2/A)·sin φ·F for H = G², which integrates at
//! each power of A because F takes its velocity from lower powers. The period is the mean of 2π/G.

use crate::algebra::{HarmonicPair, HarmonicSums, PhaseRing, Rational, Rationals, Ring};
use crate::expression::{Jet, Tape};
use crate::series::truncated::{next_square_root, reciprocal};

type Sums = HarmonicSums<Rationals>;
type Sum = <Sums as Ring>::Element;

const RING: Sums = HarmonicSums { numbers: Rationals };

/// T/T0 by powers of the amplitude, `length` of them. `None` when a number is not rational, or the oscillator is
/// not of this kind.
pub(crate) fn period_ratio(
    tape: &Tape,
    values: &[Rational],
    omega0_squared: &Rational,
    length: usize,
) -> Option<Vec<Rational>> {
    let omega0 = omega0_squared.square_root()?;
    let values = values.iter().map(|value| RING.rational(value)).collect::<Option<Vec<_>>>()?;
    let mut jet = Jet::with_values(&RING, tape, values);
    let velocity_gains = jet.gains(1).ok()?;
    let rate = |n: usize| -> Option<Sum> { RING.rational(&Rational::from(i64::from(n == 0))) };
    // H/ω0² and G/ω0.
    let mut square = vec![rate(0)?];
    let mut frequency = vec![rate(0)?];
    for n in 1..=length {
        let position = if n == 1 { wave(1, Rational::from(1), Rational::from(0)) } else { RING.zero() };
        jet.extend(&[position, RING.zero()]).ok()?;
        if n > 1 {
            let force = RING.divide(&jet.result(0)[n], &RING.rational(omega0_squared)?)?;
            let next = over_squared_sine(&minus_twice_integral_with_sine(&force, n)?, n + 1)?;
            frequency.push(next_square_root(&RING, &next, &frequency)?);
            square.push(next);
        }
        let slowing = RING.multiply(&wave(1, Rational::from(0), -omega0.clone()), &frequency[n - 1]);
        jet.amend(&velocity_gains, &slowing);
    }
    let time = reciprocal(&RING, &frequency)?;
    Some(time.iter().map(|per_angle| RING.harmonic(per_angle, 0).cosine).collect())
}

fn wave(k: usize, cosine: Rational, sine: Rational) -> Sum {
    RING.sum_of_harmonics(&[(k, HarmonicPair { cosine, sine })])
}

/// −∫ 2 sin φ·F dφ from φ = 0, for a sum F of cosines up to `highest`.
fn minus_twice_integral_with_sine(force: &Sum, highest: usize) -> Option<Sum> {
    let mut integral = RING.zero();
    for k in 0..=highest {
        let f = RING.harmonic(force, k).cosine;
        // 2 sin φ cos kφ = sin (k+1)φ − sin (k−1)φ, and −∫ sin jφ = cos jφ/j − 1/j.
        for (j, sign) in [(k + 1, 1), (k.abs_diff(1), if k == 0 { 1 } else { -1 })] {
            if j > 0 {
                let part =
                    Rationals.over_integer(&Rationals.times_integer(&f, sign), u64::try_from(j).ok()?)?;
                let both = [
                    (j, HarmonicPair { cosine: part.clone(), sine: Rational::from(0) }),
                    (0, HarmonicPair { cosine: -part, sine: Rational::from(0) }),
                ];
                integral = RING.add(&integral, &RING.sum_of_harmonics(&both));
            }
        }
    }
    Some(integral)
}

/// The quotient of a sum of cosines up to `highest` by sin²φ = (1 − cos 2φ)/2; `None` when it leaves a remainder.
fn over_squared_sine(sum: &Sum, highest: usize) -> Option<Sum> {
    let mut quotient = vec![Rational::from(0); highest + 3];
    for k in (2..=highest).rev() {
        let p = RING.harmonic(sum, k).cosine;
        let known = Rationals.subtract(
            &Rationals.times_integer(&quotient[k], 2),
            &Rationals.add(&quotient[k + 2], &Rationals.times_integer(&p, 4)),
        );
        quotient[k - 2] = if k == 2 { Rationals.over_integer(&known, 2)? } else { known };
    }
    let terms: Vec<_> = quotient
        .into_iter()
        .enumerate()
        .map(|(k, cosine)| (k, HarmonicPair { cosine, sine: Rational::from(0) }))
        .collect();
    let quotient = RING.sum_of_harmonics(&terms);
    let half = |k, numerator| {
        wave(k, Rational::new(numerator, 2).unwrap_or_else(|| Rational::from(0)), Rational::from(0))
    };
    let product = RING.multiply(&quotient, &RING.add(&half(0, 1), &half(2, -1)));
    RING.is_zero(&RING.subtract(&product, sum)).then_some(quotient)
}
