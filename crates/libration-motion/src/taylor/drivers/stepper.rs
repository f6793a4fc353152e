//! Several motions side by side, each with its own steps.

use super::checkpoint::{Checkpoint, ModulusCheckpoint};
use crate::taylor::nonsmooth::branches::Branches;
use crate::taylor::program::expander::{Expander, Surroundings};
use crate::taylor::step::allowance::Allowance;
use crate::taylor::step::block::Block;
use crate::taylor::step::ends::Ends;
use crate::taylor::step::sign_change::scaled;
use crate::taylor::{Effort, Moment, Step, System};
use libration_kernels::dispatch::Kernel;

/// N motions in progress: their states, and their next steps.
#[derive(Debug)]
pub(in crate::taylor) struct Stepper<'a, const N: usize> {
    pub(in crate::taylor) expander: Expander<'a>,
    pub(in crate::taylor) branches: Branches<N>,
    pub(in crate::taylor) surroundings: Surroundings<N>,
    pub(in crate::taylor) block: Block<N>,
    /// Buffer for the accelerations in other states.
    pub(in crate::taylor) scratch: Block<N>,
    /// `true` if `scratch` contains the zeroth coefficients of all formulas at the ends of the steps.
    pub(in crate::taylor) ends_known: bool,
    /// `true` if `block` contains the zeroth coefficients of all formulas at the starts of the steps.
    pub(in crate::taylor) begun: bool,
    pub(in crate::taylor) next: Vec<Ends<N>>,
    /// Times to which the motions are integrated.
    pub(in crate::taylor) goal: [f64; N],
    /// The units of time for the next steps.
    pub(in crate::taylor) unit: [f64; N],
    /// `true` for motions whose time scale is not known yet.
    pub(in crate::taylor) fresh: [bool; N],
    /// `true` for motions with a step that would have ended elsewhere for a later goal.
    pub(in crate::taylor) goal_bound: [bool; N],
    /// Tolerances and step limit, with the smallest of the tolerances of all coordinates.
    pub(in crate::taylor) effort: Effort,
    /// One allowance for each state component.
    pub(in crate::taylor) allowances: Vec<Allowance>,
    pub(in crate::taylor) log2_part_of_radius: f64,
}

/// Length of the shortest step, relative to the time: shorter steps are lost in the rounding of times.
pub(in crate::taylor) const SHORTEST: f64 = 8.0 * f64::EPSILON;

