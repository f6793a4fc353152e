//! The traces that are fitted, and the number of rows that count.

use super::TraceFitError;
use crate::fit::cycles;
use crate::measurement::Trace;

/// At least one trace, of angles or of velocities that a pendulum can have.
#[derive(Clone, Copy, Debug)]
pub struct Data<'a> {
    pub(super) traces: &'a [Trace],
}

impl<'a> Data<'a> {
    /// Checks that traces have enough rows for this number of parameters.
    pub(super) fn new(traces: &'a [Trace], parameters: usize) -> Result<Self, TraceFitError> {
        if traces.is_empty() {
            return Err(TraceFitError::NoTrace);
        }
        if let Some(beyond) = traces.iter().find_map(cycles::beyond_a_turn) {
            return Err(beyond.into());
        }
        if let Some([first, second]) = same_rows(traces) {
            let [first, second] = [first, second].map(|trace| trace.name().to_owned());
            return Err(TraceFitError::SameRows { first, second });
        }
        let needed = 2 * parameters / traces.len() + 4;
        match traces.iter().find(|trace| trace.len() < needed) {
            Some(trace) => {
                let (name, rows) = (trace.name().to_owned(), trace.len());
                Err(TraceFitError::TooFewRows { name, rows, parameters, needed })
            }
            None => Ok(Self { traces }),
        }
    }

    /// Number of rows of each trace.
    pub(super) fn rows(&self) -> Vec<usize> {
        self.traces.iter().map(Trace::len).collect()
    }

    /// Number of rows of each trace within this time of the first; at least `least`, or all if there are fewer.
    pub(super) fn rows_within(&self, span: f64, least: usize) -> Vec<usize> {
        let within = |trace: &Trace| trace.times().partition_point(|&time| time <= trace.times()[0] + span);
        self.traces.iter().map(|trace| within(trace).max(least.min(trace.len()))).collect()
    }

    /// The time from the first row to the last of the longest trace.
    pub(super) fn span(&self) -> f64 {
        let span = |trace: &Trace| trace.times()[trace.len() - 1] - trace.times()[0];
        self.traces.iter().map(span).fold(0.0, f64::max)
    }
}

/// Two traces with the same times and values: no instrument writes the same noise twice.
fn same_rows(traces: &[Trace]) -> Option<[&Trace; 2]> {
    let same = |one: &Trace, other: &Trace| one.times() == other.times() && one.values() == other.values();
    let pairs = (0..traces.len()).flat_map(|second| (0..second).map(move |first| [first, second]));
    pairs.map(|pair| pair.map(|index| &traces[index])).find(|[one, other]| same(one, other))
}
