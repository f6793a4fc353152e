//! The limit cycle that a weak self-excitation selects, as a series in its strength μ.
//!
//! With τ = Ωt, x = Σ μⁿxₙ(τ) and W = (Ω/ω0)² the equation x″ = −ω0²x + μf(x, x′, μ) reads at order n, for the k-th
//! harmonic, (1 − k²)·xₙₖ = Rₙₖ/ω0² + k²·Σ_{j<n} Wₙ₋ⱼ·xⱼₖ, with Rₙ the coefficient of the acceleration without −ω0²xₙ.
//! For k = 1 the cosine fixes Wₙ, and the sine, whose left side is zero because the phase is chosen so that no sin τ
//! appears, fixes the amplitude of cos τ one order below. The lowest of these conditions gives the amplitude x₀.
//!
//! # Method
//! The lowest solvability condition is a polynomial (`selection.rs`). The harmonics contain sines, so that the turning points are not at τ = 0 and
//! π but where the velocity vanishes (`extremes.rs`).

use super::lindstedt::Family;
use libration_numbers::internals::expression::{Jet, Tape};
use libration_numbers::internals::progress::Watch;
use libration_numbers::internals::series::truncated::next_square_root;
use libration_numbers::{
    algebra::Ring,
    internals::algebra::{HarmonicPair, Number, PhaseRing},
};

/// A weakly self-excited oscillator, in the numbers of a ring.
#[derive(Debug)]
pub(crate) struct Excitation<'a, R: PhaseRing> {
    /// The acceleration as a function of x, x′ and μ.
    pub(crate) tape: &'a Tape,
    pub(crate) omega0: Number<R>,
    /// The amplitude at μ = 0.
    pub(crate) amplitude: Number<R>,
    /// The derivative, with respect to that amplitude, of the sine that must vanish.
    pub(crate) slope: Number<R>,
    /// The total degree of the acceleration in x and x′.
    pub(crate) degree: usize,
    /// `true` if the acceleration is odd: x′ and x have odd harmonics only.
    pub(crate) symmetric: bool,
}

/// The highest harmonic at order n.
pub(crate) fn highest_harmonic(degree: usize, n: usize) -> usize {
    1 + n * degree.saturating_sub(1)
}

/// The sine of the acceleration at first order in μ, at the amplitude given: it vanishes on a limit cycle.
pub(crate) fn first_sine<R: PhaseRing>(
    ring: &R,
    tape: &Tape,
    omega0: &Number<R>,
    amplitude: &Number<R>,
) -> Option<Number<R>> {
    let mut jet = start(ring, tape, omega0, amplitude)?;
    jet.extend(&next_inputs(ring, 1)?).ok()?;
    Some(ring.harmonic(jet.result(0).get(1)?, 1).sine)
}

/// x, x′ and μ at zeroth order.
fn start<'a, R: PhaseRing>(
    ring: &'a R,
    tape: &'a Tape,
    omega0: &Number<R>,
    amplitude: &Number<R>,
) -> Option<Jet<'a, R>> {
    let numbers = ring.numbers();
    let zero = numbers.zero();
    let position = HarmonicPair { cosine: amplitude.clone(), sine: zero.clone() };
    let velocity = HarmonicPair { cosine: zero, sine: numbers.negate(&numbers.multiply(omega0, amplitude)) };
    let inputs =
        [ring.sum_of_harmonics(&[(1, position)]), ring.sum_of_harmonics(&[(1, velocity)]), ring.zero()];
    Jet::new(ring, tape, &inputs).ok()
}

/// Returns the next coefficients of the inputs: zero for x and x′; μ itself is of first order.
fn next_inputs<R: PhaseRing>(ring: &R, n: usize) -> Option<[R::Element; 3]> {
    let mu = if n == 1 { ring.rational(&1.into())? } else { ring.zero() };
    Some([ring.zero(), ring.zero(), mu])
}

/// The limit cycle up to μᴺ, or up to the last order that was solved when it was interrupted. `None` when a number is not in the ring.
pub(crate) fn limit_cycle<R: PhaseRing>(
    ring: &R,
    excitation: &Excitation<'_, R>,
    order: usize,
    watch: &Watch<'_>,
) -> Option<Family<Number<R>>> {
    let mut expansion = LimitCycleSeries::new(ring, excitation)?;
    for n in 1..=order {
        if watch.reached(n).is_err() && n > 1 {
            break;
        }
        expansion.extend()?;
    }
    // The last amplitude of cos τ is fixed by the order that follows.
    expansion.settle_amplitude()?;
    Some(expansion.into_family())
}

