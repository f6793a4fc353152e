//! Spacing of the times: the usual interval, the grid, gaps, and the effect of rounding.

use super::even_times::EvenTimes;
use super::grid::Grid;
use super::significant_digits::SignificantDigits;
use crate::statistics::{count, lower_median, mean, root_mean_square};

/// Spacing of the times of a table. Units are seconds.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Clock {
    /// The usual interval between two rows.
    pub interval: f64,
    /// The decimal step of all times, such as 0.001; `None` if there is none down to 1e-9.
    pub resolution: Option<f64>,
    /// Number of significant digits with which all times are written, where these limit them: the steps of rounding then grow with the times.
    pub significant_digits: Option<usize>,
    /// `true` if the times are written so coarsely that rows share them.
    pub shares_times: bool,
    /// Equally spaced times that differ from those written by at most two steps of their rounding, if there are any
    /// and the times are not equally spaced already.
    pub grid: Option<Grid>,
    /// The root mean square deviation of the intervals from the usual one, gaps aside.
    pub jitter: f64,
    /// Gaps where rows are missing.
    pub gaps: Vec<Gap>,
}

/// Missing rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// The row before it.
    pub after: usize,
    /// Duration of the gap in seconds.
    pub duration: f64,
    /// Approximate number of missing rows.
    pub missing: usize,
}

/// An interval beyond this many usual ones is a gap where the clock is even.
///
/// The numbers of how tables are read were varied over 99 recordings: six measured ones by cameras and an encoder, and 93 synthetic
/// ones, with missing rows, uneven clocks, rounded times, outliers, and rows out of order. With 1.4 clocks that are uneven by a sixth had
/// gaps, with 1.2 frames rounded to a third of their interval too; with 2.2 single rows that were missing were not.
const GAP: f64 = 1.6;
/// Intervals, in usual ones, above which there is a gap if the intervals vary. With 3 and 4 intervals that scatter like those of a phone,
/// exponentially, had 18 and 8 false gaps, with 5 two; with 10 eight missing rows were not detected.
const GAP_OF_UNEVEN_CLOCK: f64 = 5.0;
/// Relative variation of the intervals above which a clock is uneven. With 0.1 and 0.15 nothing changed; with 0.3 two more had false gaps, and that
/// phone a hundred.
const UNEVEN: f64 = 0.2;
/// Rounding relative to the interval below which it is not reported: as an error it is 0.3 % of the change in a row. With 0.03 and 0.1 three and
/// eight recordings, two of them by cameras, were no longer taken as equally spaced; with 0.003 one more was, of times with five digits.
const NEGLIGIBLE_ROUNDING: f64 = 0.01;

impl Clock {
    /// The clock of these times, of which the kept rows increase.
    pub(super) fn new(times: &[f64], kept: &[usize]) -> Option<Self> {
        let increasing: Vec<f64> = kept.iter().map(|&row| times[row]).collect();
        let interval = usual_interval(&increasing)?;
        let resolution = resolution(times);
        let within = intervals(&increasing).filter(|length| *length < GAP * interval);
        let jitter = root_mean_square(within.map(|length| length - interval));
        // Where times are written more coarsely than they follow each other, each row is one step. A tenth: with a fifth and a fortieth
        // nothing changed.
        let shares_times = times.len() - kept.len() > times.len() / 10 + 1;
        let digits = SignificantDigits::detect(times, resolution);
        let by_digits = digits.and_then(|digits| grid_of_digits(times, digits, interval));
        let significant_digits =
            digits.filter(|_| by_digits.is_some() || shares_times).map(|digits| digits.count);
        let by_rows = || grid(times, &(0..times.len()).collect::<Vec<_>>(), resolution);
        let by_times = || grid_of_increasing(times, kept, interval, resolution);
        let whole = by_digits.or_else(|| by_rows().filter(|_| shares_times && significant_digits.is_none()));
        let clock = Self {
            interval,
            resolution,
            significant_digits,
            shares_times,
            grid: None,
            jitter,
            gaps: Vec::new(),
        };
        if let Some(grid) = whole {
            let gaps = missing(&grid);
            return Some(Self { interval: grid.interval, grid: Some(grid), gaps, ..clock });
        }
        let grid = by_times().filter(|_| significant_digits.is_none());
        let gaps = gaps(&increasing, kept, interval, grid.is_none() && jitter > UNEVEN * interval);
        let interval = grid.as_ref().map_or(interval, |grid| grid.interval);
        Some(Self { interval, grid, gaps, ..clock })
    }

