//! Stability boundaries of an equilibrium over two parameters, found on a grid.

use super::curve::SpecialCurve;
use super::description::multipliers;
use super::family::{Family, TOLERANCES};
use super::node::Tests;
use super::space::Space;
use super::special::Test;
use libration_motion::orbit::Stability;
use libration_numbers::internals::roots::other_sign_between;
use libration_numbers::roots::{Tolerance, zero_between};

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
    pub(super) place: [f64; 2],
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
        let stable = |it: &Option<(Tests, bool)>| it.as_ref().map(|(_, stable)| *stable);
        let stable = self.tests.iter().map(|row| row.iter().map(stable).collect()).collect();
        let ends = [self.values[0].first(), self.values[0].last()];
        let at_ends = ends.map(|end| end.map_or_else(Vec::new, |first| self.stable_ranges(*first, edges)));
        RestStability { values: self.values.clone(), stable, at_ends }
    }

    /// The ranges of the second parameter, between the boundaries at this value of the
    /// first, in whose middle the equilibrium is stable; they may be narrower than the grid.
    fn stable_ranges(&self, first: f64, edges: &[SpecialCurve]) -> Vec<[f64; 2]> {
        let ends = edges.iter().flat_map(|edge| &edge.points);
        let ends = ends.filter(|it| it.point.parameter.to_bits() == first.to_bits()).map(|it| it.second);
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

    fn at(&self, place: [f64; 2]) -> Option<(Tests, bool)> {
        if self.family.watch.go_on().is_err() {
            return None;
        }
        let image = self.family.image(self.space, self.rest, &place, TOLERANCES[0])?;
        let tests = Tests::new(&image, 0.0)?;
        let own = multipliers(&image, &vec![1.0; self.rest.len()], 0.0, 0.0)?;
        let stability = Stability::of(own.iter().map(|(it, error)| (it.abs(), *error)));
        Some((tests, stability.may_last()))
    }

    /// Zeros of the test functions along the lines of the grid.
    pub(super) fn crossings(&self) -> Vec<Crossing> {
        let tests = [Test::Branching, Test::Flip, Test::Torus];
        let lines = (0..2).flat_map(|along| (0..self.values[1 - along].len()).map(move |line| (along, line)));
        let lines: Vec<(usize, usize)> = lines.collect();
        let of_test =
            |test: Test| lines.iter().flat_map(move |&(along, line)| self.on_line(test, along, line));
        tests.into_iter().flat_map(of_test).collect()
    }

    fn on_line(&self, test: Test, along: usize, line: usize) -> Vec<Crossing> {
        let values: Vec<Option<f64>> = (0..self.values[along].len())
            .map(|k| {
                let it = if along == 0 { &self.tests[line][k] } else { &self.tests[k][line] };
                it.as_ref().map(|(tests, _)| test.of(tests)).filter(|value| value.abs() > test.sure())
            })
            .collect();
        let place = |value: f64| {
            let across = self.values[1 - along][line];
            if along == 0 { [value, across] } else { [across, value] }
        };
        let value_at = |at: f64| self.at(place(at)).map_or(f64::NAN, |(tests, _)| test.of(&tests));
        let axis = &self.values[along];
        let crossing = |[from, to]: [(f64, f64); 2]| {
            /// Width to which a zero is enclosed, relative to the interval: small enough to start Newton's method.
            const WIDTH: f64 = 1e-6;
            let width = WIDTH * (to.0 - from.0).abs();
            let at = zero_between([from, to], Tolerance::absolute(width), value_at)?;
            Some(Crossing { test, place: place(at), along, rises: from.1 < to.1 })
        };
        let mut found = vec![];
        for k in 1..axis.len() {
            let (Some(before), Some(after)) = (values[k - 1], values[k]) else { continue };
            let ends = [(axis[k - 1], before), (axis[k], after)];
            if (before > 0.0) != (after > 0.0) {
                found.extend(crossing(ends));
            } else if let Some(next) = values.get(k + 1).copied().flatten()
                && let Some(least) = other_sign_between([ends[0], ends[1], (axis[k + 1], next)], value_at)
                && least.1.abs() > test.sure()
            {
                found.extend(crossing([ends[0], least]));
                found.extend(crossing([least, (axis[k + 1], next)]));
            }
        }
        found
    }
}
