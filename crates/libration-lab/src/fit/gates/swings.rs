//! Passages in order, the cycles among them, and the results that need no amplitude.

use super::directions::Placed;
use crate::statistics::median;

/// Passages in order, and the cycles among them: three passages of alternating sides without a gap, by the first one.
pub(super) struct OrderedPassages {
    pub(super) placed: Vec<Placed>,
    pub(super) cycles: Vec<usize>,
}

impl OrderedPassages {
    pub(super) fn new(placed: Vec<Placed>) -> Self {
        let whole = |k: &usize| {
            let [first, between, last] = [0, 1, 2].map(|step| placed[*k + step]);
            first.side == last.side && first.turn + 1 == last.turn && between.side != first.side
        };
        let cycles = (0..placed.len().saturating_sub(2)).filter(whole).collect();
        Self { placed, cycles }
    }

    pub(super) fn time(&self, passage: usize) -> f64 {
        self.placed[passage].passage.time
    }

    pub(super) fn period(&self, cycle: usize) -> f64 {
        self.time(cycle + 2) - self.time(cycle)
    }

    /// The fraction of a period from the first side to the other.
    pub(super) fn part_between(&self) -> f64 {
        let first_side = self.cycles.iter().filter(|&&cycle| self.placed[cycle].side == 0);
        let part = |cycle: &usize| (self.time(cycle + 1) - self.time(*cycle)) / self.period(*cycle);
        median(first_side.map(part).collect()).unwrap_or(f64::NAN)
    }

    /// Sign of the gate's angle in the direction of the motion at a passage, for a gate on the side to which those of the first side go.
    pub(super) fn direction(&self, passage: usize) -> f64 {
        if self.placed[passage].side == 0 { 1.0 } else { -1.0 }
    }

    /// Time of the middle passage of a cycle after the mean of the first and the last one.
    pub(super) fn unevenness(&self, cycle: usize) -> f64 {
        self.time(cycle + 1) - 0.5 * (self.time(cycle) + self.time(cycle + 2))
    }

    /// The duration for which a passage blocks the gate.
    pub(super) fn blocked(&self, passage: usize) -> Option<f64> {
        self.placed[passage].passage.blocked
    }

    /// Means of the periods of both sides, in which the position of the gate cancels, with their times.
    pub(super) fn mean_periods(&self) -> (Vec<f64>, Vec<f64>) {
        let neighbours = self.cycles.windows(2).filter(|pair| pair[0] + 1 == pair[1]);
        let mean = |pair: &[usize]| {
            let time = 0.5 * (self.time(pair[0] + 1) + self.time(pair[1] + 1));
            (time, 0.5 * (self.period(pair[0]) + self.period(pair[1])))
        };
        neighbours.map(mean).unzip()
    }
}
