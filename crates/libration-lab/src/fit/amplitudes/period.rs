//! The period of small swings, given or by times and numbers of swings.

use std::f64::consts::{PI, TAU};

use nalgebra::{DMatrix, DVector};

use super::law::DecayLaw;
use super::search::DecayLawFit;
use super::{AmplitudeTable, Position};
use crate::fit::damping_model::DampingModel;
use crate::fit::uncertain::Uncertain;
use crate::statistics::{count, least_squares, mean};
use libration::decay::DampingKind;
use libration::quantity::Quantity;

/// Points of the curve at which T/T0 is summed: the sum is exact to 1e-6 of its excess over one.
const POINTS: usize = 1000;

/// The period of small swings; `None` where neither it nor both columns are given, or the rows do not determine it. `scale` multiplies the
/// covariance of the parameters.
pub(super) fn period(
    law: &DecayLaw<'_>,
    fit: &DecayLawFit,
    scale: f64,
    given: Option<Quantity>,
) -> Option<Uncertain> {
    match given {
        Some(Quantity { value, uncertainty }) => {
            Some(Uncertain { value, uncertainty: uncertainty.unwrap_or(0.0) })
        }
        None => {
            let period = observed(law, fit.terms, &fit.parameters)?;
            Some(period.with_error(error_of_amplitudes(law, fit, scale, period.value)))
        }
    }
}

/// The period with an uncertainty by the scatter of the times alone.
fn observed(law: &DecayLaw<'_>, terms: DampingModel, parameters: &[f64]) -> Option<Uncertain> {
    by_periods(law, terms, parameters).or_else(|| by_numbers(law, terms, parameters))
}

/// Standard uncertainty of the period by those of the parameters: a larger amplitude makes the ratio T/T0 larger in all rows together.
fn error_of_amplitudes(law: &DecayLaw<'_>, fit: &DecayLawFit, scale: f64, period: f64) -> f64 {
    let deviation = |k: usize| (scale * fit.covariance[(k, k)]).sqrt();
    let change = |k: usize| {
        let moved = |sign: f64| {
            let mut parameters = fit.parameters.clone();
            parameters[k] += sign * deviation(k);
            observed(law, fit.terms, &parameters).map(|observed| sign * (observed.value - period))
        };
        // Outside the domain there is no period on one side.
        moved(1.0).or_else(|| moved(-1.0)).filter(|change| change.is_finite()).unwrap_or(0.0)
    };
    let count = fit.parameters.len();
    let changes = DVector::from_fn(count, |k, _| change(k));
    let correlation = DMatrix::from_fn(count, count, |i, j| {
        let product = deviation(i) * deviation(j);
        if product > 0.0 { scale * fit.covariance[(i, j)] / product } else { 0.0 }
    });
    (correlation * &changes).dot(&changes).max(0.0).sqrt()
}

/// The mean of T·T0/T over the rows with a period, three or more.
fn by_periods(law: &DecayLaw<'_>, terms: DampingModel, parameters: &[f64]) -> Option<Uncertain> {
    let amplitudes = law.curve(terms, parameters)?.amplitudes;
    let rows = law.table.rows.iter().zip(&amplitudes);
    let periods: Vec<f64> =
        rows.filter_map(|(row, &amplitude)| Some(row.period? / law.period_ratio(amplitude))).collect();
    if periods.len() < 3 {
        return None;
    }
    let (number, value) = (count(periods.len()), mean(periods.iter().copied()));
    let square: f64 = periods.iter().map(|period| (period - value) * (period - value)).sum();
    Some(Uncertain { value, uncertainty: (square / (number * (number - 1.0))).sqrt() })
}

/// T0 by the line of ∫dt T0/T against the number of swings; a table of three rows or more has a scatter.
fn by_numbers(law: &DecayLaw<'_>, terms: DampingModel, parameters: &[f64]) -> Option<Uncertain> {
    let table = law.table;
    if table.against == Position::Swings {
        return None;
    }
    let points = law.amplitudes_between(terms, parameters, POINTS);
    let mut sums = vec![0.0];
    for pair in points.windows(2) {
        let mean = 0.5 * (1.0 / law.period_ratio(pair[0].1) + 1.0 / law.period_ratio(pair[1].1));
        sums.push(sums[sums.len() - 1] + mean * (pair[1].0 - pair[0].0));
    }
    let rows: Vec<(f64, f64)> = table
        .rows
        .iter()
        .filter_map(|row| Some((row.swing?, small_swing_time(&points, &sums, row.position))))
        .collect();
    if rows.len() < 3 {
        return None;
    }
    let matrix = DMatrix::from_fn(rows.len(), 2, |i, k| if k == 0 { 1.0 } else { rows[i].0 });
    let line =
        least_squares(&matrix, &DVector::from_iterator(rows.len(), rows.iter().map(|row| row.1))).ok()?;
    let variance = line.chi2() / count(rows.len() - 2) * line.covariance[(1, 1)];
    let period = Uncertain { value: line.coefficients[1], uncertainty: variance.sqrt() };
    Some(period).filter(|period| period.value > 0.0)
}

/// ∫dt T0/T from the first row to a time.
fn small_swing_time(points: &[(f64, f64)], sums: &[f64], time: f64) -> f64 {
    let index = points.partition_point(|point| point.0 < time).clamp(1, points.len() - 1);
    let (from, to) = (points[index - 1].0, points[index].0);
    sums[index - 1] + (sums[index] - sums[index - 1]) * (time - from) / (to - from)
}

/// ω0 without damping: the observed angular frequency 2π/T0, and half of the linear damping.
pub(super) fn natural_frequency(table: &AmplitudeTable, fit: &DecayLawFit, period: Uncertain) -> Uncertain {
    let linear = fit.rate(DampingKind::Linear);
    let per_second = match table.against {
        Position::Time => linear,
        Position::Swings => linear / period.value,
    };
    let value = libm::hypot(TAU / period.value, 0.5 * per_second);
    Uncertain { value, uncertainty: value * period.relative() }
}

/// The phase ω0 times the unit of the positions, which is known for swings without a period.
pub(super) fn phase_per_position(
    table: &AmplitudeTable,
    fit: &DecayLawFit,
    natural_frequency: Option<Uncertain>,
) -> Option<Uncertain> {
    match table.against {
        Position::Time => natural_frequency,
        Position::Swings => {
            let value = 2.0 * libm::hypot(PI, 0.25 * fit.rate(DampingKind::Linear));
            Some(Uncertain { value, uncertainty: 0.0 })
        }
    }
}

impl DecayLawFit {
    /// κₙ of a kind of damping; zero where the law does not have it.
    pub(super) fn rate(&self, term: DampingKind) -> f64 {
        let index = self.terms.iter().position(|other| other == term);
        index.map_or(0.0, |position| self.parameters[position + 1])
    }
}
