//! Steps over positions at which a force has no series, as |x|^1.5 at zero.
//!
//! Before such a position steps become shorter and shorter, in proportion to the distance, and the same after it. The
//! effect of such a force within the time τ of its zero is less than τ^(1 + p); if that is below the tolerance, or τ
//! below the resolution of times, one step of two terms passes the zero, whose end is computed by Picard's iteration.

use super::stepper::{SHORTEST, StepEnds, Stepper, unit_for};
use crate::taylor::Cause;
use crate::taylor::nonsmooth::picard::{PicardStart, PicardStep};
use libration_kernels::dispatch::dispatch_lanes;

/// The position of the zero of a |…|'s argument, in the direction of the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Zero {
    Here,
    After(f64),
}

/// Smallest error required of a stretch, relative to the sizes of its components: Picard's iterates differ by rounding. With 1e-17 the
/// iteration rarely ends, and the zero is passed in up to millions of steps of the resolution of times.
const LEAST_MISFIT: f64 = 1e-16;

/// Ratio of the lengths of stretches that are tried.
const FACTOR: f64 = 16.0;

impl<const N: usize> Stepper<'_, N> {
    /// Takes motions over such positions; `goal_bound` is the value of that field before these steps were computed.
    pub(in crate::taylor) fn pass(&mut self, outcomes: &mut [Result<(), Cause>; N], goal_bound: &[bool; N]) {
        if self.expander.system.passage().is_none() {
            return;
        }
        let mut passed = false;
        for lane in 0..N {
            let Some(zero) = self.zero_ahead(lane, outcomes[lane]) else { continue };
            if let Some(stretch) = self.stretch_over(lane, zero) {
                self.goal_bound[lane] = goal_bound[lane];
                self.lay_out(lane, &stretch);
                outcomes[lane] = Ok(());
                passed = true;
            }
        }
        if passed {
            self.ends_known = false;
            dispatch_lanes::<N, _>(StepEnds { stepper: self });
        }
    }

    /// Returns `true` if a step over a zero replaces a step without series.
    pub(in crate::taylor) fn passes(&self, lane: usize) -> bool {
        let is_passed = |zero| self.stretch_over(lane, zero).is_some();
        self.expander.system.passage().is_some()
            && self.zero_ahead(lane, Err(Cause::Singularity)).is_some_and(is_passed)
    }

    /// The resolution of times near the start of a step, with room for some steps.
    fn resolution(&self, lane: usize) -> f64 {
        const STEPS: f64 = 64.0;
        /// Smallest resolution: below it powers of the time underflow.
        const LEAST: f64 = 1e-100;
        (STEPS * SHORTEST * self.block.start[lane].abs()).max(LEAST)
    }

    /// The nearest zero, if the step begins or ends near it.
    fn zero_ahead(&self, lane: usize, outcome: Result<(), Cause>) -> Option<Zero> {
        /// Number of step lengths within which a zero is taken as the singularity before which the step ended.
        const STEPS: f64 = 8.0;
        let (start, goal) = (self.block.start[lane], self.goal[lane]);
        if (goal - start).abs() == 0.0 {
            return None;
        }
        let step = (self.block.end[lane] - start).abs();
        let farthest = if outcome.is_ok() { STEPS * step } else { f64::INFINITY };
        let zero = |&modulus: &usize| {
            let series = &self.block[self.expander.argument(modulus)];
            let [value, slope] = [0, 1].map(|n| series[n][lane]);
            let way = -value / slope * self.block.unit[lane] * (goal - start).signum();
            match () {
                () if value == 0.0 || way.abs() <= self.resolution(lane) => Some(Zero::Here),
                () if way > 0.0 && way <= farthest => Some(Zero::After(way)),
                () if slope.is_nan() => Some(Zero::Here),
                () => None,
            }
        };
        let zeros = self.expander.system.passage()?.roots().iter().filter_map(zero);
        zeros.reduce(|a, b| match (a, b) {
            (Zero::After(a), Zero::After(b)) => Zero::After(a.min(b)),
            _ => Zero::Here,
        })
    }

    fn beginning(&self, lane: usize) -> Option<PicardStart<'_>> {
        let system = self.expander.system;
        let state: Vec<f64> = self.block.state(lane).collect();
        let mut held = vec![false; state.len()];
        for modulus in 0..system.moduli() {
            if let Some(number) = system.driven_in_modulus(modulus) {
                held[number] |= self.surroundings.sticks[modulus][lane];
            }
        }
        let parameters = self.surroundings.parameters.iter().map(|values| values[lane]).collect();
        let (passage, layout) = (system.passage()?, system.layout());
        Some(PicardStart { passage, layout, time: self.block.start[lane], state, parameters, held })
    }

    /// The motion over a zero, if its error is within the tolerance.
    fn stretch_over(&self, lane: usize, zero: Zero) -> Option<PicardStep> {
        /// Allowed error of the iteration as a fraction of the allowed error of the step: small enough to be negligible.
        const PART: f64 = 0.0625;
        let beginning = self.beginning(lane)?;
        let rates = beginning.first_rates()?;
        let (start, goal) = (self.block.start[lane], self.goal[lane]);
        let direction = (goal - start).signum();
        let resolution = self.resolution(lane);
        let tolerance = self.effort.relative.max(LEAST_MISFIT);
        let along = |length: f64| {
            // Times are exact.
            let length =
                if length < (goal - start).abs() { start + direction * length - start } else { goal - start };
            let stretch = beginning.stretch(&rates, length, PART * tolerance)?;
            let is_good = stretch.misfit <= tolerance || length.abs() <= 4.0 * resolution;
            (is_good && length.abs() > 0.0).then_some(stretch)
        };
        match zero {
            Zero::After(way) => {
                let length = direction * way;
                let changes = beginning.change(&rates, length)?;
                let sizes = beginning.sizes(&rates, length, &changes);
                let is_small =
                    |(change, size): (&f64, &f64)| (change * length).abs() <= FACTOR * tolerance * size;
                let worth_it = way <= resolution || changes.iter().zip(&sizes).all(is_small);
                if worth_it { along(way + way.max(resolution)) } else { None }
            }
            Zero::Here => self.longest(lane, along),
        }
    }

    /// The longest stretch from a zero on.
    fn longest(&self, lane: usize, along: impl Fn(f64) -> Option<PicardStep>) -> Option<PicardStep> {
        const MOST: usize = 280;
        let resolution = self.resolution(lane);
        let whole = (self.goal[lane] - self.block.start[lane]).abs();
        let first = 2.0 * resolution;
        let longer =
            std::iter::successors(Some(first), |length| (*length < whole).then_some(length * FACTOR));
        longer.take(MOST).map_while(along).last()
    }

    /// Replaces the computed step by one along a stretch.
    fn lay_out(&mut self, lane: usize, stretch: &PicardStep) {
        let unit = self.block.unit[lane];
        let start = self.block.start[lane];
        for (number, [first, second]) in stretch.coefficients.iter().enumerate() {
            let row = self.block.row(number);
            let terms = &mut self.block[row];
            terms[1..].iter_mut().for_each(|term| term[lane] = 0.0);
            (terms[1][lane], terms[2][lane]) = (first * unit, second * unit * unit);
        }
        let whole = stretch.length.abs() >= (self.goal[lane] - start).abs();
        self.goal_bound[lane] |= whole;
        self.block.end[lane] = if whole { self.goal[lane] } else { start + stretch.length };
        self.unit[lane] = unit_for(stretch.length.abs());
        self.settle_behind(lane, stretch.length);
        self.branches.pass(lane);
    }

    /// Sets the signs after the step, and the formulas of events in it.
    fn settle_behind(&mut self, lane: usize, length: f64) {
        let Some(beginning) = self.beginning(lane) else { return };
        let (start, end) = (self.block.start[lane], self.block.end[lane]);
        let step = self.block.step(lane);
        let values = [start, start + 0.5 * length, end].map(|time| {
            let state = step.state_at(time);
            beginning.passage.at(time, &state, &beginning.parameters)
        });
        let [Some(first), Some(middle), Some(last)] = values else { return };
        for (modulus, argument) in last.arguments().iter().enumerate() {
            if *argument != 0.0 && !self.surroundings.sticks[modulus][lane] {
                self.surroundings.signs[modulus][lane] = argument.signum();
            }
        }
        let parts = length / self.block.unit[lane];
        let inputs = self.expander.system.tape().inputs();
        for (event, ((a, b), c)) in first.events().iter().zip(middle.events()).zip(last.events()).enumerate()
        {
            let row = self.expander.event(event);
            // The series of the inputs are already set.
            if (0..inputs).any(|number| self.block.row(number) == row) {
                continue;
            }
            let terms = &mut self.block[row];
            terms.iter_mut().for_each(|term| term[lane] = 0.0);
            let (slope, bend) = ((4.0 * b - 3.0 * a - c) / parts, 2.0 * (a - 2.0 * b + c) / (parts * parts));
            (terms[0][lane], terms[1][lane], terms[2][lane]) = (*a, slope, bend);
        }
    }
}
