//! Parameters with uncertainties, from the minimum.

use libration::internals::progress::Watch;

use nalgebra::DMatrix;

use super::minimum::TraceMinimum;
use super::problem::Problem;
use super::response::Response;
use super::{Autocorrelation, FittedTrace, Parameter, TraceFit, TraceFitError};
use super::{bootstrap, clock, huber, noise, pivot, profile, systematic};
use crate::fit::uncertain::Uncertain;
use crate::measurement::Trace;
use crate::statistics::{count, mean};

/// Computes the fit with its uncertainties.
pub fn fit(
    problem: &Problem<'_>,
    minimum: &TraceMinimum,
    watch: &Watch<'_>,
) -> Result<TraceFit, TraceFitError> {
    let traces = problem.data.traces;
    let residuals = minimum.standard_residuals(traces);
    let scatter = ResidualScatter::new(problem, &residuals);
    let autocorrelation = Autocorrelation::of_series(&split(&residuals, traces));
    let block = (!autocorrelation.is_noise()).then(|| bootstrap::block(&autocorrelation, minimum, traces));
    let mut parameters = described(problem, minimum);
    let response = Response::new(minimum, &parameters)?;
    let covariance = response.covariance();
    for (index, parameter) in parameters.iter_mut().enumerate() {
        parameter.formal_uncertainty = (scatter.variance * covariance[(index, index)]).sqrt();
    }
    let mut shared = pivot::covariance(traces, minimum, &response.matrix);
    let unweighted = match problem.options.robust {
        true => Response::without_weights(minimum, traces, &parameters)?,
        false => response,
    };
    heed_noise(&mut parameters, traces, &unweighted, block);
    let independent_rows = independent_rows(&parameters, residuals.len());
    if problem.options.profile {
        profile::intervals(problem, minimum, &covariance, scatter.variance, &mut parameters, watch)?;
    }
    let by_clock = clock::deviation(traces, parameters[0].estimate.value);
    shared[(0, 0)] += by_clock * by_clock;
    let mut correlations = correlations(&covariance);
    systematic::add(&mut parameters, &mut correlations, &shared);
    Ok(TraceFit {
        damping: problem.model.layout.terms(),
        correlations,
        traces: fitted(traces, &residuals),
        degrees_of_freedom: scatter.degrees_of_freedom,
        independent_rows,
        chi2_per_dof: scatter.is_stated.then_some(scatter.per_degree),
        rms: rms(traces, &residuals),
        autocorrelation,
        bootstrap_block: block,
        converged: minimum.converged,
        unexplained: problem.unexplained(minimum),
        standard_residuals: residuals,
        parameters,
    })
}

/// Size of the residuals compared with their stated uncertainties.
struct ResidualScatter {
    degrees_of_freedom: usize,
    /// The sum of their squares over the degrees of freedom.
    per_degree: f64,
    /// `true` if there are stated uncertainties.
    is_stated: bool,
    /// Factor of the covariance of the parameters: the scatter, and no less than is stated.
    variance: f64,
}

impl ResidualScatter {
    fn new(problem: &Problem<'_>, residuals: &[f64]) -> Self {
        let parameters = problem.model.free().len();
        let degrees_of_freedom = residuals.len().saturating_sub(parameters).max(1);
        let squares: f64 = residuals.iter().map(|residual| residual * residual).sum();
        let per_degree = squares / count(degrees_of_freedom);
        let is_stated = problem.data.traces.iter().any(|trace| trace.uncertainties().is_some());
        let shown = if problem.options.robust { huber::variance(residuals, parameters) } else { per_degree };
        let variance = if is_stated { shown.max(1.0) } else { shown };
        Self { degrees_of_freedom, per_degree, is_stated, variance }
    }
}

/// The free parameters with their values.
fn described(problem: &Problem<'_>, minimum: &TraceMinimum) -> Vec<Parameter> {
    let layout = problem.model.layout;
    let one = |index: usize| Parameter {
        estimate: Uncertain { value: minimum.parameters[index], ..Uncertain::default() },
        ..layout.described(index, problem.data.traces)
    };
    problem.model.free().into_iter().map(one).collect()
}

