//! Rows out of the order of time: moved to their positions in time, left out, or the run divided if its clock was set back.

use super::super::choices::Finding;
use super::super::faults::order;
use crate::statistics::lower_median;

/// Smallest number of rows for each step back of a clock: a column that goes back more often is an angle, which goes back in half of them, or a
/// sorted column. With 15 one more of 99 recordings (`faults/clock.rs`) was put in order, with 30 one less.
const ROWS_PER_STEP_BACK: usize = 20;
/// Fewest usual intervals on either side of a row between two others to which it may be moved. With 0.2 and 0.45 nothing
/// changed; with 0.1 a wrong time had a position, with 0.6 that of a late row had none.
const ROOM: f64 = 0.4;

/// The rows of one recording in the order of time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sequence {
    /// One for each setting of the clock.
    pub pieces: Vec<Vec<usize>>,
    /// Rows moved to their positions in time.
    pub moved: Vec<usize>,
    /// Rows whose time has no position.
    pub left_out: Vec<usize>,
    /// The first rows after the clock was set back.
    pub cuts: Vec<usize>,
}

impl Sequence {
    /// The order of these times; the error is the first row that goes back, if too many do so for a clock.
    pub fn new(times: &[f64]) -> Result<Self, usize> {
        let back: Vec<usize> = (1..times.len()).filter(|&row| times[row] < times[row - 1]).collect();
        let Some(&first) = back.first() else {
            return Ok(Self { pieces: vec![(0..times.len()).collect()], ..Self::default() });
        };
        if back.len() * ROWS_PER_STEP_BACK > times.len() {
            return Err(first);
        }
        let mut sequence = Self { cuts: order::restarts(times), ..Self::default() };
        let mut start = 0;
        for end in sequence.cuts.clone().into_iter().chain([times.len()]) {
            let piece = sequence.arranged(times, start, end);
            sequence.pieces.push(piece);
            start = end;
        }
        Ok(sequence)
    }

    /// The rows of one piece in order.
    fn arranged(&mut self, times: &[f64], start: usize, end: usize) -> Vec<usize> {
        let piece = &times[start..end];
        let stray: Vec<usize> =
            order::out_of_order(piece, &order::repeated(piece)).iter().map(|row| start + row).collect();
        let mut rows: Vec<usize> = (start..end).filter(|row| stray.binary_search(row).is_err()).collect();
        let steps: Vec<f64> = rows.windows(2).map(|pair| times[pair[1]] - times[pair[0]]).collect();
        let room = ROOM * lower_median(steps).unwrap_or(0.0);
        for row in stray {
            let index = rows.partition_point(|&other| times[other] < times[row]);
            let is_far =
                |other: Option<&usize>| other.is_some_and(|&other| (times[other] - times[row]).abs() >= room);
            if index > 0 && is_far(rows.get(index - 1)) && is_far(rows.get(index)) {
                rows.insert(index, row);
                self.moved.push(row);
            } else {
                self.left_out.push(row);
            }
        }
        rows
    }

    /// The changes made, as findings; `lines` are those of the rows.
    pub(super) fn findings(&self, run: &str, lines: &[u64]) -> Vec<Finding> {
        let told = |rows: &[usize], what: &str| {
            let (first, more) = (lines[*rows.first()?], rows.len() - 1);
            let more = if more > 0 { format!(" and {more} more") } else { String::new() };
            Some(Finding::fact(format!("{run}line {first}{more}: {what}")))
        };
        let runs = self.pieces.len();
        let cut = format!("the time goes back and restarts: cut there into {runs} runs");
        [
            told(&self.moved, "the time is out of order: put where it belongs"),
            told(&self.left_out, "the time is out of order and belongs nowhere: left out"),
            told(&self.cuts, &cut),
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}
