//! Sub- and superharmonic responses, found from free oscillations.
//!
//! # Method
//! Isolas are found from free oscillations. At each of sixteen values, the free oscillations with p/q of the drive frequency are
//! released from rest. The work of drive and damping on them over q periods of the drive vanishes at two phases, or the drive is
//! too weak to first order (`energy_balance.rs`). These zeros do not depend on the common strength of drive and damping. Near
//! them there is a response under a tenth of drive and damping (or a fiftieth, or a 250th), which is followed to full strength
//! (`full_strength.rs`). A response that is already on a branch, in any period of the drive or mirrored, is left out.

use super::branch::{Branch, Origin, Walked};
use super::energy_balance::{EnergyBalance, Frequencies, Work};
use super::error::BranchError;
use super::full_strength::ToFullStrength;
use super::jumps::landing;
use super::order::ResonanceOrder;
use super::search::{Search, Start};
use super::space::{Space, Symmetry};
use libration_motion::orbit::Orbit;
use libration_numbers::expression::Equation;

/// Result of the search for responses of an order.
#[derive(Clone, Debug, PartialEq)]
pub struct OrderAnswers {
    /// The order.
    pub order: ResonanceOrder,
    /// Number of new branches of the order.
    pub branches: usize,
    /// Result of the search.
    pub finding: OrderFinding,
}

/// Result of the search for responses of an order.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub enum OrderFinding {
    /// Free oscillations with this frequency do not exist.
    NoOscillation,
    /// To first order, the work of the drive on the free oscillations does not depend on the phase of the oscillations.
    NoWork,
    /// The largest fraction of the energy lost to damping that the drive supplies at any phase, to first order.
    TooWeak(f64),
    /// Balanced oscillations were found, but none leads to a response at full drive and damping.
    NotReached,
    /// Responses were found.
    Found,
}

/// Number of parameter values at which free oscillations are tried, each in the middle of one of as many equal parts of the range.
const VALUES: u32 = 16;

impl Search<'_> {
    /// The branches of an order that are not yet followed; progress is reported for each.
    pub(super) fn of_order(
        &self,
        order: ResonanceOrder,
        branches: &mut Vec<Branch>,
        mut told: impl FnMut(&Walked),
    ) -> Result<OrderAnswers, BranchError> {
        let (mut finding, before) = (OrderFinding::NoOscillation, branches.len());
        let mut last: Option<(Equation, Frequencies)> = None;
        for k in 0..VALUES {
            if self.family.watch.is_stopped() {
                break;
            }
            let value = self.range[0] + self.width() * (f64::from(k) + 0.5) / f64::from(VALUES);
            let Some(drive) = self.family.drive_period(&[value]) else { continue };
            let equation = self.at(value).map_err(BranchError::NoStart)?;
            let balance =
                EnergyBalance::new(equation, self.family.scale).ok_or(BranchError::NotOneOscillator)?;
            let ratio = f64::from(order.oscillations()) / f64::from(order.drive_periods());
            let frequency = ratio * std::f64::consts::TAU / drive;
            let frequencies = match last.take() {
                Some((free, frequencies)) if free == balance.free => frequencies,
                _ => balance.frequencies(),
            };
            let orbits = balance.oscillations(&frequencies, frequency);
            last = Some((balance.free.clone(), frequencies));
            for orbit in &orbits {
                let reached =
                    self.reached_from(&balance, orbit, [value, drive], order, branches, &mut told)?;
                if reached > finding {
                    finding = reached;
                }
            }
        }
        Ok(OrderAnswers { order, branches: branches.len() - before, finding })
    }

    fn reached_from(
        &self,
        balance: &EnergyBalance,
        orbit: &Orbit,
        [value, drive]: [f64; 2],
        order: ResonanceOrder,
        branches: &mut Vec<Branch>,
        told: &mut impl FnMut(&Walked),
    ) -> Result<OrderFinding, BranchError> {
        let states = match balance.work(orbit, order, drive) {
            Work::WithoutPhase => return Ok(OrderFinding::NoWork),
            Work::TooWeak(part) => return Ok(OrderFinding::TooWeak(part)),
            Work::Balanced(states) => states,
        };
        let space = Space::of_periods(order.drive_periods());
        let (low, high) = orbit.range(0);
        let mut finding = OrderFinding::NotReached;
        let Some(way) = ToFullStrength::new(balance, self.family.watch) else { return Ok(finding) };
        for state in states {
            let Some(answer) = way.answer(space, &state, 0.5 * (high - low)) else { continue };
            let start = Start { unknowns: answer.state, space };
            let smallest = self.smallest(space, &start.unknowns, value);
            if smallest.drive_periods() < order.drive_periods() {
                continue;
            }
            finding = OrderFinding::Found;
            if self.is_followed(branches, value, &start) {
                continue;
            }
            let Some(mut walked) = self.both_ways(value, &start)? else { continue };
            walked.branch.origin = Origin::FreeOscillation;
            told(&walked);
            branches.push(walked.branch);
        }
        Ok(finding)
    }

    /// Returns `true` if a motion, begun at another period of the drive or mirrored, is on one of the branches.
    pub(super) fn is_followed(&self, branches: &[Branch], value: f64, start: &Start) -> bool {
        /// Largest difference relative to the size of the state.
        const SAME: f64 = 1e-6;
        let pairs = branches.iter().flat_map(|branch| {
            branch.points.windows(2).map(move |pair| (branch.space, [&pair[0], &pair[1]]))
        });
        let mut here = pairs.filter(|(_, [a, b])| (a.parameter < value) != (b.parameter < value));
        if self.family.is_driven() && start.unknowns == self.family.mirror.rest() {
            return here.any(|(_, ends)| ends.into_iter().all(|end| self.family.is_at_rest(end)));
        }
        let is_driven = self.family.is_driven();
        let periods = start.space.drive_periods();
        let same = here.filter(|(space, _)| !is_driven || space.drive_periods() == periods);
        let mut landings =
            same.map(|(space, pair)| landing(&self.corrector(space), pair, value, self.width()));
        if !is_driven {
            return landings.any(|point| self.is_cycle(start, value, &point, SAME));
        }
        let Some(copies) = self.copies(start, value) else { return false };
        let sizes = self.family.sizes_of(&start.unknowns, value, 0.0);
        let is_copy =
            |state: &[f64]| copies.iter().any(|copy| self.family.turning.are_near(copy, state, &sizes, SAME));
        landings.any(|landing| is_copy(&landing.state))
    }

    /// The states of a motion and of its mirror image at each time at which the phase of the drive is zero.
    pub(super) fn copies(&self, start: &Start, value: f64) -> Option<Vec<Vec<f64>>> {
        let mut copies = vec![];
        let mut state = start.unknowns.clone();
        let halves = 2 * start.space.drive_periods();
        let half = 0.5 * self.family.drive_period(&[value])?;
        for number in 0..halves {
            let mirrored = || self.family.mirror.image_of(&state);
            let is_whole = number % 2 == 0;
            match self.family.symmetry {
                Some(Symmetry::Unshifted) if is_whole => copies.push(mirrored()),
                Some(Symmetry::HalfPeriod) if !is_whole => copies.push(mirrored()),
                _ => {}
            }
            if is_whole {
                copies.push(state.clone());
            }
            state = self.family.moved_on(
                &state,
                value,
                [f64::from(number), f64::from(number + 1)].map(|multiple| multiple * half),
            )?;
        }
        Some(copies)
    }
}
