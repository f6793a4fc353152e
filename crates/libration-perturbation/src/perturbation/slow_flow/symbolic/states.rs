//! Steady states with numbers, compared with those of other orders.

use super::evaluation::{REACH, SlowFlowAt, SteadySolution};
use std::f64::consts::TAU;

/// The steady states of a slow flow with numbers, with those that it cannot give.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SteadyStates {
    /// States within reach of the series, A rising.
    pub found: Vec<JudgedState>,
    /// States that are left out.
    pub left_out: Vec<StateLeftOut>,
}

/// A steady state compared with other orders.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct JudgedState {
    /// The state.
    pub state: SteadySolution,
    /// Estimated errors of A and φ from the same state at the next order; `None` if there is no such state, or the order is not known.
    pub errors: Option<[f64; 2]>,
    /// `true` if small deviations decay; `None` if two orders disagree, if only one has the state although others are known, and if the trace is
    /// zero.
    pub is_stable: Option<bool>,
}

/// A steady state that is left out.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct StateLeftOut {
    /// The state as the order has it.
    pub state: SteadySolution,
    /// The order that has the state.
    pub order: usize,
    /// The reason.
    pub reason: LeftOutReason,
}

/// The reason why a steady state is left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LeftOutReason {
    /// The terms of higher orders are more than half of those of the lowest order.
    BeyondReach,
    /// A state of the lowest order that the highest order does not have.
    OfLowestOrder {
        /// The highest order of the slow flow.
        absent_at: usize,
    },
}

impl SlowFlowAt<'_> {
    /// The steady states compared with those of the next order and of lower orders; `None` where the relation or the phase is not known.
    #[must_use]
    pub fn judged_states(&self, next: Option<&Self>) -> Option<SteadyStates> {
        let all = self.zeros(0)?;
        let following = next.and_then(|next| next.zeros(0));
        let is_reached = |state: &SteadySolution| next.is_some_and(|next| next.is_reached(state));
        let previous = (self.higher_orders() > 0).then(|| self.zeros(1)).flatten();
        let judged = all.iter().filter(|state| self.is_reached(state)).map(|state| {
            let matching =
                |others: &Option<Vec<SteadySolution>>| self.matching(state, &all, others.as_deref()?);
            let later = matching(&following);
            let other = later.filter(is_reached).or_else(|| matching(&previous));
            let is_alone = following.is_none() && previous.is_none();
            let is_agreed = is_alone || other.is_some_and(|other| other.is_stable == state.is_stable);
            let is_centre = state.trace == 0.0 && state.determinant >= 0.0;
            JudgedState {
                state: *state,
                errors: later.map(|later| self.errors(state, &later)),
                is_stable: (is_agreed && !is_centre).then_some(state.is_stable),
            }
        });
        Some(SteadyStates { found: judged.collect(), left_out: self.left_out(&all) })
    }

    fn left_out(&self, all: &[SteadySolution]) -> Vec<StateLeftOut> {
        let (lowest, order) = self.orders();
        let beyond = all.iter().filter(|state| !self.is_reached(state));
        let beyond = beyond.map(|&state| StateLeftOut { state, order, reason: LeftOutReason::BeyondReach });
        let first = self.zeros(self.higher_orders()).unwrap_or_default();
        let lost = first.iter().filter(|state| self.matching(state, &first, all).is_none());
        let lost = lost.map(|&state| StateLeftOut {
            state,
            order: lowest,
            reason: LeftOutReason::OfLowestOrder { absent_at: order },
        });
        beyond.chain(lost).collect()
    }

    /// The same state at another order: each of the two is the nearest to the other, and their distance is small compared with the amplitude.
    fn matching(
        &self,
        state: &SteadySolution,
        all: &[SteadySolution],
        others: &[SteadySolution],
    ) -> Option<SteadySolution> {
        let nearest = |of: &SteadySolution, list: &[SteadySolution]| {
            let distance = |solution: &SteadySolution| self.distance(of, solution);
            list.iter().copied().min_by(|a, b| distance(a).total_cmp(&distance(b)))
        };
        let other = nearest(state, others)?;
        let is_mutual = nearest(&other, all).as_ref() == Some(state);
        (is_mutual && self.distance(state, &other) <= REACH * state.amplitude).then_some(other)
    }

    /// The distances of A and φ; that of φ is at least that of A divided by A, as it may vanish by accident at one order.
    fn errors(&self, state: &SteadySolution, later: &SteadySolution) -> [f64; 2] {
        let amplitude = (later.amplitude - state.amplitude).abs();
        [amplitude, self.turned(state, later).abs().max(amplitude / state.amplitude)]
    }

    /// The distance of the complex amplitudes A·e^{iφ}.
    fn distance(&self, a: &SteadySolution, b: &SteadySolution) -> f64 {
        let chord = 2.0 * libm::sin(self.turned(a, b) / 2.0);
        libm::hypot(a.amplitude - b.amplitude, libm::sqrt(a.amplitude * b.amplitude) * chord)
    }

    /// The difference of two phases, up to the period of the flow in φ.
    fn turned(&self, a: &SteadySolution, b: &SteadySolution) -> f64 {
        libm::remainder(b.phase - a.phase, TAU / self.phase_harmonic())
    }
}
