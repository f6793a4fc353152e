//! A branch of periodic motions, followed from a point on it.

use super::corrector::Corrector;
use super::established::{Milestone, is_established};
use super::node::{Node, Tests, between};
use super::point::BranchPoint;
use super::space::Space;
use super::special::{Meeting, SpecialKind, SpecialPoint, Stretch};
use super::units::{difference, in_units};
use libration_motion::internals::periodic::norm;
use libration_motion::orbit::Stability;
use libration_numbers::internals::algebra::InOrder;
use libration_numbers::roots::{Tolerance, bisect};

/// A branch of periodic orbits over one parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// Origin of the branch.
    pub origin: Origin,
    /// Space of the orbits: their period and symmetry.
    pub space: Space,
    /// Points in their order along the branch; for a closed branch the last point is the first.
    pub points: Vec<BranchPoint>,
    /// Special points in the same order.
    pub special: Vec<SpecialPoint>,
    /// The reason why the branch does not continue before the first point.
    pub beginning: Ending,
    /// The reason why the branch does not continue after the last point.
    pub ending: Ending,
    /// Ranges of the parameter in which even the minimum step does not exclude further special points.
    pub unresolved: Vec<[f64; 2]>,
}

impl Branch {
    /// The ranges between neighbouring points of which one attracts and the other is unstable, with no special point between them.
    #[doc(hidden)]
    #[must_use]
    pub fn unexplained_changes(&self) -> Vec<[f64; 2]> {
        let is_known =
            |point: &BranchPoint| matches!(point.stability, Stability::Attracting | Stability::Unstable);
        let changes =
            |pair: &[BranchPoint]| pair.iter().all(is_known) && pair[0].stability != pair[1].stability;
        let pairs = (1..).zip(self.points.windows(2)).filter(|(_, pair)| changes(pair));
        let unexplained =
            pairs.filter(|(number, _)| self.special.iter().all(|special| special.before != *number));
        unexplained.map(|(_, pair)| between_points(&pair[0], &pair[1])).collect()
    }
}

/// The range of the parameter between two points.
fn between_points(a: &BranchPoint, b: &BranchPoint) -> [f64; 2] {
    [a.parameter.min(b.parameter), a.parameter.max(b.parameter)]
}

/// Origin of a branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A motion at an end of the range.
    Primary,
    /// A free oscillation whose frequency is a simple fraction or multiple of the drive frequency.
    FreeOscillation,
    /// A symmetry-breaking bifurcation.
    SymmetryBreaking,
    /// A period-doubling bifurcation.
    PeriodDoubling,
    /// The end of another branch, on this one.
    Meeting,
    /// A motion at a value within the range.
    Within,
    /// A motion to which the system settles beyond a fold of another branch.
    Jump,
}

/// Reason why a branch ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The branch leaves the range of the parameter.
    RangeEnd,
    /// The branch returned to its first point.
    Closed,
    /// The branch ends at a branch point on another branch and is one side of that point.
    BranchPoint,
    /// The branch ends at a Hopf point, at an equilibrium.
    Rest,
    /// The branch has the largest number of points.
    PointLimit,
    /// The period of the drive exceeds a hundred times its least value, or without a drive the period of
    /// the motion exceeds a hundred times its first one: the branch continues towards frequency zero.
    SlowDrive,
    /// Without a drive, the motion takes ever longer for the same path at the same parameter: the path comes to an equilibrium, as that of a
    /// homoclinic orbit does.
    InfinitePeriod,
    /// The motion has a billion times the size of the first one.
    Unbounded,
    /// Deviations grow more than a million times in a doubled period, or a thousand times in one of eight or more drive periods or turns.
    Sensitive,
    /// The corrector failed at the minimum step.
    Lost,
    /// Cancellation by the caller.
    Interrupted,
}

/// Limits up to which a branch is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Limits {
    /// The ends of the range, the lower first.
    pub(super) range: [f64; 2],
    pub(super) most_points: usize,
    pub(super) longest_period: f64,
    /// The magnitude of a multiplier at which the branch ends.
    pub(super) largest_growth: f64,
    pub(super) initial_step: f64,
}

