//! Steps in which large terms cancel.
//!
//! The series of (1 − t/10)¹⁰ is finite, and no coefficient limits the step; but the terms are a thousand times as large as their sum, and so
//! are their rounding errors. Such motions occur where a power tends to zero.

use super::stepper::{Stepper, unit_for};
use crate::taylor::step::largest_change::largest_change;

/// Largest size of the terms relative to the change of a component: for sines it is at most 15 in steps to 1e-15.
const MOST: f64 = 32.0;

impl<const N: usize> Stepper<'_, N> {
    /// The end of a step, or an earlier time, so that the error by cancellation is small.
    pub(in crate::taylor) fn end_before_cancellation(&mut self, lane: usize, end: f64) -> f64 {
        const HALVINGS: usize = 64;
        let start = self.block.start[lane];
        let ends = std::iter::successors(Some(end), |end| Some(start + 0.5 * (end - start)));
        let mut ends = ends.take(HALVINGS);
        let units = |end: f64| (end - start) / self.block.unit[lane];
        let nearer = ends.find(|&end| !self.cancels(lane, units(end))).unwrap_or(end);
        if (nearer - end).abs() > 0.0 {
            self.unit[lane] = unit_for((nearer - start).abs());
        }
        nearer
    }

    /// Returns `true` if cancellation occurs in a step of this length, in units of the block.
    fn cancels(&self, lane: usize, length: f64) -> bool {
        const LOOKS: [f64; 4] = [0.25, 0.5, 0.75, 1.0];
        let layout = self.block.layout();
        (0..layout.numbers()).any(|number| {
            let series = self.block.series(number);
            let way = |part: f64| {
                let time = part * length;
                series[1..].iter().rev().fold(0.0, |sum, c| (sum + c[lane]) * time).abs()
            };
            let held = if layout.is_velocity(number) { series[0][lane].abs() } else { 0.0 };
            let size = LOOKS.map(way).into_iter().fold(held, f64::max);
            largest_change(series, lane, length) > MOST * size
        })
    }
}
