//! A quantity of periodic motions as a function of the amplitude: its series, its exact values, and the range
//! of the series.

use std::f64::consts::PI;

use super::exact::{ExactMotion, ExactValue, ExactValueError, of_pendulum};
use super::{Approximant, SeriesQuantity, pendulum_harmonic};
use crate::perturbation::{
    Convergence, Expansion, Pade, PeriodMajorant, SeriesEvaluation, is_pendulum, pendulum_period_remainder,
    restoring_force, stride,
};
use libration_kernels::elementary::count;
use libration_motion::oscillator::Oscillator;
use libration_numbers::algebra::{Rational, Rationals};
use libration_numbers::expression::Symbol;
use libration_numbers::internals::series::truncated::reciprocal;
use libration_numbers::progress::Progress;
use libration_numbers::quantity::Displacement;

/// A quantity as a function of the largest displacement, or of the strength of a self-excitation.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::oscillator::NamedOscillator;
/// use libration::comparison::{SeriesQuantity, SeriesComparison};
/// use libration::perturbation::{Gauge, expand};
/// use libration::progress::Quiet;
/// let pendulum = NamedOscillator::by_key("pendulum")?.oscillator(&[])?;
/// let expansion = expand(&pendulum, 31, &Gauge::Fundamental, &Quiet)?;
/// let period = SeriesComparison::new(&pendulum, &expansion, SeriesQuantity::Period);
/// let exact = period.exact_at(1.0, &Quiet)?;
/// let error = (period.evaluation_at(1.0).value() - exact.value).abs();
/// assert!(error < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct SeriesComparison<'a> {
    oscillator: &'a Oscillator,
    expansion: &'a Expansion,
    quantity: SeriesQuantity,
    series: Vec<Rational>,
}

/// The distance from zero up to which a series converges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Radius {
    /// A radius known by a theorem.
    Known(f64),
    /// A radius estimated from the coefficients.
    Estimated(Convergence),
}

impl Radius {
    /// The radius, or its estimate.
    #[must_use]
    pub fn value(&self) -> f64 {
        match self {
            Self::Known(value) => *value,
            Self::Estimated(convergence) => convergence.radius,
        }
    }
}

impl<'a> SeriesComparison<'a> {
    /// The relation in an expansion of this oscillator. The series of a harmonic that is not present is zero.
    #[must_use]
    pub fn new(oscillator: &'a Oscillator, expansion: &'a Expansion, quantity: SeriesQuantity) -> Self {
        let series = match &expansion.of_amplitude {
            Some(of) => match quantity {
                SeriesQuantity::Period => of.period_ratio.clone(),
                SeriesQuantity::Frequency => of.frequency_ratio.clone(),
                SeriesQuantity::Cosine(k) => {
                    let entry = of.harmonics.iter().find(|(n, _)| *n == k);
                    entry.map_or_else(|| nothing(expansion.order), |(_, series)| series.clone())
                }
            },
            None => of_strength(expansion, quantity),
        };
        Self { oscillator, expansion, quantity, series }
    }

