//! Stability boundaries of an equilibrium over two parameters, found on a grid.

use super::curve::{CurvePoint, SpecialCurve};
use super::description::multipliers;
use super::family::{Family, TOLERANCES};
use super::node::Tests;
use super::space::Space;
use super::special::Test;
use libration_motion::orbit::Stability;
use libration_numbers::internals::algebra::InOrder;
use libration_numbers::internals::roots::other_sign_between;
use libration_numbers::roots::{Tolerance, zero_between};
use std::f64::consts::TAU;

/// Stability of an equilibrium on a grid over two parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct RestStability {
    /// The values of the first parameter and of the second.
    pub values: [Vec<f64>; 2],
    /// `true` where the equilibrium is stable, by the value of the second
    /// parameter and then of the first; `None` if the motion cannot be integrated.
    pub stable: Vec<Vec<Option<bool>>>,
    /// Ranges of the second parameter in which the equilibrium is stable, at the least and at the greatest value of the first.
    pub at_ends: [Vec<[f64; 2]>; 2],
    /// Middles of the neighbouring grid points of which one is stable and the other is not, while no boundary that was followed passes between them.
    pub unresolved: Vec<[f64; 2]>,
}

/// Number of grid intervals in each direction.
const INTERVALS: u32 = 32;

/// The grid, with the test functions at its points.
pub(super) struct Grid<'a> {
    family: &'a Family<'a>,
    space: Space,
    rest: &'a [f64],
    values: [Vec<f64>; 2],
    tests: Vec<Vec<Option<(Tests, bool)>>>,
}

/// A point between neighbouring grid points at which a test function vanishes.
#[derive(Clone, Debug)]
pub(super) struct Crossing {
    pub(super) test: Test,
    pub(super) parameters: [f64; 2],
    /// Index of the parameter that varies between the two grid points.
    pub(super) along: usize,
    pub(super) rises: bool,
}

impl<'a> Grid<'a> {
    pub(super) fn new(family: &'a Family<'a>, space: Space, rest: &'a [f64], ranges: [[f64; 2]; 2]) -> Self {
        let values = ranges.map(|[low, high]| {
            let value = |k: u32| low + (high - low) * f64::from(k) / f64::from(INTERVALS);
            (0..=INTERVALS).map(|k| if k == INTERVALS { high } else { value(k) }).collect::<Vec<f64>>()
        });
        let mut grid = Self { family, space, rest, values, tests: vec![] };
        let row = |second: &f64| grid.values[0].iter().map(|first| grid.at([*first, *second])).collect();
        grid.tests = grid.values[1].iter().map(row).collect();
        grid
    }

    /// The stability of the equilibrium over the map, with the boundaries followed from the crossings.
    pub(super) fn stability(&self, edges: &[SpecialCurve]) -> RestStability {
        let stable = |tests: &Option<(Tests, bool)>| tests.as_ref().map(|(_, stable)| *stable);
        let stable = self.tests.iter().map(|row| row.iter().map(stable).collect()).collect();
        let ends = [self.values[0].first(), self.values[0].last()];
        let at_ends = ends.map(|end| end.map_or_else(Vec::new, |first| self.stable_ranges(*first, edges)));
        let unresolved = self.unresolved(edges);
        RestStability { values: self.values.clone(), stable, at_ends, unresolved }
    }

