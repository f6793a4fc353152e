//! Further motions at an end of the range, besides the one from the given start.
//!
//! # Method
//! The estimates of harmonic balance (`harmonic_balance.rs`) are guesses for Newton's method. Attracting motions all begin branches.
//! Of the repelling ones there are infinitely many if motions are chaotic: those that pass the coordinates of the given start begin branches, the
//! smallest first, as long as they are fewer than the attracting ones. In the plane of states a saddle lies between two nodes.

use super::branch::Branch;
use super::corrector::Corrected;
use super::harmonic_balance::HarmonicBalance;
use super::point::BranchPoint;
use super::search::{Search, Start, middle};
use super::space::Space;
use libration_motion::internals::periodic::norm;
use libration_numbers::algebra::Complex;
use libration_numbers::internals::algebra::InOrder;
use libration_numbers::internals::linear::eigenvalues;
use std::f64::consts::TAU;

/// Largest magnitude of a multiplier of a motion that attracts or, without damping, lasts: rounding of the map is smaller.
const LASTS: f64 = 1.0 + 1e-9;

/// Largest difference between states of one motion, relative to their size.
const SAME: f64 = 1e-6;

impl Search<'_> {
    /// The further motions with which branches begin at a value of the parameter, the attracting ones first, beside known motions of this size. If
    /// the drive leaves the given start at rest, as in parametric excitation, they are also searched with twice the period.
    pub(super) fn further_starts(&self, value: f64, known: f64) -> Vec<Start> {
        if !self.family.is_driven() || self.options.rotation.is_some() || self.family.watch.is_stopped() {
            return vec![];
        }
        let periods = self.options.drive_periods;
        let doubled = self.rests(value).then_some(2 * periods);
        let numbers = [periods].into_iter().chain(doubled);
        let reached = numbers.flat_map(|periods| self.reached(value, periods, known));
        let (lasting, mut others): (Vec<_>, Vec<_>) = reached.partition(|(_, largest)| *largest <= LASTS);
        let size = |(start, _): &(Start, f64)| norm(&start.unknowns);
        others.put_in_order(|a, b| size(a).total_cmp(&size(b)));
        others.truncate(lasting.len().saturating_sub(1));
        lasting.into_iter().chain(others).map(|(start, _)| start).collect()
    }

    /// The attracting motions at a value of the parameter, to which estimates lead.
    pub(super) fn lasting_starts(&self, value: f64, known: f64) -> Vec<Start> {
        let reached = self.reached(value, self.options.drive_periods, known).into_iter();
        reached.filter(|(_, largest)| *largest <= LASTS).map(|(start, _)| start).collect()
    }

    /// Values within the range at which motions between wells are searched, if branches have stable motions that do not pass the given state: such
    /// motions may be unstable at both ends.
    pub(super) fn values_between_wells(&self, branches: &[Branch]) -> Vec<f64> {
        /// Parts of the range: a motion that is stable on less than a quarter of it may be missed.
        const PARTS: [f64; 3] = [0.25, 0.5, 0.75];
        let is_sought =
            self.family.is_driven() && self.options.rotation.is_none() && self.options.at.is_none();
        let given = self.given();
        let is_in_well = |point: &BranchPoint| {
            let beside = |(coordinate, [low, high]): (usize, &[f64; 2])| {
                let may_turn =
                    self.family.turning.is_angle(coordinate) || self.family.turning.is_coupled(coordinate);
                !may_turn && !(*low..=*high).contains(&given[coordinate])
            };
            point.is_stable() && point.ranges.iter().enumerate().any(beside)
        };
        let has_wells = branches.iter().flat_map(|branch| &branch.points).any(is_in_well);
        let values = PARTS.map(|part| self.range[0] + part * self.width());
        if is_sought && has_wells { values.to_vec() } else { vec![] }
    }

    /// The state at which motions are searched first: without a given one, zero or the centre of the mirror.
    pub(super) fn given(&self) -> Vec<f64> {
        self.options.start.clone().unwrap_or_else(|| self.family.mirror.rest().to_vec())
    }

    /// `true` if the given state does not move at two times.
    fn rests(&self, value: f64) -> bool {
        let rate = |time: f64| self.family.rate(&self.given(), time, &[value]);
        [0.0, 1.0].into_iter().all(|time| rate(time).is_some_and(|rate| rate.iter().all(|x| *x == 0.0)))
    }

    /// The motions to which Newton's method leads from the estimates, each with the magnitude of its largest multiplier.
    fn reached(&self, value: f64, drive_periods: u32, known: f64) -> Vec<(Start, f64)> {
        /// Multiple of the drive frequency up to which estimates are refined; 5 and 7 led to no more of the motions of 160 double wells.
        const FINE: u32 = 3;
        /// Most centres: the given one, and two wells.
        const MOST_CENTRES: usize = 3;
        let space = Space::of_periods(drive_periods);
        let balance = |multiple| HarmonicBalance::new(self.family, value, drive_periods, multiple);
        let (Some(mut coarse), Some(mut fine)) = (balance(1), balance(FINE)) else { return vec![] };
        let mut centres = vec![self.given()[..self.family.layout.coordinates()].to_vec()];
        let (mut motions, mut done): (Vec<(Start, f64)>, usize) = (vec![], 0);
        while done < centres.len().min(MOST_CENTRES) {
            for estimate in coarse.motions(&centres[done], &self.family.turning, known) {
                let Some(estimate) = fine.refined(estimate) else { continue };
                if self.family.watch.is_stopped() {
                    return motions;
                }
                let Some((start, largest)) = self.reached_near(space, &estimate.state, value) else {
                    continue;
                };
                let repels_elsewhere = largest > LASTS && estimate.is_about_another(&centres[0]);
                if repels_elsewhere || self.has_shorter_period(&start, value) {
                    continue;
                }
                let sizes = self.family.sizes_of(&start.unknowns, value, 0.0);
                let is_same = |(other, _): &(Start, f64)| {
                    self.family.turning.are_near(&other.unknowns, &start.unknowns, &sizes, SAME)
                };
                if motions.iter().any(is_same) {
                    continue;
                }
                if largest <= LASTS && centres.iter().all(|centre| estimate.is_about_another(centre)) {
                    centres.push(estimate.means());
                }
                motions.push((start, largest));
            }
            done += 1;
        }
        motions
    }

    /// `true` if the motion also returns after a part of its periods of the drive.
    fn has_shorter_period(&self, start: &Start, value: f64) -> bool {
        let periods = start.space.drive_periods();
        let Some(period) = self.family.drive_period(&[value]) else { return false };
        let sizes = self.family.sizes_of(&start.unknowns, value, 0.0);
        let returns = |part: &u32| {
            let span = [0.0, period * f64::from(*part)];
            let end = self.family.moved_on(&start.unknowns, value, span);
            end.is_some_and(|end| self.family.turning.are_near(&end, &start.unknowns, &sizes, SAME))
        };
        (1..periods).filter(|part| periods.is_multiple_of(*part)).any(|part| returns(&part))
    }

    /// The isolated motion near a state, with the magnitude of its largest multiplier.
    fn reached_near(&self, space: Space, state: &[f64], value: f64) -> Option<(Start, f64)> {
        let size = norm(state).max(f64::MIN_POSITIVE);
        let rate = TAU / self.family.drive_period(&[value])?;
        let layout = &self.family.layout;
        let sizes = layout.arrange((0..layout.coordinates()).map(|_| size), |_| size * rate);
        let units: Vec<f64> = sizes.into_iter().chain([self.width()]).collect();
        let across: Vec<f64> = (0..units.len()).map(|number| f64::from(number + 1 == units.len())).collect();
        let guess: Vec<f64> = state.iter().copied().chain([value]).collect();
        let Corrected { position: mut unknowns, image, .. } =
            self.corrector(space).corrected(&guess, &across, &units)?;
        unknowns.pop();
        let multipliers = eigenvalues(image.return_map())?;
        /// Half of the digits: where a multiplier is 1, motions form families, or a fold is at the end of the range.
        const ISOLATED: f64 = 1e-8;
        if multipliers.iter().any(|multiplier| (*multiplier - Complex::from(1.0)).abs() < ISOLATED) {
            return None;
        }
        let largest = multipliers.iter().map(|multiplier| multiplier.abs()).fold(0.0, f64::max);
        let ranges = self.family.ranges_of(space, &unknowns, value)?;
        self.family.turning.subtract(&mut unknowns, |coordinate| middle(ranges[coordinate]));
        Some((Start { unknowns, space }, largest))
    }
}
