//! The branches to which slow sweeps jump where no known motion is stable.
//!
//! # Method
//! Beyond a fold the system leaves the motion that ended there. Where no branch has a stable motion, the equations are integrated from the fold on
//! until the motion repeats itself, as in an experiment; the branch through it is followed in both directions.

use super::branch::{Branch, Origin, Walked};
use super::jumps::{Jump, jumps};
use super::search::{Search, Start, middle};
use super::sweep::{SweepPoint, Sweeping};
use libration_motion::chaos::angles;

impl Search<'_> {
    /// The jumps of slow sweeps between branches.
    pub(super) fn jumps(&self, branches: &[Branch]) -> Vec<Jump> {
        jumps(branches, |space| self.corrector(space), self.width())
    }

    /// The branch of the motion to which the system settles beyond a fold; `None` if it is known, has another period, or is none.
    pub(super) fn landing_branch(&self, branches: &[Branch], jump: &Jump) -> Option<Walked> {
        let (value, start) = self.settled_beyond(jump)?;
        let start = self.corrected(value, &start)?;
        self.new_branch(branches, (value, &start), Origin::Jump)
    }

    /// The branch through a motion within the range, in both directions; `None` if it is known.
    pub(super) fn new_branch(
        &self,
        branches: &[Branch],
        (value, start): (f64, &Start),
        origin: Origin,
    ) -> Option<Walked> {
        if self.is_followed(branches, value, start) {
            return None;
        }
        let mut walked = self.both_ways(value, start).ok()??;
        walked.branch.origin = origin;
        Some(walked)
    }

    fn settled_beyond(&self, jump: &Jump) -> Option<(f64, Start)> {
        /// Distance from the fold, relative to the range: farther, a narrow branch would be missed; nearer, the motion hardly leaves the fold.
        const BEYOND: f64 = 1e-3;
        let beyond = BEYOND * self.width();
        let value = jump.from.parameter + if jump.rising { beyond } else { -beyond };
        if !(self.range[0]..=self.range[1]).contains(&value) {
            return None;
        }
        let swept = Sweeping { family: self.family, angles: angles(self.equation), done: 0 };
        let point = swept.settled(value, jump.from.state.clone())?;
        let SweepPoint { mut state, drive_periods, rotation, ranges, .. } = point;
        self.family.turning.subtract(&mut state, |coordinate| middle(ranges[coordinate]));
        let is_sought = drive_periods == Some(self.options.drive_periods) && rotation.is_none();
        is_sought.then(|| (value, Start { unknowns: state, space: self.space() }))
    }
}
