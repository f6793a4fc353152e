//! The motion in one gauge, from the library's expansion.

use super::super::check::DerivationError;
use super::reduced::Reduced;
use libration::algebra::{LaurentPolynomial, Polynomial, Rational, Variable};
use libration::internals::progress::Watch;
use libration::oscillator::{NumbersOrLetters, Oscillator};
use libration::perturbation::{
    AmplitudeSeries, Expansion, Gauge, SymbolicExpansionError, expand, expand_symbolically,
};

/// Coefficients of a series: numbers, or polynomials in the symbols of the force.
pub(super) type PolynomialSeries = Vec<Polynomial>;

/// The motion in one gauge.
#[derive(Debug)]
pub struct Solution {
    pub(super) gauge: Gauge,
    /// The expansion in fractions, if there are no symbols.
    pub(super) numbers: Option<Expansion>,
    harmonics: Vec<(usize, PolynomialSeries)>,
    pub(super) frequency_ratio: PolynomialSeries,
    pub(super) x_max: PolynomialSeries,
    pub(super) of_amplitude: Option<AmplitudeSeries<Polynomial>>,
}

impl Solution {
    /// The expansion of the oscillator itself, or of the equation with symbols for its factors.
    pub(super) fn new(
        oscillator: Option<&Oscillator>,
        reduced: &Reduced,
        order: usize,
        gauge: &Gauge,
        watch: &Watch<'_>,
    ) -> Result<Self, DerivationError> {
        let number = |value: &Rational| Some(Polynomial::constant(value.clone()));
        let numbers = |oscillator: &Oscillator| -> Result<Self, DerivationError> {
            let expansion = expand(oscillator, order, gauge, watch)?;
            let solution = Self::of(gauge, &expansion, &number).ok_or(DerivationError::NoFractions)?;
            Ok(Self { numbers: Some(expansion), ..solution })
        };
        if let Some(oscillator) = oscillator {
            return numbers(oscillator);
        }
        let equation = reduced.equation().parse().map_err(|_| DerivationError::NoFractions)?;
        match NumbersOrLetters::new(&equation, None).map_err(|_| DerivationError::NoFractions)? {
            NumbersOrLetters::Numbers(oscillator) => numbers(&oscillator),
            NumbersOrLetters::Letters(oscillator) => {
                let expansion = expand_symbolically(&oscillator, order, gauge, watch);
                let expansion = expansion.map_err(|error| match error {
                    SymbolicExpansionError::Expansion(error) => error.into(),
                    _ => DerivationError::NoFractions,
                })?;
                Self::of(gauge, &expansion.series, &polynomial).ok_or(DerivationError::NoFractions)
            }
        }
    }

    fn of<C>(gauge: &Gauge, of: &Expansion<C>, value: &dyn Fn(&C) -> Option<Polynomial>) -> Option<Self> {
        let series = |of: &[C]| of.iter().map(value).collect::<Option<PolynomialSeries>>();
        let all = |of: &[(usize, Vec<C>)]| {
            of.iter().map(|(k, of)| Some((*k, series(of)?))).collect::<Option<Vec<_>>>()
        };
        let amplitude = of.of_amplitude.as_ref().map(|of| {
            Some(AmplitudeSeries {
                frequency_ratio: series(&of.frequency_ratio)?,
                period_ratio: series(&of.period_ratio)?,
                epsilon: series(&of.epsilon)?,
                harmonics: all(&of.harmonics)?,
            })
        });
        let harmonics = of.harmonics.iter().map(|harmonic| Some((harmonic.k, series(&harmonic.cos)?)));
        Some(Self {
            gauge: gauge.clone(),
            numbers: None,
            harmonics: harmonics.collect::<Option<_>>()?,
            frequency_ratio: series(&of.frequency_ratio)?,
            x_max: series(&of.x_max)?,
            of_amplitude: match amplitude {
                Some(amplitude) => Some(amplitude?),
                None => None,
            },
        })
    }

    /// The coefficients of cos kτ, by powers of ε.
    pub(super) fn harmonic(&self, k: usize) -> PolynomialSeries {
        self.harmonics
            .iter()
            .find(|(multiple, _)| *multiple == k)
            .map_or_else(Vec::new, |(_, series)| series.clone())
    }

    /// The coefficient of εⁿ in a harmonic.
    pub(super) fn coefficient(&self, k: usize, n: usize) -> Polynomial {
        self.harmonic(k).get(n).cloned().unwrap_or_else(Polynomial::zero)
    }

    pub(super) fn has_even_powers(&self) -> bool {
        self.harmonic(1).iter().step_by(2).any(|a| !a.is_zero())
    }
}

/// A sum of products of symbols as a polynomial; `None` for negative and broken powers.
fn polynomial(of: &LaurentPolynomial) -> Option<Polynomial> {
    of.terms().try_fold(Polynomial::zero(), |sum, (factor, powers)| {
        let product = powers.iter().try_fold(Polynomial::constant(factor.clone()), |product, power| {
            let exponent = power.exponent.to_string().parse().ok()?;
            Some(product * Polynomial::variable(Variable::from(power.letter)).pow(exponent))
        })?;
        Some(sum + product)
    })
}
