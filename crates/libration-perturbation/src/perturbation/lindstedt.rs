//! Lindstedt and Poincaré's expansion of the periodic motions about a centre, order by order, over any ring.
//!
//! With τ = Ωt, x = xₑ + Σ εⁿxₙ(τ) and W = (Ω/ω0)² = Σ εⁿWₙ the equation x″ = F(x, x′) reads at order n, for the
//! harmonic cos kτ, or sin kτ where the phase begins at a passage through the equilibrium,
//!
//! ```text
//! (1 − k²)·xₙₖ = Rₙₖ/ω0² + k²·Σ_{0<j<n} Wₙ₋ⱼ·xⱼₖ,
//! ```
//!
//! where Rₙ is the coefficient of F with xₙ left out. For k = 1 the left side vanishes: xₙ₁ = Aₙ is free, the
//! gauge, and the right side must vanish too, which fixes Wₙ₋₁ (solvability: no secular term).
//!
//! # Method
//! At each order the jet gives the terms that the lower orders force. The coefficient of cos τ is the gauge. Named gauges are found from the
//! fundamental one by substituting a series; lists of coefficients go through the expansion itself, so that tests can compare the two. Relations
//! between physical quantities come from reversion by Lagrange's formula (`series_set.rs`).
//!
//! Where the force is opposite at the opposite displacement and the same velocity, (x, t) → (−x, −t) makes the motions periodic. Their phase begins
//! at the equilibrium, where all harmonics are sines (`shape.rs`).

use libration_numbers::internals::expression::{Jet, Tape};
use libration_numbers::internals::progress::Watch;
use libration_numbers::internals::series::truncated::next_square_root;
use libration_numbers::{
    algebra::Ring,
    internals::algebra::{HarmonicPair, Number, PhaseRing},
};

/// An oscillator about its centre, in the numbers of a ring.
#[derive(Debug)]
pub(crate) struct Centre<'a, R: PhaseRing> {
    /// The acceleration as a function of x and x′.
    pub(crate) tape: &'a Tape,
    /// The zeroth coefficient of every slot of the tape: its value at the equilibrium.
    pub(crate) values: Vec<R::Element>,
    /// ω0².
    pub(crate) omega0_squared: Number<R>,
    /// ω0, when the acceleration depends on the velocity.
    pub(crate) omega0: Option<Number<R>>,
    /// Harmonics of the motions.
    pub(crate) wave: Wave,
}

/// The harmonics of a family of motions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wave {
    /// Cosines: the phase begins at a turning point.
    Cosine,
    /// Sines: the phase begins at a passage through the equilibrium.
    Sine,
}

impl Wave {
    /// The harmonic with this coefficient.
    pub(crate) fn pair<N>(self, coefficient: N, zero: N) -> HarmonicPair<N> {
        match self {
            Self::Cosine => HarmonicPair { cosine: coefficient, sine: zero },
            Self::Sine => HarmonicPair { cosine: zero, sine: coefficient },
        }
    }

    /// The coefficient of a harmonic.
    pub(crate) fn of<N>(self, pair: HarmonicPair<N>) -> N {
        match self {
            Self::Cosine => pair.cosine,
            Self::Sine => pair.sine,
        }
    }

    /// The derivative of the k-th harmonic with this coefficient.
    fn slope<R: Ring>(self, ring: &R, k: usize, coefficient: &R::Element) -> HarmonicPair<R::Element> {
        let k = i64::try_from(k).unwrap_or(i64::MAX);
        match self {
            Self::Cosine => Self::Sine.pair(ring.times_integer(coefficient, -k), ring.zero()),
            Self::Sine => Self::Cosine.pair(ring.times_integer(coefficient, k), ring.zero()),
        }
    }
}

/// The coefficients of a family of periodic motions.
#[derive(Clone, Debug)]
pub(crate) struct Family<E> {
    /// Ω/ω0 by powers of the variable.
    pub(crate) frequency: Vec<E>,
    /// The coefficients of each harmonic k by powers of the variable.
    pub(crate) harmonics: Vec<Vec<HarmonicPair<E>>>,
}

/// The family x = xₑ + Σ εⁿxₙ(τ), n ≤ N, whose first harmonic is Σ Aₙεⁿ cos τ or sin τ; `fundamental` is 0, A₁, …, up to N.
/// If cancelled, the family ends with the last order that was solved. `None` when a number is not in the ring.
pub(crate) fn family<R: PhaseRing>(
    ring: &R,
    centre: Centre<'_, R>,
    fundamental: &[Number<R>],
    watch: &Watch<'_>,
) -> Option<Family<Number<R>>> {
    let numbers = ring.numbers();
    let half_wave = fundamental.iter().step_by(2).all(|a| numbers.is_zero(a));
    let mut expansion = LindstedtSeries::new(ring, centre)?;
    for (n, gauge) in fundamental.iter().enumerate().skip(1) {
        let harmonics: Vec<usize> = (0..=n).filter(|k| !half_wave || (n - k) % 2 == 0).collect();
        if watch.reached(n).is_err() && n > 1 {
            break;
        }
        expansion.extend(gauge, &harmonics)?;
    }
    Some(expansion.into_family())
}

struct LindstedtSeries<'a, R: PhaseRing> {
    ring: &'a R,
    jet: Jet<'a, R>,
    gains: Gains<R::Element>,
    inputs: usize,
    /// 1/ω0².
    compliance: Number<R>,
    omega0: Option<Number<R>>,
    wave: Wave,
    /// W₀, W₁, ….
    squared: Vec<Number<R>>,
    frequency: Vec<Number<R>>,
    /// xₙₖ by k and n.
    harmonics: Vec<Vec<Number<R>>>,
    /// Number of orders that are solved, the zeroth included.
    solved: usize,
}

