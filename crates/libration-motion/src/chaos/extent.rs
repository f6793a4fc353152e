//! How far a motion goes in each number of its state.

use std::f64::consts::TAU;

/// The least and the greatest value of each number of the states seen so far.
#[derive(Clone, Debug)]
pub(super) struct Extent {
    ends: Vec<(f64, f64)>,
}

impl Extent {
    /// Of nothing yet.
    pub(super) fn new(numbers: usize) -> Self {
        Self { ends: vec![(f64::INFINITY, f64::NEG_INFINITY); numbers] }
    }

    pub(super) fn include(&mut self, state: &[f64]) {
        for ((low, high), value) in self.ends.iter_mut().zip(state) {
            (*low, *high) = (low.min(*value), high.max(*value));
        }
    }

    /// How far apart the ends are.
    pub(super) fn widths(&self) -> Vec<f64> {
        self.ends.iter().map(|(low, high)| (high - low).max(0.0)).collect()
    }

    /// How far the numbers are from zero at most.
    pub(super) fn sizes(&self) -> Vec<f64> {
        self.ends.iter().map(|(low, high)| low.abs().max(high.abs())).collect()
    }

    /// What counts as one in each number: how far it goes, at most a turn in an angle; one where it stands still.
    pub(super) fn units(&self, angles: &[bool]) -> Vec<f64> {
        let widths = self.widths().into_iter().zip(angles.iter().copied().chain(std::iter::repeat(false)));
        let units = widths.map(|(width, angle)| if angle { width.min(TAU) } else { width });
        units.map(|unit| if unit > 0.0 { unit } else { 1.0 }).collect()
    }
}
