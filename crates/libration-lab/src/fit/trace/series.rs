//! The rows that count.

use std::borrow::Cow;

use super::data::Data;
use super::weights::Weights;
use crate::measurement::{Observable, Trace};
use crate::statistics::{count, mean};

/// Rows of one trace.
#[derive(Clone, Debug)]
pub struct Series<'a> {
    /// Kind of the values.
    pub observable: Observable,
    /// Times in seconds.
    pub times: Cow<'a, [f64]>,
    /// Measured values at these times.
    pub values: Cow<'a, [f64]>,
    /// Factors of the residuals.
    pub weights: Cow<'a, [f64]>,
}

/// Rows per period of small swings that a search uses: of 24 recordings, with all models, those that some model describes ended as with all rows.
const ROWS_OF_A_SEARCH: f64 = 64.0;

impl Series<'_> {
    /// The least correlation coefficient between the values and those of the fit, over parts of the rows. It does not depend on the
    /// amplitude: it is the cosine of the phase difference.
    pub fn least_correlation(&self, residuals: &[f64]) -> f64 {
        /// Number of parts: a motion that loses a cycle is out of phase for much of the trace before.
        const PARTS: usize = 10;
        let rows = (residuals.len() / PARTS).max(1);
        let missed = residuals.iter().zip(self.weights.iter()).map(|(residual, weight)| residual / weight);
        let fitted: Vec<f64> = self.values.iter().zip(missed).map(|(value, missed)| value + missed).collect();
        let parts = self.values.chunks(rows).zip(fitted.chunks(rows)).take(PARTS);
        parts.map(|(values, fitted)| correlation(values, fitted)).fold(1.0, f64::min)
    }
}

/// Coefficient of correlation of two columns; zero for columns without scatter.
fn correlation(one: &[f64], other: &[f64]) -> f64 {
    let [first, second] = [one, other].map(|column| mean(column.iter().copied()));
    let (mut product, mut squares) = (0.0, [0.0; 2]);
    for (one, other) in one.iter().zip(other) {
        let [one, other] = [one - first, other - second];
        product += one * other;
        squares[0] += one * one;
        squares[1] += other * other;
    }
    if squares[0] * squares[1] > 0.0 { product / (squares[0] * squares[1]).sqrt() } else { 0.0 }
}

/// All rows of all traces.
pub fn whole<'a>(data: Data<'a>, weights: &'a Weights) -> Vec<Series<'a>> {
    thinned(data, &data.rows(), weights, f64::INFINITY)
}

/// The first rows of each trace, thinned evenly to the number that a search over this many cycles uses.
pub fn of_search<'a>(data: Data<'a>, rows: &[usize], weights: &'a Weights, cycles: f64) -> Vec<Series<'a>> {
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

/// Every n-th of the first rows of each trace, so that at least about `wanted` are left.
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
