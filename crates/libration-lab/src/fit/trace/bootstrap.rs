//! Block bootstrap of the uncertainties where residuals are not noise, and the formal ones are too small.
//!
//! Residuals are resampled in blocks that begin at random rows (H. R. Künsch, Ann. Statist. 17, 1217 (1989),
//! doi:10.1214/aos/1176347265), so that within a block their correlation is kept. The parameters respond linearly,
//! by the pseudo-inverse of the derivatives.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};

use super::Autocorrelation;
use super::layout::Layout;
use super::minimum::TraceMinimum;
use super::random::Random;
use crate::measurement::Trace;
use crate::statistics::count;

/// Number of replicas, which gives the standard deviation to 1/√1000, or 3 %.
const REPLICAS: usize = 500;

/// Number of rows in a block, at least one swing; it grows with the correlation time of the residuals and with the number of rows.
pub(super) fn block(autocorrelation: &Autocorrelation, minimum: &TraceMinimum, traces: &[Trace]) -> usize {
    let Some(longest) = traces.iter().max_by_key(|trace| trace.len()) else { return 1 };
    let end = longest.times()[0] + TAU / minimum.parameters[Layout::OMEGA0];
    let swing = longest.times().partition_point(|&time| time < end);
    let (rows, time) = (longest.len(), autocorrelation.time);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "it is below the number of rows"
    )]
    let grown = (time * libm::cbrt(count(rows) / time)) as usize;
    swing.max(grown).min(rows / 3).max(1)
}

/// The standard deviation of each parameter over replicas; `response` has a row for each parameter, and `lengths` are
/// those of the series of residuals.
pub(super) fn deviations(
    response: &DMatrix<f64>,
    residuals: &DVector<f64>,
    lengths: &[usize],
    block: usize,
) -> Vec<f64> {
    let mut random = Random::new(1);
    let mut sums = vec![[0.0; 2]; response.nrows()];
    let mut drawn = DVector::zeros(residuals.len());
    for _ in 0..REPLICAS {
        let mut first = 0;
        for &length in lengths {
            let series = residuals.rows(first, length);
            fill(drawn.rows_mut(first, length).as_mut_slice(), series.as_slice(), block, &mut random);
            first += length;
        }
        let answer = response * &drawn;
        for (sum, answer) in sums.iter_mut().zip(answer.iter()) {
            sum[0] += answer;
            sum[1] += answer * answer;
        }
    }
    let replicas = count(REPLICAS);
    sums.iter()
        .map(|[sum, squares]| ((squares - sum * sum / replicas) / (replicas - 1.0)).max(0.0).sqrt())
        .collect()
}

/// Fills the slice with random blocks of the series, concatenated.
fn fill(sample: &mut [f64], series: &[f64], block: usize, random: &mut Random) {
    let block = block.clamp(1, series.len().max(1));
    for part in sample.chunks_mut(block) {
        let first = random.below(series.len() - part.len() + 1);
        part.copy_from_slice(&series[first..first + part.len()]);
    }
}
