//! The independent methods for conservative oscillators x″ = F(x): reversion of the potential, no harmonics.
//!
//! With V(x) = ½ω0²ρ² the energy is that of a harmonic oscillator of amplitude ρ, x = xₑ + X(ρ sin φ), and
//! ω0·dt = X′ dφ. From X alone follow the turning points X(±ρ) and the period
//! T/T0 = Σ (2i+1)·c₂ᵢ₊₁·(2i over i)/4ⁱ·ρ²ⁱ, where X = Σ cⱼρʲ.
//!
//! X is not found by reversion but from the equation V′(X)·X′ = ω0²ρ, that is F(xₑ + X)·X′ = −ω0²ρ, so that the
//! acceleration is needed only as a tape.

use libration_numbers::algebra::{Rational, Ring};
use libration_numbers::internals::expression::{Jet, Tape};

/// c₀ = 0, c₁ = 1, c₂, … up to `order`; `values` are those of the slots of the tape at the equilibrium.
/// `None` when a number is not in the ring.
pub(crate) fn displacement<R: Ring>(
    ring: &R,
    tape: &Tape,
    values: Vec<R::Element>,
    omega0_squared: &R::Element,
    order: usize,
) -> Option<Vec<R::Element>> {
    let mut jet = Jet::with_values(ring, tape, values);
    let gains = jet.gains(0).ok()?;
    let mut x = vec![ring.zero()];
    // j·cⱼ, from j = 1 on.
    let mut slope: Vec<R::Element> = vec![];
    let rest_at_zero = vec![ring.zero(); tape.inputs()];
    for n in 1..=order {
        jet.extend(&rest_at_zero).ok()?;
        let c = if n == 1 {
            ring.rational(&Rational::from(1))?
        } else {
            let force = jet.result(0);
            let convolution = ring.convolution(&force[2..=n], &slope);
            ring.over_integer(&ring.divide(&convolution, omega0_squared)?, u64::try_from(n + 1).ok()?)?
        };
        jet.amend(&gains, &c);
        slope.push(ring.times_integer(&c, i64::try_from(n).ok()?));
        x.push(c);
    }
    Some(x)
}

/// T/T0 by powers of ρ, as many as the displacement X(ρ) determines.
pub(crate) fn period_ratio<R: Ring>(ring: &R, displacement: &[R::Element]) -> Option<Vec<R::Element>> {
    // (2i over i)/4ⁱ, the mean of sin²ⁱ.
    let mut mean = ring.rational(&Rational::from(1))?;
    let mut ratio = vec![];
    for (j, c) in displacement.iter().enumerate().skip(1) {
        let j = u64::try_from(j).ok()?;
        if j % 2 == 0 {
            mean = ring.over_integer(&ring.times_integer(&mean, i64::try_from(j - 1).ok()?), j)?;
            ratio.push(ring.zero());
        } else {
            let term = ring.times_integer(c, i64::try_from(j).ok()?);
            ratio.push(ring.multiply(&term, &mean));
        }
    }
    Some(ratio)
}
