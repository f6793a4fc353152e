//! The rows that count.

use std::borrow::Cow;

use super::data::Data;
use super::weights::Weights;
use crate::measurement::{Observable, Trace};
use crate::statistics::{count, mean};

/// Rows of one trace.
#[derive(Clone, Debug)]
pub(super) struct Series<'a> {
    pub(super) observable: Observable,
    pub(super) times: Cow<'a, [f64]>,
    pub(super) values: Cow<'a, [f64]>,
    /// By which residuals are multiplied.
    pub(super) weights: Cow<'a, [f64]>,
}

/// A search wants no more rows of a small period: of 24 recordings, with all models, those that some model describes ended as with all rows.
const ROWS_OF_A_SEARCH: f64 = 64.0;

impl Series<'_> {
    /// The largest part of the weighted scatter of the values that residuals leave in one of some parts of the rows.
    pub(super) fn worst_part(&self, residuals: &[f64]) -> f64 {
        /// A motion that is out of phase for a cycle or so in a part of it is not seen, and comes into phase again only with the right ω0.
        const PARTS: usize = 10;
        let rows = (residuals.len() / PARTS).max(1);
        let mean = mean(self.values.iter().copied());
        let of_part = |((residuals, values), weights): ((&[f64], &[f64]), &[f64])| {
            let left: f64 = residuals.iter().map(|residual| residual * residual).sum();
            let deviations = values.iter().zip(weights).map(|(value, weight)| (value - mean) * weight);
            left / deviations.map(|deviation| deviation * deviation).sum::<f64>()
        };
        let parts = residuals.chunks(rows).zip(self.values.chunks(rows)).zip(self.weights.chunks(rows));
        parts.map(of_part).fold(0.0, f64::max)
    }
}

/// All rows of all traces.
pub(super) fn whole<'a>(data: Data<'a>, weights: &'a Weights) -> Vec<Series<'a>> {
    thinned(data, &data.rows(), weights, f64::INFINITY)
}

/// The first rows of each trace, of those that a search over so much time wants, which are evenly chosen.
pub(super) fn of_search<'a>(
    data: Data<'a>,
    rows: &[usize],
    weights: &'a Weights,
    cycles: f64,
) -> Vec<Series<'a>> {
    thinned(data, rows, weights, ROWS_OF_A_SEARCH * cycles.max(1.0))
}

/// The weighted sum of squares about the mean of each trace.
pub(super) fn scatter(series: &[Series<'_>]) -> f64 {
    let of_one = |series: &Series<'_>| {
        let mean = mean(series.values.iter().copied());
        let deviations = series.values.iter().zip(series.weights.iter());
        let deviations = deviations.map(|(value, weight)| (value - mean) * weight);
        deviations.map(|deviation| deviation * deviation).sum::<f64>()
    };
    series.iter().map(of_one).sum()
}

/// Of the first rows of each trace every n-th, so that about so many are left and not fewer.
fn thinned<'a>(data: Data<'a>, rows: &[usize], weights: &'a Weights, wanted: f64) -> Vec<Series<'a>> {
    let every = |rows: usize| (1..).take_while(|&n| count(rows / n) >= wanted).last().unwrap_or(1);
    let one = |((trace, weights), &rows): ((&'a Trace, &'a [f64]), &usize)| {
        let n = every(rows);
        let part = |column: &'a [f64]| match n {
            1 => Cow::Borrowed(&column[..rows]),
            n => Cow::Owned(column[..rows].iter().step_by(n).copied().collect()),
        };
        Series {
            observable: trace.observable(),
            times: part(trace.times()),
            values: part(trace.values()),
            weights: part(weights),
        }
    };
    data.traces.iter().zip(weights.traces()).zip(rows).map(one).collect()
}