    /// The middles of neighbouring points with different stability between which no boundary passes.
    fn unresolved(&self, edges: &[SpecialCurve]) -> Vec<[f64; 2]> {
        let [columns, rows] = [0, 1].map(|which| self.values[which].len());
        let points = (0..rows).flat_map(|row| (0..columns).map(move |column| [column, row]));
        let pairs = points.flat_map(|[column, row]| {
            [[[column, row], [column + 1, row]], [[column, row], [column, row + 1]]]
        });
        let is_stable =
            |[column, row]: [usize; 2]| self.tests.get(row)?.get(column)?.as_ref().map(|tests| tests.1);
        let values = |[column, row]: [usize; 2]| [self.values[0][column], self.values[1][row]];
        let differ =
            pairs.filter(|[a, b]| matches!((is_stable(*a), is_stable(*b)), (Some(a), Some(b)) if a != b));
        let open =
            differ.map(|pair| pair.map(values)).filter(|pair| !edges.iter().any(|edge| passes(edge, *pair)));
        open.map(|[a, b]| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]).collect()
    }

    /// Returns `true` if the multipliers are pairs λ and 1/λ at all points of the grid, as without damping.
    fn is_reciprocal(&self) -> bool {
        self.tests.iter().flatten().flatten().all(|(tests, _)| tests.is_reciprocal)
    }

    /// The ranges of the second parameter, between the boundaries at this value of the
    /// first, in whose middle the equilibrium is stable; they may be narrower than the grid.
    fn stable_ranges(&self, first: f64, edges: &[SpecialCurve]) -> Vec<[f64; 2]> {
        let ends = edges.iter().flat_map(|edge| &edge.points);
        let ends = ends.filter(|end| end.point.parameter.to_bits() == first.to_bits()).map(|end| end.second);
        let outermost = [self.values[1].first(), self.values[1].last()];
        let mut cuts: Vec<f64> = ends.chain(outermost.into_iter().flatten().copied()).collect();
        cuts.sort_by(f64::total_cmp);
        let mut ranges: Vec<[f64; 2]> = vec![];
        for [from, to] in cuts.windows(2).map(|pair| [pair[0], pair[1]]).filter(|[from, to]| from < to) {
            if self.at([first, 0.5 * (from + to)]).is_none_or(|(_, is_stable)| !is_stable) {
                continue;
            }
            match ranges.last_mut() {
                Some(last) if last[1].to_bits() == from.to_bits() => last[1] = to,
                _ => ranges.push([from, to]),
            }
        }
        ranges
    }

    fn at(&self, parameters: [f64; 2]) -> Option<(Tests, bool)> {
        if self.family.watch.go_on().is_err() {
            return None;
        }
        let image = self.family.image(self.space, self.rest, &parameters, TOLERANCES[0])?;
        let units = self.family.sizes_in(self.family.drive_period(&parameters).unwrap_or(TAU));
        let multipliers = multipliers(&image, &units, 0.0, 0.0)?;
        let tests = Tests::of(&multipliers, 0.0);
        let stability =
            Stability::of(multipliers.iter().map(|(multiplier, error)| (multiplier.abs(), *error)));
        Some((tests, stability.may_last()))
    }

    /// Zeros of the test functions along the lines of the grid.
    pub(super) fn crossings(&self) -> Vec<Crossing> {
        let of_complex = if self.is_reciprocal() { Test::Collision } else { Test::Torus };
        let tests = [Test::Branching, Test::Flip, of_complex];
        let lines = (0..2).flat_map(|along| (0..self.values[1 - along].len()).map(move |line| (along, line)));
        let lines: Vec<(usize, usize)> = lines.collect();
        let of_test =
            |test: Test| lines.iter().flat_map(move |&(along, line)| self.on_line(test, along, line));
        tests.into_iter().flat_map(of_test).collect()
    }

    fn on_line(&self, test: Test, along: usize, line: usize) -> Vec<Crossing> {
        let has_sign = |tests: &Tests| match test {
            Test::Torus => tests.torus.abs() > TORUS_NOISE * tests.noise[2],
            _ => test.of(tests).abs() > test.sure(),
        };
        let values = |value: f64| {
            let across = self.values[1 - along][line];
            if along == 0 { [value, across] } else { [across, value] }
        };
        let point = |at: f64, tests: &Option<(Tests, bool)>| {
            tests.as_ref().filter(|test| has_sign(&test.0)).map(|(tests, _)| (at, test.of(tests)))
        };
        let on_grid = |k: usize| if along == 0 { &self.tests[line][k] } else { &self.tests[k][line] };
        let axis = &self.values[along];
        let points: Vec<Option<Point>> =
            axis.iter().enumerate().map(|(k, at)| point(*at, on_grid(k))).collect();
        let value_at = |at: f64| self.at(values(at)).map_or(f64::NAN, |(tests, _)| test.of(&tests));
        let crossing = |[from, to]: [Point; 2]| {
            /// Width to which a zero is enclosed, relative to the interval: small enough to start Newton's method.
            const WIDTH: f64 = 1e-6;
            let width = WIDTH * (to.0 - from.0).abs();
            let at = zero_between([from, to], Tolerance::absolute(width), value_at)?;
            Some(Crossing { test, parameters: values(at), along, rises: from.1 < to.1 })
        };
        let mut crossings = vec![];
        for k in 1..axis.len() {
            let (Some(before), Some(after)) = (points[k - 1], points[k]) else { continue };
            if (before.1 > 0.0) != (after.1 > 0.0) {
                crossings.extend(crossing([before, after]));
                continue;
            }
            let next = points.get(k + 1).copied().flatten();
            let inner =
                next.and_then(|next| Some((other_sign_between([before, after, next], value_at)?, next)));
            let outer = || match (k, k + 1 == axis.len()) {
                (1, _) => dip_next_to([before, after], value_at),
                (_, true) => dip_next_to([after, before], value_at),
                _ => None,
            };
            let dip = inner.or_else(|| Some((outer()?, after)));
            if let Some((least, end)) =
                dip.filter(|(least, _)| point(least.0, &self.at(values(least.0))).is_some())
            {
                crossings.extend(crossing([before, least]));
                crossings.extend(crossing([least, end]));
            }
        }
        crossings
    }
}

