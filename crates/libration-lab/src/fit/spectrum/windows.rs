//! A trace as windows of a few swings.

use super::error::FEWEST_SWINGS;
use super::window_fit::{WindowRows, columns};
use crate::fit::cycles::Cycles;
use crate::measurement::Trace;
use crate::statistics::{count, median};

/// Least number of swings in a window relative to the wanted one: nearly ten swings are two windows of five.
const AT_LEAST: f64 = 0.9;
/// Least number of rows in a window, per coefficient.
const ROWS_PER_COEFFICIENT: f64 = 1.5;
/// Longest gap between rows, in periods, over which the phase can be followed.
const LONGEST_GAP: f64 = 1.5;

/// The windows of a trace, all of the same length.
#[derive(Clone, Debug)]
pub(super) struct Windows<'a> {
    trace: &'a Trace,
    /// Middle and period of each cycle that counts.
    cycles: Vec<(f64, f64)>,
    /// Number of windows.
    pub(super) count: usize,
    /// Number of swings in the trace.
    pub(super) swings: f64,
}

impl<'a> Windows<'a> {
    /// Divides a trace into windows of about this number of swings.
    pub(super) fn new(trace: &'a Trace, measured: &Cycles, swings_each: usize) -> Self {
        let kept = measured.cycles.iter().filter(|cycle| !cycle.outlier);
        let cycles: Vec<(f64, f64)> = kept.map(|cycle| (cycle.time, cycle.period.value)).collect();
        let period = median(cycles.iter().map(|cycle| cycle.1).collect()).unwrap_or(f64::INFINITY);
        let swings = span(trace) / period;
        let windows = whole(swings / (AT_LEAST * count(swings_each)));
        let windows = windows.min(whole(swings / count(FEWEST_SWINGS))).max(1);
        Self { trace, cycles, count: windows, swings }
    }

    /// The highest harmonic that the interval between rows allows: half an order below half the sampling rate, so that it is
    /// separated from its own alias.
    pub(super) fn highest_sampled(&self) -> usize {
        let steps = self.trace.times().windows(2).map(|pair| pair[1] - pair[0]).collect();
        let step = median(steps).unwrap_or(f64::INFINITY);
        let shortest = self.cycles.iter().map(|cycle| cycle.1).fold(f64::INFINITY, f64::min);
        whole(0.5 * shortest / step - 0.5)
    }

    /// The rows of a window, if there are enough of them and enough cycles.
    pub(super) fn rows(&self, number: usize, highest: usize) -> Option<WindowRows<'a>> {
        let times = self.trace.times();
        let width = span(self.trace) / count(self.count);
        let ends = [0, 1].map(|end| times[0] + width * count(number + end));
        let first = times.partition_point(|&time| time < ends[0]);
        let is_last = number + 1 == self.count;
        let end = if is_last { times.len() } else { times.partition_point(|&time| time < ends[1]) };
        let (within, periods) = self.cycles_between(ends);
        let period = median(periods)?;
        let rows = first..end;
        let needed = ROWS_PER_COEFFICIENT * count(columns(highest));
        // A cycle begins with each passage, upwards and downwards: there are about twice as many less three.
        let is_covered = count(within) >= width / period - 1.0;
        if count(rows.len()) < needed
            || !is_covered
            || longest_gap(&times[rows.clone()], ends) > LONGEST_GAP * period
        {
            return None;
        }
        Some(WindowRows {
            first,
            times: &times[rows.clone()],
            values: &self.trace.values()[rows.clone()],
            uncertainties: self.trace.uncertainties().map(|column| &column[rows]),
            observable: self.trace.observable(),
            ends,
            period,
            highest,
        })
    }

    fn cycles_between(&self, ends: [f64; 2]) -> (usize, Vec<f64>) {
        let within = self.cycles.iter().filter(|cycle| ends[0] <= cycle.0 && cycle.0 <= ends[1]);
        let periods: Vec<f64> = within.map(|cycle| cycle.1).collect();
        (periods.len(), periods)
    }
}

fn span(trace: &Trace) -> f64 {
    trace.times()[trace.len() - 1] - trace.times()[0]
}

fn longest_gap(times: &[f64], ends: [f64; 2]) -> f64 {
    let with_ends: Vec<f64> = [ends[0]].into_iter().chain(times.iter().copied()).chain([ends[1]]).collect();
    with_ends.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a count of swings or harmonics, cut down"
)]
fn whole(number: f64) -> usize {
    number.clamp(0.0, 1e6) as usize
}
