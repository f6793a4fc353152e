//! Faults of instruments in a column of times and values, detected before any fit.
//!
//! Nothing is repaired in silence: each fault is a list of rows, counted from zero, and a sentence for people.
//! Rows whose time is not after the one before are to be left out ([`Faults::left_out`]), since a trace needs
//! increasing times; everything else is only marked.

pub(crate) mod clipping;
mod clock;
pub(crate) mod even_times;
mod grid;
pub(crate) mod order;
pub(crate) mod outliers;
mod sentences;
pub(crate) mod significant_digits;
mod steps;

pub use clipping::Plateau;
pub use clock::{Clock, Gap};
pub use grid::Grid;

/// The faults of a column of times in seconds and a column of values.
///
/// # Examples
/// ```
/// use libration_lab::measurement::Faults;
/// let times = [0.0, 0.1, 0.2, 0.2, 0.5, 0.6, 0.7, 0.8];
/// let values = [0.50, 0.45, 0.35, 0.35, -0.10, -0.25, -0.35, -0.45];
/// let faults = Faults::detect(&times, &values, None);
/// assert_eq!((faults.repeated.as_slice(), faults.left_out().as_slice()), ([3].as_slice(), [3].as_slice()));
/// assert_eq!(faults.clock.as_ref().map(|clock| clock.gaps[0].missing), Some(2));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Faults {
    /// Rows with the time of the row before.
    pub repeated: Vec<usize>,
    /// Rows whose times go backwards: the smallest set without which all times increase.
    pub out_of_order: Vec<usize>,
    /// Rows at which the times begin again: several runs in one table. All other faults are those of the first run.
    pub restarts: Vec<usize>,
    /// Spacing of the times; `None` for fewer than three rows.
    pub clock: Option<Clock>,
    /// Root mean square error of the values from the rounding of the times, in their unit.
    pub rounding_noise: Option<f64>,
    /// Values that stay constant while the motion goes on: repeated frames, a sensor that hangs.
    pub stuck: Vec<Plateau>,
    /// Runs of rows at the largest or smallest value, cut off where the sensor ends.
    pub clipped: Vec<Plateau>,
    /// Rows before which the value jumps by a whole turn.
    pub wraps: Vec<usize>,
    /// Isolated rows, or small groups, far off the smooth curve through their neighbours.
    pub outliers: Vec<usize>,
}

impl Faults {
    /// The faults of these columns, row for row; `turn` is a whole turn in the unit of the values, if they are
    /// angles that may jump by it.
    ///
    /// Outliers are recognised by the cubic through two neighbours on either side: the rows at both ends and those
    /// next to gaps are not judged.
    #[must_use]
    pub fn detect(times: &[f64], values: &[f64], turn: Option<f64>) -> Self {
        let restarts = order::restarts(times);
        let rows = restarts.first().copied().unwrap_or(times.len()).min(values.len());
        let (times, values) = (&times[..rows], &values[..rows]);
        let repeated = order::repeated(times);
        let out_of_order = order::out_of_order(times, &repeated);
        let mut faults = Self { repeated, out_of_order, restarts, ..Self::default() };
        faults.look_closer(times, values, turn);
        faults
    }

    /// Infers further faults from the rows whose times increase.
    fn look_closer(&mut self, times: &[f64], values: &[f64], turn: Option<f64>) {
        let left_out = self.left_out();
        let kept: Vec<usize> = (0..times.len()).filter(|row| left_out.binary_search(row).is_err()).collect();
        let rows_of_table = |rows: Vec<usize>| rows.into_iter().map(|row| kept[row]).collect::<Vec<_>>();
        let times_of: Vec<f64> = kept.iter().map(|&row| times[row]).collect();
        let values_of: Vec<f64> = kept.iter().map(|&row| values[row]).collect();
        self.wraps = rows_of_table(wraps(&values_of, turn));
        let smooth = turn.map_or_else(|| values_of.clone(), |turn| unwrapped(&values_of, turn));
        self.clock = Clock::new(times, &kept);
        self.rounding_noise = self.clock.as_ref().and_then(|clock| clock.rounding_noise(&kept, &smooth));
        let runs = |plateaus: Vec<Plateau>| {
            plateaus.into_iter().map(|run| Plateau { first: kept[run.first], ..run }).collect::<Vec<_>>()
        };
        self.stuck = runs(clipping::stuck(&smooth, outliers::noise(&times_of, &smooth)));
        self.clipped = runs(clipping::clipped(&smooth));
        self.outliers = rows_of_table(outliers::outliers(&times_of, &smooth));
    }

    /// The rows without which the times increase, in order.
    #[must_use]
    pub fn left_out(&self) -> Vec<usize> {
        let mut rows = [self.repeated.as_slice(), &self.out_of_order].concat();
        rows.sort_unstable();
        rows
    }

    /// Returns `true` if there is nothing to report.
    #[must_use]
    pub fn is_clean(&self) -> bool {
        self.sentences(&[], "").is_empty()
    }
}

/// The rows before which the value jumps by more than half a turn.
fn wraps(values: &[f64], turn: Option<f64>) -> Vec<usize> {
    let Some(turn) = turn else { return Vec::new() };
    let jumps = |row: &usize| (values[*row] - values[row - 1]).abs() > turn / 2.0;
    (1..values.len()).filter(jumps).collect()
}

/// The values without jumps of whole turns, beginning with the first value as it is.
///
/// Right where the true value changes by less than half a turn from row to row.
#[must_use]
pub fn unwrapped(values: &[f64], turn: f64) -> Vec<f64> {
    let mut turns = 0.0;
    let mut before: Option<f64> = None;
    let next = |&value: &f64| {
        turns -= before.map_or(0.0, |before| ((value - before) / turn).round());
        before = Some(value);
        turn.mul_add(turns, value)
    };
    values.iter().map(next).collect()
}
