//! Singular points of a branch, located to the last digits.

use super::corrector::{Corrected, Corrector};
use super::description::parameter_error;
use super::family::{Image, TOLERANCES};
use super::hopf::hopf;
use super::node::{Node, Tests, between};
use super::point::BranchPoint;
use super::space::Space;
use super::units::{difference, in_units};
use libration_motion::internals::periodic::norm;
use libration_numbers::algebra::Doubles;
use libration_numbers::internals::algebra::InOrder;
use libration_numbers::internals::linear::null_space;
use libration_numbers::roots::{Tolerance, zero_between};
use std::f64::consts::TAU;

/// Kind of a singular point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpecialKind {
    /// The branch turns back: on one side of the value there are two motions, on the other side none.
    Fold,
    /// A symmetric motion loses its symmetry: two mirrored motions branch off. In a space that
    /// is not mirrored, the symmetry is that of some coordinates without a shift in time.
    SymmetryBreaking,
    /// A motion with twice the period branches off.
    PeriodDoubling,
    /// Two complex multipliers cross the unit circle: a second frequency appears. Without damping, two pairs of
    /// complex multipliers meet on the unit circle and leave it.
    NeimarkSacker,
    /// The product of two real multipliers is one: not a bifurcation, although the determinant is the same as at one.
    NeutralSaddle,
    /// Another branch of the same period crosses this one.
    BranchPoint,
    /// A limit cycle shrinks to an equilibrium, where two complex eigenvalues cross the imaginary axis.
    Hopf,
}

impl SpecialKind {
    /// The name in machine-readable output.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Fold => "fold",
            Self::SymmetryBreaking => "symmetry_breaking",
            Self::PeriodDoubling => "period_doubling",
            Self::NeimarkSacker => "neimark_sacker",
            Self::NeutralSaddle => "neutral_saddle",
            Self::BranchPoint => "branch_point",
            Self::Hopf => "hopf",
        }
    }
}

impl std::fmt::Display for SpecialKind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Fold => "fold",
            Self::SymmetryBreaking => "symmetry breaking",
            Self::PeriodDoubling => "period doubling",
            Self::NeimarkSacker => "Neimark–Sacker",
            Self::NeutralSaddle => "neutral saddle",
            Self::BranchPoint => "branch point",
            Self::Hopf => "Hopf point",
        })
    }
}

/// A singular point.
#[derive(Clone, Debug, PartialEq)]
pub struct SpecialPoint {
    /// Kind of the singular point.
    pub kind: SpecialKind,
    /// The motion at the singular point.
    pub point: BranchPoint,
    /// Error estimate of the parameter: its change with another integration tolerance, plus rounding.
    pub error: f64,
    /// Number of points of the branch before the singular one.
    pub before: usize,
}

/// Test functions; each changes its sign at one kind of singular point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Test {
    Fold,
    Branching,
    Flip,
    Torus,
    /// Two pairs of multipliers λ and 1/λ meet, if the multipliers are such pairs at all values of the parameters.
    Collision,
}

impl Test {
    pub(super) fn of(self, tests: &Tests) -> f64 {
        match self {
            Self::Fold => tests.fold,
            Self::Branching => tests.branching,
            Self::Flip => tests.flip,
            Self::Torus => tests.torus,
            Self::Collision => tests.collision,
        }
    }

    /// Smallest magnitude at which a value has a sign: in conservative systems products of multipliers are one up to rounding.
    pub(super) fn sure(self) -> f64 {
        match self {
            Self::Fold => 0.0,
            Self::Branching | Self::Flip | Self::Collision => 1e-12,
            // The products of pairs of multipliers have the rounding of both.
            Self::Torus => 1e-9,
        }
    }

    /// Returns `true` if a value has a sign beyond the errors of the multipliers.
    pub(super) fn has_sign(self, tests: &Tests) -> bool {
        let noise = match self {
            Self::Fold | Self::Collision => 0.0,
            Self::Branching => tests.noise[0],
            Self::Flip => tests.noise[1],
            Self::Torus => tests.noise[2],
        };
        self.of(tests).abs() > self.sure().max(noise)
    }

