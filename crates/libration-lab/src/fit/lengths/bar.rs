//! A bar that is turned about several points: T²h = (4π²/g)(k² + h²), fitted as T(h).
//!
//! With y = (T/2πR)² the law is y = (h + κ/h)/g, κ = k² being the square of the radius of gyration about the centre of mass, and h = |L + δ| the distance
//! of the pivot from it: δ is zero where positions are measured from the centre, and minus the position of the centre where they are measured from
//! a mark, such as an end of the bar. Both sides of the centre then count. At h = k the period is least.
//!
//! Next to the centre the period changes by up to 25 ms in a millimetre. Where no uncertainties are stated, errors of the positions and of the periods
//! are told apart by their effect on the rows (`variance_components.rs`).

use libration::internals::InOrder;
use nalgebra::{DMatrix, DVector};

use super::model::{LengthFit, LengthModel, Solution};
use super::table::{LengthRow, LengthTable};
use super::variance_components::{OfRatio, SHARES, most_likely};
use crate::statistics::levenberg_marquardt::{Effort, Linearised, ResidualsError, minimum};
use crate::statistics::student::probability_beyond_any;
use crate::statistics::{Design, count, is_settled, weighted_least_squares};

/// The tolerance is above the rounding of a sum of squares.
const EFFORT: Effort = Effort { tolerance: 1e-13, patience: 100 };
/// Rounding errors of the derivatives, which are closed forms.
const EXACTNESS: f64 = 1e-12;
/// Rounds in which the weights are renewed: two to five are usual, and thirty where the rows refute the law by several standard deviations. At a minimum
/// with far larger deviations the weights of rows next to the centre may not settle.
const MOST_ROUNDS: usize = 50;
/// Trial positions of the centre over three times the range of the lengths.
const TRIALS: usize = 300;
/// Number of the best trials from which the search begins: a pivot next to the centre causes a minimum on either side of it.
const STARTS: usize = 4;

/// Fits the law to the table, with the centre where it is free; `None` where the rows are too few or do not determine it.
pub(super) fn fit(table: &LengthTable, model: LengthModel) -> Option<LengthFit> {
    let width = model.parameters();
    if table.rows.len() < width + usize::from(!table.weighted) {
        return None;
    }
    let starts = match model {
        LengthModel::BarOffset => trials(table),
        _ => vec![0.0],
    };
    let mut solutions: Vec<BarSolution> =
        starts.into_iter().filter_map(|offset| at_minimum(table, model, offset, 0.0)).collect();
    solutions.put_in_order(|one, other| one.chi2.total_cmp(&other.chi2));
    let (best, others) = solutions.split_first()?;
    let likely = if table.weighted { None } else { most_likely_ratio(table, model, best) };
    let described = likely.as_ref().unwrap_or(best);
    let fit = described.solution.described_bar(table, model, &described.fitted)?;
    let other_centre =
        others.iter().find(|other| is_rival(&fit, best, other)).map(BarSolution::centre_and_gravity);
    Some(LengthFit { other_centre, ..fit })
}

/// Returns `true` if the rows do not exclude another minimum: its sum of squares is larger by less than that of two standard uncertainties.
fn is_rival(fit: &LengthFit, best: &BarSolution, other: &BarSolution) -> bool {
    /// Relative difference above which positions belong to different minima; those reached from several trials agree to far less.
    const SAME: f64 = 1e-6;
    let [[centre, _], [other_centre, _]] = [best, other].map(BarSolution::centre_and_gravity);
    let is_other = (centre - other_centre).abs() > SAME * centre.abs().max(other_centre.abs());
    is_other && fit.unit_variance().is_some_and(|variance| other.chi2 - best.chi2 < 4.0 * variance)
}

/// The fit with the most likely ratio of the variances of lengths and periods, where none are stated, with the uncertainty of the ratio; `None`
/// without a degree of freedom.
fn most_likely_ratio(table: &LengthTable, model: LengthModel, equal: &BarSolution) -> Option<BarSolution> {
    if table.rows.len() <= model.parameters() {
        return None;
    }
    let parameters = DVector::from_column_slice(&equal.solution.coefficients);
    let bar = Bar::of(&parameters);
    let squares = table.rows.iter().map(|row| bar.slope_of_period(table, row)).map(|slope| slope * slope);
    let mean = squares.sum::<f64>() / count(table.rows.len());
    let ratio = |share: f64| (share / ((1.0 - share) * mean)).sqrt();
    let mut fits: Vec<BarSolution> =
        SHARES.iter().filter_map(|&share| at_minimum(table, model, bar.offset, ratio(share))).collect();
    let views: Vec<OfRatio<'_>> = fits.iter().map(BarSolution::of_ratio).collect();
    let (index, covariance) = most_likely(&views)?;
    let mut best = fits.swap_remove(index);
    best.solution.covariance = covariance;
    Some(best)
}

