//! Further starts of a branch that is followed: beyond a change of the number of stops, and at other turning points of the last motion.

use super::branch::{Walk, size};
use super::corrector::Corrector;
use super::established::Milestone;
use super::family::TOLERANCES;
use super::node::Node;
use super::units::{difference, in_units};
use libration_motion::internals::periodic::{norm, turns_in};

impl Walk<'_> {
    /// The nearest node on the other side of a motion at which the number of stops of a force that jumps changes, with its distance: the branch
    /// is continuous there, but its direction is not, and next to it deviations have no derivatives.
    pub(super) fn across_change_of_stops(&self, units: &[f64]) -> Option<(Node, f64)> {
        /// Distances that are tried, in scaled units, from the shortest on: far enough for derivatives, near enough to skip little of the branch.
        const LENGTHS: [f64; 4] = [1e-6, 1e-5, 1e-4, 1e-3];
        /// Largest distance of the node relative to the step.
        const NEAR: f64 = 10.0;
        /// Largest angle between the directions on both sides.
        const TURN: f64 = 1.5;
        let last = self.at();
        if !self.corrector.family.has_jumps() {
            return None;
        }
        let tangent = in_units(&last.direction, units);
        let at = |length: f64| {
            let step = |j: usize| last.position()[j] + units[j] * length * tangent[j];
            let guess: Vec<f64> = (0..tangent.len()).map(step).collect();
            let corrected = self.corrector.corrected(&guess, &tangent, units)?;
            let is_near = norm(&difference(&corrected.position, last.position(), units)) <= NEAR * length;
            let node = is_near.then(|| Node::new(&self.corrector, corrected, &last.direction, units))??;
            let cosine: f64 = in_units(&node.direction, units).iter().zip(&tangent).map(|(a, b)| a * b).sum();
            (cosine >= libm::cos(TURN)).then_some((node, length))
        };
        LENGTHS.into_iter().find_map(at)
    }

    /// Continues with a node beyond the last one; the range between them is not resolved.
    pub(super) fn restart_at(&mut self, node: Node) {
        let [from, to] = [self.at(), &node].map(|node| node.point.parameter);
        self.unresolved.push([from.min(to), from.max(to)]);
        let at = self.milestones.last().map_or(0.0, |last| last.at);
        self.milestones = vec![Milestone { at, tests: node.tests }];
        self.largest = self.largest.max(self.corrector.family.largest_swing(&node.point));
        self.nodes.push(node);
    }

    /// Restarts the last motion at its turning point with the smallest error, if that error is far smaller, and returns `true` if it does. A
    /// canard, which follows a repelling part of the orbit for a while, can be followed from other points of the orbit only.
    pub(super) fn begin_elsewhere(&mut self, units: &[f64]) -> bool {
        const LESS: f64 = 0.01;
        /// Largest change of the parameter, relative to the range, and of the period by which it is still this motion.
        const SAME: f64 = 1e-6;
        let here = self.at().point.clone();
        let is_exact = LESS * here.error <= f64::EPSILON * size(&here);
        if is_exact || std::mem::replace(&mut self.restarted, self.nodes.len()) == self.nodes.len() {
            return false;
        }
        let width = self.limits.range[1] - self.limits.range[0];
        let is_this = |node: &Node| {
            (node.point.parameter - here.parameter).abs() <= SAME * width
                && (node.point.period - here.period).abs() <= SAME * here.period
        };
        let nodes = self.other_turns(units).unwrap_or_default().into_iter().filter(is_this);
        let best = nodes.min_by(|a, b| a.point.error.total_cmp(&b.point.error));
        let Some(node) = best.filter(|best| best.point.error < LESS * here.error) else { return false };
        let at = self.milestones.last().map_or(0.0, |last| last.at);
        self.milestones = vec![Milestone { at, tests: node.tests }];
        self.nodes.pop();
        self.nodes.push(node);
        true
    }

    /// The last motion, begun at each of its other turning points, if no drive sets the phase.
    fn other_turns(&self, units: &[f64]) -> Option<Vec<Node>> {
        let Corrector { family, space, .. } = self.corrector;
        let node = self.at();
        let (parameter, unknowns) = node.position().split_last()?;
        family.field()?;
        let duration = family.duration(space, unknowns, &[*parameter])?;
        let (steps, _) =
            family.motion(family.state(unknowns), &[*parameter], [0.0, duration], TOLERANCES[1]).ok()?;
        let numbers = family.layout.numbers();
        // The period and the parameter change along the branch in the same way for every starting point.
        let along: Vec<f64> =
            node.direction.iter().enumerate().map(|(j, x)| if j < numbers { 0.0 } else { *x }).collect();
        let from = |state: Vec<f64>| {
            let position: Vec<f64> =
                state.into_iter().chain(node.position()[numbers..].iter().copied()).collect();
            let corrected = self.corrector.corrected(&position, &in_units(&along, units), units)?;
            Node::new(&self.corrector, corrected, &along, units)
        };
        let turns = steps
            .iter()
            .flat_map(|owned| turns_in(owned, 0, 0.0, duration).into_iter().map(move |time| (owned, time)));
        Some(turns.filter_map(|(owned, time)| from(owned.step().state_at(time))).collect())
    }
}