struct LimitCycleSeries<'a, R: PhaseRing> {
    ring: &'a R,
    excitation: &'a Excitation<'a, R>,
    jet: Jet<'a, R>,
    position_gains: Vec<R::Element>,
    velocity_gains: Vec<R::Element>,
    /// 1/ω0².
    compliance: Number<R>,
    squared: Vec<Number<R>>,
    frequency: Vec<Number<R>>,
    /// xₙₖ by k and n.
    harmonics: Vec<Waves<Number<R>>>,
    /// Number of orders that are solved, the zeroth included.
    solved: usize,
}

/// The coefficients of one harmonic by powers of μ.
struct Waves<N> {
    cosines: Vec<N>,
    sines: Vec<N>,
}

impl<'a, R: PhaseRing> LimitCycleSeries<'a, R> {
    fn new(ring: &'a R, excitation: &'a Excitation<'a, R>) -> Option<Self> {
        let numbers = ring.numbers();
        let (zero, one) = (numbers.zero(), numbers.rational(&1.into())?);
        let nothing = Waves { cosines: vec![zero.clone()], sines: vec![zero.clone()] };
        let first = Waves { cosines: vec![excitation.amplitude.clone()], sines: vec![zero] };
        let jet = start(ring, excitation.tape, &excitation.omega0, &excitation.amplitude)?;
        Some(Self {
            ring,
            excitation,
            position_gains: jet.gains(0).ok()?,
            velocity_gains: jet.gains(1).ok()?,
            compliance: numbers.divide(&one, &numbers.multiply(&excitation.omega0, &excitation.omega0))?,
            jet,
            squared: vec![one.clone()],
            frequency: vec![one],
            harmonics: vec![nothing, first],
            solved: 1,
        })
    }

    /// Solves the equations of the next order, which leaves its amplitude of cos τ open.
    fn extend(&mut self) -> Option<()> {
        let numbers = self.ring.numbers();
        let rest = self.settle_amplitude()?;
        let n = self.solved;
        let highest = highest_harmonic(self.excitation.degree, n);
        let forced: Vec<usize> =
            (0..=highest).filter(|k| *k != 1 && !(self.excitation.symmetric && k % 2 == 0)).collect();
        let wanted: Vec<usize> = std::iter::once(1).chain(forced).collect();
        let driving = self.driving(&rest, &wanted);
        let secular = numbers.add(&driving[0].cosine, &self.mixed(1).cosine);
        let next = numbers.divide(&numbers.negate(&secular), &self.excitation.amplitude)?;
        self.frequency.push(next_square_root(numbers, &next, &self.frequency)?);
        self.squared.push(next);
        let answers = wanted[1..].iter().zip(&driving[1..]);
        let answers = answers.map(|(&k, driving)| Some((k, self.forced(driving, k)?)));
        let answers = answers.collect::<Option<Vec<_>>>()?;
        self.keep(highest, answers);
        let position = self.ring.sum_of_harmonics(&self.of_order(n));
        self.jet.amend(&self.position_gains, &position);
        let velocity = self.velocity(n)?;
        self.jet.amend(&self.velocity_gains, &velocity);
        Some(())
    }

    /// Adds the harmonics of the next order.
    fn keep(&mut self, highest: usize, answers: Vec<(usize, HarmonicPair<Number<R>>)>) {
        let zero = self.ring.numbers().zero();
        let nothing = || vec![zero.clone(); self.solved];
        while self.harmonics.len() <= highest {
            self.harmonics.push(Waves { cosines: nothing(), sines: nothing() });
        }
        self.solved += 1;
        for (k, answer) in answers {
            self.harmonics[k].cosines.push(answer.cosine);
            self.harmonics[k].sines.push(answer.sine);
        }
        for waves in &mut self.harmonics {
            waves.cosines.resize(self.solved, zero.clone());
            waves.sines.resize(self.solved, zero.clone());
        }
    }

    /// The acceleration of the next order, with the undetermined amplitude of cos τ chosen so that it has no sin τ.
    fn settle_amplitude(&mut self) -> Option<R::Element> {
        let (ring, numbers, n) = (self.ring, self.ring.numbers(), self.solved);
        self.jet.extend(&next_inputs(ring, n)?).ok()?;
        let rest = self.jet.result(0)[n].clone();
        let sine = ring.harmonic(&rest, 1).sine;
        if n == 1 || numbers.is_zero(&sine) {
            return Some(rest);
        }
        let amplitude = numbers.divide(&numbers.negate(&sine), &self.excitation.slope)?;
        self.jet.shorten();
        self.harmonics[1].cosines[n - 1] = amplitude.clone();
        let position = HarmonicPair { cosine: amplitude.clone(), sine: numbers.zero() };
        let speed = numbers.negate(&numbers.multiply(&self.excitation.omega0, &amplitude));
        let velocity = HarmonicPair { cosine: numbers.zero(), sine: speed };
        self.jet.amend(&self.position_gains, &ring.sum_of_harmonics(&[(1, position)]));
        self.jet.amend(&self.velocity_gains, &ring.sum_of_harmonics(&[(1, velocity)]));
        self.jet.extend(&next_inputs(ring, n)?).ok()?;
        Some(self.jet.result(0)[n].clone())
    }