/// The probability that chance improves the fit by as much with a free centre as against one at zero; without uncertainties, when the two laws have
/// different weights, the probability of so large a position. `None` without a degree of freedom.
pub(super) fn improvement_by_chance(at_zero: &LengthFit, free: &LengthFit) -> Option<f64> {
    if let (None, Some(offset)) = (free.chi2, free.offset) {
        let deviations = (offset.value / offset.uncertainty).abs();
        return Some(probability_beyond_any(deviations, free.uncertainty_degrees_of_freedom()));
    }
    let improvement = (at_zero.sum_of_squares() - free.sum_of_squares()).max(0.0);
    let deviations = (improvement / free.unit_variance()?).sqrt();
    Some(probability_beyond_any(deviations, free.uncertainty_degrees_of_freedom()))
}

/// A solution at its least sum of squares.
struct BarSolution {
    solution: Solution,
    fitted: Vec<f64>,
    chi2: f64,
}

impl BarSolution {
    fn of_ratio(&self) -> OfRatio<'_> {
        let Solution { coefficients, covariance, variances, .. } = &self.solution;
        OfRatio { coefficients, covariance, variances, chi2: self.chi2 }
    }

    /// The position of the centre of mass, and g.
    fn centre_and_gravity(&self) -> [f64; 2] {
        [-self.solution.coefficients.get(2).copied().unwrap_or_default(), 1.0 / self.solution.coefficients[0]]
    }
}

/// The offsets with the smallest sums of squares, each smaller than those of its neighbours.
fn trials(table: &LengthTable) -> Vec<f64> {
    let lengths = table.rows.iter().map(|row| row.length);
    let (low, high) = lengths
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), length| (low.min(length), high.max(length)));
    let span = high - low;
    let offset = |step: usize| -(low - span + 3.0 * span * (count(step) + 0.5) / count(TRIALS));
    let sums: Vec<f64> = (0..TRIALS)
        .map(|step| {
            let offset = offset(step);
            linear(table, offset).map_or(f64::INFINITY, |start| sum_of_squares(table, &start, offset))
        })
        .collect();
    let is_least = |step: &usize| {
        let neighbour =
            |other: Option<usize>| other.and_then(|other| sums.get(other)).copied().unwrap_or(f64::INFINITY);
        sums[*step].is_finite()
            && sums[*step] <= neighbour(step.checked_sub(1))
            && sums[*step] <= neighbour(Some(step + 1))
    };
    let mut steps: Vec<usize> = (0..TRIALS).filter(is_least).collect();
    steps.put_in_order(|one, other| sums[*one].total_cmp(&sums[*other]));
    steps.into_iter().take(STARTS).map(offset).collect()
}

/// 1/g and κ/g at a given centre, by weighted linear least squares.
fn linear(table: &LengthTable, offset: f64) -> Option<[f64; 2]> {
    let rows = &table.rows;
    let height = |row: &LengthRow| (row.length + offset).abs();
    let matrix =
        DMatrix::from_fn(
            rows.len(),
            2,
            |i, k| if k == 0 { height(&rows[i]) } else { 1.0 / height(&rows[i]) },
        );
    let values = DVector::from_iterator(rows.len(), rows.iter().map(LengthRow::square));
    let weights: Vec<f64> = rows.iter().map(|row| 1.0 / of_period(table, row)).collect();
    let coefficients = weighted_least_squares(matrix, values, &weights).ok()?.coefficients;
    (coefficients[0] > 0.0 && coefficients[1] > 0.0).then(|| [coefficients[0], coefficients[1]])
}

fn sum_of_squares(table: &LengthTable, start: &[f64; 2], offset: f64) -> f64 {
    let residual = |row: &LengthRow| {
        let height = (row.length + offset).abs();
        (start[0] * height + start[1] / height - row.square()) / of_period(table, row)
    };
    table.rows.iter().map(|row| residual(row) * residual(row)).sum()
}

/// Standard deviation of y from that of T, which is the same for all rows if none are stated.
fn of_period(table: &LengthTable, row: &LengthRow) -> f64 {
    let uncertainty = if table.weighted { row.period_uncertainty } else { 1.0 };
    2.0 * row.square() * uncertainty / row.period
}