/// Changes of all coefficients of the jet with those of x and of x′.
struct Gains<E> {
    position: Vec<E>,
    velocity: Option<Vec<E>>,
}

impl<'a, R: PhaseRing> LindstedtSeries<'a, R> {
    fn new(ring: &'a R, centre: Centre<'a, R>) -> Option<Self> {
        let one = ring.numbers().rational(&1.into())?;
        let jet = Jet::with_values(ring, centre.tape, centre.values);
        let velocity = if centre.omega0.is_some() { Some(jet.gains(1).ok()?) } else { None };
        let gains = Gains { position: jet.gains(0).ok()?, velocity };
        Some(Self {
            ring,
            jet,
            gains,
            inputs: centre.tape.inputs(),
            compliance: ring.numbers().divide(&one, &centre.omega0_squared)?,
            omega0: centre.omega0,
            wave: centre.wave,
            squared: vec![one.clone()],
            frequency: vec![one],
            harmonics: vec![],
            solved: 1,
        })
    }

    /// Solves the equations of the next order, in which only these harmonics are present.
    fn extend(&mut self, gauge: &Number<R>, harmonics: &[usize]) -> Option<()> {
        let (ring, n) = (self.ring, self.solved);
        let numbers = ring.numbers();
        self.jet.extend(&vec![ring.zero(); self.inputs]).ok()?;
        let rest = self.jet.result(0)[n].clone();
        let driving = self.driving(&rest, harmonics);
        let first = harmonics.iter().position(|&k| k == 1);
        if n > 1 {
            let secular =
                first.map_or_else(|| numbers.zero(), |at| numbers.add(&driving[at], &self.mixed(1)));
            self.impose_solvability(&secular)?;
        }
        let forced = |(&k, driving): (&usize, &Number<R>)| {
            Some((k, if k == 1 { gauge.clone() } else { self.forced(driving, k)? }))
        };
        let answers = harmonics.iter().zip(&driving).map(forced).collect::<Option<Vec<_>>>()?;
        let position: Vec<_> =
            answers.iter().map(|(k, a)| (*k, self.wave.pair(a.clone(), numbers.zero()))).collect();
        self.keep(answers);
        self.jet.amend(&self.gains.position, &ring.sum_of_harmonics(&position));
        self.amend_velocity(n);
        Some(())
    }

    /// Adds the harmonics of the next order.
    fn keep(&mut self, answers: Vec<(usize, Number<R>)>) {
        let zero = self.ring.numbers().zero();
        self.harmonics.resize(self.solved + 1, vec![zero.clone(); self.solved]);
        self.solved += 1;
        for (k, answer) in answers {
            self.harmonics[k].push(answer);
        }
        for series in &mut self.harmonics {
            series.resize(self.solved, zero.clone());
        }
    }

    /// Wₙ₋₁ from the first harmonic of order n.
    fn impose_solvability(&mut self, secular: &Number<R>) -> Option<()> {
        let numbers = self.ring.numbers();
        let next = numbers.divide(&numbers.negate(secular), &self.harmonics[1][1])?;
        self.frequency.push(next_square_root(numbers, &next, &self.frequency)?);
        self.squared.push(next);
        Some(())
    }

    /// The k-th harmonic that its driving and the lower orders force, k ≠ 1.
    fn forced(&self, driving: &Number<R>, k: usize) -> Option<Number<R>> {
        let numbers = self.ring.numbers();
        let k_squared = i64::try_from(k * k).ok()?;
        let forcing = numbers.add(driving, &numbers.times_integer(&self.mixed(k), k_squared));
        if k == 0 {
            return Some(forcing);
        }
        let k = u64::try_from(k).ok()?;
        let response = numbers.over_integer(&numbers.over_integer(&forcing, k - 1)?, k + 1)?;
        Some(numbers.negate(&response))
    }

    /// Rₙₖ/ω0² for some k.
    fn driving(&self, rest: &R::Element, wanted: &[usize]) -> Vec<Number<R>> {
        let scaled = |pair| self.ring.numbers().multiply(&self.wave.of(pair), &self.compliance);
        self.ring.harmonics(rest, wanted).into_iter().map(scaled).collect()
    }

    /// Σ Wₙ₋ⱼ·xⱼₖ over 1 < j < n, and j = 1 where W is known and k ≠ 1; there is no k-th harmonic below order k.
    fn mixed(&self, k: usize) -> Number<R> {
        let (numbers, n, first) = (self.ring.numbers(), self.solved, k.max(2));
        match self.harmonics.get(k) {
            Some(series) if first < n => numbers.convolution(&self.squared[1..=n - first], &series[first..n]),
            _ => numbers.zero(),
        }
    }

    /// The velocity of order n, ω0·Σ wₙ₋ⱼ·dxⱼ/dτ.
    fn amend_velocity(&mut self, n: usize) {
        let (Some(omega0), Some(gains)) = (&self.omega0, &self.gains.velocity) else { return };
        let numbers = self.ring.numbers();
        let slope = |(k, series): (usize, &Vec<Number<R>>)| {
            let sum = numbers.convolution(&self.frequency[..n], &series[1..=n]);
            (k, self.wave.slope(numbers, k, &numbers.multiply(omega0, &sum)))
        };
        let velocity: Vec<_> = self.harmonics.iter().enumerate().map(slope).collect();
        self.jet.amend(gains, &self.ring.sum_of_harmonics(&velocity));
    }

    fn into_family(self) -> Family<Number<R>> {
        let zero = self.ring.numbers().zero();
        let pairs = |series: Vec<Number<R>>| {
            series.into_iter().map(|number| self.wave.pair(number, zero.clone())).collect()
        };
        Family { frequency: self.frequency, harmonics: self.harmonics.into_iter().map(pairs).collect() }
    }
}