/// The maximum and the minimum step, in units of the motion and of the range.
const STEPS: [f64; 2] = [0.12, 1e-7];
/// The initial step.
pub(super) const FIRST: f64 = 0.02;
/// Maximum step at which a fold is distinguished from a crossing of branches.
const SHORT: f64 = 0.01;
/// The minimum step of the halvings that exclude hidden special points.
const RESOLVED: f64 = 2e-4;
/// A branch ends at an orbit larger than this multiple of its first one's size (at least one unit).
const UNBOUNDED: f64 = 1e9;
/// Largest distance of a predicted point from the corrected one, relative to the step; beyond it the corrected point may lie on another branch.
const FAR: f64 = 0.2;
/// Largest magnitude of the test for a multiplier +1 that counts as a crossing at the end of the range.
const CROSSES: f64 = 1e-6;
/// The largest angle between the directions at both ends of a step, and the intended angle.
const TURNS: [f64; 2] = [0.35, 0.14];

/// A branch while it is followed.
pub(super) struct Walk<'a> {
    pub(super) corrector: Corrector<'a>,
    pub(super) limits: Limits,
    /// The largest half-range of a coordinate so far.
    pub(super) largest: f64,
    pub(super) nodes: Vec<Node>,
    pub(super) milestones: Vec<Milestone>,
    pub(super) unresolved: Vec<[f64; 2]>,
    special: Vec<(SpecialPoint, Node)>,
    /// The length of the last step.
    last: f64,
    /// The number of nodes when the last one was begun at its other turning points.
    pub(super) restarted: usize,
    /// The size of the first motion, at least one.
    scale: f64,
    /// The branch point at which this branch ends on another one.
    meeting: Option<Meeting>,
    /// The Hopf point at which the branch ends.
    hopf: Option<SpecialPoint>,
}

/// A followed branch, with the nodes of its singular points.
#[derive(Clone, Debug)]
pub(super) struct Walked {
    pub(super) branch: Branch,
    pub(super) specials: Vec<(SpecialPoint, Node)>,
    /// The branch points, at either end, on other branches.
    pub(super) meetings: Vec<Meeting>,
}

impl Walked {
    /// The branch, marked as lost before its first point.
    pub(super) fn beginning_lost(mut self) -> Self {
        self.branch.beginning = Ending::Lost;
        self
    }

    /// The branch reversed, followed by another one that begins at the same point.
    pub(super) fn turned_into(mut self, onward: &Self) -> Self {
        let all = self.branch.points.len();
        let turned = |special: SpecialPoint| SpecialPoint { before: all - special.before, ..special };
        let later = |special: SpecialPoint| SpecialPoint { before: special.before + all - 1, ..special };
        let first = self.branch.special.into_iter().rev().map(turned);
        self.branch.special = first.chain(onward.branch.special.iter().cloned().map(later)).collect();
        let first = self.specials.into_iter().rev().map(|(special, node)| (turned(special), node));
        let then = onward.specials.iter().cloned().map(|(special, node)| (later(special), node));
        self.specials = first.chain(then).collect();
        self.branch.points.reverse();
        self.branch.unresolved.extend_from_slice(&onward.branch.unresolved);
        self.branch.unresolved = merged(self.branch.unresolved);
        self.branch.points.extend_from_slice(&onward.branch.points[1..]);
        (self.branch.beginning, self.branch.ending) = (self.branch.ending, onward.branch.ending);
        self.meetings.extend_from_slice(&onward.meetings);
        self
    }
}

impl<'a> Walk<'a> {
    pub(super) fn new(corrector: Corrector<'a>, limits: Limits, start: Node) -> Self {
        let largest = corrector.family.largest_swing(&start.point);
        Self {
            corrector,
            limits,
            largest,
            scale: size(&start.point).max(1.0),
            milestones: vec![Milestone { at: 0.0, tests: start.tests }],
            nodes: vec![start],
            unresolved: vec![],
            special: vec![],
            last: 0.0,
            restarted: 0,
            meeting: None,
            hopf: None,
        }
    }

