//! Intervals of the profile likelihood: the distance by which a parameter can be moved, with all others refitted, until the sum of squares
//! has grown by the amount of the level (D. M. Bates and D. G. Watts, *Nonlinear Regression Analysis and Its
//! Applications*, Wiley 1988, doi:10.1002/9780470316757, chapter 6).

use libration::internals::progress::Watch;

use super::minimum::TraceMinimum;
use super::problem::Problem;
use super::{Parameter, TraceFitError};
use crate::parallel;
use nalgebra::DMatrix;

/// Standard deviations within which a normal distribution has 68.27 % and 95 %.
pub const LEVELS: [f64; 2] = [1.0, 1.959963984540054];
/// Number of distances that are tried, each corrected by the error of the last one: in 21 recordings one correction was enough, so that with 1 and
/// 12 nothing changed. Profiles that are less parabolic need more.
const TRIES: usize = 6;
/// Largest negligible relative error of a distance: with a tenth of it no end moved by a hundredth of an uncertainty.
const SAME: f64 = 0.005;
/// Largest factor of a correction: with 1.5 and 10 nothing changed.
const LARGEST_CORRECTION: f64 = 3.0;

/// The intervals if the model were linear.
pub fn linear_intervals(parameter: &Parameter) -> [[f64; 2]; 2] {
    quantiles(parameter.degrees_of_freedom).map(|quantile| {
        let half = quantile * parameter.estimate.uncertainty;
        [parameter.estimate.value - half, parameter.estimate.value + half]
    })
}

/// Half-widths of the two intervals, in standard uncertainties.
pub(super) fn quantiles(degrees_of_freedom: f64) -> [f64; 2] {
    LEVELS.map(|level| students(level, degrees_of_freedom))
}

/// Computes the intervals of all shared parameters.
pub(super) fn intervals(
    problem: &Problem<'_>,
    minimum: &TraceMinimum,
    covariance: &DMatrix<f64>,
    variance: f64,
    parameters: &mut [Parameter],
    watch: &Watch<'_>,
) -> Result<(), TraceFitError> {
    let free = problem.model.free();
    let shared: Vec<usize> =
        (0..parameters.len()).filter(|&index| parameters[index].trace.is_none()).collect();
    let ends: Vec<(usize, f64, f64)> = shared
        .iter()
        .flat_map(|&index| LEVELS.map(|level| [-1.0, 1.0].map(|side| (index, level, side))).concat())
        .collect();
    let outcomes = parallel::map(&ends, watch, |&(index, level, side), watch| {
        let parameter = &parameters[index];
        let inflation = parameter.estimate.uncertainty / parameter.formal_uncertainty;
        let wanted = students(level, parameter.degrees_of_freedom) * inflation;
        let profile = Profile { problem, minimum, free: &free, covariance, index, variance };
        profile.end(side * wanted, parameter.formal_uncertainty, watch)
    });
    let distances = outcomes.into_iter().collect::<Result<Vec<f64>, TraceFitError>>()?;
    for (index, ends) in shared.into_iter().zip(distances.chunks_exact(2 * LEVELS.len())) {
        parameters[index].intervals = [[ends[0], ends[1]], [ends[2], ends[3]]];
    }
    Ok(())
}

/// One parameter as it is moved away from the minimum.
struct Profile<'a> {
    problem: &'a Problem<'a>,
    minimum: &'a TraceMinimum,
    free: &'a [usize],
    covariance: &'a DMatrix<f64>,
    /// Index of the parameter among the free ones.
    index: usize,
    variance: f64,
}

impl Profile<'_> {
    /// The value at this number of standard deviations; by the linear approximation if the profile does not reach so far.
    fn end(&self, deviations: f64, uncertainty: f64, watch: &Watch<'_>) -> Result<f64, TraceFitError> {
        let centre = self.minimum.parameters[self.free[self.index]];
        let mut distance = deviations * uncertainty;
        for _ in 0..TRIES {
            let reached = match self.deviations(distance, watch) {
                Err(TraceFitError::Interrupted) => return Err(TraceFitError::Interrupted),
                Err(_) => return Ok(centre + deviations * uncertainty),
                Ok(reached) => reached,
            };
            let ratio = deviations.abs() / reached;
            if (ratio - 1.0).abs() < SAME {
                return Ok(centre + distance);
            }
            distance *= ratio.clamp(LARGEST_CORRECTION.recip(), LARGEST_CORRECTION);
        }
        Ok(centre + distance)
    }

    /// Number of standard deviations by which the data contradict a value at this distance. The other parameters start at the values
    /// of the linear approximation.
    fn deviations(&self, distance: f64, watch: &Watch<'_>) -> Result<f64, TraceFitError> {
        let mut parameters = self.minimum.parameters.clone();
        let variance = self.covariance[(self.index, self.index)];
        for (column, &index) in self.free.iter().enumerate() {
            parameters[index] += distance * self.covariance[(self.index, column)] / variance;
        }
        let fixed = self.free[self.index];
        let others = self.free.iter().copied().filter(|&other| other != fixed).collect();
        let least = self.minimum.sum_of_squares();
        let moved = self.problem.sum_beside(&self.minimum.weights, parameters, others, least, watch)?;
        Ok(((moved - least).max(0.0) / self.variance).sqrt())
    }
}

/// Student's quantile for this number of degrees of freedom at a normal one, by the first terms of Cornish and Fisher
/// (Abramowitz and Stegun 26.7.5).
pub fn students(z: f64, degrees: f64) -> f64 {
    let square = z * z;
    let first = z * (square + 1.0) / 4.0;
    let second = z * ((5.0 * square + 16.0) * square + 3.0) / 96.0;
    let third = z * (((3.0 * square + 19.0) * square + 17.0) * square - 15.0) / 384.0;
    z + (first + (second + third / degrees) / degrees) / degrees
}
