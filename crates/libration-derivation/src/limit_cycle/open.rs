//! Functions of the phase with one undetermined amplitude, as polynomials in it.

use std::collections::BTreeMap;

use super::super::formula::{Formula, Name, sum};
use super::super::phase::{PhaseFunction, Wave, series, term_with};
use libration::algebra::Rational;

/// Σ Aᵈ·(a function of the phase).
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Open {
    /// The nonzero functions by the power d.
    powers: BTreeMap<usize, PhaseFunction>,
}

impl From<PhaseFunction> for Open {
    fn from(function: PhaseFunction) -> Self {
        Self::default().with(0, &function)
    }
}

impl Open {
    /// A·cos τ.
    pub(super) fn wave() -> Self {
        Self::default().with(1, &PhaseFunction::cosine())
    }

    fn with(mut self, degree: usize, function: &PhaseFunction) -> Self {
        let sum = self.powers.remove(&degree).unwrap_or_default().plus(function);
        if !sum.is_zero() {
            self.powers.insert(degree, sum);
        }
        self
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        other.powers.iter().fold(self.clone(), |sum, (degree, part)| sum.with(*degree, part))
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        let mut product = Self::default();
        for (d, left) in &self.powers {
            for (e, right) in &other.powers {
                product = product.with(d + e, &left.times(right));
            }
        }
        product
    }

    pub(super) fn scaled(&self, factor: &Rational) -> Self {
        self.each(|part| part.scaled(&factor.clone().into()))
    }

    pub(super) fn slope(&self) -> Self {
        self.each(PhaseFunction::slope)
    }

    fn each(&self, change: impl Fn(&PhaseFunction) -> PhaseFunction) -> Self {
        self.powers.iter().fold(Self::default(), |sum, (degree, part)| sum.with(*degree, &change(part)))
    }

    /// The factor of cos τ or sin τ, by powers of the amplitude.
    pub(super) fn first_harmonic(&self, wave: Wave) -> Vec<Rational> {
        let highest = self.powers.keys().next_back().copied().unwrap_or(0);
        let of = |degree: usize| {
            self.powers.get(&degree).and_then(|power| power.coefficient(0, 1, wave).to_rational())
        };
        (0..=highest).map(|degree| of(degree).unwrap_or_else(|| Rational::from(0))).collect()
    }

    /// The function at a value of the amplitude.
    pub(super) fn at(&self, amplitude: &Rational) -> PhaseFunction {
        self.powers.iter().fold(PhaseFunction::default(), |sum, (degree, part)| {
            let factor = (0..*degree).fold(Rational::from(1), |product, _| product * amplitude.clone());
            sum.plus(&part.scaled(&factor.into()))
        })
    }

    /// The polynomial as a formula.
    pub(super) fn written(&self, amplitude: &Name) -> Formula {
        let terms: Vec<Formula> = (self.powers.iter())
            .flat_map(|(degree, part)| match degree {
                0 => summands(series(part, "τ")),
                degree => part
                    .terms()
                    .flat_map(|(key, value)| {
                        let power = match degree {
                            1 => Formula::from(amplitude),
                            degree => {
                                Formula::from(amplitude).pow(i64::try_from(*degree).unwrap_or(i64::MAX))
                            }
                        };
                        let wave =
                            series(&PhaseFunction::term(key.0, key.1, key.2, Rational::from(1).into()), "τ");
                        let factors = if wave == Formula::from(1) { vec![power] } else { vec![power, wave] };
                        value
                            .terms()
                            .map(|(pi, coefficient)| term_with(coefficient, pi, factors.clone()))
                            .collect::<Vec<_>>()
                    })
                    .collect(),
            })
            .collect();
        if terms.is_empty() { Formula::from(0) } else { sum(terms) }
    }
}

fn summands(formula: Formula) -> Vec<Formula> {
    match formula {
        Formula::Sum(terms) => terms,
        term => vec![term],
    }
}