    pub(super) fn walked(mut self, origin: Origin) -> Walked {
        let ending = self.followed();
        let nodes = self.nodes.into_iter().map(|node| node.point);
        let points = nodes.chain(self.hopf.iter().map(|hopf| hopf.point.clone())).collect();
        let special = self.special.iter().map(|(special, _)| special).chain(&self.hopf).cloned().collect();
        let beginning = match origin {
            _ if ending == Ending::Closed => Ending::Closed,
            Origin::Primary | Origin::FreeOscillation | Origin::Meeting | Origin::Within | Origin::Jump => {
                Ending::RangeEnd
            }
            Origin::SymmetryBreaking | Origin::PeriodDoubling => Ending::BranchPoint,
        };
        let Self { corrector: Corrector { space, .. }, .. } = self;
        let unresolved = std::mem::take(&mut self.unresolved);
        let mut branch = Branch { origin, space, points, special, beginning, ending, unresolved };
        branch.unresolved.extend(branch.unexplained_changes());
        branch.unresolved = merged(branch.unresolved);
        Walked { branch, specials: self.special, meetings: self.meeting.into_iter().collect() }
    }

    fn followed(&mut self) -> Ending {
        let mut length = self.limits.initial_step;
        while self.nodes.len() < self.limits.most_points {
            if self.corrector.family.watch.reached(self.nodes.len()).is_err() {
                return Ending::Interrupted;
            }
            let Some(ending) = self.step(&mut length) else { continue };
            return if self.corrector.family.watch.is_stopped() { Ending::Interrupted } else { ending };
        }
        Ending::PointLimit
    }

    pub(super) fn at(&self) -> &Node {
        self.nodes.last().expect("a walk begins with a node")
    }

    /// Takes one step, or shortens the next one; returns the reason if the branch ends.
    fn step(&mut self, length: &mut f64) -> Option<Ending> {
        let width = self.limits.range[1] - self.limits.range[0];
        let units = self.corrector.family.units(&self.at().point, self.largest, width);
        let candidate = self.next(&units, *length);
        let is_lost = candidate.is_none();
        let next = candidate.and_then(|(next, turn, off)| {
            let stretch = Stretch { corrector: &self.corrector, ends: [self.at(), &next], units: &units };
            if *length > SHORT && (stretch.may_meet_other_branch() || stretch.may_cross_other_branch()) {
                return None;
            }
            if stretch.falls_into_smaller_space() {
                return None;
            }
            let established = self.is_established(&stretch, *length);
            (established || *length <= RESOLVED).then_some((next, turn, off, established))
        });
        let Some((next, turn, off, established)) = next else {
            if is_lost && *length < SHORT && self.begin_elsewhere(&units) {
                return None;
            }
            *length *= 0.5;
            if *length >= STEPS[1] {
                return None;
            }
            let Some((node, step)) = self.across_change_of_stops(&units) else { return Some(Ending::Lost) };
            *length = step;
            self.restart_at(node);
            return None;
        };
        if !established {
            self.leave_unresolved(&next);
        }
        self.last = *length;
        // Growth is at most 1.6, which a turn of a thousandth and a prediction off by a millionth allow: smaller divisors change nothing.
        let longer = (TURNS[1] / turn.max(1e-3)).min(libm::cbrt(0.2 * FAR / off.max(1e-6))).clamp(0.5, 1.6);
        *length = (*length * longer).min(STEPS[0]);
        let parameter = next.point.parameter;
        let [low, high] = self.limits.range;
        if let Some(ending) = self.limit_reached(&next.point) {
            return Some(ending);
        }
        if !(low..=high).contains(&parameter) {
            let boundary = if parameter < low { low } else { high };
            let Some(end) = self.at_parameter(&next, &units, boundary) else { return Some(Ending::Lost) };
            let crossing = self.crossing_at_end(&end);
            let ending = self.accept(end, &units).unwrap_or(Ending::RangeEnd);
            self.special.extend(crossing);
            return Some(ending);
        }
        if let Some(end) = self.closing(&next, &units) {
            return Some(self.accept(end, &units).unwrap_or(Ending::Closed));
        }
        self.accept(next, &units)
    }

    /// The limit that ends the branch before this motion, if it reaches one.
    fn limit_reached(&self, next: &BranchPoint) -> Option<Ending> {
        if next.period > self.limits.longest_period {
            return Some(Ending::SlowDrive);
        }
        if self.slows_down(next) {
            return Some(Ending::InfinitePeriod);
        }
        if size(next) > UNBOUNDED * self.scale {
            return Some(Ending::Unbounded);
        }
        let growth = next.multipliers.first().map_or(0.0, |multiplier| multiplier.abs());
        (growth > self.limits.largest_growth).then_some(Ending::Sensitive)
    }

