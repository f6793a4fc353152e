//! Jumps from one stable motion to another in slow sweeps of the parameter.

use super::branch::Branch;
use super::corrector::Corrector;
use super::node::Node;
use super::point::BranchPoint;
use super::space::Space;
use super::special::{SpecialKind, SpecialPoint};
use libration_motion::internals::periodic::norm;
use libration_numbers::algebra::Complex;
use libration_numbers::internals::algebra::InOrder;
use std::ops::Range;

/// A fold at which a stable motion ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Jump {
    /// `true` if the jump happens as the parameter rises.
    pub rising: bool,
    /// The motion before the jump, at the fold.
    pub from: BranchPoint,
    /// The other stable periodic motions at this parameter value; empty if all known ones are unstable.
    pub to: Vec<BranchPoint>,
}

/// The jumps of slow sweeps, branch by branch.
pub(super) fn jumps<'a>(
    branches: &[Branch],
    corrector: impl Fn(Space) -> Corrector<'a>,
    width: f64,
) -> Vec<Jump> {
    let jump = |number: usize, fold: &SpecialPoint| {
        let points = &branches[number].points;
        let value = fold.point.parameter;
        let [first, last] = at_the_fold(points, fold);
        let neighbours = [points.get(first.checked_sub(1)?)?, points.get(last)?];
        let side = neighbours.into_iter().find(|point| point.is_stable());
        let left = side.or_else(|| others_attract(&fold.point).then_some(neighbours[0]))?;
        let pairs = branches.iter().enumerate().flat_map(|(index, branch)| {
            let fold = if index == number { first..last } else { 0..0 };
            stable_stretches(branch, value, fold).map(|pair| (branch.space, pair))
        });
        let to = pairs.filter_map(|(space, pair)| {
            let landing = landing(&corrector(space), pair, value, width);
            let is_at_value = landing.parameter.to_bits() == value.to_bits();
            (is_at_value || pair.iter().all(|point| point.is_stable())).then_some(landing)
        });
        Some(Jump {
            rising: left.parameter < value,
            from: fold.point.clone(),
            to: to.filter(|point| point.is_stable()).collect(),
        })
    };
    let folds = branches.iter().enumerate().flat_map(|(number, branch)| {
        let folds = branch.special.iter().filter(|special| special.kind == SpecialKind::Fold);
        folds.map(move |fold| (number, fold))
    });
    folds.filter_map(|(number, fold)| jump(number, fold)).collect()
}

/// Returns `true` if all multipliers of a fold but its own are inside the unit circle: on one side of it the motion is stable, even if the branch
/// has no point there, as next to a period doubling.
fn others_attract(fold: &BranchPoint) -> bool {
    let errors = fold.multiplier_errors.iter().copied();
    let counted =
        fold.multipliers.iter().copied().zip(errors).filter(|along| *along != (Complex::from(1.0), 0.0));
    let mut multipliers: Vec<(Complex, f64)> = counted.collect();
    multipliers.put_in_order(|(a, _), (b, _)| {
        (*a - Complex::from(1.0)).abs().total_cmp(&(*b - Complex::from(1.0)).abs())
    });
    multipliers.iter().skip(1).all(|(multiplier, error)| multiplier.abs() + error < 1.0)
}

/// The places of the points whose parameter is that of the fold within its error: the first, and the one after the last. Along canards there are
/// many, on either side of it by rounding.
fn at_the_fold(points: &[BranchPoint], fold: &SpecialPoint) -> [usize; 2] {
    /// Errors of the fold within which rounding decides; those of points are as large as its own.
    const ERRORS: f64 = 16.0;
    let value = fold.point.parameter;
    let slack = ERRORS * (fold.error + f64::EPSILON * value.abs());
    let is_near = |point: &&BranchPoint| (point.parameter - value).abs() <= slack;
    let (before, after) = points.split_at(fold.before.min(points.len()));
    let count = |near: &mut dyn Iterator<Item = &BranchPoint>| near.take_while(is_near).count();
    [before.len() - count(&mut before.iter().rev()), before.len() + count(&mut after.iter())]
}

/// Neighbouring points of a branch that enclose a value, one of them stable, but for those at a fold there.
fn stable_stretches(
    branch: &Branch,
    value: f64,
    fold: Range<usize>,
) -> impl Iterator<Item = [&BranchPoint; 2]> {
    let pairs = branch.points.iter().zip(branch.points.iter().skip(1)).map(|(a, b)| [a, b]);
    let others = pairs.enumerate().filter(move |(index, _)| index + 1 < fold.start || fold.end <= *index);
    others.map(|(_, pair)| pair).filter(move |[a, b]| {
        (a.is_stable() || b.is_stable()) && (a.parameter < value) != (b.parameter < value)
    })
}

/// The motion at a value between two points; if the corrector fails, the nearer point, with their distance as its error.
pub(super) fn landing(
    corrector: &Corrector<'_>,
    [a, b]: [&BranchPoint; 2],
    value: f64,
    width: f64,
) -> BranchPoint {
    let part = (value - a.parameter) / (b.parameter - a.parameter);
    let [from, to] = [a, b].map(|point| corrector.unknowns(point));
    let unknowns: Vec<f64> = from.iter().zip(&to).map(|(x, y)| x + part * (y - x)).chain([value]).collect();
    let along: Vec<f64> =
        (0..unknowns.len()).map(|j| if j + 1 < unknowns.len() { 0.0 } else { 1.0 }).collect();
    let nearer = if part < 0.5 { a } else { b };
    let Some(node) = Node::near(corrector, &unknowns, [&along, &along], width) else {
        let apart = norm(&a.state.iter().zip(&b.state).map(|(x, y)| x - y).collect::<Vec<_>>());
        return BranchPoint { error: apart.max(nearer.error), ..nearer.clone() };
    };
    BranchPoint { parameter: value, ..node.point }
}
