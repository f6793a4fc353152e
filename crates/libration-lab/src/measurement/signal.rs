//! Passages of a pendulum in a continuous signal: dips of a light sensor, peaks of a magnetometer or of an accelerometer in the bob.
//!
//! # Method
//! The signal rests at a level, its median, and leaves it at each passage. The noise is the scatter of fourth differences, in which neither slopes nor
//! curvatures of a sampled swing remain. A stretch away from the level is a passage if its height is at least ten standard deviations of the
//! noise and a quarter of the largest height, and begins and ends where the signal has half of this height, between two rows by a straight line: the
//! middle between both moves neither with a slow drift nor with the height, which falls with the amplitude of the swing.

use crate::statistics::{NORMAL_PER_MEDIAN_DEVIATION, median};

/// Least height in standard deviations of the noise. Normal noise exceeds half of it in one of 3·10⁶ rows.
const LEAST_CLEARNESS: f64 = 10.0;

/// Least height as a fraction of the largest: peaks along the string of a pendulum fall to a quarter when its amplitude falls to half.
const LEAST_HEIGHT: f64 = 0.25;

/// Longest step between two rows with an edge between them, in median steps: a straight line does not bridge a gap.
const LONGEST_STEP: f64 = 3.0;

/// Least number of passages: two have no period.
const LEAST_PASSAGES: usize = 3;

/// The passages in a signal.
#[derive(Clone, Debug, PartialEq)]
pub struct SignalPassages {
    /// `true` for dips, `false` for peaks.
    pub are_dips: bool,
    /// The passages in the order of time.
    pub passages: Vec<SignalPassage>,
}

/// A stretch of a signal away from its level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SignalPassage {
    /// Times at which it begins and ends, at half of its height.
    pub edges: [f64; 2],
    /// Index of its highest row.
    pub row: usize,
}

impl SignalPassages {
    /// The passages in a signal at increasing times; `None` if fewer than three last for two rows or more and exceed the noise, or the numbers of
    /// times and values differ.
    #[must_use]
    pub fn in_signal(times: &[f64], values: &[f64]) -> Option<Self> {
        if times.len() != values.len() {
            return None;
        }
        let level = median(values.to_vec())?;
        let step = median(times.windows(2).map(|pair| pair[1] - pair[0]).collect())?;
        let smooth = without_spikes(values);
        let above: Vec<f64> = smooth.iter().map(|value| value - level).collect();
        let (peak, dip) =
            above.iter().fold((0.0_f64, 0.0_f64), |(up, down), &value| (up.max(value), down.max(-value)));
        let sign = if dip > peak { -1.0 } else { 1.0 };
        let signal = Signal {
            times,
            heights: above.iter().map(|height| sign * height).collect(),
            least: (LEAST_CLEARNESS * noise(values)).max(LEAST_HEIGHT * peak.max(dip)),
            longest_step: LONGEST_STEP * step,
        };
        let passages = if signal.least > 0.0 { signal.passages() } else { vec![] };
        // More rows that stand alone than passages are noise of another kind, or passages too short for the rows.
        let alone = |(value, smooth): &(&f64, &f64)| (*value - *smooth).abs() > 0.5 * signal.least;
        let is_seen = values.iter().zip(&smooth).filter(alone).count() <= passages.len();
        (is_seen && passages.len() >= LEAST_PASSAGES).then_some(Self { are_dips: dip > peak, passages })
    }
}

/// The median of each value and its neighbours: the value itself on a flank, without isolated wrong rows.
fn without_spikes(values: &[f64]) -> Vec<f64> {
    let middle = |[a, b, c]: [f64; 3]| a.max(b).min(a.min(b).max(c));
    let all = values.windows(3).map(|window| middle([window[0], window[1], window[2]]));
    let [first, last] = [values.first(), values.last()].map(Option::into_iter);
    let all: Vec<f64> = first.copied().chain(all).chain(last.copied()).collect();
    all[..values.len().min(all.len())].to_vec()
}

/// Standard deviation of the noise of neighbouring rows.
fn noise(values: &[f64]) -> f64 {
    /// Sum of the squares of 1, −4, 6, −4, 1.
    const VARIANCE: f64 = 70.0;
    let fourth = values
        .windows(5)
        .map(|window| (window[0] + window[4] - 4.0 * (window[1] + window[3]) + 6.0 * window[2]).abs());
    NORMAL_PER_MEDIAN_DEVIATION * median(fourth.collect()).unwrap_or(0.0) / VARIANCE.sqrt()
}

/// A signal as heights away from its level.
struct Signal<'a> {
    times: &'a [f64],
    heights: Vec<f64>,
    /// Least height of a passage.
    least: f64,
    longest_step: f64,
}

impl Signal<'_> {
    fn passages(&self) -> Vec<SignalPassage> {
        let is_away = |row: &usize| self.heights[*row] > 0.5 * self.least;
        let (mut passages, mut row) = (vec![], 0);
        while let Some(begin) = (row..self.heights.len()).find(is_away) {
            let end = (begin..self.heights.len()).find(|row| !is_away(row)).unwrap_or(self.heights.len());
            let highest =
                (begin..end).max_by(|&one, &other| self.heights[one].total_cmp(&self.heights[other]));
            passages.extend(highest.and_then(|row| self.passage(row)));
            row = end;
        }
        passages
    }

    /// The passage whose highest row is here; `None` if it is too low, or incomplete in the record.
    fn passage(&self, row: usize) -> Option<SignalPassage> {
        if self.heights[row] < self.least {
            return None;
        }
        let half = 0.5 * self.heights[row];
        let is_low = |row: &usize| self.heights[*row] < half;
        let before = (0..row).rev().find(is_low)?;
        let after = (row + 1..self.heights.len()).find(is_low)?;
        let edges = [self.crossing(before, before + 1, half)?, self.crossing(after, after - 1, half)?];
        Some(SignalPassage { edges, row })
    }

    /// The time of a height between a row below it and the row next to it.
    fn crossing(&self, below: usize, above: usize, height: f64) -> Option<f64> {
        let step = self.times[above] - self.times[below];
        let part = (height - self.heights[below]) / (self.heights[above] - self.heights[below]);
        (step.abs() <= self.longest_step).then_some(self.times[below] + part * step)
    }
}
