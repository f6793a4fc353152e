//! The integrals over a side exactly: functions of χ are polynomials in χ times harmonics, their integrals have powers of π.

use super::Side;
use super::phase::turned;
use crate::perturbation::slow_flow::{HalfSwings, PhaseFunctions, Term};
use libration_numbers::{
    algebra::{Rational, Rationals, Ring},
    internals::algebra::{HarmonicPair, PiPolynomial, PiPowers},
};

const NUMBERS: PiPowers<Rationals> = PiPowers { numbers: Rationals };

type Number = PiPolynomial<Rational>;
type Function = <HalfSwings<Rationals> as Ring>::Element;

/// The coefficients of (1/π)∫ X·cos kθ dθ for each k, by powers of ρ; half of it for k = 0.
pub(super) fn integrals(side: &Side<'_, Number>, harmonics: &[usize]) -> Option<Vec<Vec<Number>>> {
    let swing = Swing::new(side)?;
    harmonics.iter().map(|&k| swing.integral(k)).collect()
}

/// The series of a side, with functions of χ for coefficients.
struct Swing<'a> {
    ring: HalfSwings<Rationals>,
    side: &'a Side<'a, Number>,
    /// cosⁿχ.
    cosines: Vec<Function>,
    /// Series of X′.
    slope: Vec<Function>,
    /// Series of θ′(χ).
    rate: Vec<Function>,
    /// Series of θ − χ.
    delta: Vec<Function>,
}

impl<'a> Swing<'a> {
    fn new(side: &'a Side<'a, Number>) -> Option<Self> {
        let ring = HalfSwings::new(Rationals);
        let length = side.frequency.len();
        let cosine = harmonic(&ring, 1, one()?, NUMBERS.zero());
        let mut cosines = vec![ring.rational(&1.into())?];
        while cosines.len() <= length {
            cosines.push(ring.multiply(cosines.last()?, &cosine));
        }
        let slope: Option<Vec<Function>> = (0..length)
            .map(|n| {
                let c = NUMBERS.times_integer(side.displacement.get(n + 1)?, i64::try_from(n + 1).ok()?);
                Some(ring.times_number(&cosines[n], &c))
            })
            .collect();
        let slope = slope?;
        let rate: Vec<Function> = (0..length)
            .map(|n| {
                let terms = (0..=n).map(|j| ring.times_number(&slope[n - j], &side.frequency[j]));
                terms.fold(ring.zero(), |sum, term| ring.add(&sum, &term))
            })
            .collect();
        let mut delta = vec![ring.zero()];
        for rate in rate.iter().skip(1) {
            delta.push(integral_from_zero(&ring, rate)?);
        }
        Some(Self { ring, side, cosines, slope, rate, delta })
    }

    /// The integral as a mean of X·cos kθ·θ′ for k = 0, of sin kθ·sin χ·ρX′/k otherwise.
    fn integral(&self, k: usize) -> Option<Vec<Number>> {
        let (ring, length) = (&self.ring, self.side.displacement.len());
        if k == 0 {
            let product = |(cosine, c): (&Function, &Number)| ring.times_number(cosine, c);
            let products: Vec<Function> =
                self.cosines.iter().zip(self.side.displacement).map(product).collect();
            let twice = ring.series_product(&products, &self.rate, length);
            return twice.iter().map(|part| NUMBERS.over_integer(&mean(ring, part)?, 2)).collect();
        }
        let [cosine, sine] = turned(ring, k, &self.delta)?;
        let base_sine = harmonic(ring, k, NUMBERS.zero(), one()?);
        let base_cosine = harmonic(ring, k, one()?, NUMBERS.zero());
        let phase = cosine.iter().zip(&sine);
        let phase: Vec<Function> = phase
            .map(|(c, s)| ring.add(&ring.multiply(&base_sine, c), &ring.multiply(&base_cosine, s)))
            .collect();
        let across = harmonic(ring, 1, NUMBERS.zero(), one()?);
        let fall: Vec<Function> = self.slope.iter().map(|slope| ring.multiply(slope, &across)).collect();
        let product = ring.series_product(&phase, &fall, length - 1);
        let each =
            product.iter().map(|part| NUMBERS.over_integer(&mean(ring, part)?, u64::try_from(k).ok()?));
        std::iter::once(Some(NUMBERS.zero())).chain(each).collect()
    }
}

