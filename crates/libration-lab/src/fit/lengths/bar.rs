//! A bar that is turned about several points: T²h = (4π²/g)(k² + h²), fitted as T(h).
//!
//! With y = (T/2πR)² the law is y = (h + κ/h)/g, κ = k² being the square of the radius of gyration about the centre of mass, and h = |L + δ| the distance
//! of the pivot from it: δ is zero where positions are measured from the centre, and minus the position of the centre where they are measured from
//! a mark, such as an end of the bar. Both sides of the centre then count. At h = k the period is least.

use nalgebra::{DMatrix, DVector};

use super::model::{LengthFit, LengthModel, Solution};
use super::table::{LengthTable, Row};
use crate::statistics::levenberg_marquardt::{Effort, Linearised, ResidualsError, minimum};
use crate::statistics::student::probability_beyond_any;
use crate::statistics::{Design, count, is_settled, weighted_least_squares};

const EFFORT: Effort = Effort { tolerance: 1e-13, patience: 100 };
/// Rounding errors of the derivatives, which are closed forms.
const EXACTNESS: f64 = 1e-12;
/// Rounds in which the weights are renewed: two to five are usual, and thirty where the rows refute the law by several standard deviations. At a minimum
/// with far larger deviations the weights of rows next to the centre may not settle.
const MOST_ROUNDS: usize = 50;
/// Trial positions of the centre over three times the range of the lengths.
const TRIALS: usize = 300;
/// Number of the best trials from which the search begins: a pivot next to the centre makes a minimum on either side of it.
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
    let mut found: Vec<Found> =
        starts.into_iter().filter_map(|offset| at_minimum(table, model, offset)).collect();
    found.sort_by(|one, other| one.chi2.total_cmp(&other.chi2));
    let (best, others) = found.split_first()?;
    let fit = best.solution.described_bar(table, model, &best.fitted)?;
    let other_centre = others.iter().find(|other| is_rival(&fit, best, other)).map(Found::centre_and_gravity);
    Some(LengthFit { other_centre, ..fit })
}

/// Returns whether the rows do not exclude another minimum: its sum of squares is larger by less than that of two standard uncertainties.
fn is_rival(fit: &LengthFit, best: &Found, other: &Found) -> bool {
    /// Positions of one minimum that is reached from several trials agree to far less.
    const SAME: f64 = 1e-6;
    let [[centre, _], [other_centre, _]] = [best, other].map(Found::centre_and_gravity);
    let is_other = (centre - other_centre).abs() > SAME * centre.abs().max(other_centre.abs());
    is_other && fit.unit_variance().is_some_and(|variance| other.chi2 - best.chi2 < 4.0 * variance)
}

/// The probability that chance makes as large an improvement by a free centre over one at zero; `None` without a degree of freedom.
pub(super) fn improvement_by_chance(at_zero: &LengthFit, free: &LengthFit) -> Option<f64> {
    let improvement = (at_zero.sum_of_squares() - free.sum_of_squares()).max(0.0);
    let deviations = (improvement / free.unit_variance()?).sqrt();
    Some(probability_beyond_any(deviations, free.uncertainty_degrees_of_freedom()))
}

/// A solution at its least sum of squares.
struct Found {
    solution: Solution,
    fitted: Vec<f64>,
    chi2: f64,
}

impl Found {
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
            |other: Option<usize>| other.and_then(|it| sums.get(it)).copied().unwrap_or(f64::INFINITY);
        sums[*step].is_finite()
            && sums[*step] <= neighbour(step.checked_sub(1))
            && sums[*step] <= neighbour(Some(step + 1))
    };
    let mut steps: Vec<usize> = (0..TRIALS).filter(is_least).collect();
    steps.sort_by(|one, other| sums[*one].total_cmp(&sums[*other]));
    steps.into_iter().take(STARTS).map(offset).collect()
}

/// 1/g and κ/g at a given centre, by weighted linear least squares.
fn linear(table: &LengthTable, offset: f64) -> Option<[f64; 2]> {
    let rows = &table.rows;
    let height = |row: &Row| (row.length + offset).abs();
    let matrix =
        DMatrix::from_fn(
            rows.len(),
            2,
            |i, k| if k == 0 { height(&rows[i]) } else { 1.0 / height(&rows[i]) },
        );
    let values = DVector::from_iterator(rows.len(), rows.iter().map(Row::square));
    let weights: Vec<f64> = rows.iter().map(|row| 1.0 / of_period(table, row)).collect();
    let found = weighted_least_squares(matrix, values, &weights).ok()?.coefficients;
    (found[0] > 0.0 && found[1] > 0.0).then(|| [found[0], found[1]])
}

fn sum_of_squares(table: &LengthTable, start: &[f64; 2], offset: f64) -> f64 {
    let residual = |row: &Row| {
        let height = (row.length + offset).abs();
        (start[0] * height + start[1] / height - row.square()) / of_period(table, row)
    };
    table.rows.iter().map(|row| residual(row) * residual(row)).sum()
}

/// Standard deviation of y by that of T, which is the same for all rows where none are stated.
fn of_period(table: &LengthTable, row: &Row) -> f64 {
    let uncertainty = if table.weighted { row.period_uncertainty } else { 1.0 };
    2.0 * row.square() * uncertainty / row.period
}

fn at_minimum(table: &LengthTable, model: LengthModel, offset: f64) -> Option<Found> {
    let start = linear(table, offset)?;
    let mut parameters = DVector::from_vec(match model {
        LengthModel::BarOffset => vec![start[0], start[1], offset],
        _ => start.to_vec(),
    });
    for _ in 0..MOST_ROUNDS {
        let deviations = deviations(table, &parameters);
        let least = minimum(parameters.clone(), EFFORT, |it| linearised(table, it, &deviations)).ok()?;
        if !least.parameters.iter().take(2).all(|&it| it > 0.0) {
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
        if least.converged && is_settled(parameters.as_slice(), &coefficients, &covariance, 1.0) {
            return Some(Found {
                solution: Solution { coefficients, columns, covariance, variances },
                fitted,
                chi2,
            });
        }
        parameters = least.parameters;
    }
    None
}

/// Standard deviations of y with those of the lengths folded in.
fn deviations(table: &LengthTable, parameters: &DVector<f64>) -> Vec<f64> {
    let bar = Bar::of(parameters);
    let deviation = |row: &Row| {
        let of_length = if table.weighted { bar.slope(row.length) * row.length_uncertainty } else { 0.0 };
        libm::hypot(of_period(table, row), of_length)
    };
    table.rows.iter().map(deviation).collect()
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

    /// Its derivative with respect to the length.
    fn slope(&self, length: f64) -> f64 {
        let height = length + self.offset;
        height.signum() * (self.inverse - self.inertia / (height * height))
    }
}
