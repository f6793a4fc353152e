//! The rows of a trace within a time, measured from the centre.

use super::centre::Centre;
use crate::measurement::Trace;

/// A trace with the centre it swings about.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window<'a> {
    trace: &'a Trace,
    centre: &'a Centre,
}

impl<'a> Window<'a> {
    pub(super) fn new(trace: &'a Trace, centre: &'a Centre) -> Self {
        Self { trace, centre }
    }

    /// Time, value from the centre and standard deviation (relative to the noise) of the rows from one time to another.
    pub(super) fn rows(&self, from: f64, to: f64) -> impl Iterator<Item = (f64, f64, f64)> {
        let times = self.trace.times();
        let (first, end) = (times.partition_point(|&t| t < from), times.partition_point(|&t| t <= to));
        (first..end.max(first)).map(|row| {
            let deviation = self.trace.uncertainties().map_or(1.0, |column| column[row]);
            (times[row], self.trace.values()[row] - self.centre.at(times[row]), deviation)
        })
    }
}
