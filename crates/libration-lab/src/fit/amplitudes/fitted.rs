//! The result of a fit of amplitudes.

use super::comparison::{Compared, LawComparison};
use super::law::DecayLaw;
use super::quality;
use super::search::{DecayLawFit, parameters};
use super::{AmplitudeTable, AmplitudesOptions, AmplitudesWarning, Position, Sides, period};
use crate::fit::damping_model::DampingModel;
use crate::fit::quality::Quality;
use crate::fit::scatter::{self, Scatter};
use crate::fit::significance::SIGNIFICANT;
use crate::fit::uncertain::Uncertain;
use crate::statistics::count;
use libration::decay::DampingKind;

/// Steps of the curve of a law.
const CURVE: usize = 300;

/// The damping laws fitted to a table of amplitudes.
#[derive(Clone, Debug, PartialEq)]
pub struct AmplitudesFit {
    /// Laws whose coefficients are not negative, simpler ones first.
    pub laws: Vec<LawOfAmplitudes>,
    /// Index of the given law or, without one, of the simplest law that the rows do not separate from the best.
    pub chosen: usize,
    /// The period of small swings, in seconds, where it is given or determined by times and numbers of swings.
    pub period: Option<Uncertain>,
    /// ω0 without damping, in rad/s, where the period is known.
    pub natural_frequency: Option<Uncertain>,
    /// The coefficients of the chosen law.
    pub coefficients: Vec<DampingCoefficient>,
    /// Q of the chosen law, for other than linear damping at the first row; its uncertainty includes the difference to laws that the rows do not
    /// exclude. `None` against times without a period.
    pub quality: Option<Quality>,
    /// Q at the last row; `None` for linear damping, where it is the same.
    pub last_quality: Option<Quality>,
    /// The time, or number of swings, in which the amplitude falls by a factor of e at its rate at the first row; for linear damping at every
    /// amplitude.
    pub decay: Uncertain,
    /// Warnings about the fit.
    pub warnings: Vec<AmplitudesWarning>,
}

/// A coefficient of the damping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampingCoefficient {
    /// Kind of damping.
    pub term: DampingKind,
    /// κₙ = cₙω0ⁿ⁻¹, by which the amplitude falls, per second or per swing and per power n − 1 of the unit of the amplitude.
    pub rate: Uncertain,
    /// cₙ per s²⁻ⁿ and per power n − 1 of the unit of the amplitude; `None` where it needs the period, which is not known.
    pub coefficient: Option<Uncertain>,
}

/// One law fitted to the amplitudes.
#[derive(Clone, Debug, PartialEq)]
pub struct LawOfAmplitudes {
    /// Kinds of damping.
    pub damping: DampingModel,
    /// Amplitude at the first row, in radians or in the unit of the displacements.
    pub first_amplitude: Uncertain,
    /// κₙ in the order of the kinds.
    pub rates: Vec<Uncertain>,
    /// Q, for other than linear damping at the first row; `None` against times without a period.
    pub quality: Option<Quality>,
    /// Offset of the scale's zero, where turning points of both sides determine it.
    pub zero: Option<Uncertain>,
    /// The sum of the squared residuals over their variances; `None` without stated uncertainties.
    pub chi2: Option<f64>,
    /// Degrees of freedom.
    pub dof: usize,
    /// Akaike's criterion, corrected for few rows; `None` where they are too few.
    pub aicc: Option<f64>,
    /// Excess over the least criterion.
    pub aicc_difference: f64,
    /// The probability that chance makes the improvement over the best simpler law as large.
    pub chance: Option<f64>,
    /// Fitted amplitudes at the rows.
    pub amplitudes: Vec<f64>,
    /// Values less the law, row by row.
    pub residuals: Vec<f64>,
    /// Standard deviations of the values, as stated; without stated ones their scatter.
    pub standard_deviations: Vec<f64>,
    /// Number of neighbouring rows that share one error: above 1 only where residuals are not white noise. All variances include it.
    pub rows_per_error: f64,
    /// The amplitude from the first to the last position.
    pub curve: Vec<(f64, f64)>,
}

