//! From the minimum to parameters with uncertainties.

use crate::statistics::count;
use nalgebra::{DMatrix, DVector};

use super::layout::Layout;
use super::linearised::Linearised;
use super::problem::Minimum;
use super::search::Search;
use super::{Autocorrelation, FittedTrace, Parameter, TraceFit, TraceFitError};
use super::{bootstrap, clock, huber, noise, pivot, profile, systematic};
use crate::measurement::Trace;

/// The fit with its uncertainties.
pub(super) fn fit(search: &mut Search<'_>, minimum: &Minimum) -> Result<TraceFit, TraceFitError> {
    let (free, traces) = (search.free(), search.traces);
    let described = |place: &usize| search.layout.described(*place, traces);
    let mut parameters: Vec<Parameter> = free.iter().map(described).collect();
    let response = response(&minimum.jacobian, &parameters)?;
    let covariance = &response * response.transpose();
    let mut shared = pivot::covariance(traces, minimum, &response);
    let all = search.unweighted(minimum);
    let degrees_of_freedom = all.len().saturating_sub(free.len()).max(1);
    let chi2 = all.iter().map(|residual| residual * residual).sum::<f64>() / count(degrees_of_freedom);
    let has_uncertainties = traces.iter().any(|trace| trace.uncertainties().is_some());
    let variance = match search.options.robust {
        true => huber::variance(&all, free.len()),
        false => chi2,
    };
    let variance = if has_uncertainties { variance.max(1.0) } else { variance };
    let series = split(&all, traces);
    let autocorrelation = Autocorrelation::of(&series);
    let linearised = match search.options.robust {
        true => without_weights(search, minimum, &all, &parameters)?,
        false => {
            Linearised { jacobian: minimum.jacobian.clone(), residuals: minimum.residuals.clone(), response }
        }
    };
    let block = (!autocorrelation.is_noise()).then(|| block(&autocorrelation, minimum, traces));
    let formal = (0..free.len()).map(|place| (variance * covariance[(place, place)]).sqrt());
    for (place, (parameter, formal)) in parameters.iter_mut().zip(formal).enumerate() {
        (parameter.value, parameter.formal_uncertainty) = (minimum.parameters[free[place]], formal);
    }
    heed_noise(&mut parameters, traces, &linearised, block);
    let independent_rows = independent_rows(&parameters, all.len());
    if search.options.profile {
        search.weights.clone_from(&minimum.weights);
        profile::intervals(search, minimum, &covariance, variance, &mut parameters)?;
    }
    let by_clock = clock::deviation(traces, parameters[0].value);
    shared[(0, 0)] += by_clock * by_clock;
    let mut correlations = correlations(&covariance);
    systematic::add(&mut parameters, &mut correlations, &shared);
    Ok(TraceFit {
        damping: search.layout.terms(),
        correlations,
        traces: fitted(search, &all),
        degrees_of_freedom,
        independent_rows,
        chi2_per_dof: has_uncertainties.then_some(chi2),
        rms: rms(search, &all),
        autocorrelation,
        bootstrap_block: block,
        converged: minimum.converged,
        unexplained: search.unexplained(minimum),
        standard_residuals: all,
        parameters,
    })
}

/// Uncertainties and intervals from the formal ones: by the noise, and by blocks of so many rows if that is more.
fn heed_noise(parameters: &mut [Parameter], traces: &[Trace], linearised: &Linearised, block: Option<usize>) {
    let lengths: Vec<usize> = traces.iter().map(Trace::len).collect();
    let rows = linearised.residuals.len();
    let correction = (count(rows) / count(rows.saturating_sub(parameters.len()).max(1))).sqrt();
    let by_blocks = block.map_or(vec![0.0; parameters.len()], |block| {
        bootstrap::deviations(&linearised.response, &linearised.residuals, &lengths, block)
    });
    let effects = noise::effects(traces, linearised);
    for ((parameter, effect), by_blocks) in parameters.iter_mut().zip(effects).zip(by_blocks) {
        let by_noise = parameter.formal_uncertainty * effect.inflation.sqrt();
        parameter.uncertainty = by_noise.max(by_blocks * correction);
        parameter.degrees_of_freedom = effect.degrees_of_freedom;
        parameter.intervals = profile::linear_intervals(parameter);
    }
}

/// The rows over the geometric mean of what the noise makes of the variances of the shared parameters.
fn independent_rows(parameters: &[Parameter], rows: usize) -> f64 {
    let shared = parameters.iter().filter(|parameter| parameter.trace.is_none());
    let logarithms: Vec<f64> = shared
        .map(|it| 2.0 * libm::log(it.uncertainty / it.formal_uncertainty))
        .filter(|x| x.is_finite())
        .collect();
    let mean = logarithms.iter().sum::<f64>() / count(logarithms.len().max(1));
    count(rows) / libm::exp(mean.max(0.0))
}

