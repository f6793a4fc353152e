//! Several motions side by side, each with steps of its own.

use super::block::{Block, Row};
use super::branches::Branches;
use super::checkpoint::{Checkpoint, ModulusCheckpoint};
use super::ends::Ends;
use super::expander::{Expander, Surroundings};
use super::sign_change::scaled;
use super::step_length::{log2_time_scale, step_lengths};
use super::trial::larger_or_nan;
use super::{Cause, Effort, Moment, Step, System};
use crate::dispatch::{Kernel, dispatch};
use crate::elementary::rough::exp2;

/// N motions under way: where they are, and the steps that lead on.
#[derive(Debug)]
pub(super) struct Flight<'a, const N: usize> {
    pub(super) expander: Expander<'a>,
    branches: Branches<N>,
    pub(super) surroundings: Surroundings<N>,
    pub(super) block: Block<N>,
    /// Room for the accelerations in other states.
    pub(super) scratch: Block<N>,
    /// Whether that has the zeroth coefficients of all formulas at the ends of the steps.
    pub(super) ends_known: bool,
    /// Whether the block has those at their starts.
    begun: bool,
    pub(super) next: Vec<Ends<N>>,
    /// Where the motions are going.
    goal: [f64; N],
    /// The units of time for the next steps.
    pub(super) unit: [f64; N],
    /// Motions whose scale of time is not known yet.
    fresh: [bool; N],
    /// Motions with a step that would have ended elsewhere on the way to another goal.
    goal_bound: [bool; N],
    pub(super) effort: Effort,
    log2_part_of_radius: f64,
}

/// Steps that are no longer than this part of the time are lost in its roundings.
pub(super) const SHORTEST: f64 = 8.0 * f64::EPSILON;

impl<'a, const N: usize> Flight<'a, N> {
    pub(super) fn new(system: &'a System, effort: Effort) -> Self {
        let (order, numbers) = (effort.order(), 2 * system.coordinates());
        let expander = Expander::new(system, order);
        Self {
            branches: Branches::new(system.moduli()),
            surroundings: Surroundings {
                parameters: vec![[0.0; N]; system.parameters().len()],
                signs: vec![[1.0; N]; system.moduli()],
                sticks: vec![[false; N]; system.moduli()],
            },
            block: expander.block(),
            scratch: expander.block(),
            ends_known: false,
            begun: false,
            expander,
            next: vec![Ends { high: [0.0; N], low: [0.0; N] }; numbers],
            goal: [0.0; N],
            unit: [1.0; N],
            fresh: [false; N],
            goal_bound: [false; N],
            effort,
            log2_part_of_radius: effort.log2_part_of_radius(),
        }
    }

    /// Begins a motion in a lane.
    pub(super) fn launch(&mut self, lane: usize, start: &Moment, parameters: &[f64], goal: f64) {
        self.block.launch(lane, start.time, &start.state);
        self.begun = false;
        self.branches.launch(lane);
        (self.goal[lane], self.fresh[lane], self.goal_bound[lane]) = (goal, true, false);
        for (parameter, &value) in self.surroundings.parameters.iter_mut().zip(parameters) {
            parameter[lane] = value;
        }
        let Surroundings { signs, sticks, .. } = &mut self.surroundings;
        for (sign, sticks) in signs.iter_mut().zip(sticks) {
            (sign[lane], sticks[lane]) = (1.0, false);
        }
    }

    /// Goes on with a motion in a lane, which has been launched.
    pub(super) fn resume(&mut self, lane: usize, checkpoint: &Checkpoint) {
        for (number, &[high, low]) in checkpoint.state.iter().enumerate() {
            self.block.place(number, lane, high, low);
        }
        (self.block.unit[lane], self.fresh[lane], self.begun) = (checkpoint.unit, false, false);
        self.branches.resume(lane, checkpoint.moduli.iter().map(|modulus| modulus.zeros));
        let Surroundings { signs, sticks, .. } = &mut self.surroundings;
        for ((sign, sticks), modulus) in signs.iter_mut().zip(sticks).zip(&checkpoint.moduli) {
            (sign[lane], sticks[lane]) = (modulus.sign, modulus.sticks);
        }
    }

    /// Where the step leads, to be gone on from; `None` if on the way to another goal a step would have ended elsewhere.
    pub(super) fn checkpoint(&self, lane: usize) -> Option<Checkpoint> {
        let moduli = (0..self.surroundings.signs.len()).map(|modulus| ModulusCheckpoint {
            sign: self.surroundings.signs[modulus][lane],
            sticks: self.surroundings.sticks[modulus][lane],
            zeros: self.branches.zeros(modulus, lane),
        });
        (!self.goal_bound[lane]).then(|| Checkpoint {
            time: self.block.end[lane],
            state: self.next.iter().map(|ends| [ends.high[lane], ends.low[lane]]).collect(),
            unit: self.unit[lane],
            moduli: moduli.collect(),
            events: vec![],
            steps: 0,
        })
    }