    /// Returns `true` if a motion without a drive differs from the last one in its period alone. Next to a homoclinic orbit the distance of the
    /// parameter from its limit falls exponentially with the period, until it is rounding, which has folds everywhere.
    fn slows_down(&self, next: &BranchPoint) -> bool {
        /// Changes of the parameter at which the motion is the limit, in units of rounding: at 4096 the multipliers of the cycle of the tests are off
        /// by 1e-4, at 16 by 0.1, and from 3 on folds are found.
        const ROUNDINGS: f64 = 4096.0;
        /// Largest change of the path, relative to its size: a family at one parameter, as that of a conservative system or of canards, changes
        /// its size as much as its period.
        const SAME: f64 = 1e-6;
        /// Least relative change of the period, a thousand times as large; the steps of the tests change it by 0.01 to 0.03.
        const LONGER: f64 = 1e-3;
        let last = &self.at().point;
        let width = self.limits.range[1] - self.limits.range[0];
        let still = ROUNDINGS * f64::EPSILON * (next.parameter.abs() + width);
        let ends = last.ranges.iter().zip(&next.ranges).flat_map(|(a, b)| [a[0] - b[0], a[1] - b[1]]);
        let moved = ends.fold(0.0, |most: f64, change| most.max(change.abs()));
        !self.corrector.family.is_driven()
            && (next.parameter - last.parameter).abs() <= still
            && next.period > (1.0 + LONGER) * last.period
            && moved <= SAME * self.largest
    }

    /// The node after a step of this length, the angle by which the direction turned, and the
    /// distance of the prediction relative to the step; `None` if the node may lie on another branch.
    fn next(&self, units: &[f64], length: f64) -> Option<(Node, f64, f64)> {
        let tangent = in_units(&self.at().direction, units);
        let curvature = match self.nodes.len().checked_sub(2) {
            Some(before) => {
                let before = in_units(&self.nodes[before].direction, units);
                tangent.iter().zip(before).map(|(now, then)| (now - then) / self.last).collect()
            }
            None => vec![0.0; tangent.len()],
        };
        let step = |j: usize| units[j] * length * (tangent[j] + 0.5 * length * curvature[j]);
        let guess: Vec<f64> = self.at().position().iter().enumerate().map(|(j, x)| x + step(j)).collect();
        let corrected = self.corrector.corrected(&guess, &tangent, units)?;
        let off = corrected.first / length;
        if off > FAR {
            return None;
        }
        let node = Node::new(&self.corrector, corrected, &self.at().direction, units)?;
        let cosine: f64 = in_units(&node.direction, units).iter().zip(&tangent).map(|(a, b)| a * b).sum();
        let turn = libm::acos(cosine.clamp(-1.0, 1.0));
        (turn <= TURNS[0]).then_some((node, turn, off))
    }

    /// The node at which the parameter has a value, between the last node and the next one.
    fn at_parameter(&self, next: &Node, units: &[f64], value: f64) -> Option<Node> {
        let side = |s: f64| between(self.at(), next, units, s).last().is_some_and(|p| *p > value);
        let begins = side(0.0);
        let [before, _] = bisect([0.0, 1.0], Tolerance::absolute(1e-9), |s| side(s) == begins);
        let mut guess = between(self.at(), next, units, before);
        *guess.last_mut()? = value;
        let mut across = vec![0.0; guess.len()];
        *across.last_mut()? = 1.0;
        let image = self.corrector.image(&guess)?;
        let mut corrected = match self.comes_to_crossing(&Tests::new(&image, 0.0)?) {
            true => self.corrector.closed_by_period(guess)?,
            false => self.corrector.corrected(&guess, &across, units)?,
        };
        *corrected.position.last_mut()? = value;
        Node::new(&self.corrector, corrected, &self.at().direction, units)
    }

    /// Returns `true` if the test for a multiplier +1 vanishes here and does not vanish at the last node.
    fn comes_to_crossing(&self, tests: &Tests) -> bool {
        self.at().tests.branching.abs() > CROSSES && tests.branching.abs() <= CROSSES
    }

