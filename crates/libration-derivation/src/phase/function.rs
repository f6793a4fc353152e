//! Sums of c·ψᵖ·cos kψ and c·ψᵖ·sin kψ, where c is a sum of powers of π.

use std::collections::BTreeMap;

use super::PiNumber;
use libration::algebra::Rational;

/// A cosine or a sine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Wave {
    /// The cosine.
    Cosine,
    /// The sine.
    Sine,
}

/// The power of ψ, the harmonic, and the wave.
type Key = (usize, usize, Wave);

/// A sum of powers of the phase times harmonics.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PhaseFunction {
    /// Nonzero coefficients; there is no sine of 0ψ.
    terms: BTreeMap<Key, PiNumber>,
}

impl PhaseFunction {
    pub(crate) fn constant(value: PiNumber) -> Self {
        Self::term(0, 0, Wave::Cosine, value)
    }

    /// cos ψ.
    pub(crate) fn cosine() -> Self {
        Self::term(0, 1, Wave::Cosine, Rational::from(1).into())
    }

    /// sin ψ.
    pub fn sine() -> Self {
        Self::term(0, 1, Wave::Sine, Rational::from(1).into())
    }

    /// One power of the phase times one harmonic.
    pub fn term(power: usize, k: usize, wave: Wave, coefficient: PiNumber) -> Self {
        let mut sum = Self::default();
        sum.add((power, k, wave), &coefficient);
        sum
    }

    pub(crate) fn terms(&self) -> impl Iterator<Item = (Key, &PiNumber)> {
        self.terms.iter().map(|(key, coefficient)| (*key, coefficient))
    }

    pub(crate) fn coefficient(&self, power: usize, k: usize, wave: Wave) -> PiNumber {
        self.terms.get(&(power, k, wave)).cloned().unwrap_or_default()
    }

    /// Returns `true` if the function is zero.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Returns `true` if the function has the same value after a whole turn.
    pub(crate) fn is_periodic(&self) -> bool {
        self.terms.keys().all(|(power, _, _)| *power == 0)
    }