    /// The harmonic that its driving, the Rₙₖ/ω0², forces.
    fn forced(&self, driving: &HarmonicPair<Number<R>>, k: usize) -> Option<HarmonicPair<Number<R>>> {
        let numbers = self.ring.numbers();
        let k_squared = i64::try_from(k * k).ok()?;
        let detunings =
            if k == 0 { [1, 1] } else { [u64::try_from(k).ok()? - 1, u64::try_from(k).ok()? + 1] };
        let mixed = self.mixed(k);
        let respond = |driving: &Number<R>, mixed: &Number<R>| {
            let forcing = numbers.add(driving, &numbers.times_integer(mixed, k_squared));
            let response =
                numbers.over_integer(&numbers.over_integer(&forcing, detunings[0])?, detunings[1])?;
            Some(if k == 0 { response } else { numbers.negate(&response) })
        };
        Some(HarmonicPair {
            cosine: respond(&driving.cosine, &mixed.cosine)?,
            sine: respond(&driving.sine, &mixed.sine)?,
        })
    }

    /// Rₙₖ/ω0² for some k.
    fn driving(&self, rest: &R::Element, wanted: &[usize]) -> Vec<HarmonicPair<Number<R>>> {
        let numbers = self.ring.numbers();
        let scaled = |HarmonicPair { cosine, sine }| HarmonicPair {
            cosine: numbers.multiply(&cosine, &self.compliance),
            sine: numbers.multiply(&sine, &self.compliance),
        };
        self.ring.harmonics(rest, wanted).into_iter().map(scaled).collect()
    }

    /// Σ Wₙ₋ⱼ·xⱼₖ over 0 < j < n, and over j = 0 if k ≠ 1, where it is zero.
    fn mixed(&self, k: usize) -> HarmonicPair<Number<R>> {
        let (numbers, n) = (self.ring.numbers(), self.solved);
        let sum = |x: &[Number<R>]| numbers.convolution(&self.squared[1..n], &x[1..n]);
        match self.harmonics.get(k) {
            Some(waves) => HarmonicPair { cosine: sum(&waves.cosines), sine: sum(&waves.sines) },
            None => HarmonicPair { cosine: numbers.zero(), sine: numbers.zero() },
        }
    }

    /// The harmonics of one order.
    fn of_order(&self, n: usize) -> Vec<(usize, HarmonicPair<Number<R>>)> {
        let pair = |waves: &Waves<Number<R>>| HarmonicPair {
            cosine: waves.cosines[n].clone(),
            sine: waves.sines[n].clone(),
        };
        self.harmonics.iter().map(pair).enumerate().collect()
    }

    /// The velocity of order n, ω0·Σ wₙ₋ⱼ·dxⱼ/dτ.
    fn velocity(&self, n: usize) -> Option<R::Element> {
        let numbers = self.ring.numbers();
        let sum = |x: &[Number<R>]| numbers.convolution(&self.frequency[..=n], &x[..=n]);
        let slope = |(k, waves): (usize, &Waves<Number<R>>)| {
            let factor = numbers.times_integer(&self.excitation.omega0, i64::try_from(k).ok()?);
            let cosine = numbers.multiply(&sum(&waves.sines), &factor);
            let sine = numbers.negate(&numbers.multiply(&sum(&waves.cosines), &factor));
            Some((k, HarmonicPair { cosine, sine }))
        };
        let slopes = self.harmonics.iter().enumerate().map(slope).collect::<Option<Vec<_>>>()?;
        Some(self.ring.sum_of_harmonics(&slopes))
    }

    fn into_family(self) -> Family<Number<R>> {
        let pairs = |waves: Waves<Number<R>>| {
            let pairs = waves.cosines.into_iter().zip(waves.sines);
            pairs.map(|(cosine, sine)| HarmonicPair { cosine, sine }).collect()
        };
        Family { frequency: self.frequency, harmonics: self.harmonics.into_iter().map(pairs).collect() }
    }
}
