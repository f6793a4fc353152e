//! Where a slow sweep of the parameter jumps from one motion to another.

use super::branch::Branch;
use super::response::Response;
use super::special::SpecialKind;

/// A fold in which a stable motion ends.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Jump {
    /// The value of the parameter.
    pub parameter: f64,
    /// Whether it happens as the parameter rises.
    pub rising: bool,
    /// The amplitude that is left.
    pub from: f64,
    /// Amplitudes of the stable periodic motions there, between neighbouring points, to some parts in a thousand; none where all that were
    /// found are unstable.
    pub to: Vec<f64>,
}

impl Response {
    /// The jumps of slow sweeps, by the amplitude of one coordinate.
    #[must_use]
    pub fn jumps(&self, coordinate: usize, is_angle: bool) -> Vec<Jump> {
        let of_branch = |(number, branch): (usize, &Branch)| {
            let folds = branch.special.iter().filter(|it| it.kind == SpecialKind::Fold);
            let jump = |fold: &super::special::SpecialPoint| {
                let neighbours =
                    [branch.points.get(fold.before.checked_sub(1)?)?, branch.points.get(fold.before)?];
                let left = neighbours.into_iter().find(|point| point.stable)?;
                let others = self.branches.iter().enumerate().flat_map(|(other, it)| {
                    let own = (other == number).then_some(fold.before);
                    stable_amplitudes(it, fold.point.parameter, own, coordinate, is_angle)
                });
                Some(Jump {
                    parameter: fold.point.parameter,
                    rising: left.parameter < fold.point.parameter,
                    from: fold.point.amplitude(coordinate, is_angle),
                    to: others.collect(),
                })
            };
            folds.filter_map(jump).collect::<Vec<_>>()
        };
        self.branches.iter().enumerate().flat_map(of_branch).collect()
    }
}

/// Where stable stretches of a branch go through a value, except on both sides of a fold.
fn stable_amplitudes(
    branch: &Branch,
    value: f64,
    fold: Option<usize>,
    coordinate: usize,
    is_angle: bool,
) -> Vec<f64> {
    let pairs = branch.points.windows(2).enumerate();
    let away = pairs.filter(|(number, _)| fold.is_none_or(|fold| number + 1 != fold));
    let through = |(_, pair): (usize, &[super::point::BranchPoint])| {
        let [a, b] = pair else { return None };
        let (before, after) = (a.parameter - value, b.parameter - value);
        let crosses = a.stable && b.stable && (before < 0.0) != (after < 0.0);
        let part = before / (before - after);
        let [x, y] = [a, b].map(|point| point.amplitude(coordinate, is_angle));
        crosses.then_some(x + part * (y - x))
    };
    away.filter_map(through).collect()
}