    /// Lets a lane stay where it is.
    pub(super) fn rest(&mut self, lane: usize) {
        self.goal[lane] = self.block.start[lane];
    }

    /// The steps from where the motions are towards their goals, at most up to them.
    pub(super) fn look_ahead(&mut self) -> [Result<(), Cause>; N] {
        let mut outcomes = self.expand_in_fitting_units();
        let lengths = dispatch(Lengths { flight: self });
        let endless: [bool; N] = std::array::from_fn(|lane| self.is_endless(lane, lengths[lane]));
        for lane in 0..N {
            let end = match endless[lane] {
                true if self.sticks(lane) => Ok(self.goal[lane]),
                true => self.end_of_finite_states(lane).and_then(|end| self.confirmed_end(lane, end)),
                false => self.end_towards_goal(lane, lengths[lane]),
            };
            self.goal_bound[lane] |= endless[lane] || end == Ok(self.goal[lane]);
            self.unit[lane] = if endless[lane] { self.block.unit[lane] } else { unit_for(lengths[lane]) };
            let end = end.and_then(|end| self.end_before_boundary(lane, end, lengths[lane]));
            self.block.end[lane] = end.unwrap_or(self.block.start[lane]);
            outcomes[lane] = outcomes[lane].and(end.map(|_| ()));
        }
        self.confirm(&mut outcomes);
        if self.expander.system.moduli() > 0 {
            self.branches.cut(&self.expander, &mut self.block, &mut self.surroundings);
            dispatch(Arrival { flight: self });
        }
        let finite =
            |lane: usize| self.next.iter().all(|ends| (ends.high[lane] + ends.low[lane]).is_finite());
        let outcome = |lane: usize| if finite(lane) { outcomes[lane] } else { Err(Cause::Singularity) };
        std::array::from_fn(|lane| outcome(lane).map_err(|cause| self.cause_where_it_is(lane, cause)))
    }

    /// Why there is no step, as the state tells it. Next to a singularity at a finite time steps end long before.
    fn cause_where_it_is(&self, lane: usize, cause: Cause) -> Cause {
        /// Coefficients of order 63 in a unit of 64 steps may be 1e113 times as large.
        const FAR: f64 = 1e190;
        let is_far = self.block.state(lane).any(|number| number.abs() > FAR);
        if is_far { Cause::OutOfRange } else { cause }
    }

    /// Goes to the ends of the steps.
    pub(super) fn go_on(&mut self) {
        self.block.begin_at_end(&self.next, &self.unit);
        if self.ends_known {
            self.expander.program.begin_as(&self.scratch, &mut self.block);
        }
        self.begun = std::mem::take(&mut self.ends_known);
    }

