//! Functions of the phase ψ, and the response of a harmonic oscillator of unit frequency to them.

use libration_numbers::{
    algebra::Ring,
    internals::algebra::{HarmonicPair, HarmonicSum, HarmonicSums, PhaseRing},
};

/// A coefficient of a function of the phase.
pub(in crate::perturbation) type Coefficient<R> = <<R as PhaseFunctions>::Numbers as Ring>::Element;

/// Functions of the phase that can be multiplied, and that force the oscillator y″ + y.
pub trait PhaseFunctions: Ring {
    /// Ring of the coefficients.
    type Numbers: Ring;

    fn numbers(&self) -> &Self::Numbers;

    /// c·cos ψ + s·sin ψ.
    fn wave(&self, wave: HarmonicPair<Coefficient<Self>>) -> Self::Element;

    fn times_number(&self, a: &Self::Element, factor: &Coefficient<Self>) -> Self::Element;

    /// The derivative with respect to ψ.
    fn slope(&self, a: &Self::Element) -> Self::Element;

    /// The value at ψ = 0.
    fn at_start(&self, a: &Self::Element) -> Coefficient<Self>;

    /// The response of an oscillator to a forcing; `None` when a number is not in the ring.
    fn response(&self, forcing: &Self::Element) -> Option<Response<Self>>;

    /// Each ψᵖ(c·cos kψ + s·sin kψ) that is present.
    fn terms(&self, a: &Self::Element) -> Vec<Term<Coefficient<Self>>>;
}

/// The wave that must be removed from the forcing for y to be continued, and a y that solves y″ + y for the rest.
#[expect(missing_debug_implementations, reason = "its numbers are those of a ring that may have none")]
pub struct Response<R: PhaseFunctions + ?Sized> {
    pub secular: HarmonicPair<Coefficient<R>>,
    pub forced: R::Element,
}

/// ψᵖ(c·cos kψ + s·sin kψ).
#[derive(Debug)]
pub struct Term<N> {
    pub(in crate::perturbation) power: usize,
    pub(in crate::perturbation) k: usize,
    pub(in crate::perturbation) wave: HarmonicPair<N>,
}

/// The derivative with respect to τ, harmonic by harmonic.
pub(super) fn slope_of<F: Ring>(
    sums: &HarmonicSums<F>,
    a: &HarmonicSum<F::Element>,
) -> HarmonicSum<F::Element> {
    each_harmonic(sums, a, |k, HarmonicPair { cosine, sine }| {
        let k = i64::try_from(k).ok()?;
        let times = |number, factor| sums.numbers.times_integer(number, factor);
        Some(HarmonicPair { cosine: times(&sine, k), sine: times(&cosine, -k) })
    })
    .unwrap_or_else(|| sums.zero())
}

/// The y with y″ + y = a, for an a without first harmonic, which is left out.
pub(super) fn forced_by<F: Ring>(
    sums: &HarmonicSums<F>,
    a: &HarmonicSum<F::Element>,
) -> Option<HarmonicSum<F::Element>> {
    each_harmonic(sums, a, |k, HarmonicPair { cosine, sine }| {
        let over = |number: &F::Element| match k {
            0 => Some(number.clone()),
            1 => Some(sums.numbers.zero()),
            _ => sums.numbers.over_integer(&sums.numbers.negate(number), u64::try_from(k * k - 1).ok()?),
        };
        Some(HarmonicPair { cosine: over(&cosine)?, sine: over(&sine)? })
    })
}

/// The sum of the coefficients of all cosines, with this sign for odd k: the value at ψ = 0 or π.
pub(super) fn cosines_with<F: Ring>(
    sums: &HarmonicSums<F>,
    a: &HarmonicSum<F::Element>,
    odd: i64,
) -> F::Element {
    let numbers = &sums.numbers;
    (0..=a.highest()).fold(numbers.zero(), |sum, k| {
        let sign = if k % 2 == 1 { odd } else { 1 };
        numbers.add(&sum, &numbers.times_integer(&sums.harmonic(a, k).cosine, sign))
    })
}

fn each_harmonic<F: Ring>(
    sums: &HarmonicSums<F>,
    a: &HarmonicSum<F::Element>,
    change: impl Fn(usize, HarmonicPair<F::Element>) -> Option<HarmonicPair<F::Element>>,
) -> Option<HarmonicSum<F::Element>> {
    let changed = (0..=a.highest()).map(|k| Some((k, change(k, sums.harmonic(a, k))?)));
    Some(sums.sum_of_harmonics(&changed.collect::<Option<Vec<_>>>()?))
}

/// Periodic functions, for forces without kinks.
impl<F: Ring> PhaseFunctions for HarmonicSums<F> {
    type Numbers = F;

    fn numbers(&self) -> &F {
        &self.numbers
    }

    fn wave(&self, wave: HarmonicPair<F::Element>) -> Self::Element {
        self.sum_of_harmonics(&[(1, wave)])
    }

    fn times_number(&self, a: &Self::Element, factor: &F::Element) -> Self::Element {
        PhaseRing::times_number(self, a, factor)
    }

    fn slope(&self, a: &Self::Element) -> Self::Element {
        slope_of(self, a)
    }

    fn at_start(&self, a: &Self::Element) -> F::Element {
        cosines_with(self, a, 1)
    }

    fn response(&self, forcing: &Self::Element) -> Option<Response<Self>> {
        Some(Response { secular: self.harmonic(forcing, 1), forced: forced_by(self, forcing)? })
    }

    fn terms(&self, a: &Self::Element) -> Vec<Term<F::Element>> {
        let each = (0..=a.highest()).map(|k| Term { power: 0, k, wave: self.harmonic(a, k) });
        let present = |term: &Term<F::Element>| {
            !self.numbers.is_zero(&term.wave.cosine) || !self.numbers.is_zero(&term.wave.sine)
        };
        each.filter(present).collect()
    }
}
