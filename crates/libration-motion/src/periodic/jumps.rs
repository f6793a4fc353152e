//! The derivatives of a motion whose forces jump.
//!
//! # Method
//! The motion alone gives the times of its jumps. Between them the equations with their variations are integrated with constant signs. Where a
//! formula g passes zero, a deviation δ becomes δ + (f⁺ − f⁻)·(∇g·δ + ∂g/∂p)/ġ, in which f⁻ and f⁺ are the rates of change before and after
//! and ∂g/∂p is for a deviation by a parameter. Where friction stops a component, f⁺ is the sliding motion; at its release nothing jumps.
//! A jump at the very start of the motion is that at the end of the motion before, so that on an orbit each is counted once.
//!
//! # References
//! R. I. Leine, H. Nijmeijer, *Dynamics and Bifurcations of Non-Smooth Mechanical Systems*, Springer 2004, section 7.

use std::ops::ControlFlow;

use super::modes::{Modes, Place};
use crate::taylor::{
    Approach, Effort, IntegrationError, Moment, NEAR_ZERO, NoDerivative, Phase, Side, Step, System,
    Trajectory, phases,
};

/// Distance from the start or the end, as a fraction of the duration, at which a jump counts as at the end; also
/// the distance of jumps that happen together. The starts of orbits are more accurate.
const TOGETHER: f64 = 1e-10;

/// A motion to be followed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Route<'a> {
    /// The system without variations.
    pub(super) plain: &'a System,
    pub(super) effort: Effort,
    pub(super) parameters: &'a [f64],
    pub(super) times: [f64; 2],
}

/// The end of a motion with its variations, and the rates of change of the motion at both ends.
#[derive(Debug)]
pub(super) struct Arrival {
    pub(super) all: Vec<f64>,
    pub(super) rates: [Vec<f64>; 2],
}

/// The variations on their way.
struct Traveller<'a> {
    modes: &'a Modes,
    parameters: &'a [f64],
    time: f64,
    all: Vec<f64>,
    sides: Vec<Side>,
    /// The latest jumps, with their times and what they changed.
    recent: Vec<(f64, Jump, Variation)>,
}

/// A change of the side of an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Jump {
    argument: usize,
    to: Side,
}

