//! Lengths of the next steps, as far as the series converge, the formulas have values, and the equations of motion agree with the series.

use super::stepper::{SHORTEST, StepEnds, Stepper, unit_for};
use crate::taylor::Cause;
use crate::taylor::step::block::Row;
use crate::taylor::step::ends::Ends;
use crate::taylor::step::larger::larger_or_nan;
use crate::taylor::step::step_length::{log2_time_scale, step_lengths};
use libration_kernels::dispatch::{Kernel, dispatch_lanes};
use libration_kernels::elementary::rough::exp2;
use libration_numbers::internals::algebra::{any, lanes};

impl<const N: usize> Stepper<'_, N> {
    /// Computes the next step of each motion, at most up to its goal.
    pub(in crate::taylor) fn look_ahead(&mut self) -> [Result<(), Cause>; N] {
        let mut outcomes = self.expand_in_fitting_units();
        let goal_bound = self.goal_bound;
        let lengths = dispatch_lanes::<N, _>(LengthsKernel { stepper: self });
        match dispatch_lanes::<N, _>(EndsOnOpenWays { stepper: self, lengths: &lengths }) {
            Some(ends) => (self.block.end, self.unit) = (ends, lanes(|lane| unit_for(lengths[lane]))),
            None => self.look_for_ends(&lengths, &mut outcomes),
        }
        self.confirm(&mut outcomes);
        if self.expander.system.moduli() > 0 {
            self.branches.cut(&self.expander, &mut self.block, &mut self.surroundings);
            dispatch_lanes::<N, _>(StepEnds { stepper: self });
        }
        self.pass(&mut outcomes, &goal_bound);
        let is_finite = |ends: &Ends<N>| {
            let ends: [f64; N] = lanes(|lane| ends.high[lane] + ends.low[lane]);
            !any(&ends, |end| !end.is_finite())
        };
        if self.next.iter().all(is_finite) && outcomes.iter().all(Result::is_ok) {
            return outcomes;
        }
        let finite =
            |lane: usize| self.next.iter().all(|ends| (ends.high[lane] + ends.low[lane]).is_finite());
        let outcome = |lane: usize| if finite(lane) { outcomes[lane] } else { Err(Cause::Singularity) };
        std::array::from_fn(|lane| outcome(lane).map_err(|cause| self.cause_where_it_is(lane, cause)))
    }

    /// Computes the ends of the steps, lane by lane.
    fn look_for_ends(&mut self, lengths: &[f64; N], outcomes: &mut [Result<(), Cause>; N]) {
        let endless: [bool; N] = std::array::from_fn(|lane| self.is_endless(lane, lengths[lane]));
        let powers = self.expander.system.passage().is_some();
        for lane in 0..N {
            let end = match endless[lane] {
                true if self.sticks(lane) => Ok(self.goal[lane]),
                true => self.end_of_finite_states(lane).and_then(|end| self.confirmed_end(lane, end)),
                false => self.end_towards_goal(lane, lengths[lane]),
            };
            self.goal_bound[lane] |= endless[lane] || end == Ok(self.goal[lane]);
            self.unit[lane] = if endless[lane] { self.block.unit[lane] } else { unit_for(lengths[lane]) };
            let end = if endless[lane] || powers {
                end.map(|end| self.end_before_cancellation(lane, end))
            } else {
                end
            };
            let end = end.and_then(|end| self.end_before_boundary(lane, end, lengths[lane]));
            self.block.end[lane] = end.unwrap_or(self.block.start[lane]);
            outcomes[lane] = outcomes[lane].and(end.map(|_| ()));
        }
    }

    /// The cause of the missing step, corrected by the state. Next to a singularity at a finite time steps end long before this.
    fn cause_where_it_is(&self, lane: usize, cause: Cause) -> Cause {
        if self.is_far(lane) { Cause::OutOfRange } else { cause }
    }

    fn is_far(&self, lane: usize) -> bool {
        /// Size of the state above which it counts as divergent: coefficients of order 63 in a unit of 64 steps may be 1e113 times as large.
        const FAR: f64 = 1e190;
        self.block.state(lane).any(|number| number.abs() > FAR)
    }

    /// Expands the steps; at the beginning of a motion a second time, if its time scale requires another unit.
    fn expand_in_fitting_units(&mut self) -> [Result<(), Cause>; N] {
        /// Largest base-2 logarithm of the change of units: it changes coefficients
        /// of order 63 by a factor of 2⁶³⁰, which an `f64` can represent.
        const FITS: f64 = 10.0;
        let outcomes = self.expand();
        let fresh = std::mem::replace(&mut self.fresh, [false; N]);
        let scales =
            if fresh.contains(&true) { log2_time_scale(&self.block, &self.allowances) } else { [0.0; N] };
        let mut fits = true;
        for lane in
            (0..N).filter(|&lane| fresh[lane] && scales[lane].is_finite() && scales[lane].abs() > FITS)
        {
            self.block.unit[lane] = unit_for(exp2(scales[lane]));
            fits = false;
        }
        let outcomes = if fits { outcomes } else { self.expand() };
        self.expand_in_smaller_units(outcomes)
    }

    /// Expands again, in smaller units, the steps whose coefficients overflow: where a force is far below the last bit, the first terms show no
    /// time scale, and before a potential wall the unit is that of the free flight that ended there.
    fn expand_in_smaller_units(&mut self, mut outcomes: [Result<(), Cause>; N]) -> [Result<(), Cause>; N] {
        /// Factor between two units, 2⁻¹⁶: it changes coefficients of order 63 by a factor of
        /// 1e-303, so that no coefficient underflows in the first unit in which none overflows.
        const SMALLER: f64 = 1.0 / 65_536.0;
        /// Number of units: a force of 1e-308 in a state of size one suggests a unit that is too large by 2¹⁰⁰.
        const UNITS: usize = 16;
        for _ in 0..UNITS {
            let is_regular = self.block.last_coefficients().all(|last| !any(last, |c| !c.is_finite()));
            if is_regular && (0..N).all(|lane| self.has_force_at_rest(lane)) {
                break;
            }
            let overflows: [bool; N] = std::array::from_fn(|lane| self.overflows(lane));
            if !overflows.contains(&true) {
                break;
            }
            for lane in (0..N).filter(|&lane| overflows[lane]) {
                self.block.unit[lane] *= SMALLER;
            }
            outcomes = self.expand();
        }
        outcomes
    }

    /// Returns `true` if the coefficients of a moving lane grow until numbers exceed their range; at a singularity they have no values from
    /// the first one on.
    fn overflows(&self, lane: usize) -> bool {
        /// Growth of coefficients after the first two, in the state or in a part of a formula, that shows an overflow.
        const GROWN: f64 = 1e20;
        let moves = (self.goal[lane] - self.block.start[lane]).abs() > 0.0;
        if self.is_regular(lane) && self.has_force_at_rest(lane) || !moves || self.is_far(lane) {
            return false;
        }
        let largest = |series: &[[f64; N]]| {
            let finite = series.iter().map(|c| c[lane].abs()).filter(|c| c.is_finite());
            finite.fold(0.0, f64::max)
        };
        let mut rows = self.block.rows().map(|row| row.split_at(2));
        rows.any(|(first, later)| largest(later) > GROWN * largest(first)) && !self.passes(lane)
    }

    fn expand(&mut self) -> [Result<(), Cause>; N] {
        let (expander, block) = (&self.expander, &mut self.block);
        if expander.system.moduli() == 0 {
            match std::mem::take(&mut self.begun) {
                true => expander.expand_begun(block, &self.surroundings),
                false => expander.expand(block, &self.surroundings),
            }
            return [Ok(()); N];
        }
        let backward = std::array::from_fn(|lane| self.goal[lane] < block.start[lane]);
        self.branches.settle(expander, block, &mut self.surroundings, &backward)
    }

    fn is_endless(&self, lane: usize, length: f64) -> bool {
        length == f64::INFINITY && (self.goal[lane] - self.block.start[lane]).abs() > 0.0
    }

    /// The end of a step of this length, rounded to an `f64`, so that times are exact.
    fn end_towards_goal(&self, lane: usize, length: f64) -> Result<f64, Cause> {
        let (start, goal) = (self.block.start[lane], self.goal[lane]);
        let remaining = goal - start;
        if !self.is_regular(lane) {
            return Err(Cause::Singularity);
        }
        if length >= remaining.abs() {
            return Ok(goal);
        }
        let end = start + length.copysign(remaining);
        if (end - start).abs() > SHORTEST * start.abs() { Ok(end) } else { Err(Cause::StepUnderflow) }
    }

    /// The end of a step, or an earlier time if a boundary of the formulas lies in the step and the formulas beyond it disagree with the series.
    /// Steps close to the boundary either resolve it in their series or become too short.
    fn end_before_boundary(&mut self, lane: usize, end: f64, length: f64) -> Result<f64, Cause> {
        /// Fraction of the distance to the boundary that a step may cover; the next begins with an eighth of it left.
        const TOWARDS: f64 = 0.875;
        /// Distance from a boundary, in tolerances of the change in the step, within which the boundary
        /// is examined: the series of √(x² + ε²) resolve ε²/x² if it is not below one tolerance.
        const NEAR: f64 = 1e4;
        /// Largest such distance relative to the change: with tolerances above 1e-6 every boundary would be examined in every step.
        const WIDEST: f64 = 1e-2;
        if self.expander.plan.boundaries.is_empty() || self.sticks(lane) {
            return Ok(end);
        }
        let start = self.block.start[lane];
        let units = (end - start) / self.block.unit[lane];
        let blur = (NEAR * self.effort.relative).min(WIDEST);
        let boundaries = self.expander.plan.boundaries.iter();
        let contacts =
            boundaries.filter_map(|boundary| boundary.first_contact(&self.block, lane, units, blur));
        let Some(first) = contacts.reduce(f64::min) else { return Ok(end) };
        let nominal = if length.is_finite() { length.copysign(end - start) } else { end - start };
        if self.goes_on_behind(lane, start + first * (end - start), nominal) {
            return Ok(end);
        }
        let nearer = start + TOWARDS * first * (end - start);
        if (nearer - start).abs() <= SHORTEST * start.abs() {
            return Err(Cause::Singularity);
        }
        // With the length of the whole step as its unit, the next series would overflow.
        self.unit[lane] = unit_for((nearer - start).abs());
        Ok(nearer)
    }

    /// Returns `true` if the accelerations after a time also agree with the series, as at a removable singularity.
    ///
    /// Up to a quarter of a step beyond its end the error of the series is 39·2⁻¹⁴·1.25³⁹ = 14 tolerances at the highest order.
    fn goes_on_behind(&mut self, lane: usize, time: f64, length: f64) -> bool {
        const PARTS: [f64; 4] = [0.25, 0.125, 0.0625, 0.03125];
        const TOLERANCES: f64 = 100.0;
        let bound = TOLERANCES * self.effort.relative.max(f64::EPSILON);
        PARTS.iter().all(|part| self.misfit(lane, time + part * length, length) <= bound)
    }

    /// The error of the velocities after a time, relative to their size, if accelerations were those of the series; not less than the relative
    /// error of the accelerations themselves, which a short time does not reduce. Errors have a smaller weight if a larger tolerance is allowed.
    fn misfit(&mut self, lane: usize, time: f64, length: f64) -> f64 {
        let step = self.block.step(lane);
        let state = step.state_at(time);
        let Self { expander, scratch, surroundings, allowances, .. } = self;
        let layout = expander.system.layout();
        let exact = expander.accelerations(scratch, time, &state, surroundings);
        let parts = exact.enumerate().map(|(i, exact)| {
            let driven = layout.driven(i);
            let slope = step.slope_at(driven, time);
            let held = if layout.is_velocity(driven) { step.coefficient(driven, 0).abs() } else { 0.0 };
            let speed = held.max((slope * length).abs());
            let rate = (length.abs() / speed).max(1.0 / exact[lane].abs().max(slope.abs()));
            let error = (exact[lane] - slope).abs();
            if error == 0.0 { 0.0 } else { error * rate * allowances[i].weight }
        });
        parts.fold(0.0, larger_or_nan)
    }

    /// Returns `true` if the last coefficients are finite, which depend on all earlier ones.
    fn is_regular(&self, lane: usize) -> bool {
        self.block.last_coefficients().all(|c| c[lane].is_finite())
    }

    /// Returns `false` if friction holds a motion, whose series are then finite, against a force whose series overflows.
    fn has_force_at_rest(&self, lane: usize) -> bool {
        !self.sticks(lane) || self.block.rows().flatten().all(|c| c[lane].is_finite())
    }

    /// The latest end at which series that seem to be polynomials do not overflow.
    fn end_of_finite_states(&self, lane: usize) -> Result<f64, Cause> {
        /// Halvings after which the longest span, 1.8e308, is 1e-23.
        const HALVINGS: usize = 1100;
        let start = self.block.start[lane];
        let ends = std::iter::successors(Some(self.goal[lane]), |end| Some(start + 0.5 * (end - start)));
        let mut ends = ends.take(HALVINGS).take_while(|&end| (end - start).abs() > 0.0);
        let is_finite =
            |end: f64| self.block.step(lane).state_at(end).iter().all(|number| number.is_finite());
        ends.find(|&end| is_finite(end)).ok_or(Cause::StepUnderflow)
    }
}