/// Computes uncertainties and intervals from the formal ones: by the noise, and by the block bootstrap if it gives larger ones.
fn heed_noise(parameters: &mut [Parameter], traces: &[Trace], response: &Response, block: Option<usize>) {
    let lengths: Vec<usize> = traces.iter().map(Trace::len).collect();
    let residuals = &response.linearised.residuals;
    let rows = residuals.len();
    let correction = (count(rows) / count(rows.saturating_sub(parameters.len()).max(1))).sqrt();
    let by_blocks = block.map_or(vec![0.0; parameters.len()], |block| {
        bootstrap::deviations(&response.matrix, residuals, &lengths, block)
    });
    let effects = noise::effects(traces, response);
    for ((parameter, effect), by_blocks) in parameters.iter_mut().zip(effects).zip(by_blocks) {
        let by_noise = parameter.formal_uncertainty * effect.inflation.sqrt();
        parameter.estimate.uncertainty = by_noise.max(by_blocks * correction);
        parameter.degrees_of_freedom = effect.degrees_of_freedom;
        parameter.intervals = profile::linear_intervals(parameter);
    }
}

/// The rows over the geometric mean of the inflations of the shared parameters' variances by the noise.
fn independent_rows(parameters: &[Parameter], rows: usize) -> f64 {
    let shared = parameters.iter().filter(|parameter| parameter.trace.is_none());
    let logarithms: Vec<f64> = shared
        .map(|shared| 2.0 * libm::log(shared.estimate.uncertainty / shared.formal_uncertainty))
        .filter(|x| x.is_finite())
        .collect();
    // Without any it is NaN, for which `max` returns the other number.
    count(rows) / libm::exp(mean(logarithms.into_iter()).max(0.0))
}

fn correlations(covariance: &DMatrix<f64>) -> Vec<Vec<f64>> {
    let deviation = |index: usize| covariance[(index, index)].sqrt();
    let correlation = |i: usize, j: usize| covariance[(i, j)] / (deviation(i) * deviation(j));
    let row =
        |i: usize| (0..covariance.ncols()).map(|j| if i == j { 1.0 } else { correlation(i, j) }).collect();
    (0..covariance.nrows()).map(row).collect()
}

/// Splits a column into those of the traces.
fn split(column: &[f64], traces: &[Trace]) -> Vec<Vec<f64>> {
    let mut rest = column.iter().copied();
    traces.iter().map(|trace| rest.by_ref().take(trace.len()).collect()).collect()
}

/// The stated uncertainty of each row, or one.
fn uncertainties(trace: &Trace) -> impl Iterator<Item = f64> {
    (0..trace.len()).map(|row| trace.uncertainties().map_or(1.0, |uncertainties| uncertainties[row]))
}

/// The fitted values and residuals of each trace, from residuals in units of the uncertainties.
fn fitted(traces: &[Trace], all: &[f64]) -> Vec<FittedTrace> {
    let scale = huber::scale(all);
    let one = |(trace, column): (&Trace, Vec<f64>)| {
        let residuals: Vec<f64> =
            column.iter().zip(uncertainties(trace)).map(|(r, uncertainty)| -r * uncertainty).collect();
        let fitted =
            trace.values().iter().zip(&residuals).map(|(value, residual)| value - residual).collect();
        let outliers = (0..column.len()).filter(|&row| huber::is_outlier(column[row], scale)).collect();
        FittedTrace { start_time: trace.times()[0], fitted, residuals, outliers }
    };
    traces.iter().zip(split(all, traces)).map(one).collect()
}

fn rms(traces: &[Trace], all: &[f64]) -> f64 {
    let uncertainties = traces.iter().flat_map(uncertainties);
    let size =
        all.iter().zip(uncertainties).fold(0.0, |size, (r, uncertainty)| libm::hypot(size, r * uncertainty));
    size / count(all.len()).sqrt()
}
