//! A slow flow with numbers for its symbols.

use super::force::DriveFrequency;
use super::letters::{Column, Letters, Sum};
use super::phase_sums::PhaseSum;
use super::steady::Steady;
use libration_numbers::algebra::Rational;
use libration_numbers::roots::polynomial_sign_changes;
use std::f64::consts::{PI, TAU};

/// The largest ratio within reach of the series: of the terms of higher orders to those of the lowest, and of the distance of one state at two
/// orders to its amplitude. A geometric series whose terms after the first are at most half of it has a ratio of at most 1/3.
pub(super) const REACH: f64 = 0.5;

/// Sums of a slow flow that have values.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FormulaSums {
    pub(super) symbols: Vec<String>,
    pub(super) drive: Option<DriveFrequency>,
    pub(super) resonance: (i64, i64),
    pub(super) omega0: Sum,
    /// ω0², if ω0 has a name.
    pub(super) square: Option<Sum>,
    /// σ·`unit` is W − (p/q)·ω0.
    pub(super) unit: Sum,
    /// A′ and A·φ′.
    pub(super) rates: [PhaseSum; 2],
    pub(super) steady: Steady,
}

/// A steady state of a slow flow with numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SteadySolution {
    /// A.
    pub amplitude: f64,
    /// φ within −π … π, the smallest of those that differ by periods of the drive; zero without drive.
    pub phase: f64,
    /// The trace of the Jacobian.
    pub trace: f64,
    /// The determinant of the Jacobian; 0 without drive.
    pub determinant: f64,
    /// `true` if small deviations decay.
    pub is_stable: bool,
}

/// A slow flow with numbers for all symbols.
#[derive(Clone, Debug, PartialEq)]
pub struct SlowFlowAt<'a> {
    sums: &'a FormulaSums,
    /// Values by columns; A is changed.
    values: Vec<f64>,
}

impl FormulaSums {
    /// The slow flow with values for all symbols and, with a drive that is a symbol, for W; the names that have no value are the error.
    pub(super) fn at(
        &self,
        value: &dyn Fn(&str) -> Option<f64>,
        drive_frequency: Option<f64>,
    ) -> Result<SlowFlowAt<'_>, Vec<String>> {
        let mut missing = vec![];
        let mut values: Vec<f64> = self
            .symbols
            .iter()
            .map(|name| {
                value(name).unwrap_or_else(|| {
                    missing.push(name.clone());
                    f64::NAN
                })
            })
            .collect();
        let given = values.len();
        values.resize(self.omega0.letters().len(), 1.0);
        let index = |column: Column| given + column as usize;
        values[index(Column::Pi)] = PI;
        if let Some(square) = &self.square {
            values[index(Column::Natural)] = libm::sqrt(number(square, &values));
        }
        let drive = match &self.drive {
            Some(DriveFrequency::Number(number)) => Some(number.to_f64()),
            Some(DriveFrequency::Symbol(name)) => drive_frequency.or_else(|| value(name)).or_else(|| {
                missing.push(name.clone());
                None
            }),
            None => None,
        };
        if !missing.is_empty() {
            return Err(missing);
        }
        values[index(Column::Detuning)] = drive.map_or(0.0, |drive| {
            let [p, q] = [self.resonance.0, self.resonance.1].map(double);
            (drive - p / q * number(&self.omega0, &values)) / number(&self.unit, &values)
        });
        Ok(SlowFlowAt { sums: self, values })
    }
}