impl LawOfAmplitudes {
    /// Scatter of the rows compared with their uncertainties; `None` without uncertainties or without a degree of freedom.
    #[must_use]
    pub fn scatter(&self) -> Option<Scatter> {
        Scatter::new(self.chi2, self.dof)
    }

    /// Degrees of freedom of the uncertainties: infinite where they come from stated ones.
    #[must_use]
    pub fn uncertainty_degrees_of_freedom(&self) -> f64 {
        scatter::degrees_of_freedom(self.chi2, self.dof)
    }

    fn new(law: &DecayLaw<'_>, compared: &Compared, phase: Option<Uncertain>) -> Self {
        let (table, fit) = (law.table, &compared.fit);
        let terms = fit.terms.count();
        let scale = VarianceFactors::new(table, fit);
        let estimate = |index: usize| Uncertain {
            value: fit.parameters[index],
            uncertainty: (scale.of_covariance * fit.covariance[(index, index)]).sqrt(),
        };
        Self {
            damping: fit.terms,
            first_amplitude: estimate(0),
            rates: (1..=terms).map(estimate).collect(),
            quality: phase.and_then(|phase| {
                quality::quality(law, fit, phase, fit.curve.amplitudes[0], scale.of_covariance)
            }),
            zero: (table.sides == Sides::Both).then(|| estimate(terms + 1)),
            chi2: table.weighted.then_some(fit.chi2),
            dof: scale.dof,
            aicc: compared.aicc,
            aicc_difference: compared.excess,
            chance: compared.chance,
            amplitudes: fit.curve.amplitudes.clone(),
            residuals: residuals(table, fit),
            standard_deviations: fit
                .deviations
                .iter()
                .map(|deviation| deviation * scale.of_row.sqrt())
                .collect(),
            rows_per_error: scale.rows_per_error,
            curve: law.amplitudes_between(fit.terms, &fit.parameters, CURVE),
        }
    }
}

impl AmplitudesFit {
    pub(super) fn new(
        table: &AmplitudeTable,
        options: &AmplitudesOptions,
        comparison: &LawComparison<'_>,
    ) -> Self {
        let law = &comparison.law;
        let chosen = &comparison.laws[comparison.chosen].fit;
        let scale = VarianceFactors::new(table, chosen).of_covariance;
        let period = period::period(law, chosen, scale, options.period);
        let natural_frequency = period.map(|period| period::natural_frequency(table, chosen, period));
        let phase = period::phase_per_position(table, chosen, natural_frequency);
        let ends = [0, table.len() - 1].map(|row| chosen.curve.amplitudes[row]);
        let of = |amplitude| quality::quality(law, chosen, phase?, amplitude, scale);
        let spread = |quality: Quality| Quality {
            factor: quality.factor.with_error(comparison.spread_of_quality(phase, ends[0])),
            ..quality
        };
        let last = of(ends[1]).filter(|quality| quality.amplitude.is_some());
        let mut fit = Self {
            laws: comparison.laws.iter().map(|compared| LawOfAmplitudes::new(law, compared, phase)).collect(),
            chosen: comparison.chosen,
            period,
            natural_frequency,
            coefficients: vec![],
            quality: of(ends[0]).map(spread),
            last_quality: last.map(spread),
            decay: decay(law, chosen, scale),
            warnings: vec![],
        };
        fit.coefficients = fit.coefficients(table);
        fit
    }

    /// The law that is reported.
    #[must_use]
    pub fn law(&self) -> &LawOfAmplitudes {
        &self.laws[self.chosen]
    }

    /// cₙ = κₙω0¹⁻ⁿ.
    fn coefficients(&self, table: &AmplitudeTable) -> Vec<DampingCoefficient> {
        let law = self.law();
        let coefficient = |term: DampingKind, rate: Uncertain| {
            let exponent = term.exponent();
            if table.against == Position::Time && term == DampingKind::Linear {
                return Some(rate);
            }
            let (period, omega0) = (self.period?, self.natural_frequency?);
            let (per_second, power) = match table.against {
                Position::Time => (rate.value, exponent - 1.0),
                Position::Swings => (rate.value / period.value, exponent - 2.0),
            };
            let value = per_second * libm::pow(omega0.value, 1.0 - exponent);
            let relative = libm::hypot(rate.relative(), power * period.relative());
            Some(Uncertain { value, uncertainty: value * relative })
        };
        let terms = law.damping.iter().zip(&law.rates);
        let described = |(term, &rate): (DampingKind, &Uncertain)| DampingCoefficient {
            term,
            rate,
            coefficient: coefficient(term, rate),
        };
        terms.map(described).collect()
    }
}

