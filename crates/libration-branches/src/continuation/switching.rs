//! Secondary branches, from symmetry breaking and period doubling.

use super::branch::{Branch, FIRST, Limits, Origin, Walk, Walked};
use super::description::squared;
use super::node::Node;
use super::point::BranchPoint;
use super::search::Search;
use super::space::{Rotation, Space};
use super::special::{SpecialKind, SpecialPoint};
use libration_numbers::algebra::Doubles;
use libration_numbers::internals::linear::null_space;

/// A secondary branch at its branch point.
pub(super) struct Leaving {
    origin: Origin,
    space: Space,
    /// The space of the primary branch.
    primary: Space,
    node: Node,
}

impl Search<'_> {
    /// Returns `true` if a secondary branch was already followed from elsewhere to this branch point.
    pub(super) fn is_met(&self, start: &Leaving, space: Space, parameter: f64) -> bool {
        /// Largest difference relative to the range, within the error of the interpolation.
        const SAME: f64 = 1e-3;
        let off = (start.node.point.parameter - parameter).abs();
        start.space.drive_periods() == space.drive_periods() && off <= SAME * self.width()
    }

    /// The secondary branches of a branch.
    pub(super) fn leaving(&self, walked: &Walked, generation: usize) -> Vec<(usize, Leaving)> {
        if generation >= self.options.generations {
            return vec![];
        }
        let is_mirrored = walked.branch.space.mirrored;
        let origin = |kind: SpecialKind| match kind {
            SpecialKind::SymmetryBreaking if is_mirrored => Some(Origin::SymmetryBreaking),
            SpecialKind::PeriodDoubling => Some(Origin::PeriodDoubling),
            _ => None,
        };
        let (primary, space) = (walked.branch.space, walked.branch.space.doubled());
        let leaving = |(special, node): &(SpecialPoint, Node)| {
            Some((
                generation + 1,
                Leaving { origin: origin(special.kind)?, space, primary, node: node.clone() },
            ))
        };
        walked.specials.iter().filter_map(leaving).collect()
    }

    /// The secondary branch, along the deviation that the map turns into its opposite.
    pub(super) fn switched(&self, leaving: &Leaving) -> Option<Walked> {
        /// Initial distances in scaled units, in the order of the trials: far enough from the primary branch to determine
        /// the side, and nearer if a motion is not found there, as on cycles of many turns, whose maps bend strongly.
        const ASIDE: [f64; 9] = [1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6];
        ASIDE.into_iter().find_map(|aside| self.switched_aside(leaving, aside))
    }

    fn switched_aside(&self, leaving: &Leaving, distance: f64) -> Option<Walked> {
        let turned = |(i, row): (usize, &Vec<f64>)| {
            row.iter().enumerate().map(|(j, x)| if i == j { x + 1.0 } else { *x }).collect()
        };
        let matrix: Vec<Vec<f64>> =
            leaving.node.corrected.image.return_map().iter().enumerate().map(turned).collect();
        let vector = null_space(&Doubles, |x| x.abs(), &matrix, 1)?.pop()?;
        let parent = &leaving.node.point;
        let sizes = self.family.units(parent, self.family.largest_swing(parent), self.width());
        let largest = vector.iter().zip(&sizes).map(|(x, unit)| (x / unit).abs()).fold(0.0, f64::max);
        let mut aside: Vec<f64> = vector.iter().map(|x| distance * x / largest).collect();
        aside.resize(sizes.len(), 0.0);
        let position: Vec<f64> = leaving.node.position().iter().zip(&aside).map(|(x, d)| x + d).collect();
        let start = Node::near(&self.corrector(leaving.space), &position, [&aside, &aside], self.width())?;
        let (value, unknowns) = start.position().split_last()?;
        if self.belongs_to(leaving.primary, unknowns, *value) {
            return None;
        }
        let space = self.smallest(leaving.space, unknowns, *value);
        /// Largest growth of deviations in a period up to which doubled periods, and long ones, are followed: farther on, and on the branches that
        /// leave them, motions are unstable, and each takes twice the work of the one before. A pendulum with a torque and a drive has 3000 points
        /// where the growth in four periods goes from 1e6 to 4e10.
        const SENSITIVE: [f64; 2] = [1e6, 1e3];
        const LONG: u32 = 8;
        let largest_growth = match leaving.origin {
            Origin::PeriodDoubling => SENSITIVE[usize::from(space.drive_periods() >= LONG)],
            _ => f64::INFINITY,
        };
        let limits =
            Limits { largest_growth, initial_step: FIRST.min(2.0 * distance), ..self.limits(&start, space) };
        let mut walked = Walk::new(self.corrector(space), limits, start).walked(leaving.origin);
        walked.branch.begin_with(leaving.node.point.clone());
        Some(walked)
    }
}

impl Branch {
    /// Puts the branch point first, as a motion of twice the period, whose multipliers are the squares.
    fn begin_with(&mut self, point: BranchPoint) {
        let is_doubled = self.origin == Origin::PeriodDoubling;
        let (period, rotation) = (2.0 * point.period, point.rotation.map(Rotation::doubled));
        let with_errors = point.multipliers.iter().copied().zip(point.multiplier_errors.iter().copied());
        let multipliers = with_errors.map(squared).collect();
        let doubled = BranchPoint { period, rotation, ..point.clone() }.with_multipliers(multipliers);
        self.points.insert(0, if is_doubled { doubled } else { point });
        self.special.iter_mut().for_each(|special| special.before += 1);
    }
}
