//! A damping law as a curve through the rows.

use std::f64::consts::{FRAC_2_PI, PI};

use super::table::{AmplitudeReading, AmplitudeTable, Position};
use crate::fit::cycles::decay_rates::DecayRates;
use crate::fit::damping_model::DampingModel;
use crate::fit::falling::falling;
use crate::statistics::count;
use libration::decay::DampingKind;
use libration::pendulum::period_ratio;

/// Steps of the integration over the whole table: an amplitude that falls by a factor of e¹⁰ is then exact to 1e-8.
const STEPS: f64 = 400.0;
/// Amplitudes of a pendulum beyond this are outside the law, as in the tables of the rates.
const LARGEST: f64 = 3.13;

/// The rates of fall at any amplitude, and the table with which they are compared.
pub(super) struct DecayLaw<'a> {
    pub(super) table: &'a AmplitudeTable,
    rates: Option<DecayRates>,
}

/// The curve of a law: amplitudes at the rows, and the values that are read there.
#[derive(Clone, Debug)]
pub(super) struct DecayCurve {
    pub(super) amplitudes: Vec<f64>,
    pub(super) values: Vec<f64>,
}

impl<'a> DecayLaw<'a> {
    /// Prepares the rates for this table; `largest` is an upper bound of its amplitudes.
    pub(super) fn new(table: &'a AmplitudeTable, largest: f64) -> Self {
        let rates = table.reading.is_of_angles().then(|| DecayRates::new(1.0, largest));
        Self { table, rates }
    }

    /// fₙ: the rate of fall for κₙ = 1.
    pub(super) fn rate(&self, term: DampingKind, amplitude: f64) -> f64 {
        let amplitude = amplitude.max(0.0);
        let per_time = match (&self.rates, term) {
            (Some(rates), term) => rates.at(term, amplitude),
            (None, DampingKind::Dry) => FRAC_2_PI,
            (None, DampingKind::Linear) => 0.5 * amplitude,
            (None, DampingKind::Quadratic) => 4.0 / (3.0 * PI) * amplitude * amplitude,
        };
        match self.table.against {
            Position::Time => per_time,
            Position::Swings => per_time * self.period_ratio(amplitude),
        }
    }

    /// T/T0.
    pub(super) fn period_ratio(&self, amplitude: f64) -> f64 {
        match self.table.reading {
            AmplitudeReading::Displacement => 1.0,
            _ => period_ratio(amplitude.min(LARGEST)),
        }
    }

    /// The rate of fall under all terms.
    pub(super) fn fall(&self, terms: DampingModel, parameters: &[f64], amplitude: f64) -> f64 {
        terms.iter().zip(&parameters[1..]).map(|(term, rate)| rate * self.rate(term, amplitude)).sum()
    }

    /// The curve with these parameters: the first amplitude, the κₙ, and the zero of the scale where it is fitted. `None` outside the domain.
    pub(super) fn curve(&self, terms: DampingModel, parameters: &[f64]) -> Option<DecayCurve> {
        let longest_step = self.table.span() / STEPS;
        let rate = |amplitude: f64| self.fall(terms, parameters, amplitude);
        let amplitudes = falling(parameters[0], self.table.positions(), longest_step, rate);
        let largest = if self.rates.is_some() { LARGEST } else { f64::MAX };
        if !amplitudes.iter().all(|amplitude| (0.0..=largest).contains(amplitude)) {
            return None;
        }
        let zero = parameters.get(terms.count() + 1).copied().unwrap_or(0.0);
        let values = self.table.rows.iter().zip(&amplitudes);
        let values = values.map(|(row, &amplitude)| zero + row.side * self.table.reading.of(amplitude));
        Some(DecayCurve { values: values.collect(), amplitudes })
    }

    /// The coefficient κₙ with which a kind of damping alone would halve the amplitude over the table.
    pub(super) fn typical(&self, term: DampingKind, amplitude: f64) -> f64 {
        0.5 * amplitude / (self.rate(term, amplitude) * self.table.span())
    }

    /// The amplitudes at evenly spaced positions between two.
    pub(super) fn amplitudes_between(
        &self,
        terms: DampingModel,
        parameters: &[f64],
        number: usize,
    ) -> Vec<(f64, f64)> {
        let (first, span) = (self.table.rows[0].position, self.table.span());
        let positions: Vec<f64> =
            (0..=number).map(|step| first + span * count(step) / count(number)).collect();
        let rate = |amplitude: f64| self.fall(terms, parameters, amplitude);
        let amplitudes = falling(parameters[0], positions.iter().copied(), span / STEPS, rate);
        positions.into_iter().zip(amplitudes).collect()
    }
}
