//! The independent methods for oscillators whose acceleration depends on the velocity, x″ = F(x, x′): the orbit in the plane of states, which
//! knows no time.
//!
//! With x = r sin φ, x′ = ω0·r cos φ and F = −ω0²x + ω0²·g the equation is
//!
//! ```text
//! φ′ = ω0·(1 − s·sin φ),    (1 − s·sin φ)·dr/dφ = r·s·cos φ,    s = g/r.
//! ```
//!
//! r(φ) = Σ cⁿrₙ(φ) closes, as the motion runs back as it came; with r(π/2) = c its parameter is the turning point A. The period is the
//! mean of 2π/φ′. Which c a state has is the first integral.

use libration_numbers::internals::expression::{Jet, Tape};
use libration_numbers::internals::progress::Watch;
use libration_numbers::internals::series::truncated::reciprocal;
use libration_numbers::{
    algebra::Ring,
    internals::algebra::{HarmonicPair, HarmonicSums, Number, PhaseRing},
};

/// An oscillator in the numbers of a ring.
pub(crate) struct PlaneOfStates<'a, F: Ring> {
    pub(crate) tape: &'a Tape,
    /// The values of the slots of the tape at the equilibrium.
    pub(crate) values: Vec<F::Element>,
    pub(crate) omega0_squared: F::Element,
    pub(crate) omega0: F::Element,
}

/// T/T0 by powers of the largest displacement, `length` of them. `None` when a number is not in the ring, the orbits do not close, or it is
/// interrupted.
pub(crate) fn period_ratio<F: Ring + Clone>(
    numbers: &F,
    plane: PlaneOfStates<'_, F>,
    length: usize,
    watch: &Watch<'_>,
) -> Option<Vec<F::Element>> {
    let ring = &HarmonicSums { numbers: numbers.clone() };
    let values = plane.values.iter().map(|value| wave(ring, 0, value.clone(), numbers.zero())).collect();
    let mut orbit = Orbit::new(ring, plane, values)?;
    for n in 1..=length {
        watch.reached(n).ok()?;
        orbit.extend(n)?;
    }
    let time = reciprocal(ring, &orbit.rate)?;
    Some(time.iter().map(|per_angle| ring.harmonic(per_angle, 0).cosine).collect())
}

struct Orbit<'a, R: PhaseRing> {
    ring: &'a R,
    jet: Jet<'a, R>,
    gains: [Vec<R::Element>; 2],
    omega0: Number<R>,
    compliance: Number<R>,
    /// rₙ and its derivative.
    radius: Vec<R::Element>,
    slope: Vec<R::Element>,
    /// Series of s.
    departure: Vec<R::Element>,
    /// Series of φ′/ω0.
    rate: Vec<R::Element>,
}

impl<'a, F: Ring> Orbit<'a, HarmonicSums<F>> {
    fn new(
        ring: &'a HarmonicSums<F>,
        plane: PlaneOfStates<'a, F>,
        values: Vec<<HarmonicSums<F> as Ring>::Element>,
    ) -> Option<Self> {
        let jet = Jet::with_values(ring, plane.tape, values);
        Some(Self {
            ring,
            gains: [jet.gains(0).ok()?, jet.gains(1).ok()?],
            jet,
            omega0: plane.omega0,
            compliance: ring.numbers.divide(&ring.numbers.rational(&1.into())?, &plane.omega0_squared)?,
            radius: vec![ring.zero()],
            slope: vec![ring.zero()],
            departure: vec![],
            rate: vec![],
        })
    }

    /// rₙ, and s and φ′ of one order less.
    fn extend(&mut self, n: usize) -> Option<()> {
        let (ring, one) = (self.ring, self.ring.numbers.rational(&1.into())?);
        let (sine, cosine) = (unit_sine(ring, &one), wave(ring, 1, one.clone(), ring.numbers.zero()));
        self.jet.extend(&[ring.zero(), ring.zero()]).ok()?;
        let radius = if n == 1 {
            self.departure.push(ring.zero());
            self.rate.push(wave(ring, 0, one, ring.numbers.zero()));
            self.slope.push(ring.zero());
            self.rate[0].clone()
        } else {
            let force = ring.times_number(&self.jet.result(0)[n], &self.compliance);
            let departure = ring.subtract(&force, &ring.convolution(&self.departure[1..], &self.radius[2..]));
            self.departure.push(departure);
            let across = ring.convolution(&self.departure[1..], &self.slope[1..]);
            let slope = ring.add(&ring.multiply(&force, &cosine), &ring.multiply(&across, &sine));
            self.rate.push(ring.negate(&ring.multiply(self.departure.last()?, &sine)));
            self.slope.push(slope.clone());
            integral(ring, &slope)?
        };
        self.jet.amend(&self.gains[0], &ring.multiply(&radius, &sine));
        let velocity = ring.times_number(&ring.multiply(&radius, &cosine), &self.omega0);
        self.jet.amend(&self.gains[1], &velocity);
        self.radius.push(radius);
        Some(())
    }
}

fn wave<F: Ring>(
    ring: &HarmonicSums<F>,
    k: usize,
    cosine: F::Element,
    sine: F::Element,
) -> <HarmonicSums<F> as Ring>::Element {
    ring.sum_of_harmonics(&[(k, HarmonicPair { cosine, sine })])
}

fn unit_sine<F: Ring>(ring: &HarmonicSums<F>, one: &F::Element) -> <HarmonicSums<F> as Ring>::Element {
    wave(ring, 1, ring.numbers.zero(), one.clone())
}

/// The integral from φ = π/2 on; `None` when the mean does not vanish.
fn integral<F: Ring>(
    ring: &HarmonicSums<F>,
    a: &<HarmonicSums<F> as Ring>::Element,
) -> Option<<HarmonicSums<F> as Ring>::Element> {
    let numbers = &ring.numbers;
    if !numbers.is_zero(&ring.harmonic(a, 0).cosine) {
        return None;
    }
    let mut terms = vec![];
    let mut at_quarter = numbers.zero();
    for k in 1..=a.highest() {
        let HarmonicPair { cosine, sine } = ring.harmonic(a, k);
        let over = |number: &F::Element| numbers.over_integer(number, u64::try_from(k).ok()?);
        let (cosine, sine) = (numbers.negate(&over(&sine)?), over(&cosine)?);
        let there = if k % 2 == 0 { cosine.clone() } else { sine.clone() };
        // cos kπ/2 = 1, 0, −1, 0 and sin kπ/2 = 0, 1, 0, −1.
        let sign = if matches!(k % 4, 0 | 1) { 1 } else { -1 };
        at_quarter = numbers.add(&at_quarter, &numbers.times_integer(&there, sign));
        terms.push((k, HarmonicPair { cosine, sine }));
    }
    terms.push((0, HarmonicPair { cosine: numbers.negate(&at_quarter), sine: numbers.zero() }));
    Some(ring.sum_of_harmonics(&terms))
}
