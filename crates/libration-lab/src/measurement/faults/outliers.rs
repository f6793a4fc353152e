//! Isolated values far off the cubic through their neighbours.

use super::steps::smallest_step;
use crate::statistics::{NORMAL_PER_MEDIAN_DEVIATION, count, lower_median};
use libration::internals::InOrder;
use std::ops::Range;

/// Number of robust standard deviations beyond which a value is an outlier: one in 5e8 of normal errors.
const THRESHOLD: f64 = 6.0;
/// Neighbours on either side that give the prediction.
const NEIGHBOURS: usize = 2;
/// Rows on either side that give the local error of the prediction. With 5 a video of 4502 frames had 11 outliers instead of 7, with 20 and 40 six,
/// and of 98 other recordings (`clock.rs`) one changed.
const SURROUNDINGS: usize = 10;
/// Extent of the neighbours, in usual intervals between them, above which they contain a gap and predict nothing. Four intervals of five with one
/// row missing are 1.25. With 1.6 and 3 nothing changed, with 1.1 that video had one outlier more.
const WIDEST: f64 = 1.3;
/// Maximum number of adjacent outliers. With 3 blocks of four and five rows, 260 standard deviations off, were not detected; with 6 nothing else
/// was called an outlier in 103 recordings, four of them next to the top. A longer block is a part of the recording.
pub const LONGEST: usize = 5;
/// Number of passes, in each of which one of several adjacent outliers is detected. With 2 and 30 nothing changed, with 1 one of four rows was
/// detected.
const PASSES: usize = 10;

/// The rows, single or up to [`LONGEST`] together, that are far off while their neighbours agree with each other
/// without these rows.
pub fn outliers(times: &[f64], values: &[f64]) -> Vec<usize> {
    let mut curve = Curve::new(times, values);
    let scales = curve.scales();
    for _ in 0..PASSES {
        let marked = curve.mark(&scales);
        if marked == 0 {
            break;
        }
    }
    (0..curve.is_marked.len()).filter(|&row| curve.is_marked[row]).collect()
}

/// The standard deviation of a value about the cubic through its neighbours.
pub(super) fn noise(times: &[f64], values: &[f64]) -> f64 {
    robust(Curve::new(times, values).deviations().into_iter().flatten().collect())
}

/// The standard deviation of normal deviations with the median of these.
fn robust(deviations: Vec<f64>) -> f64 {
    NORMAL_PER_MEDIAN_DEVIATION * lower_median(deviations).unwrap_or(0.0)
}

struct Curve<'a> {
    times: &'a [f64],
    values: &'a [f64],
    is_marked: Vec<bool>,
    /// The usual time between rows.
    interval: f64,
}

impl<'a> Curve<'a> {
    fn new(times: &'a [f64], values: &'a [f64]) -> Self {
        let interval = lower_median(times.windows(2).map(|pair| pair[1] - pair[0]).collect());
        Self { times, values, is_marked: vec![false; values.len()], interval: interval.unwrap_or(0.0) }
    }

    /// The unmarked rows nearest to this one on either side.
    fn neighbours(&self, row: usize) -> Option<[usize; 2 * NEIGHBOURS]> {
        let mut left = (0..row).rev().filter(|&row| !self.is_marked[row]);
        let mut right = (row + 1..self.values.len()).filter(|&row| !self.is_marked[row]);
        let (near_left, far_left) = (left.next()?, left.next()?);
        let (near_right, far_right) = (right.next()?, right.next()?);
        let usual = self.interval * count(far_right - far_left);
        let is_near = self.times[far_right] - self.times[far_left] <= WIDEST * usual;
        is_near.then_some([far_left, near_left, near_right, far_right])
    }

    /// Deviation of the value from the cubic through its neighbours, divided by the standard deviation that unit errors of all five cause.
    fn deviation(&self, row: usize) -> Option<f64> {
        let neighbours = self.neighbours(row)?;
        let weights = neighbours.map(|one| self.weight(row, one, &neighbours));
        let predicted: f64 = neighbours.iter().zip(weights).map(|(&one, w)| w * self.values[one]).sum();
        let gain: f64 = 1.0 + weights.iter().map(|weight| weight * weight).sum::<f64>();
        Some((self.values[row] - predicted).abs() / gain.sqrt())
    }