    fn changes(self, a: &Node, b: &Node) -> bool {
        let values = [a, b].map(|node| self.of(&node.tests));
        [a, b].iter().all(|node| self.has_sign(&node.tests)) && (values[0] > 0.0) != (values[1] > 0.0)
    }
}

/// Largest size of a motion that counts as an equilibrium, in units that are at least a fiftieth of the largest half-range.
const REST: f64 = 0.05;

/// A stretch of a branch between two nodes.
pub(super) struct Stretch<'s> {
    pub(super) corrector: &'s Corrector<'s>,
    pub(super) ends: [&'s Node; 2],
    pub(super) units: &'s [f64],
}

/// A singular point with its node.
pub(super) struct Located {
    pub(super) special: SpecialPoint,
    pub(super) node: Node,
}

/// End of a branch on another one, whose motions belong to a smaller space.
#[derive(Clone, Debug)]
pub(super) struct Meeting {
    pub(super) parameter: f64,
    pub(super) unknowns: Vec<f64>,
    pub(super) space: Space,
}

impl Stretch<'_> {
    /// Returns `true` if the branch turns back within the stretch, in a space that contains the spaces of other branches.
    pub(super) fn may_meet_other_branch(&self) -> bool {
        let Corrector { family, space, .. } = self.corrector;
        let turns = Test::Fold.changes(self.ends[0], self.ends[1]);
        let may_be_rest = match family.is_driven() {
            true => space.mirrored && self.distance_from_rest(self.ends[1].position()) < 1.0,
            false => self.speed(self.ends[1].position()).is_some_and(|speed| speed < 1.0),
        };
        turns && (may_be_rest || !space.within(family.symmetry).is_empty())
    }

    /// Returns `true` if the branch turns back within the stretch although no multiplier of its map seems to pass through +1, as it does at each
    /// fold: at a crossing with another branch, or at a fold next to a crossing.
    pub(super) fn may_cross_other_branch(&self) -> bool {
        let [a, b] = self.ends;
        Test::Fold.changes(a, b) && !Test::Branching.changes(a, b)
    }

    /// The distance of a state from the centre of the mirror, in scaled units; infinite if other states are their own mirror images too.
    fn distance_from_rest(&self, position: &[f64]) -> f64 {
        let Corrector { family, space, .. } = self.corrector;
        let Some(rest) = space.fixed_state(&family.mirror) else { return f64::INFINITY };
        norm(&difference(family.state(position), &rest, self.units))
    }

    /// The distance in units that a state moves in the time of one radian of phase, if no drive sets the period.
    fn speed(&self, position: &[f64]) -> Option<f64> {
        let (parameter, unknowns) = position.split_last()?;
        let Corrector { family, .. } = self.corrector;
        let rates = family.field()?.at(family.state(unknowns), &[*parameter])?.rates;
        let radian = unknowns.last()? / TAU;
        Some(norm(&rates.iter().zip(self.units).map(|(x, unit)| radian * x / unit).collect::<Vec<_>>()))
    }

    /// The point where the branch turns, according to the interpolation.
    fn turn(&self) -> Vec<f64> {
        let [a, b] = self.ends.map(|node| node.tests.fold);
        between(self.ends[0], self.ends[1], self.units, a / (a - b))
    }

    /// The Hopf point where the branch turns, if its motion is an equilibrium there and no drive sets the period.
    pub(super) fn hopf(&self) -> Option<SpecialPoint> {
        let turn = self.turn();
        let [unknowns @ .., parameter] = &turn[..] else { return None };
        let Corrector { family, .. } = self.corrector;
        let is_rest = self.speed(&turn).is_some_and(|speed| speed < REST);
        let (period, width) = (*unknowns.last()?, *self.units.last()?);
        let field = family.field().filter(|_| is_rest)?;
        let point = hopf(field, family.state(unknowns), [period, *parameter], width)?;
        Some(SpecialPoint { kind: SpecialKind::Hopf, error: point.error, point, before: 0 })
    }

    /// The turning point of the branch, if its motion belongs to a smaller space there: the branch meets
    /// the one of which it is a side, and continues as its own image, mirrored or half a period later.
    pub(super) fn meeting(&self) -> Option<Meeting> {
        /// Largest defect relative to the size of the motion; on a short stretch the error of the interpolation is much smaller.
        const SAME: f64 = 1e-3;
        let turn = self.turn();
        let (parameter, unknowns) = turn.split_last()?;
        let Corrector { family, space, .. } = self.corrector;
        let meeting = |space: Space, unknowns: Vec<f64>| Meeting { parameter: *parameter, unknowns, space };
        if space.mirrored {
            let mut rest = space.fixed_state(&family.mirror)?;
            rest.resize(unknowns.len(), 0.0);
            return (self.distance_from_rest(&turn) < REST).then(|| meeting(Space::of_periods(1), rest));
        }
        Some(meeting(self.smaller_space(&turn, SAME)?, unknowns.to_vec()))
    }

    /// Returns `true` if the step leads from a motion of this space to one with half the period or with a symmetry: next to a point where
    /// branches meet, a long step may end on the other one.
    pub(super) fn falls_into_smaller_space(&self) -> bool {
        /// Largest defect relative to the size of the motion, far above that of a corrected motion.
        const SAME: f64 = 1e-6;
        let [from, to] = self.ends.map(Node::position);
        self.smaller_space(to, SAME).is_some_and(|_| self.smaller_space(from, SAME).is_none())
    }

    /// The space within this one in which a motion closes, up to a defect relative to its size.
    fn smaller_space(&self, position: &[f64], largest: f64) -> Option<Space> {
        let (parameter, unknowns) = position.split_last()?;
        let Corrector { family, space, tolerance, .. } = self.corrector;
        let misses = |image: &Image| {
            norm(&image.defect.iter().zip(self.units).map(|(d, unit)| d / unit).collect::<Vec<_>>())
        };
        let mut smaller = family.images_within(*space, unknowns, std::slice::from_ref(parameter), *tolerance);
        smaller.find(|(_, image)| misses(image) < largest).map(|(smaller, _)| smaller)
    }

    /// The singular points on the stretch, in order, and whether all of which a test has another sign at its end were located.
    pub(super) fn specials(&self) -> (Vec<Located>, bool) {
        let [a, b] = self.ends;
        let folds = Test::Fold.changes(a, b);
        let wanted = [
            (folds, Test::Fold),
            // At a fold a multiplier is +1 too.
            (!folds && Test::Branching.changes(a, b), Test::Branching),
            (Test::Flip.changes(a, b), Test::Flip),
            (Test::Torus.changes(a, b), Test::Torus),
        ];
        let wanted: Vec<Test> =
            wanted.into_iter().filter(|(changes, _)| *changes).map(|(_, test)| test).collect();
        let mut specials: Vec<(f64, Located)> =
            wanted.iter().filter_map(|test| self.located(*test)).collect();
        let are_all = specials.len() == wanted.len();
        specials.put_in_order(|a, b| a.0.total_cmp(&b.0));
        (specials.into_iter().map(|(_, located)| located).collect(), are_all)
    }

    fn located(&self, test: Test) -> Option<(f64, Located)> {
        let crosses = test == Test::Branching || (test == Test::Fold && self.may_cross_other_branch());
        let exactly = if test == Test::Fold && crosses { None } else { self.located_exactly(test) };
        exactly.or_else(|| if crosses { self.crossing(test) } else { self.enclosed_fold(test) })
    }

    /// A fold between two nodes that are closer than motions can be corrected, as where the branch turns within the last digits of the parameter: at
    /// the node whose direction has less of the parameter.
    fn enclosed_fold(&self, test: Test) -> Option<(f64, Located)> {
        let [a, b] = self.ends;
        let flatter = if a.tests.fold.abs() < b.tests.fold.abs() { a } else { b };
        let steepest = a.tests.fold.abs().max(b.tests.fold.abs());
        let way = norm(&difference(a.position(), b.position(), self.units)) * self.units.last()?;
        let apart = (a.point.parameter - b.point.parameter).abs();
        let perpendicular = parameter_error(&flatter.corrected, &flatter.direction, self.units)?;
        let error = perpendicular + apart + steepest * way + f64::EPSILON * flatter.point.parameter.abs();
        let special =
            SpecialPoint { kind: SpecialKind::Fold, point: flatter.point.clone(), error, before: 0 };
        (test == Test::Fold).then(|| (0.5, Located { special, node: flatter.clone() }))
    }

    /// Crossing of branches, located as closely as nearby motions can be corrected: at the
    /// crossing itself several directions are equivalent, and corrections are unbounded.
    fn crossing(&self, test: Test) -> Option<(f64, Located)> {
        /// Distance to which the crossing is located.
        const NEAR: f64 = 1e-9;
        /// The smallest part of the stretch that is left out on both sides, and the number of its doublings.
        const BESIDE: f64 = 1e-4;
        const DOUBLINGS: i32 = 10;
        let value = |s: f64| self.tests_at(self.corrector, test, s).map_or(0.0, |tests| test.of(&tests));
        let ends = [0.0, 1.0].map(|s| (s, value(s)));
        let s = zero_between(ends, Tolerance::absolute(NEAR), value)?;
        // The same computation with another tolerance differs by the error that is sought.
        let other = Corrector { tolerance: TOLERANCES[1], ..self.corrector.clone() };
        let between_nodes = |corrector: &Corrector<'_>, aside: f64| {
            let [a, b] = [s - aside, s + aside].map(|s| self.node_at(corrector, s));
            let [a, b] = Some([a?, b?]).filter(|[a, b]| test.changes(a, b))?;
            let [from, to] = [&a, &b].map(|node| test.of(&node.tests));
            let unknowns = between(&a, &b, self.units, from / (from - to));
            let corrected = Corrected {
                image: corrector.image(&unknowns)?,
                position: unknowns,
                first: 0.0,
                map_slope: 1.0,
                stale: 0.0,
            };
            let node = Node::new(corrector, corrected, &a.direction, self.units)?;
            Some((node, [a, b]))
        };
        let mut both = (0..DOUBLINGS).filter_map(|doublings| {
            let aside = BESIDE * libm::exp2(f64::from(doublings));
            Some([between_nodes(self.corrector, aside)?, between_nodes(&other, aside)?])
        });
        let [(node, [a, b]), (again, _)] = both.next()?;
        let off = |beside: &Node| (beside.point.parameter - node.point.parameter).abs();
        let errors =
            [&a, &b].map(|node| parameter_error(&node.corrected, &node.direction, self.units).unwrap_or(0.0));
        let missed = off(&a).max(off(&b)) + off(&again) + f64::EPSILON * node.point.parameter.abs();
        let error = errors[0].max(errors[1]) + 4.0 * (missed + left_of(test, [&node, &again], [&a, &b]));
        let kind = self.kind(Test::Branching, &node);
        let special = SpecialPoint { kind, point: node.point.clone(), error, before: 0 };
        Some((s, Located { special, node }))
    }

    fn located_exactly(&self, test: Test) -> Option<(f64, Located)> {
        let precise = Corrector { stale: 0.0, ..self.corrector.clone() };
        let s = self.zero(&precise, test, [0.0, 1.0])?;
        let node = self.node_at(&precise, s)?;
        let other = Corrector { tolerance: TOLERANCES[1], ..precise.clone() };
        /// Half-width of the stretch in which the zero for the other tolerance is searched first; a badly determined zero may lie outside.
        const NEAR: f64 = 1e-4;
        let near = [(s - NEAR).max(0.0), (s + NEAR).min(1.0)];
        let again = self.zero(&other, test, near).or_else(|| self.zero(&other, test, [0.0, 1.0]));
        let again = self.node_at(&other, again?)?;
        let parameter = node.point.parameter;
        let missed = (parameter - again.point.parameter).abs() + f64::EPSILON * parameter.abs();
        let error = 4.0 * (missed + left_of(test, [&node, &again], self.ends));
        let special =
            SpecialPoint { kind: self.kind(test, &node), point: node.point.clone(), error, before: 0 };
        Some((s, Located { special, node }))
    }

    /// The position on the stretch, from 0 to 1, at which a test function vanishes.
    fn zero(&self, corrector: &Corrector<'_>, test: Test, [from, to]: [f64; 2]) -> Option<f64> {
        /// Width to which a zero is enclosed; rounding errors of the test function are larger.
        const WIDTH: f64 = 1e-13;
        let value = |s: f64| self.tests_at(corrector, test, s).map_or(f64::NAN, |tests| test.of(&tests));
        zero_between([(from, value(from)), (to, value(to))], Tolerance::absolute(WIDTH), value)
    }

    fn tests_at(&self, corrector: &Corrector<'_>, test: Test, s: f64) -> Option<Tests> {
        let (corrected, secant) = self.corrected_at(corrector, s)?;
        if test != Test::Fold {
            return Tests::new(&corrected.image, 0.0);
        }
        let along = in_units(&self.ends[0].direction, self.units);
        let tangent = corrector.tangent(&corrected.image, &secant, self.units);
        let tangent = tangent.or_else(|| corrector.tangent(&corrected.image, &along, self.units))?;
        Tests::new(&corrected.image, *tangent.last()?)
    }

    /// The node at a position on the stretch.
    pub(super) fn node_at(&self, corrector: &Corrector<'_>, s: f64) -> Option<Node> {
        let (corrected, _) = self.corrected_at(corrector, s)?;
        Node::new(corrector, corrected, &self.ends[0].direction, self.units)
    }

    fn corrected_at(&self, corrector: &Corrector<'_>, s: f64) -> Option<(Corrected, Vec<f64>)> {
        let [a, b] = self.ends;
        let guess = between(a, b, self.units, s);
        let secant = difference(b.position(), a.position(), self.units);
        let size = norm(&secant);
        let secant: Vec<f64> = secant.into_iter().map(|x| x / size).collect();
        Some((corrector.corrected(&guess, &secant, self.units)?, secant))
    }

    fn kind(&self, test: Test, node: &Node) -> SpecialKind {
        match test {
            Test::Fold => SpecialKind::Fold,
            Test::Branching if self.loses_partial_mirror(node) => SpecialKind::SymmetryBreaking,
            Test::Branching => SpecialKind::BranchPoint,
            Test::Flip if self.corrector.space.mirrored => SpecialKind::SymmetryBreaking,
            Test::Flip => SpecialKind::PeriodDoubling,
            Test::Torus if node.point.is_torus() => SpecialKind::NeimarkSacker,
            Test::Torus | Test::Collision => SpecialKind::NeutralSaddle,
        }
    }

    /// `true` if a motion other than an equilibrium loses the mirror symmetry of some coordinates without a shift in time. In mirrored spaces
    /// the kind could not distinguish this from the loss of the space's own mirror symmetry.
    fn loses_partial_mirror(&self, node: &Node) -> bool {
        let Corrector { family, space, .. } = self.corrector;
        let moves = node.point.ranges.iter().any(|[low, high]| low < high);
        if space.mirrored || !moves {
            return false;
        }
        let map = node.corrected.image.return_map().iter().enumerate();
        let less_one = map
            .map(|(i, row)| row.iter().enumerate().map(|(j, x)| if i == j { x - 1.0 } else { *x }).collect());
        let vectors = null_space(&Doubles, |x| x.abs(), &less_one.collect::<Vec<Vec<f64>>>(), 1);
        let Some(vector) = vectors.and_then(|mut all| all.pop()) else { return false };
        let scaled =
            |vector: &[f64]| vector.iter().zip(self.units).map(|(x, unit)| x / unit).collect::<Vec<f64>>();
        family.loses_partial_mirror(&scaled(&node.point.state), &scaled(&vector))
    }
}

/// Error of the parameter from the residuals of a test function in two integrations and the rounding of a product of multipliers, divided by the
/// slope between two nodes. A fold is an extremum of the parameter and moves by less.
fn left_of(test: Test, at: [&Node; 2], [a, b]: [&Node; 2]) -> f64 {
    if test == Test::Fold {
        return 0.0;
    }
    let product = |node: &Node| {
        node.point.multipliers.iter().fold(f64::EPSILON, |size, node| size * (1.0 + node.abs()))
    };
    let largest =
        |node: &Node| node.point.multipliers.first().map_or(1.0, |multiplier| multiplier.abs().max(1.0));
    let scale = if test == Test::Torus { largest(at[0]) * largest(at[0]) } else { 1.0 };
    let left: f64 = at.iter().map(|node| test.of(&node.tests).abs()).sum::<f64>() + product(at[0]) / scale;
    let slope = (test.of(&b.tests) - test.of(&a.tests)) / (b.point.parameter - a.point.parameter);
    if slope.is_normal() { left / slope.abs() } else { 0.0 }
}
