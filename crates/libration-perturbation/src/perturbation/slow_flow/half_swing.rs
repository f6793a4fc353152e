//! Functions on the half swing 0 ≤ ψ ≤ π that are their own opposites on the next one: y(ψ + π) = −y(ψ).
//!
//! They are Σ ψᵖ·hₚ(ψ) with sums of harmonics hₚ. If the velocity has one sign a force such as x′|x′| is a polynomial, and so is
//! the forced motion: a forcing cos ψ, which a periodic function must not have, makes ½ψ·sin ψ.

use super::phase_functions::{
    Coefficient, PhaseFunctions, Response, Term, cosines_with, forced_by, slope_of,
};
use libration_numbers::{
    algebra::{Function, Rational, Ring},
    internals::algebra::{HarmonicPair, HarmonicSum, HarmonicSums, PhaseRing, PiPolynomial, PiPowers},
};

/// The ring of these functions, whose coefficients are sums of powers of π.
#[derive(Clone, Debug)]
pub struct HalfSwings<F> {
    pub sums: HarmonicSums<PiPowers<F>>,
}

/// hₚ by p.
pub type Sums<F> = Vec<HarmonicSum<PiPolynomial<<F as Ring>::Element>>>;

impl<F: Ring> HalfSwings<F> {
    pub fn new(numbers: F) -> Self {
        Self { sums: HarmonicSums { numbers: PiPowers { numbers } } }
    }

    /// ψᵖ(c·cos kψ + s·sin kψ).
    pub(in crate::perturbation) fn term(
        &self,
        power: usize,
        k: usize,
        wave: HarmonicPair<PiPolynomial<F::Element>>,
    ) -> Sums<F> {
        let mut sums = vec![self.sums.zero(); power];
        sums.push(self.sums.sum_of_harmonics(&[(k, wave)]));
        sums
    }

    fn zip(
        &self,
        a: &Sums<F>,
        b: &Sums<F>,
        f: impl Fn(&HarmonicSum<PiPolynomial<F::Element>>, &HarmonicSum<PiPolynomial<F::Element>>) -> PiSum<F>,
    ) -> Sums<F> {
        let zero = self.sums.zero();
        let at = |list: &Sums<F>, p: usize| list.get(p).unwrap_or(&zero).clone();
        (0..a.len().max(b.len())).map(|p| f(&at(a, p), &at(b, p))).collect()
    }

    /// The value as a number; `None` if it depends on the phase.
    fn as_constant<'a>(&self, a: &'a Sums<F>) -> Option<Option<&'a PiSum<F>>> {
        let (first, rest) = match a.split_first() {
            None => return Some(None),
            Some(parts) => parts,
        };
        rest.iter().all(|sum| self.sums.is_zero(sum)).then_some(Some(first))
    }

    /// A y with y″ + y = r: from the highest power of ψ down the equation of ψᵖ,
    /// hₚ″ + hₚ = rₚ − 2(p + 1)hₚ₊₁′ − (p + 2)(p + 1)hₚ₊₂, gives hₚ, and its first harmonic that of hₚ₊₁.
    fn particular(&self, r: &Sums<F>) -> Option<Sums<F>> {
        let sums = &self.sums;
        let mut y = vec![sums.zero(); r.len() + 2];
        for p in (0..r.len()).rev() {
            let p_signed = i64::try_from(p).ok()?;
            let above = sums.times_integer(&y[p + 2], (p_signed + 2) * (p_signed + 1));
            let rest = sums.subtract(&r[p], &above);
            let HarmonicPair { cosine, sine } = sums.harmonic(&rest, 1);
            let halved = |number: &PiPolynomial<F::Element>| {
                sums.numbers.over_integer(number, 2 * (u64::try_from(p).ok()? + 1))
            };
            let wave = HarmonicPair { cosine: sums.numbers.negate(&halved(&sine)?), sine: halved(&cosine)? };
            y[p + 1] = sums.add(&y[p + 1], &sums.sum_of_harmonics(&[(1, wave)]));
            let slope = sums.times_integer(&slope_of(sums, &y[p + 1]), 2 * (p_signed + 1));
            y[p] = forced_by(sums, &sums.subtract(&rest, &slope))?;
        }
        Some(y)
    }

    /// The value at ψ = π.
    fn at_end(&self, a: &Sums<F>) -> PiPolynomial<F::Element> {
        let numbers = &self.sums.numbers;
        let Some(pi) = numbers.pi() else { return numbers.zero() };
        a.iter().rev().fold(numbers.zero(), |sum, h| {
            numbers.add(&numbers.multiply(&sum, &pi), &cosines_with(&self.sums, h, -1))
        })
    }

    /// (y(0) + y(π))·2/π, which is zero where the next half swing begins at the opposite.
    pub fn gap(&self, y: &Sums<F>) -> Option<PiPolynomial<F::Element>> {
        let numbers = &self.sums.numbers;
        let sum = numbers.add(&self.at_start(y), &self.at_end(y));
        numbers.divide(&numbers.times_integer(&sum, 2), &numbers.pi()?)
    }
}