    /// Lagrange's polynomial of one neighbour at the time of the row.
    fn weight(&self, row: usize, one: usize, neighbours: &[usize]) -> f64 {
        let others = neighbours.iter().filter(|&&other| other != one).map(|&other| self.times[other]);
        others.map(|other| (self.times[row] - other) / (self.times[one] - other)).product()
    }

    fn deviations(&self) -> Vec<Option<f64>> {
        (0..self.values.len()).map(|row| self.deviation(row)).collect()
    }

    /// The expected standard deviation of each row: that of all rows or of the local ones, whichever is larger,
    /// combined with that of rounding to the steps of the scale.
    fn scales(&self) -> Vec<f64> {
        let deviations = self.deviations();
        let everywhere = robust(deviations.iter().copied().flatten().collect());
        let least = everywhere.max(smallest_step(self.values).unwrap_or(0.0) / 12_f64.sqrt());
        let around = |row: usize| {
            let from = row.saturating_sub(SURROUNDINGS);
            let to = deviations.len().min(row + SURROUNDINGS + 1);
            let others = (from..to).filter(|other| other.abs_diff(row) > NEIGHBOURS);
            robust(others.filter_map(|other| deviations[other]).collect()).max(least)
        };
        (0..deviations.len()).map(around).collect()
    }

    /// Marks the outliers that explain the rows beyond the threshold, the worst first; returns their number.
    fn mark(&mut self, scales: &[f64]) -> usize {
        let mut suspects: Vec<(usize, f64)> =
            (0..scales.len()).filter_map(|row| Some((row, self.excess(row, scales)?))).collect();
        suspects.put_in_order(|a, b| b.1.total_cmp(&a.1));
        let mut marked = 0;
        for (row, _) in suspects {
            let block = self.excess(row, scales).and_then(|_| self.explanation(row, scales));
            for outlier in block.into_iter().flatten() {
                self.is_marked[outlier] = true;
                marked += 1;
            }
        }
        marked
    }

    /// Deviation of a row that is not marked in multiples of the threshold; `None` up to 1.
    fn excess(&self, row: usize, scales: &[f64]) -> Option<f64> {
        let deviation = self.deviation(row).filter(|_| !self.is_marked[row])?;
        Some(deviation / (THRESHOLD * scales[row])).filter(|excess| *excess > 1.0)
    }

    /// The shortest isolated block of rows with or next to this one.
    fn explanation(&mut self, row: usize, scales: &[f64]) -> Option<Range<usize>> {
        let starts = |length: usize| row.saturating_sub(length)..=row + 1;
        let mut blocks =
            (1..=LONGEST).flat_map(|length| starts(length).map(move |start| start..start + length));
        blocks.find(|block| self.stands_alone(block.clone(), scales))
    }

    /// Returns `true` if every row of the block is far off its neighbours outside, and the nearest of these are not.
    fn stands_alone(&mut self, block: Range<usize>, scales: &[f64]) -> bool {
        if block.end > self.is_marked.len() || block.clone().any(|row| self.is_marked[row]) {
            return false;
        }
        self.is_marked[block.clone()].fill(true);
        let deviations =
            block.clone().map(|row| self.deviation(row).filter(|d| *d > THRESHOLD * scales[row]));
        let least = deviations.collect::<Option<Vec<f64>>>().and_then(|all| all.into_iter().reduce(f64::min));
        let neighbours = self.neighbours(block.start);
        // A third: with a half and two thirds the neighbours of outliers were taken for some in nine and 14 recordings, with a fifth three
        // of the outliers of two measured ones were not told.
        let agrees = |one: usize, least: f64| self.deviation(one).is_none_or(|other| other < least / 3.0);
        let stands_alone = least
            .zip(neighbours)
            .is_some_and(|(least, [_, left, right, _])| agrees(left, least) && agrees(right, least));
        self.is_marked[block].fill(false);
        stands_alone
    }
}