    /// Returns `true` if the intervals vary, and not by rounding.
    #[must_use]
    pub fn is_uneven(&self) -> bool {
        // What a reader is told. A twentieth of the interval is some millimetres of the path of a bob at 30 rows in a second.
        const WORTH_A_WORD: f64 = 0.05;
        self.grid.is_none() && self.significant_digits.is_none() && self.jitter > WORTH_A_WORD * self.interval
    }

    /// Root mean square error that the rounding of the times causes in values that change as these, of the kept rows.
    pub(super) fn rounding_noise(&self, kept: &[usize], values: &[f64]) -> Option<f64> {
        let grid = self.grid.as_ref()?;
        let intervals =
            kept.windows(2).map(|pair| grid.numbers[pair[1]].saturating_sub(grid.numbers[pair[0]]));
        let steps = values.windows(2).map(|pair| pair[1] - pair[0]).zip(intervals);
        let speeds = steps.map(|(step, ticks)| step / (grid.interval * count(ticks.max(1))));
        let noise = grid.rms_deviation * root_mean_square(speeds);
        noise.is_finite().then_some(noise)
    }
}

fn intervals(times: &[f64]) -> impl Iterator<Item = f64> {
    times.windows(2).map(|pair| pair[1] - pair[0])
}

/// The mean of the intervals near their median: rounded times have two or three different ones.
fn usual_interval(times: &[f64]) -> Option<f64> {
    let median = lower_median(intervals(times).collect()).filter(|_| times.len() > 2)?;
    // As far below the median as above it: with 0.6 clocks that are uneven by a sixth to a half had intervals too long by up to 7 %, with 0.2
    // too short by up to 11 %.
    let near = |length: &f64| (0.4 * median..GAP * median).contains(length);
    Some(mean(intervals(times).filter(near))).filter(|length| length.is_finite())
}

/// The decimal step of which all times are multiples, up to the rounding of their binary values.
fn resolution(times: &[f64]) -> Option<f64> {
    let steps = (0..=9).map(|decimals| 10_u32.pow(decimals)).map(f64::from);
    let is_whole = |value: f64| (value - value.round()).abs() <= 1e-9 + 4.0 * f64::EPSILON * value.abs();
    steps.into_iter().find(|scale| times.iter().all(|time| is_whole(time * scale))).map(|scale| 1.0 / scale)
}

/// The grid of times with a given number of significant digits: one step per row, or with gaps if early times, whose rounding is finer than the
/// interval, show gaps.
fn grid_of_digits(times: &[f64], digits: SignificantDigits, interval: f64) -> Option<Grid> {
    let half_steps: Vec<f64> = times
        .iter()
        .map(|&time| (0.5 * digits.step_at(time)).max(0.5 * NEGLIGIBLE_ROUNDING * interval))
        .collect();
    let rows: Vec<usize> = (0..times.len()).collect();
    // A tenth: with 0.03 and 0.4 nothing changed.
    let is_fine = |row: &usize| half_steps[*row] < 0.1 * (times[*row] - times[*row - 1]);
    let fine: Vec<f64> = (1..times.len()).filter(is_fine).map(|row| times[row] - times[row - 1]).collect();
    let seen = lower_median(fine).unwrap_or(interval);
    let mut tick = 0;
    let with_gaps: Vec<usize> = rows
        .iter()
        .map(|&row| {
            let steps =
                if row > 0 && is_fine(&row) { whole((times[row] - times[row - 1]) / seen).max(1) } else { 1 };
            tick += if row > 0 { steps } else { 0 };
            tick
        })
        .collect();
    let mut candidates = [rows, with_gaps].into_iter();
    let grid = candidates
        .find_map(|ticks| Some(EvenTimes::through(times, &ticks, &half_steps)?.grid(times, &ticks)))?;
    (grid.rms_deviation > NEGLIGIBLE_ROUNDING * grid.interval).then_some(grid)
}