    pub(super) fn step(&self, lane: usize) -> Step<'_> {
        self.block.step(lane)
    }

    /// The series of the formula of an event, with the part of the step as variable.
    pub(super) fn event(&self, event: usize, lane: usize) -> Vec<f64> {
        let length = (self.block.end[lane] - self.block.start[lane]) / self.block.unit[lane];
        let series = self.block[self.expander.event(event)].iter();
        scaled(series.map(|c| c[lane]), length)
    }

    /// Where a step leads.
    pub(super) fn end(&self, lane: usize) -> Moment {
        let state = self.next.iter().map(|ends| ends.high[lane] + ends.low[lane]).collect();
        Moment { time: self.block.end[lane], state }
    }

    /// Where a motion is.
    pub(super) fn moment(&self, lane: usize) -> Moment {
        Moment { time: self.block.start[lane], state: self.block.state(lane).collect() }
    }

    /// Expands the steps; at the beginning of a motion once more, if its time scale asks for another unit.
    fn expand_in_fitting_units(&mut self) -> [Result<(), Cause>; N] {
        const FITS: f64 = 10.0;
        let outcomes = self.expand();
        let fresh = std::mem::replace(&mut self.fresh, [false; N]);
        let scales = if fresh.contains(&true) { log2_time_scale(&self.block) } else { [0.0; N] };
        let mut fits = true;
        for lane in
            (0..N).filter(|&lane| fresh[lane] && scales[lane].is_finite() && scales[lane].abs() > FITS)
        {
            self.block.unit[lane] = unit_for(exp2(scales[lane]));
            fits = false;
        }
        if fits { outcomes } else { self.expand() }
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

    pub(super) fn sticks(&self, lane: usize) -> bool {
        self.surroundings.sticks.iter().any(|sticks| sticks[lane])
    }

    fn is_endless(&self, lane: usize, length: f64) -> bool {
        length == f64::INFINITY && (self.goal[lane] - self.block.start[lane]).abs() > 0.0
    }

    /// Always at an `f64`, so that times are exact.
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

    /// The end of a step, or one nearer to its start if the formulas end on the way, and what they say behind is not what
    /// the series do. Where steps come near it, either the series show what happens there or they become too short.
    fn end_before_boundary(&mut self, lane: usize, end: f64, length: f64) -> Result<f64, Cause> {
        /// The part of the way to the boundary that a step may go.
        const TOWARDS: f64 = 0.875;
        /// What comes within so many tolerances of its change in the step is looked at: of √(x² + ε²) the series show ε²/x²
        /// where it is not below one tolerance.
        const NEAR: f64 = 1e4;
        const WIDEST: f64 = 1e-2;
        if self.expander.boundaries.is_empty() || self.sticks(lane) {
            return Ok(end);
        }
        let start = self.block.start[lane];
        let units = (end - start) / self.block.unit[lane];
        let blur = (NEAR * self.effort.relative).min(WIDEST);
        let boundaries = self.expander.boundaries.iter();
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
        // In the unit of the whole step the next series would overflow.
        self.unit[lane] = unit_for((nearer - start).abs());
        Ok(nearer)
    }

    /// Whether the accelerations behind a time are those of the series as well, as where a singularity is removable.
    ///
    /// Up to a quarter of a step beyond its end series of the most terms, 33, err by 1.25³³·33·2⁻⁹ = 100 tolerances.
    fn goes_on_behind(&mut self, lane: usize, time: f64, length: f64) -> bool {
        const PARTS: [f64; 4] = [0.25, 0.125, 0.0625, 0.03125];
        const TOLERANCES: f64 = 100.0;
        let bound = TOLERANCES * self.effort.relative.max(f64::EPSILON);
        PARTS.iter().all(|part| self.misfit(lane, time + part * length, length) <= bound)
    }

    /// What the velocities would err by in a time, as a part of their size, if accelerations were those of the series; not less
    /// than the part of themselves that the accelerations err by, which a short time does not excuse.
    fn misfit(&mut self, lane: usize, time: f64, length: f64) -> f64 {
        let step = self.block.step(lane);
        let state = step.state_at(time);
        let Self { expander, scratch, surroundings, .. } = self;
        let coordinates = expander.system.coordinates();
        let exact = expander.accelerations(scratch, time, &state, surroundings);
        let parts = exact.enumerate().map(|(i, exact)| {
            let own = step.slope_at(coordinates + i, time);
            let speed = step.coefficient(coordinates + i, 0).abs().max((own * length).abs());
            let rate = (length.abs() / speed).max(1.0 / exact[lane].abs().max(own.abs()));
            let error = (exact[lane] - own).abs();
            if error == 0.0 { 0.0 } else { error * rate }
        });
        parts.fold(0.0, larger_or_nan)
    }

    /// Whether the last coefficients are finite, into which the ones before enter.
    fn is_regular(&self, lane: usize) -> bool {
        let last = |number| self.block.series(number).last().is_some_and(|c| c[lane].is_finite());
        (0..self.block.numbers()).all(last)
    }

    /// The farthest end in which series that seem to be polynomials do not overflow.
    fn end_of_finite_states(&self, lane: usize) -> Result<f64, Cause> {
        const HALVINGS: usize = 1100;
        let start = self.block.start[lane];
        let ends = std::iter::successors(Some(self.goal[lane]), |end| Some(start + 0.5 * (end - start)));
        let mut ends = ends.take(HALVINGS).take_while(|&end| (end - start).abs() > 0.0);
        let is_finite =
            |end: f64| self.block.step(lane).state_at(end).iter().all(|number| number.is_finite());
        ends.find(|&end| is_finite(end)).ok_or(Cause::StepUnderflow)
    }
}

/// How long the steps may be.
struct Lengths<'f, 'a, const N: usize> {
    flight: &'f Flight<'a, N>,
}

impl<const N: usize> Kernel for Lengths<'_, '_, N> {
    type Output = [f64; N];

    #[inline(always)]
    fn run(self) -> [f64; N] {
        let Flight { expander, surroundings, block, effort, log2_part_of_radius, .. } = self.flight;
        let moduli = surroundings.sticks.iter().enumerate().filter(|(_, sticks)| sticks.contains(&true));
        let signs = moduli.map(|(modulus, _)| expander.sign(block, modulus));
        let events = (0..expander.system.events().len()).map(|event| expander.event(event));
        let others: Vec<Row> = signs.chain(events).collect();
        step_lengths(block, &others, effort.absolute / effort.relative, *log2_part_of_radius)
    }
}

/// The states at the ends of the steps.
pub(super) struct Arrival<'f, 'a, const N: usize> {
    pub(super) flight: &'f mut Flight<'a, N>,
}

impl<const N: usize> Kernel for Arrival<'_, '_, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Flight { block, next, .. } = self.flight;
        for (number, next) in next.iter_mut().enumerate() {
            *next = block.ends(number);
        }
    }
}

/// The unit of time for series with steps of this length: a power of two, larger by so much that terms that are small in
/// a step do not underflow.
pub(super) fn unit_for(length: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff << 52;
    const LARGER: f64 = 64.0;
    let power = f64::from_bits(length.min(1e300).to_bits() & EXPONENT);
    if power > 0.0 { LARGER * power } else { 1.0 }
}