/// Follows a motion, whose state with variations at the start is `all`; `each` is called before the motion
/// is known and with each step of the variations.
pub(super) fn followed(
    modes: &Modes,
    route: Route<'_>,
    (state, all): (&[f64], Vec<f64>),
    each: &mut dyn FnMut(Option<&Step<'_>>) -> ControlFlow<()>,
) -> Result<Arrival, IntegrationError> {
    let Route { plain, effort, parameters, times: [from, to] } = route;
    let cannot = |cause: NoDerivative| IntegrationError::NoDerivative { cause, time: from };
    if plain.has_passages() {
        return Err(cannot(NoDerivative::Power));
    }
    let start = Moment { time: from, state: state.to_vec() };
    let trajectory = Trajectory { start, parameters: parameters.to_vec(), times: &[to] };
    let phases = phases(plain, &trajectory, &effort, &mut || each(None))?;
    let sides = phases.first().map_or_else(Vec::new, |first| first.sides.clone());
    let mut traveller = Traveller { modes, parameters, time: from, all, sides, recent: vec![] };
    let near = TOGETHER * (to - from).abs();
    traveller.hold_all();
    let mut first_rates = traveller.rates()?;
    for (number, phase) in phases.iter().enumerate() {
        traveller.refuse_touching(phase)?;
        traveller.travel(phase.end, &effort, each)?;
        let Some(next) = phases.get(number + 1) else { break };
        if (phase.end - from).abs() <= near {
            traveller.sides.clone_from(&next.sides);
            traveller.hold_all();
            first_rates = traveller.rates()?;
        } else {
            traveller.change_sides(&phase.ending, &next.sides, near)?;
        }
    }
    if let Some(last) = phases.last() {
        traveller.arrive(last, near)?;
    }
    let rates = [first_rates, traveller.rates()?];
    Ok(Arrival { all: traveller.all, rates })
}

impl Traveller<'_> {
    fn refusal(&self, cause: NoDerivative) -> IntegrationError {
        IntegrationError::NoDerivative { cause, time: self.time }
    }

    fn state(&self) -> Vec<f64> {
        state_in(self.modes, &self.all)
    }

    fn rates(&self) -> Result<Vec<f64>, IntegrationError> {
        let state = self.state();
        let position = Place { time: self.time, state: &state, parameters: self.parameters };
        self.modes.rates(&self.sides, position).map_err(|cause| self.refusal(cause))
    }

    /// Integrates the variations to a time. Jumps that happen together may be closer than steps can be.
    fn travel(
        &mut self,
        to: f64,
        effort: &Effort,
        each: &mut dyn FnMut(Option<&Step<'_>>) -> ControlFlow<()>,
    ) -> Result<(), IntegrationError> {
        /// Length relative to the time below which the motion is straight, and its deviations do not change.
        const SHORT: f64 = 64.0 * f64::EPSILON;
        let length = to - self.time;
        if length.abs() <= SHORT * self.time.abs() {
            for (number, rate) in self.rates()?.into_iter().enumerate() {
                let address = self.address(number, 0);
                self.all[address] += length * rate;
            }
            self.time = to;
            return Ok(());
        }
        let mode = self.modes.mode(&self.sides).map_err(|cause| self.refusal(cause))?;
        let start = Moment { time: self.time, state: self.all.clone() };
        let parameters = self.modes.values(self.parameters, &self.sides);
        let trajectory = Trajectory { start, parameters, times: &[to] };
        let solution = trajectory.integrate_stepwise(&mode.variations, effort, |step| each(Some(step)))?;
        (self.time, self.all) = (to, solution.end.state);
        Ok(())
    }

    fn refuse_touching(&self, phase: &Phase) -> Result<(), IntegrationError> {
        let touching = phase.touching.iter().find(|(argument, _)| self.modes.open.jumps(*argument));
        match touching {
            Some(&(_, time)) => Err(IntegrationError::NoDerivative { cause: NoDerivative::Grazing, time }),
            None => Ok(()),
        }
    }

    /// Passes all jumps between two phases.
    fn change_sides(
        &mut self,
        ending: &[Approach],
        next: &[Side],
        near: f64,
    ) -> Result<(), IntegrationError> {
        let jumps = self.jumps_to(next);
        if jumps.iter().any(|jump| !self.is_crossed(*jump, ending)) {
            return Err(self.refusal(NoDerivative::Grazing));
        }
        for (argument, (side, next)) in self.sides.iter_mut().zip(next).enumerate() {
            if !self.modes.open.jumps(argument) {
                *side = *next;
            }
        }
        self.pass(&jumps, near)
    }

    /// The changes of sides at which a force jumps.
    fn jumps_to(&self, next: &[Side]) -> Vec<Jump> {
        let changes =
            |&argument: &usize| self.sides[argument] != next[argument] && self.modes.open.jumps(argument);
        (0..next.len()).filter(changes).map(|argument| Jump { argument, to: next[argument] }).collect()
    }

    /// Returns `true` if an argument passes zero so fast that the error of its value hardly changes the speed.
    fn is_crossed(&self, jump: Jump, ending: &[Approach]) -> bool {
        /// Largest relative change of the speed.
        const CHANGE: f64 = 1e-3;
        let Approach { slopes: [slope, bend], size, .. } = ending[jump.argument];
        self.sides[jump.argument] == Side::Zero
            || bend.abs() * NEAR_ZERO * size <= CHANGE * slope * slope && slope.abs() > 0.0
    }

    /// Passes jumps; the order of jumps that happen together must not matter.
    fn pass(&mut self, jumps: &[Jump], near: f64) -> Result<(), IntegrationError> {
        let time = self.time;
        self.recent.retain(|(before, ..)| (time - before).abs() <= near);
        for &jump in jumps {
            let mut variations = Variation { sides: self.sides.clone(), all: self.all.clone() };
            self.recent.push((self.time, jump, variations.clone()));
            self.jump(jump, &mut variations).map_err(|cause| self.refusal(cause))?;
            (self.sides, self.all) = (variations.sides, variations.all);
        }
        self.refuse_order()
    }

    /// Refuses recent jumps whose result depends on their order, or that cancel each other.
    fn refuse_order(&self) -> Result<(), IntegrationError> {
        /// Largest relative difference that rounding explains.
        const SAME: f64 = 1e-9;
        let jumps: Vec<Jump> = self.recent.iter().map(|(_, jump, _)| *jump).collect();
        let Some((_, first, before)) = self.recent.first() else { return Ok(()) };
        if jumps.len() < 2 {
            return Ok(());
        }
        if jumps.iter().all(|jump| jump.argument == first.argument) {
            let slides = jumps.iter().any(|jump| jump.to == Side::Zero);
            return if slides { Ok(()) } else { Err(self.refusal(NoDerivative::Grazing)) };
        }
        let passed = |jumps: &mut dyn Iterator<Item = &Jump>| {
            let mut variations = before.clone();
            for jump in jumps {
                self.jump(*jump, &mut variations).map_err(|cause| self.refusal(cause))?;
            }
            Ok::<_, IntegrationError>(variations.all)
        };
        let (forward, backward) = (passed(&mut jumps.iter())?, passed(&mut jumps.iter().rev())?);
        let size = forward.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        let agree = forward.iter().zip(&backward).all(|(a, b)| (a - b).abs() <= SAME * size);
        if agree { Ok(()) } else { Err(self.refusal(NoDerivative::Together)) }
    }

    /// Passes one jump.
    fn jump(&self, jump: Jump, on: &mut Variation) -> Result<(), NoDerivative> {
        let Jump { argument, to } = jump;
        let from = on.sides[argument];
        let before = on.sides.clone();
        on.sides[argument] = to;
        if from == Side::Zero || from == to {
            return Ok(());
        }
        let state = state_in(self.modes, &on.all);
        let position = Place { time: self.time, state: &state, parameters: self.parameters };
        let rates = [self.modes.rates(&before, position)?, self.modes.rates(&on.sides, position)?];
        let gradient = self.modes.gradient(argument, &before, position);
        let numbers = state.len();
        let along = |vector: &[f64]| gradient.iter().zip(vector).map(|(a, b)| a * b).sum::<f64>();
        let speed = along(&rates[0]) + gradient[numbers];
        for copy in 1..=self.copies() {
            let deviation: Vec<f64> = (0..numbers).map(|number| on.all[self.address(number, copy)]).collect();
            let by_parameter = if copy <= self.parameters.len() { gradient[numbers + copy] } else { 0.0 };
            let late = (along(&deviation) + by_parameter) / speed;
            for (number, (before, after)) in rates[0].iter().zip(&rates[1]).enumerate() {
                on.all[self.address(number, copy)] += (after - before) * late;
            }
        }
        if to == Side::Zero {
            self.hold(argument, &mut on.all);
        }
        Ok(())
    }

    /// Sets a component that friction holds, and its deviations, to zero.
    fn hold(&self, argument: usize, all: &mut [f64]) {
        let Some(number) = self.modes.driven[argument] else { return };
        for copy in 0..=self.copies() {
            all[self.address(number, copy)] = 0.0;
        }
    }

    fn hold_all(&mut self) {
        let mut all = std::mem::take(&mut self.all);
        for argument in (0..self.sides.len()).filter(|&argument| self.sides[argument] == Side::Zero) {
            self.hold(argument, &mut all);
        }
        self.all = all;
    }

    fn copies(&self) -> usize {
        self.parameters.len() + self.modes.layout.numbers()
    }

    fn address(&self, number: usize, copy: usize) -> usize {
        self.modes.layout.place_in_copy(number, copy, self.copies())
    }

    /// Passes the jumps that the end of the motion only just misses.
    fn arrive(&mut self, last: &Phase, near: f64) -> Result<(), IntegrationError> {
        let time = self.time;
        self.recent.retain(|(before, ..)| (time - before).abs() <= near);
        let mut next = self.sides.clone();
        for (argument, approach) in last.ending.iter().enumerate() {
            let is_new = self.recent.iter().all(|(_, jump, _)| jump.argument != argument);
            let ahead = -approach.value / approach.slopes[0];
            let side = self.sides[argument];
            let outward = approach.slopes[0] * side.sign() < 0.0;
            if is_new && outward && ahead.abs() <= near && self.modes.open.jumps(argument) {
                next[argument] = self.behind(argument)?;
            }
        }
        if next == self.sides { Ok(()) } else { self.change_sides(&last.ending, &next, near) }
    }

    /// The side after the zero of an argument: the other one, or zero if friction then holds it.
    fn behind(&self, argument: usize) -> Result<Side, IntegrationError> {
        let mut sides = self.sides.clone();
        sides[argument] = if sides[argument] == Side::Above { Side::Below } else { Side::Above };
        let state = self.state();
        let position = Place { time: self.time, state: &state, parameters: self.parameters };
        let rates = self.modes.rates(&sides, position).map_err(|cause| self.refusal(cause))?;
        let held =
            self.modes.driven[argument].is_some_and(|number| rates[number] * sides[argument].sign() <= 0.0);
        Ok(if held { Side::Zero } else { sides[argument] })
    }
}

/// A state with variations and the sides of all arguments.
#[derive(Clone)]
struct Variation {
    sides: Vec<Side>,
    all: Vec<f64>,
}

/// The state of the motion itself: it comes first in the order of coordinates and that of velocities.
fn state_in(modes: &Modes, all: &[f64]) -> Vec<f64> {
    let numbers = modes.layout.numbers();
    let copies = all.len() / numbers - 1;
    (0..numbers).map(|number| all[modes.layout.place_in_copy(number, 0, copies)]).collect()
}
