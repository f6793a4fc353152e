//! The result: all series of a family of periodic motions or of a limit cycle, in exact fractions.

use super::gauge::Gauge;
use super::phase_origin::PhaseOrigin;
use super::series_set::{OfAmplitude, SeriesSet};
use libration_numbers::algebra::{Rational, Ring};

/// Periodic motions x = xₑ + Σₖ aₖ cos kΩt + bₖ sin kΩt of an oscillator as power series. Lists are indexed by the
/// power of the variable. Displacements count from the equilibrium. Coefficients are fractions, or another kind `C`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expansion<C = Rational> {
    /// The displacement is given up to this power of the variable, the frequency up to one less; of a limit cycle
    /// both up to this power.
    pub order: usize,
    /// Variable of the series.
    pub variable: ExpansionVariable,
    /// State of the motion at Ωt = 0.
    pub phase_origin: PhaseOrigin,
    /// Precision of the coefficients: exact, or to a number of digits.
    pub precision: Precision,
    /// The equilibrium of the motion.
    pub equilibrium: C,
    /// ω0², the square of the frequency of small oscillations.
    pub omega0_squared: C,
    /// Ω/ω0.
    pub frequency_ratio: Vec<C>,
    /// The harmonics that are present, by ascending k.
    pub harmonics: Vec<HarmonicSeries<C>>,
    /// `true` if the omitted harmonics are of higher order. They are not for a force with two sides: there are infinitely many harmonics in the
    /// same powers.
    pub has_all_harmonics: bool,
    /// Square of the unit of harmonics and turning points; it is 1 except for limit cycles whose amplitude is
    /// not rational.
    pub unit_squared: C,
    /// The largest displacement, for a centre with ε of the sign of A₁; if the phase is counted from a turning point it is that at Ωt = 0.
    pub x_max: Vec<C>,
    /// The smallest displacement, for a centre with ε of the sign of A₁; if the phase is counted from a turning point it is that at Ωt = π.
    pub x_min: Vec<C>,
    /// The series in powers of the largest displacement; `None` for limit cycles, whose amplitude is determined.
    pub of_amplitude: Option<AmplitudeSeries<C>>,
    /// The same by powers of half the distance between the turning points, for asymmetric wells.
    pub of_half_swing: Option<AmplitudeSeries<C>>,
    /// Kind of check that the result has passed.
    pub certificate: Certificate,
}

/// The variable in which the series of an expansion are written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ExpansionVariable {
    /// The parameter ε of a family of motions, in this gauge.
    Epsilon(Gauge),
    /// The strength of a self-excitation, a parameter of this name.
    Parameter(String),
}

impl ExpansionVariable {
    /// The name of the variable.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Epsilon(_) => "epsilon",
            Self::Parameter(name) => name,
        }
    }
}

impl ExpansionVariable {
    /// Returns `true` if it is the strength of a self-excitation.
    #[must_use]
    pub const fn is_strength(&self) -> bool {
        matches!(self, Self::Parameter(_))
    }
}

/// Precision of coefficients: exact fractions, or digits of numbers that are not rational.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// Every coefficient is the number itself.
    Exact,
    /// Some coefficients are not rational: each is correct to this many digits.
    Digits(usize),
}

/// The coefficients of cos kΩt and sin kΩt.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HarmonicSeries<C = Rational> {
    /// Number of the harmonic.
    pub k: usize,
    /// Coefficients of cos kΩt.
    pub cos: Vec<C>,
    /// Coefficients of sin kΩt.
    pub sin: Vec<C>,
}

/// Physical relations by powers of an amplitude: the same in every gauge.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AmplitudeSeries<C = Rational> {
    /// Ω/ω0.
    pub frequency_ratio: Vec<C>,
    /// T/T0.
    pub period_ratio: Vec<C>,
    /// The expansion parameter ε.
    pub epsilon: Vec<C>,
    /// The coefficient of cos kΩt, of sin kΩt for [`PhaseOrigin::Passage`], by ascending k, where it is present.
    pub harmonics: Vec<(usize, Vec<C>)>,
}

