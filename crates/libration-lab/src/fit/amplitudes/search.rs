//! Least squares of one law, with weights that belong to the result.

use nalgebra::{DMatrix, DVector};

use super::law::{DecayCurve, DecayLaw};
use super::sides::Sides;
use super::table::{AmplitudeRow, AmplitudeTable, UnstatedErrors};
use crate::fit::damping_model::DampingModel;
use crate::statistics::levenberg_marquardt::{Effort, Linearised, ResidualsError, minimum};
use crate::statistics::{Design, count, is_settled, median, weighted_least_squares};

/// χ² is smooth to rounding errors; the derivatives by differences only slow the search down.
const EFFORT: Effort = Effort { tolerance: 1e-12, patience: 40 };
/// Step of difference quotients, relative to an amplitude or to a coefficient that would halve it.
const STEP: f64 = 1e-5;
/// Relative error of difference quotients: rounding over that step, with that of hundreds of integration steps.
const EXACTNESS: f64 = 1e-8;
/// Rounds in which weights that depend on the result are renewed; the error falls by the relative error of the amplitudes each time.
const MOST_ROUNDS: usize = 50;
/// Amplitudes below this fraction of the largest one have the relative error of one of this size.
const LEAST: f64 = 1e-3;

/// A law at its least sum of squares.
#[derive(Clone, Debug)]
pub(super) struct DecayLawFit {
    pub(super) terms: DampingModel,
    /// The first amplitude, the κₙ, and the zero of the scale where it is fitted.
    pub(super) parameters: Vec<f64>,
    /// Covariance of the parameters where the variances are right.
    pub(super) covariance: DMatrix<f64>,
    pub(super) chi2: f64,
    pub(super) curve: DecayCurve,
    /// Standard deviations of the values, up to a common factor where none are stated.
    pub(super) deviations: Vec<f64>,
}

/// Number of free parameters of a law.
pub(super) fn parameters(table: &AmplitudeTable, terms: DampingModel) -> usize {
    1 + terms.count() + usize::from(table.sides == Sides::Both)
}

/// The zero of the scale before any fit: half way between the medians of both sides in the later half of the table.
pub(super) fn first_zero(table: &AmplitudeTable) -> f64 {
    if table.sides == Sides::One {
        return 0.0;
    }
    let late = &table.rows[table.rows.len() / 2..];
    let side = |sign: f64| {
        let of = |rows: &[AmplitudeRow]| {
            median(rows.iter().filter(|row| row.side * sign > 0.0).map(|row| row.value).collect())
        };
        of(late).or_else(|| of(&table.rows)).unwrap_or(0.0)
    };
    0.5 * (side(1.0) + side(-1.0))
}

/// Fits a law; `None` where the rows are too few, leave a parameter undetermined, or lead out of the law's domain, and where the search or the weights do not
/// settle.
pub(super) fn fit(law: &DecayLaw<'_>, terms: DampingModel) -> Option<DecayLawFit> {
    let table = law.table;
    if table.len() < parameters(table, terms) + usize::from(!table.weighted) {
        return None;
    }
    let zero = first_zero(table);
    let mut amplitudes: Vec<f64> = table
        .rows
        .iter()
        .map(|row| table.reading.amplitude(row.side * (row.value - zero)).max(0.0))
        .collect();
    let mut start = guess(law, terms, &amplitudes, zero)?;
    for _ in 0..MOST_ROUNDS {
        let deviations = deviations(law, terms, start.as_slice(), &amplitudes);
        let weights: Vec<f64> = deviations.iter().map(|deviation| 1.0 / deviation).collect();
        let evaluate = |parameters: &DVector<f64>| linearised(law, terms, parameters, &weights);
        let least = minimum(start.clone(), EFFORT, evaluate).ok().filter(|least| least.converged)?;
        let parameters: Vec<f64> = least.parameters.iter().copied().collect();
        let curve = law.curve(terms, &parameters)?;
        let covariance = Design::new(&least.linearised.jacobian, EXACTNESS).ok()?.covariance();
        let chi2 = least.linearised.residuals.norm_squared();
        let dof = table.len().saturating_sub(parameters.len()).max(1);
        let variance = if table.weighted { 1.0 } else { chi2 / count(dof) };
        let has_settled = !has_weights_of_the_result(table)
            || is_settled(start.as_slice(), &parameters, &covariance, variance);
        if has_settled {
            return Some(DecayLawFit { terms, parameters, covariance, chi2, curve, deviations });
        }
        amplitudes = curve.amplitudes;
        start = least.parameters;
    }
    None
}

fn has_weights_of_the_result(table: &AmplitudeTable) -> bool {
    let is_relative = !table.weighted && table.unstated_errors == UnstatedErrors::Relative;
    is_relative || table.rows.iter().any(|row| row.position_uncertainty > 0.0)
}