    /// The point where another branch crosses this one at the end of the range, beyond which no test function can change its sign.
    fn crossing_at_end(&self, end: &Node) -> Option<(SpecialPoint, Node)> {
        if !self.comes_to_crossing(&end.tests) {
            return None;
        }
        let [before, at] = [self.at(), end].map(|node| node.tests.branching);
        let way = (end.point.parameter - self.at().point.parameter).abs();
        let error = way * (at / before).abs() + 4.0 * f64::EPSILON * end.point.parameter.abs();
        let (kind, before) = (SpecialKind::BranchPoint, self.nodes.len());
        Some((SpecialPoint { kind, point: end.point.clone(), error, before }, end.clone()))
    }

    /// The first node, if the step to the next node passes through it in the same direction.
    fn closing(&self, next: &Node, units: &[f64]) -> Option<Node> {
        let start = self.nodes.first().filter(|_| self.nodes.len() > 3)?;
        let along = in_units(&start.direction, units);
        let before = difference(self.at().position(), start.position(), units);
        let after = difference(next.position(), start.position(), units);
        let side = |to: &[f64]| -> f64 { to.iter().zip(&along).map(|(a, b)| a * b).sum() };
        // Steps next to a special point may be far shorter than the distance of the nodes about the start.
        let near = norm(&before).min(norm(&after)) <= 2.0 * self.last.max(1e-3);
        if !(near && side(&before) < 0.0 && side(&after) >= 0.0) {
            return None;
        }
        let part = side(&before) / (side(&before) - side(&after));
        let mut guess = between(self.at(), next, units, part);
        let beside = side(&difference(&guess, start.position(), units));
        for ((number, along), unit) in guess.iter_mut().zip(&along).zip(units) {
            *number -= beside * along * unit;
        }
        let corrected = self.corrector.corrected(&guess, &along, units)?;
        /// Ten thousand rounding errors; the distance to another branch is larger.
        const SAME: f64 = 1e-8;
        let off = norm(&difference(&corrected.position, start.position(), units));
        (off < SAME).then(|| start.clone())
    }

    /// Appends a node and the singular points before it; returns an ending if the branch meets the one from which it came.
    fn accept(&mut self, next: Node, units: &[f64]) -> Option<Ending> {
        let stretch = Stretch { corrector: &self.corrector, ends: [self.at(), &next], units };
        if stretch.may_meet_other_branch() {
            if let Some(hopf) = stretch.hopf() {
                self.hopf = Some(SpecialPoint { before: self.nodes.len(), ..hopf });
                return Some(Ending::Rest);
            }
            if let Some(meeting) = stretch.meeting() {
                self.meeting = Some(meeting);
                return Some(Ending::BranchPoint);
            }
        }
        let (specials, are_all) = stretch.specials();
        if !are_all {
            self.leave_unresolved(&next);
        }
        let before = self.nodes.len();
        self.special.extend(
            specials.into_iter().map(|special| (SpecialPoint { before, ..special.special }, special.node)),
        );
        self.largest = self.largest.max(self.corrector.family.largest_swing(&next.point));
        self.milestones.push(self.milestone(&next, self.last));
        self.nodes.push(next);
        None
    }

    fn leave_unresolved(&mut self, next: &Node) {
        let range = between_points(&self.at().point, &next.point);
        self.unresolved.push(range);
    }

    fn milestone(&self, next: &Node, length: f64) -> Milestone {
        let at = self.milestones.last().map_or(0.0, |last| last.at + length);
        Milestone { at, tests: next.tests }
    }

    fn is_established(&self, stretch: &Stretch<'_>, length: f64) -> bool {
        let middle = || Some(self.milestone(&stretch.node_at(stretch.corrector, 0.5)?, 0.5 * length));
        is_established(&self.milestones, &self.milestone(stretch.ends[1], length), middle)
    }
}

/// Ranges in ascending order; adjacent ones are joined.
fn merged(mut ranges: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    ranges.put_in_order(|a, b| a[0].total_cmp(&b[0]));
    let mut merged: Vec<[f64; 2]> = vec![];
    for [low, high] in ranges {
        match merged.last_mut() {
            Some(last) if low <= last[1] => last[1] = last[1].max(high),
            _ => merged.push([low, high]),
        }
    }
    merged
}

/// The largest distance of a coordinate from zero.
pub(super) fn size(point: &BranchPoint) -> f64 {
    point.ranges.iter().flatten().map(|x| x.abs()).fold(0.0, f64::max)
}