    pub(super) const fn oscillator(&self) -> &'a Oscillator {
        self.oscillator
    }

    pub(super) const fn expansion(&self) -> &'a Expansion {
        self.expansion
    }

    /// The quantity that the series gives.
    #[must_use]
    pub const fn quantity(&self) -> SeriesQuantity {
        self.quantity
    }

    /// The coefficients, indexed by the power of the amplitude.
    #[must_use]
    pub fn series(&self) -> &[Rational] {
        &self.series
    }

    /// The series in numbers. Remainders are proven for period, frequency and harmonics of the pendulum, and for period and frequency where the
    /// force is a polynomial of the displacement, below an amplitude above which no bound is known; otherwise they are estimates.
    #[must_use]
    pub fn evaluation_at(&self, amplitude: f64) -> SeriesEvaluation {
        let evaluation = SeriesEvaluation::new(&self.series, amplitude);
        match self.quantity {
            _ if self.expansion.of_amplitude.is_none() => evaluation,
            // No coefficient of Ω/ω0 is larger than that of T/T0 (`pendulum_harmonic.rs`).
            SeriesQuantity::Period | SeriesQuantity::Frequency if is_pendulum(self.oscillator) => {
                evaluation.with_bound(|power| pendulum_period_remainder(amplitude, power / 2))
            }
            SeriesQuantity::Cosine(k) if is_pendulum(self.oscillator) => {
                let sizes = pendulum_harmonic::series_of_size(&self.series, k);
                let bound = sizes.at(amplitude, PI, |amplitude| pendulum_harmonic::size(amplitude, k));
                evaluation.with_bound(|power| bound.after(power))
            }
            SeriesQuantity::Cosine(_) => evaluation,
            SeriesQuantity::Period | SeriesQuantity::Frequency => self.bounded_by_majorant(evaluation),
        }
    }

    /// The evaluation with the bounds for a polynomial force, if there are any.
    fn bounded_by_majorant(&self, evaluation: SeriesEvaluation) -> SeriesEvaluation {
        let Some(majorant) = self.period_majorant() else { return evaluation };
        let bound = match self.quantity {
            SeriesQuantity::Frequency => majorant.frequency_at(evaluation.at()),
            _ => majorant.period_at(evaluation.at()),
        };
        if bound.after(0).is_infinite() {
            evaluation
        } else {
            evaluation.with_bound(|power| bound.after(power))
        }
    }

    /// The bound of period and frequency of a polynomial force.
    fn period_majorant(&self) -> Option<PeriodMajorant> {
        let x = Symbol { name: self.oscillator.variable().to_owned(), primes: 0 };
        let degree = self.oscillator.acceleration().polynomial_coefficients(&x)?.len().checked_sub(1)?;
        PeriodMajorant::new(&restoring_force(self.oscillator, degree)?, self.expansion.order)
    }

    /// The radius of convergence; `None` when there are too few coefficients for an estimate.
    #[must_use]
    pub fn radius(&self) -> Option<Radius> {
        if is_pendulum(self.oscillator) && self.series.iter().any(|c| !c.is_zero()) {
            // K(m) has no zeros, so that period, frequency and harmonics are analytic for |Re θ0| < π.
            return Some(Radius::Known(PI));
        }
        Convergence::estimate(&self.series).map(Radius::Estimated)
    }

    /// The Padé approximant with numerator and denominator of equal degrees in the powers that occur, times the
    /// common factor of all terms; `None` if there are too few coefficients.
    #[must_use]
    pub fn approximant(&self, degree: usize) -> Option<Approximant> {
        let present: Vec<usize> = (0..self.series.len()).filter(|n| !self.series[*n].is_zero()).collect();
        let first = *present.first()?;
        let stride = stride(present);
        let spread: Vec<Rational> = self.series[first..].iter().step_by(stride.max(1)).cloned().collect();
        let pade = Pade::new(&spread, degree, degree)?;
        Some(Approximant { pade, first: count(first), stride: count(stride.max(1)) })
    }

    /// The value of the motion itself, without the series, at exactly this `f64`. Harmonics of limit cycles are in the
    /// expansion's units.
    ///
    /// # Accuracy
    /// As [`ExactValue::uncertainty`] says.
    ///
    /// # Errors
    /// There is no such motion, it is not found, or its period is infinite.
    /// [`OrbitError::Interrupted`](libration_motion::orbit::OrbitError::Interrupted) if the call is cancelled.
    pub fn exact_at(&self, amplitude: f64, progress: &dyn Progress) -> Result<ExactValue, ExactValueError> {
        let displacement = Displacement::from_f64(amplitude).ok_or(ExactValueError::Amplitude(amplitude))?;
        self.exact_from(&displacement, progress)
    }

    /// The value at an amplitude, or a strength, that is known to more digits than those of an `f64`.
    ///
    /// # Accuracy
    /// As [`ExactValue::uncertainty`] says.
    ///
    /// # Errors
    /// As [`exact_at`](Self::exact_at).
    pub fn exact_from(
        &self,
        amplitude: &Displacement,
        progress: &dyn Progress,
    ) -> Result<ExactValue, ExactValueError> {
        ExactMotion::new(self.oscillator, self.expansion, amplitude, progress)?.value(self.quantity)
    }

    /// The value by elliptic functions; `None` except for the pendulum.
    pub(super) fn exact_without_motion(
        &self,
        amplitude: &Displacement,
    ) -> Option<Result<ExactValue, ExactValueError>> {
        is_pendulum(self.oscillator).then(|| of_pendulum(self.quantity, amplitude))
    }
}

/// The series of a limit cycle by powers of the strength.
fn of_strength(expansion: &Expansion, quantity: SeriesQuantity) -> Vec<Rational> {
    match quantity {
        SeriesQuantity::Frequency => expansion.frequency_ratio.clone(),
        SeriesQuantity::Period => {
            reciprocal(&Rationals, &expansion.frequency_ratio).unwrap_or_else(|| nothing(expansion.order))
        }
        SeriesQuantity::Cosine(k) => {
            expansion.harmonic(k).map_or_else(|| nothing(expansion.order), |harmonic| harmonic.cos.clone())
        }
    }
}

fn nothing(order: usize) -> Vec<Rational> {
    vec![Rational::from(0); order + 1]
}