impl LawComparison<'_> {
    /// The difference of Q at an amplitude to other laws: to the preferred one where the given one is refuted; without a given one to those that the rows
    /// do not separate, with their Akaike weights.
    fn spread_of_quality(&self, phase: Option<Uncertain>, amplitude: f64) -> f64 {
        let of =
            |law: &Compared| Some(quality::at_amplitude(&self.law, &law.fit, phase?, amplitude, 1.0)?.value);
        let chosen = &self.laws[self.chosen];
        let Some(quality) = of(chosen) else { return 0.0 };
        let difference = |law: &Compared| of(law).map_or(0.0, |other| other - quality);
        let weight = |law: &Compared| self.weight(law);
        let weights: f64 = self.not_separated().map(weight).sum::<f64>() + weight(chosen);
        let square = |law: &Compared| difference(law) * difference(law);
        let others: f64 = self.not_separated().map(|law| weight(law) * square(law)).sum();
        let preferred = self.preferred_to_given().map_or(0.0, square);
        (others / weights + preferred).sqrt()
    }
}

/// A/(−dA/dt) at the first row.
fn decay(law: &DecayLaw<'_>, fit: &DecayLawFit, scale: f64) -> Uncertain {
    let amplitude = fit.parameters[0];
    let factors: Vec<f64> = fit.terms.iter().map(|term| law.rate(term, amplitude) / amplitude).collect();
    let rate = law.fall(fit.terms, &fit.parameters, amplitude) / amplitude;
    let pairs = factors.iter().enumerate().flat_map(|(i, one)| {
        factors.iter().enumerate().map(move |(j, other)| one * other * fit.covariance[(i + 1, j + 1)])
    });
    let spread = (scale * pairs.sum::<f64>()).sqrt();
    Uncertain { value: 1.0 / rate, uncertainty: spread / (rate * rate) }
}

/// Factors of variances by the scatter of the rows about a law.
struct VarianceFactors {
    dof: usize,
    /// Factor of the variances of the rows, without enlargement.
    of_row: f64,
    of_covariance: f64,
    rows_per_error: f64,
}

impl VarianceFactors {
    fn new(table: &AmplitudeTable, fit: &DecayLawFit) -> Self {
        let dof = table.len() - parameters(table, fit.terms);
        let per_dof = if dof > 0 { fit.chi2 / count(dof) } else { f64::NAN };
        let (of_row, enlargement) = match table.weighted {
            true => (1.0, scatter::enlargement(Some(fit.chi2), dof)),
            false => (per_dof, 1.0),
        };
        let rows_per_error = rows_per_error(table, fit);
        let of_covariance = of_row * enlargement * enlargement * rows_per_error;
        Self { dof, of_row, of_covariance, rows_per_error }
    }
}

fn residuals(table: &AmplitudeTable, fit: &DecayLawFit) -> Vec<f64> {
    table.rows.iter().zip(&fit.curve.values).map(|(row, fitted)| row.value - fitted).collect()
}

/// (1 + ρ)/(1 − ρ) with the correlation ρ of the errors of neighbouring amplitudes, where it is significant; otherwise 1.
fn rows_per_error(table: &AmplitudeTable, fit: &DecayLawFit) -> f64 {
    let residuals = residuals(table, fit);
    let rows = table.rows.iter().zip(&fit.deviations).zip(residuals);
    let errors: Vec<f64> = rows.map(|((row, deviation), residual)| row.side * residual / deviation).collect();
    let products: f64 = errors.windows(2).map(|pair| pair[0] * pair[1]).sum();
    let correlation = products / errors.iter().map(|error| error * error).sum::<f64>();
    if correlation * count(errors.len()).sqrt() > SIGNIFICANT {
        (1.0 + correlation) / (1.0 - correlation).max(0.05)
    } else {
        1.0
    }
}