/// The minimum next to an offset; without uncertainties with this ratio of the standard deviations of lengths and periods, in m/s.
fn at_minimum(table: &LengthTable, model: LengthModel, offset: f64, ratio: f64) -> Option<BarSolution> {
    let start = linear(table, offset)?;
    let mut parameters = DVector::from_vec(match model {
        LengthModel::BarOffset => vec![start[0], start[1], offset],
        _ => start.to_vec(),
    });
    for _ in 0..MOST_ROUNDS {
        let deviations = deviations(table, &parameters, ratio);
        let least =
            minimum(parameters.clone(), EFFORT, |trial| linearised(table, trial, &deviations)).ok()?;
        if !least.parameters.iter().take(2).all(|&parameter| parameter > 0.0) {
            return None;
        }
        let covariance = Design::new(&least.linearised.jacobian, EXACTNESS).ok()?.covariance();
        let coefficients: Vec<f64> = least.parameters.iter().copied().collect();
        let variances: Vec<f64> = deviations.iter().map(|deviation| deviation * deviation).collect();
        let fitted = table.rows.iter().map(|row| Bar::of(&least.parameters).square(row.length)).collect();
        let chi2 = least.linearised.residuals.norm_squared();
        let jacobian = &least.linearised.jacobian;
        let columns =
            DMatrix::from_fn(jacobian.nrows(), jacobian.ncols(), |i, k| jacobian[(i, k)] * deviations[i]);
        let dof = count(table.rows.len() - coefficients.len());
        let variance = if table.weighted { 1.0 } else { chi2 / dof };
        if least.converged && is_settled(parameters.as_slice(), &coefficients, &covariance, variance) {
            return Some(BarSolution {
                solution: Solution { coefficients, columns, covariance, variances },
                fitted,
                chi2,
            });
        }
        parameters = least.parameters;
    }
    None
}

/// Standard deviations of y with those of the lengths folded in; without uncertainties relative to their geometric mean, so that sums of squares of
/// different ratios compare as likelihoods.
fn deviations(table: &LengthTable, parameters: &DVector<f64>, ratio: f64) -> Vec<f64> {
    let bar = Bar::of(parameters);
    if table.weighted {
        let of_length = |row: &LengthRow| bar.slope(row.length) * row.length_uncertainty;
        return table.rows.iter().map(|row| libm::hypot(of_period(table, row), of_length(row))).collect();
    }
    let factors = table.rows.iter().map(|row| libm::hypot(1.0, ratio * bar.slope_of_period(table, row)));
    let factors: Vec<f64> = factors.collect();
    let mean = libm::exp(factors.iter().map(|&factor| libm::log(factor)).sum::<f64>() / count(factors.len()));
    table.rows.iter().zip(factors).map(|(row, factor)| of_period(table, row) * factor / mean).collect()
}

fn linearised(
    table: &LengthTable,
    parameters: &DVector<f64>,
    deviations: &[f64],
) -> Result<Linearised, ResidualsError> {
    let bar = Bar::of(parameters);
    let rows = &table.rows;
    let residuals =
        DVector::from_fn(rows.len(), |i, _| (bar.square(rows[i].length) - rows[i].square()) / deviations[i]);
    let jacobian = DMatrix::from_fn(rows.len(), parameters.len(), |i, k| {
        let height = (rows[i].length + bar.offset).abs();
        let slope = match k {
            0 => height,
            1 => 1.0 / height,
            _ => bar.slope(rows[i].length),
        };
        slope / deviations[i]
    });
    let finite = residuals.iter().chain(jacobian.iter()).all(|x| x.is_finite());
    if finite { Ok(Linearised { residuals, jacobian }) } else { Err(ResidualsError::OutOfDomain) }
}

/// 1/g, κ/g and δ.
struct Bar {
    inverse: f64,
    inertia: f64,
    offset: f64,
}

impl Bar {
    fn of(parameters: &DVector<f64>) -> Self {
        let offset = if parameters.len() > 2 { parameters[2] } else { 0.0 };
        Self { inverse: parameters[0], inertia: parameters[1], offset }
    }

    /// (T/2πR)² about the point at this length.
    fn square(&self, length: f64) -> f64 {
        let height = (length + self.offset).abs();
        self.inverse * height + self.inertia / height
    }

    /// The derivative with respect to the length.
    fn slope(&self, length: f64) -> f64 {
        let height = length + self.offset;
        height.signum() * (self.inverse - self.inertia / (height * height))
    }

    /// dT/dh where no uncertainties are stated.
    fn slope_of_period(&self, table: &LengthTable, row: &LengthRow) -> f64 {
        self.slope(row.length) / of_period(table, row)
    }
}