/// Computes the ends of steps that are shorter than the distances to the goals
/// and contain no boundary or turn; `None` if that does not hold for all lanes.
struct EndsOnOpenWays<'f, 'a, const N: usize> {
    stepper: &'f Stepper<'a, N>,
    lengths: &'f [f64; N],
}

impl<const N: usize> Kernel for EndsOnOpenWays<'_, '_, N> {
    type Output = Option<[f64; N]>;

    #[inline(always)]
    fn run(self) -> Option<[f64; N]> {
        let Self { stepper: Stepper { expander, block, goal, .. }, lengths } = self;
        let (start, unit) = (&block.start, &block.unit);
        let ends = lanes(|lane| start[lane] + lengths[lane].copysign(goal[lane] - start[lane]));
        let units: [f64; N] = lanes(|lane| (ends[lane] - start[lane]) / unit[lane]);
        let mut open = expander.system.moduli() == 0;
        for lane in 0..N {
            open &= lengths[lane] < (goal[lane] - start[lane]).abs();
            open &= (ends[lane] - start[lane]).abs() > SHORTEST * start[lane].abs();
        }
        for last in block.last_coefficients() {
            open &= !any(last, |c| !c.is_finite());
        }
        for boundary in &expander.plan.boundaries {
            open = open && boundary.is_far(block, &units);
        }
        open.then_some(ends)
    }
}