impl SlowFlowAt<'_> {
    /// W; `None` without drive.
    #[must_use]
    pub fn drive_frequency(&self) -> Option<f64> {
        let [p, q] = [self.sums.resonance.0, self.sums.resonance.1].map(double);
        let omega0 = number(&self.sums.omega0, &self.values);
        let drive = p / q * omega0 + self.detuning() * number(&self.sums.unit, &self.values);
        self.sums.drive.as_ref().map(|_| drive)
    }

    /// σ.
    #[must_use]
    pub fn detuning(&self) -> f64 {
        self.values[self.index(Column::Detuning)]
    }

    /// dA/dt and dφ/dt.
    #[must_use]
    pub fn rates(&self, amplitude: f64, phase: f64) -> [f64; 2] {
        let values = self.with_amplitude(amplitude);
        let rates = self.sums.rates.each_ref().map(|rate| phase_sum(rate, &values, phase));
        [rates[0], rates[1] / amplitude]
    }

    /// The steady states with A above zero, rising; `None` where the relation or the phase is not known. Zeros of the relation at which its terms
    /// of higher orders are more than half of those of the lowest are left out, since the truncation may have caused them.
    #[must_use]
    pub fn steady_states(&self) -> Option<Vec<SteadySolution>> {
        let mut states = self.zeros(0)?;
        states.retain(|state| self.is_reached(state));
        Some(states)
    }

    /// The zeros of the relation with A above zero, rising, without the highest orders.
    pub(super) fn zeros(&self, dropped: i64) -> Option<Vec<SteadySolution>> {
        let steady = &self.sums.steady;
        let is_known = self.sums.drive.is_none() || steady.phase.is_some();
        // Without its highest orders the relation may not contain the drive.
        let has_drive = steady.order - dropped >= 2 * steady.coupling - steady.lowest;
        let relation = steady.relation.as_ref().filter(|_| is_known && has_drive)?;
        let values = self.with_amplitude(1.0);
        let column = self.index(Column::Amplitude);
        let mut coefficients = vec![];
        for (powers, factor) in self.to_order(relation, self.higher_orders() - dropped) {
            let power = usize::try_from(powers[column] / 2).ok()?;
            if coefficients.len() <= power {
                coefficients.resize(power + 1, 0.0);
            }
            coefficients[power] += term(powers, factor.to_f64(), &values);
        }
        let mut amplitudes = polynomial_sign_changes(&coefficients)?;
        amplitudes.retain(|&amplitude| amplitude > 0.0);
        Some(amplitudes.into_iter().map(|amplitude| self.steady_state(amplitude, dropped)).collect())
    }

    /// Returns `true` if the terms of higher orders are small compared with those of the lowest, among which are the first of drive and damping.
    pub(super) fn is_reached(&self, state: &SteadySolution) -> bool {
        let steady = &self.sums.steady;
        let Some(relation) = &steady.relation else { return true };
        let values = self.with_amplitude(state.amplitude);
        let [amplitude, detuning, order] =
            [Column::Amplitude, Column::Detuning, Column::Order].map(|column| self.index(column));
        let least = self.to_order(relation, 0).map(|(powers, _)| powers[amplitude]).min().unwrap_or(0);
        let is_first = |powers: &[i64]| {
            let is_level = powers[detuning] == 0 && powers[amplitude] <= least;
            powers[order] <= 0 || (is_level && powers[order] <= 4 * (steady.coupling - steady.lowest))
        };
        let [mut lowest, mut higher] = [0.0, 0.0];
        for (powers, factor) in self.to_order(relation, self.higher_orders()) {
            let size = term(powers, factor.to_f64(), &values).abs();
            *(if is_first(powers) { &mut lowest } else { &mut higher }) += size;
        }
        higher <= REACH * lowest
    }

    fn steady_state(&self, amplitude: f64, dropped: i64) -> SteadySolution {
        let values = self.with_amplitude(amplitude);
        let steady = &self.sums.steady;
        let to_order = |sum: &Sum, highest: i64| {
            let terms = self.to_order(sum, highest - dropped);
            terms.map(|(powers, factor)| term(powers, factor.to_f64(), &values)).sum::<f64>()
        };
        let value = |sum: &Option<Sum>, highest: i64| sum.as_ref().map_or(0.0, |sum| to_order(sum, highest));
        let trace = value(&steady.trace, steady.order);
        let determinant = value(&steady.determinant, steady.order + steady.lowest);
        let phase = steady.phase.as_ref().map_or(0.0, |(m, parts)| {
            // Both have the sign of their denominator.
            let sign = steady.denominator.as_ref().map_or(1.0, |below| number(below, &values).signum());
            let [cosine, sine] =
                parts.each_ref().map(|part| sign * to_order(part, steady.order - steady.coupling));
            libm::remainder(libm::atan2(sine, cosine) / double(*m), TAU)
        });
        let is_stable = trace < 0.0 && (steady.determinant.is_none() || determinant > 0.0);
        SteadySolution { amplitude, phase, trace, determinant, is_stable }
    }

    /// The terms of a sum up to an order.
    fn to_order<'s>(
        &self,
        sum: &'s Sum,
        highest: i64,
    ) -> impl Iterator<Item = (&'s [i64], &'s Rational)> + use<'s> {
        let grade = self.index(Column::Order);
        let terms = sum.half_powers().map(|(powers, factor)| (&powers[..], factor));
        terms.filter(move |(powers, _)| powers[grade] <= 2 * highest)
    }

    /// The lowest and the highest order of the slow flow.
    pub(super) fn orders(&self) -> (usize, usize) {
        let steady = &self.sums.steady;
        let [lowest, order] =
            [steady.lowest, steady.order].map(|exponent| usize::try_from(exponent).unwrap_or(0));
        (lowest, order)
    }

    /// The number of orders above the lowest.
    pub(super) fn higher_orders(&self) -> i64 {
        self.sums.steady.order - self.sums.steady.lowest
    }

    /// The m of cos mφ and sin mφ.
    pub(super) fn phase_harmonic(&self) -> f64 {
        self.sums.steady.phase.as_ref().map_or(1.0, |(m, _)| double(*m))
    }

    fn with_amplitude(&self, amplitude: f64) -> Vec<f64> {
        let mut values = self.values.clone();
        values[self.index(Column::Amplitude)] = amplitude;
        values
    }

    fn index(&self, column: Column) -> usize {
        self.sums.symbols.len() + column as usize
    }
}

fn phase_sum(sum: &PhaseSum, values: &[f64], phase: f64) -> f64 {
    let waves = sum.harmonics.iter().map(|(&k, [cosine, sine])| {
        let angle = double(k) * phase;
        number(cosine, values) * libm::cos(angle) + number(sine, values) * libm::sin(angle)
    });
    waves.sum()
}

fn number(sum: &Sum, values: &[f64]) -> f64 {
    sum.half_powers().map(|(powers, factor)| term(powers, factor.to_f64(), values)).sum()
}

fn term(powers: &[i64], factor: f64, values: &[f64]) -> f64 {
    let present = powers.iter().zip(values).filter(|(power, _)| **power != 0);
    present.fold(factor, |product, (power, value)| product * libm::pow(*value, double(*power) / 2.0))
}

fn double(number: i64) -> f64 {
    Rational::from(number).to_f64()
}

impl Letters {
    /// The unit of σ: the detuning without σ and orders.
    pub(super) fn unit(&self, detuning: &Sum) -> Sum {
        self.changed(detuning, |powers, factor| {
            powers[self.index(Column::Detuning)] = 0;
            powers[self.index(Column::Order)] = 0;
            factor.clone()
        })
    }
}