/// Gaps in the positions of a grid.
fn missing(grid: &Grid) -> Vec<Gap> {
    let steps = grid.numbers.windows(2).map(|pair| pair[1].saturating_sub(pair[0])).enumerate();
    let gap = |(after, steps): (usize, usize)| Gap {
        after,
        duration: grid.interval * count(steps),
        missing: steps - 1,
    };
    steps.filter(|(_, steps)| *steps > 1).map(gap).collect()
}

/// The grid with gaps where intervals are several usual ones; the length of gaps needs an accurate interval,
/// which is first found from the stretches between them.
fn grid_of_increasing(times: &[f64], kept: &[usize], interval: f64, resolution: Option<f64>) -> Option<Grid> {
    let increasing: Vec<f64> = kept.iter().map(|&row| times[row]).collect();
    let better = slope_between_gaps(&increasing, interval);
    let mut tick = 0;
    let mut ticks = vec![0];
    for length in intervals(&increasing) {
        tick = whole(length / better).max(1).saturating_add(tick);
        ticks.push(tick);
    }
    let grid = grid(&increasing, &ticks, resolution)?;
    let numbers = times.iter().map(|time| whole((time - grid.first) / grid.interval)).collect();
    Some(Grid { numbers, ..grid })
}

/// The slope of the times against their row within stretches without gaps, all stretches together.
fn slope_between_gaps(times: &[f64], interval: f64) -> f64 {
    let (mut products, mut squares) = (0.0, 0.0);
    for stretch in times.chunk_by(|a, b| b - a < GAP * interval) {
        let middle = count(stretch.len() - 1) / 2.0;
        for (row, time) in stretch.iter().enumerate() {
            let from_middle = count(row) - middle;
            products += from_middle * (time - stretch[0]);
            squares += from_middle * from_middle;
        }
    }
    if squares > 0.0 { products / squares } else { interval }
}

/// The least-squares grid, if the times are on it up to their rounding, and not exactly.
fn grid(times: &[f64], ticks: &[usize], resolution: Option<f64>) -> Option<Grid> {
    let resolution = resolution?;
    let (x, t) = (mean(ticks.iter().map(|&number| count(number))), mean(times.iter().copied()));
    let moments = ticks.iter().zip(times).map(|(&number, time)| {
        let from_mean = count(number) - x;
        (from_mean * (time - t), from_mean * from_mean)
    });
    let (products, squares) = moments.fold((0.0, 0.0), |(a, b), (c, d)| (a + c, b + d));
    let interval = products / squares;
    let bounds = EvenTimes::through(times, ticks, &vec![0.5 * resolution; times.len()]);
    // Independent errors of rounding, for programs that add up rounded intervals.
    let usual = resolution / (12.0 * squares).sqrt();
    let interval_uncertainty = bounds.map_or(usual, |bounds| bounds.interval_uncertainty);
    let even = EvenTimes { first: interval.mul_add(-x, t), interval, interval_uncertainty };
    let even = even.grid(times, ticks);
    let (rms, largest_deviation) = (even.rms_deviation, even.largest_deviation);
    // Half a step of the rounding itself, √(1/12) in the mean square; programs that add up rounded intervals are off by more: with one step,
    // or half of one in the mean square, a video of 4502 frames was not even; with 4, and with 1, nothing changed. A tenth is exact
    // rounding of what is even already; with 0.2 nothing changed.
    let is_within = largest_deviation < 2.0 * resolution && rms < 0.7 * resolution;
    let is_worth_it = resolution > NEGLIGIBLE_ROUNDING * interval && rms > 0.1 * resolution;
    (interval > 0.0 && is_within && is_worth_it).then_some(even)
}

fn gaps(times: &[f64], kept: &[usize], interval: f64, is_uneven: bool) -> Vec<Gap> {
    let least = if is_uneven { GAP_OF_UNEVEN_CLOCK } else { GAP };
    let gap = |(row, duration): (usize, f64)| {
        let missing = whole(duration / interval).saturating_sub(1);
        Gap { after: kept[row], duration, missing }
    };
    intervals(times).enumerate().filter(|(_, length)| *length > least * interval).map(gap).collect()
}

/// The nearest whole number, zero at least.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the conversion saturates")]
fn whole(value: f64) -> usize {
    value.round() as usize
}
