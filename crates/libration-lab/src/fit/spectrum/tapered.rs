//! The spectrum of a trace for display.

use std::f64::consts::TAU;

use super::lomb_scargle::{SpectrumPoint, lomb_scargle};
use crate::measurement::Trace;
use crate::statistics::{count, median};
use libration::internals::progress::Watch;
use libration::progress::Interrupted;

/// More swings make lines no narrower where the frequency drifts, and would take long.
const MOST_SWINGS: f64 = 60.0;
/// Longest time that a row represents, in usual intervals; it extends half way to the neighbours. With equal weights, rows about a gap of three
/// rows in 1200 caused a floor of half a per cent of the first harmonic, above the third.
const MOST_INTERVALS: f64 = 3.0;
/// Points in the width of a line, one over the time.
const OVERSAMPLING: f64 = 5.0;

/// Computes the periodogram of the first swings of a trace without its outliers, up to a frequency in Hz; rows are weighted by Hann's window, by
/// the time that they represent and by their uncertainties. Without that window the first harmonic of a few swings would hide the others.
pub(super) fn tapered(
    trace: &Trace,
    outliers: &[usize],
    period: f64,
    highest: f64,
    watch: &Watch<'_>,
) -> Result<Vec<SpectrumPoint>, Interrupted> {
    let all = trace.times();
    let rows = all.partition_point(|&time| time - all[0] <= MOST_SWINGS * period);
    let span = all[rows - 1] - all[0];
    let step = 1.0 / (OVERSAMPLING * span);
    let kept: Vec<usize> = (0..rows).filter(|row| outliers.binary_search(row).is_err()).collect();
    let intervals: Vec<f64> = kept.windows(2).map(|pair| all[pair[1]] - all[pair[0]]).collect();
    let longest = MOST_INTERVALS * median(intervals.clone()).unwrap_or(span);
    let weight = |index: usize| {
        let row = kept[index];
        let taper = 0.5 - 0.5 * libm::cos(TAU * (all[row] - all[0]) / span);
        let beside =
            [index.checked_sub(1), Some(index)].into_iter().flatten().filter_map(|side| intervals.get(side));
        let stands_for = (0.5 * beside.sum::<f64>()).min(longest);
        let uncertainty = trace.uncertainties().map_or(1.0, |column| column[row]);
        taper * stands_for / (uncertainty * uncertainty)
    };
    let weights: Vec<f64> = (0..kept.len()).map(weight).collect();
    let [times, values] =
        [all, trace.values()].map(|column| kept.iter().map(|&row| column[row]).collect::<Vec<f64>>());
    lomb_scargle(&times, &values, Some(&weights), step, points(highest / step), watch)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "five points for each of 60 swings and its harmonics"
)]
fn points(number: f64) -> usize {
    count(1_000_000).min(number.max(0.0)) as usize
}
