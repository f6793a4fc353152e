//! Equally spaced times.

use crate::statistics::count;

/// Equally spaced times: `first + interval·numbers[row]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// The first time, in seconds.
    pub first: f64,
    /// The interval, in seconds.
    pub interval: f64,
    /// The standard uncertainty of the interval, from the rounding.
    pub interval_uncertainty: f64,
    /// The root mean square difference of the times as written from these, in seconds.
    pub rms_deviation: f64,
    /// The largest difference, in seconds.
    pub largest_deviation: f64,
    /// The position of each row on the grid, including rows out of order.
    pub numbers: Vec<usize>,
}

impl Grid {
    /// The even times, one for each row.
    #[must_use]
    pub fn times(&self) -> Vec<f64> {
        self.numbers.iter().map(|&number| self.interval.mul_add(count(number), self.first)).collect()
    }
}