/// The problem that a robust one is in the limit of many rows: outliers are bounded there, and their rows have full weight, so
/// that the noise is the same in all.
fn without_weights(
    search: &Search<'_>,
    minimum: &Minimum,
    all: &[f64],
    parameters: &[Parameter],
) -> Result<Linearised, TraceFitError> {
    let mut jacobian = minimum.jacobian.clone();
    let stated = search.stated_weights().into_iter().flatten();
    let weights = minimum.weights.iter().flatten().zip(stated);
    for (mut row, (weight, stated)) in jacobian.row_iter_mut().zip(weights) {
        row *= stated / weight;
    }
    let response = response(&jacobian, parameters)?;
    Ok(Linearised { jacobian, residuals: DVector::from_vec(huber::bounded(all)), response })
}

/// The pseudo-inverse of the derivatives, by which parameters answer to residuals.
fn response(jacobian: &DMatrix<f64>, parameters: &[Parameter]) -> Result<DMatrix<f64>, TraceFitError> {
    let sizes: Vec<f64> = jacobian.column_iter().map(|column| column.norm()).collect();
    let factored = jacobian.clone().qr();
    let triangle = factored.r();
    for (place, size) in sizes.iter().enumerate() {
        // What is left of a column that the others span is rounding errors.
        if triangle[(place, place)].abs() <= 1e-11 * size || *size <= 0.0 {
            return Err(TraceFitError::Undetermined { parameter: parameters[place].name });
        }
    }
    let undetermined = TraceFitError::Undetermined { parameter: parameters[0].name };
    triangle.solve_upper_triangular(&factored.q().transpose()).ok_or(undetermined)
}

fn correlations(covariance: &DMatrix<f64>) -> Vec<Vec<f64>> {
    let deviation = |place: usize| covariance[(place, place)].sqrt();
    let correlation = |i: usize, j: usize| covariance[(i, j)] / (deviation(i) * deviation(j));
    let row =
        |i: usize| (0..covariance.ncols()).map(|j| if i == j { 1.0 } else { correlation(i, j) }).collect();
    (0..covariance.nrows()).map(row).collect()
}

/// A block holds one swing, and the longer the more there is to choose from.
fn block(autocorrelation: &Autocorrelation, minimum: &Minimum, traces: &[Trace]) -> usize {
    let longest = traces.iter().max_by_key(|trace| trace.len());
    let swing = longest.map_or(1, |trace| {
        let period = 2.0 * std::f64::consts::PI / minimum.parameters[Layout::OMEGA0];
        trace.times().partition_point(|&time| time < trace.times()[0] + period)
    });
    let rows = longest.map_or(1, Trace::len);
    let time = autocorrelation.time;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "it is below the number of rows"
    )]
    let grown = (time * libm::cbrt(count(rows) / time)) as usize;
    swing.max(grown).min(rows / 3).max(1)
}

/// A column cut into those of the traces.
fn split(column: &[f64], traces: &[Trace]) -> Vec<Vec<f64>> {
    let mut rest = column.iter().copied();
    traces.iter().map(|trace| rest.by_ref().take(trace.len()).collect()).collect()
}

/// What was seen less what should have been, from residuals in units of the uncertainties.
fn fitted(search: &Search<'_>, all: &[f64]) -> Vec<FittedTrace> {
    let scale = huber::scale(all);
    let one = |(trace, column): (&Trace, Vec<f64>)| {
        let uncertainty = |row: usize| trace.uncertainties().map_or(1.0, |uncertainties| uncertainties[row]);
        let residuals: Vec<f64> = column.iter().enumerate().map(|(row, r)| -r * uncertainty(row)).collect();
        let fitted =
            trace.values().iter().zip(&residuals).map(|(value, residual)| value - residual).collect();
        let outliers = (0..column.len()).filter(|&row| huber::is_outlier(column[row], scale)).collect();
        FittedTrace { begins: trace.times()[0], fitted, residuals, outliers }
    };
    search.traces.iter().zip(split(all, search.traces)).map(one).collect()
}

fn rms(search: &Search<'_>, all: &[f64]) -> f64 {
    let uncertainties = search.traces.iter().flat_map(|trace| {
        (0..trace.len()).map(|row| trace.uncertainties().map_or(1.0, |uncertainties| uncertainties[row]))
    });
    let size =
        all.iter().zip(uncertainties).fold(0.0, |size, (r, uncertainty)| libm::hypot(size, r * uncertainty));
    size / count(all.len()).sqrt()
}