type PiSum<F> = HarmonicSum<PiPolynomial<<F as Ring>::Element>>;

impl<F: Ring> Ring for HalfSwings<F> {
    type Element = Sums<F>;

    fn zero(&self) -> Self::Element {
        vec![]
    }

    fn is_zero(&self, a: &Self::Element) -> bool {
        a.iter().all(|sum| self.sums.is_zero(sum))
    }

    fn rational(&self, value: &Rational) -> Option<Self::Element> {
        self.sums.rational(value).map(|sum| vec![sum])
    }

    fn add(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        self.zip(a, b, |x, y| self.sums.add(x, y))
    }

    fn subtract(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        self.zip(a, b, |x, y| self.sums.subtract(x, y))
    }

    fn negate(&self, a: &Self::Element) -> Self::Element {
        a.iter().map(|sum| self.sums.negate(sum)).collect()
    }

    fn multiply(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        let mut product = vec![self.sums.zero(); (a.len() + b.len()).saturating_sub(1)];
        for (p, x) in a.iter().enumerate().filter(|(_, x)| !self.sums.is_zero(x)) {
            for (q, y) in b.iter().enumerate().filter(|(_, y)| !self.sums.is_zero(y)) {
                product[p + q] = self.sums.add(&product[p + q], &self.sums.multiply(x, y));
            }
        }
        while product.last().is_some_and(|sum| self.sums.is_zero(sum)) {
            product.pop();
        }
        product
    }

    fn times_integer(&self, a: &Self::Element, factor: i64) -> Self::Element {
        a.iter().map(|sum| self.sums.times_integer(sum, factor)).collect()
    }

    fn divide(&self, a: &Self::Element, divisor: &Self::Element) -> Option<Self::Element> {
        let divisor = self.as_constant(divisor)??;
        a.iter().map(|sum| self.sums.divide(sum, divisor)).collect()
    }

    fn over_integer(&self, a: &Self::Element, divisor: u64) -> Option<Self::Element> {
        a.iter().map(|sum| self.sums.over_integer(sum, divisor)).collect()
    }

    fn value(&self, function: Function, at: &Self::Element) -> Option<Self::Element> {
        let at = self.as_constant(at)?.cloned().unwrap_or_else(|| self.sums.zero());
        self.sums.value(function, &at).map(|sum| vec![sum])
    }

    fn power(&self, a: &Self::Element, exponent: &Rational) -> Option<Self::Element> {
        let base = self.as_constant(a)?.cloned().unwrap_or_else(|| self.sums.zero());
        self.sums.power(&base, exponent).map(|sum| vec![sum])
    }

    fn pi(&self) -> Option<Self::Element> {
        self.sums.pi().map(|sum| vec![sum])
    }
}

impl<F: Ring> PhaseFunctions for HalfSwings<F> {
    type Numbers = PiPowers<F>;

    fn numbers(&self) -> &PiPowers<F> {
        &self.sums.numbers
    }

    fn wave(&self, wave: HarmonicPair<Coefficient<Self>>) -> Self::Element {
        vec![self.sums.sum_of_harmonics(&[(1, wave)])]
    }

    fn times_number(&self, a: &Self::Element, factor: &Coefficient<Self>) -> Self::Element {
        a.iter().map(|sum| PhaseRing::times_number(&self.sums, sum, factor)).collect()
    }

    fn slope(&self, a: &Self::Element) -> Self::Element {
        let of_powers: Sums<F> = (1..a.len())
            .map(|p| self.sums.times_integer(&a[p], i64::try_from(p).unwrap_or(i64::MAX)))
            .collect();
        self.add(&a.iter().map(|sum| slope_of(&self.sums, sum)).collect(), &of_powers)
    }

    fn at_start(&self, a: &Self::Element) -> Coefficient<Self> {
        a.first().map_or_else(|| self.sums.numbers.zero(), |sum| cosines_with(&self.sums, sum, 1))
    }

    /// A forcing c·cos ψ + s·sin ψ makes ½ψ(c·sin ψ − s·cos ψ), which leaves a gap of π·s/2 and one of −π·c/2 in the slope.
    fn response(&self, forcing: &Self::Element) -> Option<Response<Self>> {
        let numbers = &self.sums.numbers;
        let whole = self.particular(forcing)?;
        let secular =
            HarmonicPair { cosine: numbers.negate(&self.gap(&self.slope(&whole))?), sine: self.gap(&whole)? };
        let of_secular = self.particular(&self.wave(secular.clone()))?;
        Some(Response { secular, forced: self.subtract(&whole, &of_secular) })
    }

    fn terms(&self, a: &Self::Element) -> Vec<Term<Coefficient<Self>>> {
        let of_power = |(power, sum)| {
            let terms = PhaseFunctions::terms(&self.sums, sum).into_iter();
            terms.map(move |term| Term { power, ..term })
        };
        a.iter().enumerate().flat_map(of_power).collect()
    }
}
