//! The range of a motion in each component of its state.

use std::f64::consts::TAU;

/// The least and the greatest value of each component of the states so far.
#[derive(Clone, Debug)]
pub(super) struct Extent {
    ends: Vec<(f64, f64)>,
}

impl Extent {
    /// An empty range, before any state is included.
    pub(super) fn new(numbers: usize) -> Self {
        Self { ends: vec![(f64::INFINITY, f64::NEG_INFINITY); numbers] }
    }

    pub(super) fn include(&mut self, state: &[f64]) {
        for ((low, high), value) in self.ends.iter_mut().zip(state) {
            (*low, *high) = (low.min(*value), high.max(*value));
        }
    }

    /// The width of the range of each component.
    pub(super) fn widths(&self) -> Vec<f64> {
        self.ends.iter().map(|(low, high)| (high - low).max(0.0)).collect()
    }

    /// The largest magnitude of each component.
    pub(super) fn sizes(&self) -> Vec<f64> {
        self.ends.iter().map(|(low, high)| low.abs().max(high.abs())).collect()
    }

    /// The unit of each component: the width of its range, at most one turn for an angle; 1 if the component is constant.
    pub(super) fn units(&self, angles: &[bool]) -> Vec<f64> {
        let widths = self.widths().into_iter().zip(angles.iter().copied().chain(std::iter::repeat(false)));
        let units = widths.map(|(width, angle)| if angle { width.min(TAU) } else { width });
        units.map(|unit| if unit > 0.0 { unit } else { 1.0 }).collect()
    }
}