fn one() -> Option<Number> {
    NUMBERS.rational(&1.into())
}

fn harmonic(ring: &HalfSwings<Rationals>, k: usize, cosine: Number, sine: Number) -> Function {
    ring.term(0, k, HarmonicPair { cosine, sine })
}

/// The integral from χ = 0 of a sum of cosines.
fn integral_from_zero(ring: &HalfSwings<Rationals>, of: &Function) -> Option<Function> {
    let mut sum = ring.zero();
    for Term { power, k, wave } in ring.terms(of) {
        let part = match (power, k) {
            (0, 0) => ring.term(1, 0, wave),
            (0, k) => {
                let sine = NUMBERS.over_integer(&wave.cosine, u64::try_from(k).ok()?)?;
                harmonic(ring, k, NUMBERS.zero(), sine)
            }
            _ => return None,
        };
        sum = ring.add(&sum, &part);
    }
    Some(sum)
}

/// (1/π)∫ from −π/2 to π/2.
fn mean(ring: &HalfSwings<Rationals>, of: &Function) -> Option<Number> {
    let mut sum = NUMBERS.zero();
    for Term { power, k, wave } in ring.terms(of) {
        let (cosine, sine) = moments(power, k)?;
        sum = NUMBERS.add(&sum, &NUMBERS.multiply(&wave.cosine, &cosine));
        sum = NUMBERS.add(&sum, &NUMBERS.multiply(&wave.sine, &sine));
    }
    Some(sum)
}

/// (1/π)∫ χᵖ cos kχ and (1/π)∫ χᵖ sin kχ from −π/2 to π/2: each by parts from the other with one power less.
fn moments(power: usize, k: usize) -> Option<(Number, Number)> {
    if k == 0 {
        let mean =
            if power % 2 == 1 { NUMBERS.zero() } else { at_quarter(power, u64::try_from(power + 1).ok()?)? };
        return Some((mean, NUMBERS.zero()));
    }
    let divisor = u64::try_from(k).ok()?;
    let mut moments = (NUMBERS.zero(), NUMBERS.zero());
    for p in 0..=power {
        let (cosine, sine) = moments;
        let over = |number: &Number| NUMBERS.over_integer(number, divisor);
        let times = |number: &Number| NUMBERS.times_integer(number, i64::try_from(p).unwrap_or(i64::MAX));
        // 2(π/2)ᵖ/π at both ends together, where the function is even.
        let ends = NUMBERS.divide(&NUMBERS.times_integer(&at_quarter(p, 1)?, 2), &NUMBERS.pi()?)?;
        let sign = |positive: bool| if positive { 1 } else { -1 };
        let sine_there = if k % 2 == 1 && p % 2 == 0 { sign(k % 4 == 1) } else { 0 };
        let cosine_there = if k.is_multiple_of(2) && p % 2 == 1 { sign(k.is_multiple_of(4)) } else { 0 };
        let from_sine = NUMBERS.subtract(&NUMBERS.times_integer(&ends, sine_there), &times(&sine));
        let from_cosine = NUMBERS.subtract(&times(&cosine), &NUMBERS.times_integer(&ends, cosine_there));
        moments = (over(&from_sine)?, over(&from_cosine)?);
    }
    Some(moments)
}

/// (π/2)ᵖ over a number.
fn at_quarter(power: usize, over: u64) -> Option<Number> {
    let number = Rational::from(1).divided_by_power_of_two(power);
    NUMBERS.over_integer(&NUMBERS.term(i32::try_from(power).ok()?, number), over)
}