/// The check that a result has passed. The series are always found modulo many primes, put together, and compared with five
/// fresh primes of 30 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Certificate {
    /// All coefficients were computed again in plain rational arithmetic, and are thus proven.
    PlainRationals,
    /// Frequency and turning points obey the relation given by the reversion of the potential, which proves the
    /// dependence of one on the other; the single series are confirmed by fresh primes.
    Potential,
    /// The period by powers of the amplitude agrees exactly with that along the curves of the first integral, which proves it;
    /// the rest rests on the fresh primes.
    FirstIntegral,
    /// All coefficients rest on the fresh primes.
    FreshPrimes,
    /// Nothing is proven: the coefficients were computed twice, with different numbers of digits.
    TwoPrecisions,
    /// Coefficients with powers of π, which agree to 30 digits with those of a quadrature.
    Quadrature,
    /// Coefficients with symbols, computed in plain fractions; with fractions in place of the symbols they equal
    /// those of the expansion modulo primes.
    Substitution,
    /// Coefficients with names for constants, which agree to 30 digits with those of the expansion in decimal numbers.
    Digits,
    /// Coefficients with symbols whose check was cancelled, or for which there is no other method.
    Unchecked,
}

impl Certificate {
    /// Returns `true` if an exact check proves at least the dependence of the frequency on the amplitude.
    #[must_use]
    pub fn is_proof(self) -> bool {
        matches!(self, Self::PlainRationals | Self::Potential | Self::FirstIntegral)
    }
}

impl<C> Expansion<C> {
    /// The harmonic k, where it is present.
    #[must_use]
    pub fn harmonic(&self, k: usize) -> Option<&HarmonicSeries<C>> {
        self.harmonics.iter().find(|harmonic| harmonic.k == k)
    }

    /// Puts the series of a set over a ring under the names of a result.
    pub(crate) fn new<R: Ring<Element = C>>(
        ring: &R,
        heading: Heading<C>,
        set: SeriesSet<C>,
        certificate: Certificate,
    ) -> Self {
        let Heading {
            order,
            variable,
            phase_origin,
            has_all_harmonics,
            precision,
            equilibrium,
            omega0_squared,
            unit_squared,
        } = heading;
        let harmonics = set.harmonics.into_iter().enumerate().map(|(k, series)| {
            let (cos, sin) = series.into_iter().map(|h| (h.cosine, h.sine)).unzip();
            HarmonicSeries { k, cos, sin }
        });
        let present =
            |h: &HarmonicSeries<C>| h.k == 1 || h.cos.iter().chain(&h.sin).any(|c| !ring.is_zero(c));
        Self {
            order,
            variable,
            phase_origin,
            precision,
            equilibrium,
            omega0_squared,
            frequency_ratio: set.frequency,
            harmonics: harmonics.filter(present).collect(),
            has_all_harmonics,
            unit_squared,
            x_max: set.x_max,
            x_min: set.x_min,
            of_amplitude: set.of_amplitude.map(|of| AmplitudeSeries::new(ring, of)),
            of_half_swing: set.of_half_swing.map(|of| AmplitudeSeries::new(ring, of)),
            certificate,
        }
    }
}

/// All data of a result except its series.
#[derive(Clone, Debug)]
pub(crate) struct Heading<C = Rational> {
    pub(crate) order: usize,
    pub(crate) variable: ExpansionVariable,
    pub(crate) phase_origin: PhaseOrigin,
    pub(crate) has_all_harmonics: bool,
    pub(crate) precision: Precision,
    pub(crate) equilibrium: C,
    pub(crate) omega0_squared: C,
    pub(crate) unit_squared: C,
}

impl<C> AmplitudeSeries<C> {
    fn new<R: Ring<Element = C>>(ring: &R, of: OfAmplitude<C>) -> Self {
        let present = |(k, series): &(usize, Vec<C>)| *k == 1 || series.iter().any(|c| !ring.is_zero(c));
        Self {
            frequency_ratio: of.frequency,
            period_ratio: of.period,
            epsilon: of.epsilon,
            harmonics: of.harmonics.into_iter().enumerate().filter(present).collect(),
        }
    }
}