    /// The sum.
    pub fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        other.terms.iter().for_each(|(key, coefficient)| sum.add(*key, coefficient));
        sum
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        self.plus(&other.scaled(&Rational::from(-1).into()))
    }

    /// The product with a number.
    pub fn scaled(&self, factor: &PiNumber) -> Self {
        let mut product = Self::default();
        self.terms.iter().for_each(|(key, coefficient)| product.add(*key, &coefficient.times(factor)));
        product
    }

    /// Multiplies by the rules for cos·cos, sin·sin and sin·cos, which are halves of sums of two harmonics.
    pub fn times(&self, other: &Self) -> Self {
        let half = Rational::new(1, 2).unwrap_or_else(|| Rational::from(0));
        let mut product = Self::default();
        for ((p, j, left), a) in &self.terms {
            for ((q, k, right), b) in &other.terms {
                let each = a.times(b).scaled(&half);
                let (low, sign) = (j.abs_diff(*k), if j < k { -1 } else { 1 });
                let opposite = each.negated();
                let signed = |sign: i64| each.scaled(&Rational::from(sign));
                let power = p + q;
                match (left, right) {
                    (Wave::Cosine, Wave::Cosine) => {
                        product.add((power, low, Wave::Cosine), &each);
                        product.add((power, j + k, Wave::Cosine), &each);
                    }
                    (Wave::Sine, Wave::Sine) => {
                        product.add((power, low, Wave::Cosine), &each);
                        product.add((power, j + k, Wave::Cosine), &opposite);
                    }
                    (Wave::Sine, Wave::Cosine) => {
                        product.add((power, low, Wave::Sine), &signed(sign));
                        product.add((power, j + k, Wave::Sine), &each);
                    }
                    (Wave::Cosine, Wave::Sine) => {
                        product.add((power, low, Wave::Sine), &signed(-sign));
                        product.add((power, j + k, Wave::Sine), &each);
                    }
                }
            }
        }
        product
    }

    /// The derivative with respect to the phase.
    pub fn slope(&self) -> Self {
        let mut slope = Self::default();
        for ((power, k, wave), coefficient) in &self.terms {
            if *power > 0 {
                slope.add((power - 1, *k, *wave), &coefficient.scaled(&integer(*power)));
            }
            let (other, factor) = match wave {
                Wave::Cosine => (Wave::Sine, -integer(*k)),
                Wave::Sine => (Wave::Cosine, integer(*k)),
            };
            slope.add((*power, *k, other), &coefficient.scaled(&factor));
        }
        slope
    }

    /// The integral from 0 to the phase, by parts.
    pub fn integral(&self) -> Self {
        let mut whole = Self::default();
        for ((power, k, wave), coefficient) in &self.terms {
            if *k == 0 {
                let factor = fraction(1, power + 1);
                whole.add((power + 1, 0, Wave::Cosine), &coefficient.scaled(&factor));
            } else {
                whole = whole.plus(&by_parts(*power, *k, *wave, coefficient));
            }
        }
        let start = whole.at_start();
        whole.plus(&Self::constant(start.negated()))
    }

    /// The solution of y″ + y = r, with this function as r and zero initial value and slope: sin ψ·∫r·cos ψ − cos ψ·∫r·sin ψ.
    pub(crate) fn begun_at_rest(&self) -> Self {
        let (cosine, sine) = (Self::cosine(), Self::sine());
        let of_sine = sine.times(&self.times(&cosine).integral());
        of_sine.minus(&cosine.times(&self.times(&sine).integral()))
    }

    /// The value at 0.
    pub fn at_start(&self) -> PiNumber {
        self.terms.iter().fold(PiNumber::default(), |sum, ((power, _, wave), coefficient)| {
            let counts = *power == 0 && *wave == Wave::Cosine;
            if counts { sum.plus(coefficient) } else { sum }
        })
    }

    /// The value after `half_turns` half turns, at π or 2π.
    pub fn at_half_turns(&self, half_turns: usize) -> PiNumber {
        let cosines = self.terms.iter().filter(|((_, _, wave), _)| *wave == Wave::Cosine);
        cosines.fold(PiNumber::default(), |sum, ((power, k, _), coefficient)| {
            let sign = if (k * half_turns).is_multiple_of(2) { 1 } else { -1 };
            let scale = (0..*power).fold(Rational::from(sign), |product, _| product * integer(half_turns));
            let exponent = i32::try_from(*power).unwrap_or(i32::MAX);
            sum.plus(&coefficient.scaled(&scale).times_power_of_pi(exponent))
        })
    }

    /// The value after a quarter turn, at π/2.
    pub fn at_quarter_turn(&self) -> PiNumber {
        self.terms.iter().fold(PiNumber::default(), |sum, ((power, k, wave), coefficient)| {
            let value = match (k % 4, wave) {
                (0, Wave::Cosine) | (1, Wave::Sine) => 1,
                (2, Wave::Cosine) | (3, Wave::Sine) => -1,
                _ => 0,
            };
            let scale = (0..*power).fold(Rational::from(value), |product, _| product * fraction(1, 2));
            let exponent = i32::try_from(*power).unwrap_or(i32::MAX);
            sum.plus(&coefficient.scaled(&scale).times_power_of_pi(exponent))
        })
    }

    fn add(&mut self, key: Key, coefficient: &PiNumber) {
        if coefficient.is_zero() || (key.1 == 0 && key.2 == Wave::Sine) {
            return;
        }
        let sum = self.terms.remove(&key).map_or_else(|| coefficient.clone(), |old| old.plus(coefficient));
        if !sum.is_zero() {
            self.terms.insert(key, sum);
        }
    }
}

/// An antiderivative of c·ψᵖ·cos kψ or c·ψᵖ·sin kψ.
fn by_parts(power: usize, k: usize, wave: Wave, coefficient: &PiNumber) -> PhaseFunction {
    let over_k = coefficient.scaled(&fraction(1, k));
    let (other, first) = match wave {
        Wave::Cosine => (Wave::Sine, over_k.clone()),
        Wave::Sine => (Wave::Cosine, over_k.negated()),
    };
    let whole = PhaseFunction::term(power, k, other, first.clone());
    match power {
        0 => whole,
        _ => whole.plus(&by_parts(power - 1, k, other, &first.scaled(&integer(power)).negated())),
    }
}

fn integer(n: usize) -> Rational {
    Rational::from(i64::try_from(n).unwrap_or(i64::MAX))
}

fn fraction(over: i64, under: usize) -> Rational {
    Rational::new(over, i64::try_from(under).unwrap_or(i64::MAX)).unwrap_or_else(|| Rational::from(0))
}