/// Standard deviations of the values, with those of the positions folded in by the rate of fall.
fn deviations(law: &DecayLaw<'_>, terms: DampingModel, parameters: &[f64], amplitudes: &[f64]) -> Vec<f64> {
    let table = law.table;
    let largest = amplitudes.iter().copied().fold(0.0, f64::max);
    let deviation = |(row, &amplitude): (&AmplitudeRow, &f64)| {
        if !table.weighted {
            return match table.unstated_errors {
                UnstatedErrors::Absolute => 1.0,
                UnstatedErrors::Relative => table.reading.of(amplitude.max(LEAST * largest)),
            };
        }
        let of_position = law.fall(terms, parameters, amplitude)
            * table.reading.slope(amplitude)
            * row.position_uncertainty;
        libm::hypot(row.value_uncertainty, of_position)
    };
    table.rows.iter().zip(amplitudes).map(deviation).collect()
}

/// Guesses the parameters by A = A0 − Σ κₙ∫fₙ with the measured amplitudes inside the integrals.
fn guess(law: &DecayLaw<'_>, terms: DampingModel, amplitudes: &[f64], zero: f64) -> Option<DVector<f64>> {
    let rows = &law.table.rows;
    let mut columns = vec![vec![1.0; rows.len()]];
    for term in terms.iter() {
        let mut integral = vec![0.0];
        for (pair, rows) in amplitudes.windows(2).zip(rows.windows(2)) {
            let mean = 0.5 * (law.rate(term, pair[0]) + law.rate(term, pair[1]));
            integral.push(integral[integral.len() - 1] - mean * (rows[1].position - rows[0].position));
        }
        columns.push(integral);
    }
    let matrix = DMatrix::from_fn(rows.len(), columns.len(), |i, j| columns[j][i]);
    let weights: Vec<f64> = rows.iter().map(|row| 1.0 / row.value_uncertainty).collect();
    let values = DVector::from_column_slice(amplitudes);
    let mut guess: Vec<f64> =
        weighted_least_squares(matrix, values, &weights).ok()?.coefficients.iter().copied().collect();
    guess[0] = guess[0].max(0.1 * amplitudes.iter().copied().fold(0.0, f64::max));
    if law.table.sides == Sides::Both {
        guess.push(zero);
    }
    if law.curve(terms, &guess).is_none() {
        // Outside the domain the search begins without damping.
        guess.iter_mut().skip(1).take(terms.count()).for_each(|rate| *rate = 0.0);
        guess[0] = amplitudes.iter().copied().fold(0.0, f64::max);
    }
    Some(DVector::from_vec(guess))
}

/// Differences of the law from the values, over their standard deviations, with their derivatives by differences.
fn linearised(
    law: &DecayLaw<'_>,
    terms: DampingModel,
    parameters: &DVector<f64>,
    weights: &[f64],
) -> Result<Linearised, ResidualsError> {
    let values = |parameters: &DVector<f64>| {
        law.curve(terms, parameters.as_slice()).map(|curve| curve.values).ok_or(ResidualsError::OutOfDomain)
    };
    let here = values(parameters)?;
    let rows = law.table.rows.iter().zip(&here).zip(weights);
    let residuals =
        DVector::from_iterator(here.len(), rows.map(|((row, value), weight)| (value - row.value) * weight));
    let mut jacobian = DMatrix::zeros(here.len(), parameters.len());
    for k in 0..parameters.len() {
        let step = STEP * scale(law, terms, parameters, k);
        let mut moved = parameters.clone();
        moved[k] += step;
        let there = match values(&moved) {
            Ok(there) => there,
            Err(error) => {
                // Next to the end of the domain the difference is taken on the other side.
                moved[k] -= 2.0 * step;
                values(&moved).map_err(|_| error)?
            }
        };
        let step = moved[k] - parameters[k];
        for (row, value) in there.iter().enumerate() {
            jacobian[(row, k)] = (value - here[row]) / step * weights[row];
        }
    }
    let finite = residuals.iter().chain(jacobian.iter()).all(|x| x.is_finite());
    if finite { Ok(Linearised { residuals, jacobian }) } else { Err(ResidualsError::OutOfDomain) }
}

/// The size of a parameter: an amplitude, or a coefficient that would halve it.
fn scale(law: &DecayLaw<'_>, terms: DampingModel, parameters: &DVector<f64>, index: usize) -> f64 {
    let amplitude = parameters[0].max(f64::MIN_POSITIVE);
    match terms.iter().nth(index.wrapping_sub(1)) {
        Some(term) => law.typical(term, amplitude),
        // The zero of the scale is linear in the values.
        None => law.table.reading.of(amplitude),
    }
}