/// The kernel that computes the lengths of the steps.
struct LengthsKernel<'f, 'a, const N: usize> {
    stepper: &'f Stepper<'a, N>,
}

impl<const N: usize> Kernel for LengthsKernel<'_, '_, N> {
    type Output = [f64; N];

    #[inline(always)]
    fn run(self) -> [f64; N] {
        let Stepper { expander, surroundings, block, effort, allowances, log2_part_of_radius, .. } =
            self.stepper;
        let moduli = surroundings.sticks.iter().enumerate().filter(|(_, sticks)| sticks.contains(&true));
        let signs = moduli.map(|(modulus, _)| expander.sign(block, modulus));
        let shown = |event: &usize| expander.system.sharp(*event).is_none_or(|formula| !formula.ends);
        let events = (0..expander.system.events().len()).filter(shown).map(|event| expander.event(event));
        let as_long = signs.chain(events).map(|row| (row, 0.0));
        // The positions at which a force jumps have no error beyond rounding, whatever the tolerance.
        let shorter = |&row: &Row| (row, effort.log2_longer(f64::EPSILON).min(0.0));
        let others = as_long.chain(expander.plan.curved.iter().map(shorter));
        step_lengths(block, others, allowances, effort.absolute, *log2_part_of_radius)
    }
}