/// A value of a parameter with a test function.
type Point = (f64, f64);

/// The sign of the torus function counts from this multiple of the error that it inherits from the multipliers. That error is of first order in
/// one factor; the function is a product of a factor for each pair, several of which may be small.
const TORUS_NOISE: f64 = 4.0;

/// A point with the opposite sign next to an end of a line, on which the function of one sign is nearer to zero at the end than at the next point.
fn dip_next_to([end, next]: [Point; 2], f: impl Fn(f64) -> f64) -> Option<Point> {
    /// The nearest point tried is this power of a half of the interval away.
    const HALVINGS: u32 = 4;
    if next.1.abs() <= end.1.abs() {
        return None;
    }
    let mut at = next.0;
    for _ in 0..HALVINGS {
        at = 0.5 * (end.0 + at);
        let point = (at, f(at));
        if (point.1 > 0.0) != (end.1 > 0.0) {
            return Some(point).filter(|point| !point.1.is_nan());
        }
        if point.1.abs() < end.1.abs() {
            let mut three = [end, point, next];
            three.put_in_order(|a, b| a.0.total_cmp(&b.0));
            return other_sign_between(three, f);
        }
    }
    None
}

/// Returns `true` if a boundary passes between two points, which are extended a little for the error of linear interpolation.
fn passes(edge: &SpecialCurve, [a, b]: [[f64; 2]; 2]) -> bool {
    const MORE: f64 = 0.1;
    let beyond = |a: [f64; 2], b: [f64; 2]| [0, 1].map(|k| a[k] + MORE * (a[k] - b[k]));
    let [a, b] = [beyond(a, b), beyond(b, a)];
    let side = |[a, b]: [[f64; 2]; 2], point: [f64; 2]| {
        (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0])
    };
    let of = |point: &CurvePoint| [point.point.parameter, point.second];
    edge.points.windows(2).any(|pair| {
        let [c, d] = [of(&pair[0]), of(&pair[1])];
        side([a, b], c) * side([a, b], d) <= 0.0 && side([c, d], a) * side([c, d], b) <= 0.0
    })
}