impl<'a, const N: usize> Stepper<'a, N> {
    pub(in crate::taylor) fn new(system: &'a System, effort: Effort) -> Self {
        let (effort, allowances) = system.allowances(&effort);
        let (order, numbers) = (effort.order(), system.layout().numbers());
        let expander = Expander::new(system, order, N);
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
            allowances,
            log2_part_of_radius: effort.log2_part_of_radius(),
        }
    }

    /// Begins a motion in a lane.
    pub(in crate::taylor) fn start(&mut self, lane: usize, start: &Moment, parameters: &[f64], goal: f64) {
        self.block.start(lane, start.time, &start.state);
        self.begun = false;
        self.branches.start(lane);
        (self.goal[lane], self.fresh[lane], self.goal_bound[lane]) = (goal, true, false);
        for (parameter, &value) in self.surroundings.parameters.iter_mut().zip(parameters) {
            parameter[lane] = value;
        }
        let Surroundings { signs, sticks, .. } = &mut self.surroundings;
        for (sign, sticks) in signs.iter_mut().zip(sticks) {
            (sign[lane], sticks[lane]) = (1.0, false);
        }
    }

    /// Continues a motion in a lane, which has been started.
    pub(in crate::taylor) fn resume(&mut self, lane: usize, checkpoint: &Checkpoint) {
        for (number, &[high, low]) in checkpoint.state.iter().enumerate() {
            self.block.set_component(number, lane, high, low);
        }
        (self.block.unit[lane], self.fresh[lane], self.begun) = (checkpoint.unit, false, false);
        self.branches.resume(lane, checkpoint.moduli.iter().map(|modulus| modulus.zeros));
        let Surroundings { signs, sticks, .. } = &mut self.surroundings;
        for ((sign, sticks), modulus) in signs.iter_mut().zip(sticks).zip(&checkpoint.moduli) {
            (sign[lane], sticks[lane]) = (modulus.sign, modulus.sticks);
        }
    }

    /// The checkpoint at the end of the step; `None` if a step would have ended
    /// elsewhere for a later goal, and for the equations of a component at rest.
    pub(in crate::taylor) fn checkpoint(&self, lane: usize) -> Option<Checkpoint> {
        let is_resumable = !self.goal_bound[lane] && !self.expander.system.rests();
        is_resumable.then(|| self.checkpoint_to_this_goal(lane))
    }

    /// The checkpoint at the end of the step, for continuing to the same goal.
    pub(in crate::taylor) fn checkpoint_to_this_goal(&self, lane: usize) -> Checkpoint {
        let moduli = (0..self.surroundings.signs.len()).map(|modulus| ModulusCheckpoint {
            sign: self.surroundings.signs[modulus][lane],
            sticks: self.surroundings.sticks[modulus][lane],
            zeros: self.branches.zeros(modulus, lane),
        });
        Checkpoint {
            time: self.block.end[lane],
            state: self.next.iter().map(|ends| [ends.high[lane], ends.low[lane]]).collect(),
            unit: self.unit[lane],
            moduli: moduli.collect(),
            events: vec![],
            steps: 0,
        }
    }

    /// Makes a lane stay at its present time.
    pub(in crate::taylor) fn idle(&mut self, lane: usize) {
        self.goal[lane] = self.block.start[lane];
    }

    /// Moves all lanes to the ends of their steps.
    pub(in crate::taylor) fn advance(&mut self) {
        self.block.begin_at_end(&self.next, &self.unit);
        if self.ends_known {
            self.expander.plan.program.begin_as(&self.scratch, &mut self.block);
        }
        self.begun = std::mem::take(&mut self.ends_known);
    }

    pub(in crate::taylor) fn step(&self, lane: usize) -> Step<'_> {
        self.block.step(lane)
    }

    /// The series of the formula of an event, in powers of the fraction of the step.
    pub(in crate::taylor) fn event(&self, event: usize, lane: usize) -> Vec<f64> {
        let length = (self.block.end[lane] - self.block.start[lane]) / self.block.unit[lane];
        let series = self.block[self.expander.event(event)].iter();
        scaled(series.map(|c| c[lane]), length)
    }

    /// The sign of the argument of each |…| with which the series of the step was computed.
    pub(in crate::taylor) fn signs(&self, lane: usize) -> Vec<f64> {
        let sign = |modulus: usize| self.block[self.expander.sign(&self.block, modulus)][0][lane];
        (0..self.expander.system.moduli()).map(sign).collect()
    }

    /// The time and state at the end of a step.
    pub(in crate::taylor) fn end(&self, lane: usize) -> Moment {
        let state = self.next.iter().map(|ends| ends.high[lane] + ends.low[lane]).collect();
        Moment { time: self.block.end[lane], state }
    }

    /// The time and state at the start of the step.
    pub(in crate::taylor) fn moment(&self, lane: usize) -> Moment {
        Moment { time: self.block.start[lane], state: self.block.state(lane).collect() }
    }

    pub(in crate::taylor) fn sticks(&self, lane: usize) -> bool {
        self.surroundings.sticks.iter().any(|sticks| sticks[lane])
    }
}

/// The states at the ends of the steps.
pub(in crate::taylor) struct StepEnds<'f, 'a, const N: usize> {
    pub(in crate::taylor) stepper: &'f mut Stepper<'a, N>,
}

impl<const N: usize> Kernel for StepEnds<'_, '_, N> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Stepper { block, next, .. } = self.stepper;
        let lengths = block.lengths();
        for (number, next) in next.iter_mut().enumerate() {
            *next = block.ends(number, &lengths);
        }
    }
}

/// The unit of time for series with steps of this length: a power of two, large enough that terms that are small in a step do not underflow.
pub(in crate::taylor) fn unit_for(length: f64) -> f64 {
    /// The bits of the exponent.
    const EXPONENT: u64 = 0x7ff << 52;
    const LARGER: f64 = 64.0;
    let power = f64::from_bits(length.min(1e300).to_bits() & EXPONENT);
    if power > 0.0 { LARGER * power } else { 1.0 }
}
