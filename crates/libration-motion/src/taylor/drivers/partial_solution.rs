//! The solution of one trajectory during its computation.

use crate::taylor::events::contacts::{Contacts, Stretch};
use crate::taylor::events::sharp::{Part, SHIFTED};
use crate::taylor::program::linearised::{Linearised, half_ulp};
use crate::taylor::{
    Cause, Checkpoint, Contact, Effort, EventCheckpoint, IntegrationError, Moment, Occurrence, Solution,
    Step, System, Trajectory,
};
use libration_numbers::internals::algebra::InOrder;

/// Samples and events of a motion so far.
#[derive(Debug)]
pub(in crate::taylor) struct PartialSolution<'a> {
    pub(in crate::taylor) number: usize,
    system: &'a System,
    trajectory: &'a Trajectory<'a>,
    samples: Vec<Moment>,
    events: Vec<Occurrence>,
    /// Number of events that were known before the last step.
    events_before: usize,
    contacts: Vec<Contacts>,
    /// The formula of each event that contains a |…|, for its rounding error.
    kinked: Vec<Option<Linearised>>,
    steps: usize,
}

impl<'a> PartialSolution<'a> {
    pub(in crate::taylor) fn new(number: usize, trajectory: &'a Trajectory<'a>, system: &'a System) -> Self {
        let samples = Vec::with_capacity(trajectory.times.len());
        let contacts = vec![Contacts::NONE; system.events().len()];
        let kinked = (0..contacts.len()).map(|event| kinked(system, event)).collect();
        Self {
            number,
            system,
            trajectory,
            samples,
            events: vec![],
            events_before: 0,
            contacts,
            kinked,
            steps: 0,
        }
    }

    /// Continues with the state of the events at a checkpoint.
    pub(in crate::taylor) fn resume(&mut self, checkpoint: &Checkpoint) {
        self.contacts = checkpoint.events.iter().map(EventCheckpoint::contacts).collect();
        self.steps = checkpoint.steps;
    }

    /// The state of each event.
    pub(in crate::taylor) fn checkpoints(&self) -> Vec<EventCheckpoint> {
        self.contacts.iter().map(EventCheckpoint::from_contacts).collect()
    }

    /// The events in the last step.
    pub(in crate::taylor) fn new_events(&self) -> &[Occurrence] {
        &self.events[self.events_before..]
    }

    /// The time at which an event in the last step ended the integration.
    pub(in crate::taylor) fn ended_at(&self) -> Option<f64> {
        let last = self.new_events().last().filter(|last| last.contact != Contact::Start)?;
        let number = Some(self.contacts[last.event].zeros);
        (self.system.events()[last.event].ends_at == number).then_some(last.time)
    }

    /// Returns `true` if numbers are too large for double precision at this moment.
    pub(in crate::taylor) fn overflows(&self, moment: &Moment) -> bool {
        let inputs = [&moment.state[..], &[moment.time], &self.trajectory.parameters].concat();
        self.system.accelerations().is_some_and(|tape| tape.overflows_at(&inputs))
    }

    /// The values of the open parameters.
    pub(in crate::taylor) fn parameters(&self) -> &[f64] {
        &self.trajectory.parameters
    }

    pub(in crate::taylor) fn steps(&self) -> usize {
        self.steps
    }

    /// Records the samples at the start, which require no step.
    pub(in crate::taylor) fn sample_start(&mut self) {
        let start = &self.trajectory.start;
        let here = self.trajectory.times.iter().take_while(|&&time| (time - start.time).abs() == 0.0);
        self.samples.extend(here.map(|_| start.clone()));
    }

    /// The time of the last sample; `None` once all samples are recorded.
    pub(in crate::taylor) fn goal(&self) -> Option<f64> {
        let times = self.trajectory.times;
        if self.samples.len() < times.len() { times.last().copied() } else { None }
    }

    pub(in crate::taylor) fn has_steps_left(&self, effort: &Effort) -> Result<(), Cause> {
        if self.steps < effort.most_steps { Ok(()) } else { Err(Cause::StepLimit) }
    }

    /// Counts a step that ends before the next sample, if there are no events to search; returns `true` if it did.
    pub(in crate::taylor) fn pass(&mut self, start: f64, end: f64) -> bool {
        let next = self.trajectory.times.get(self.samples.len());
        let is_behind = next.is_some_and(|&next| if end < start { next < end } else { next > end });
        let passes = is_behind && self.contacts.is_empty();
        self.steps += usize::from(passes);
        passes
    }

    /// Records the samples and events of a step, given the series of the formulas of events and the sign of the argument of each |…|; returns
    /// the end of the motion if an event ends it.
    pub(in crate::taylor) fn take(
        &mut self,
        step: &Step<'_>,
        formula: impl Fn(usize) -> Vec<f64>,
        signs: &[f64],
        tolerance: f64,
    ) -> Option<Moment> {
        self.steps += 1;
        self.events_before = self.events.len();
        let terminal =
            if self.contacts.is_empty() { None } else { self.find_events(step, formula, signs, tolerance) };
        let last = terminal.as_ref().map_or(step.end(), |end| end.time);
        let inside = |time: f64| if step.end() < step.start() { time >= last } else { time <= last };
        while let Some(&time) = self.trajectory.times.get(self.samples.len())
            && inside(time)
        {
            self.samples.push(Moment { time, state: step.state_at(time) });
        }
        terminal
    }

    fn find_events(
        &mut self,
        step: &Step<'_>,
        formula: impl Fn(usize) -> Vec<f64>,
        signs: &[f64],
        tolerance: f64,
    ) -> Option<Moment> {
        let length = step.end() - step.start();
        let goal = self.trajectory.times.last().copied().unwrap_or(step.end());
        let is_last = (goal - step.end()) * length.signum() <= 0.0;
        let constants = [&self.trajectory.parameters[..], signs].concat();
        let mut zeros: Vec<(f64, usize, Contact)> = vec![];
        for (event, contacts) in self.contacts.iter_mut().enumerate() {
            let whole = || Part { start: step.start(), length, coefficients: formula(event) };
            let sharp = self.system.sharp(event);
            let parts = sharp.map_or_else(|| vec![whole()], |sharp| sharp.parts(step, &constants, tolerance));
            let last = parts.len().saturating_sub(1);
            for (number, Part { start, length, coefficients }) in parts.into_iter().enumerate() {
                // Steps end at the zeros of |…|: only the first part and the last one of a formula in several parts have a kink.
                let ends = [(number == 0, step.start()), (number == last && last > 0, step.end())];
                let kink = ends.into_iter().find(|(is_end, _)| *is_end).map(|(_, time)| time);
                let rounding = kink.zip(self.kinked[event].as_mut()).map(|(time, formula)| {
                    let at = Moment { time, state: step.state_at(time) };
                    let of_state = sharp.map_or(0.0, |sharp| sharp.rounding(step, &constants, time, SHIFTED));
                    let rounding = of_state + rounding(formula, self.system, event, &at, &constants);
                    if rounding.is_finite() { rounding } else { 0.0 }
                });
                let is_last = is_last && number == last;
                let stretch =
                    Stretch { coefficients: &coefficients, start, length, tolerance, rounding, is_last };
                let error_at_start = || event_error_at_start(self.system, self.trajectory, event);
                let all = contacts.zeros_in(&stretch, error_at_start).into_iter();
                let is_pole =
                    |time: f64| sharp.is_some_and(|sharp| sharp.has_pole_at(step, &constants, time));
                let wanted = all.filter(|(time, contact)| {
                    self.system.events()[event].counts(*contact)
                        && (*contact == Contact::Start || !is_pole(*time))
                });
                zeros.extend(wanted.map(|(time, contact)| (time, event, contact)));
            }
        }
        zeros.put_in_order(|a, b| if length < 0.0 { b.0.total_cmp(&a.0) } else { a.0.total_cmp(&b.0) });
        for (time, event, contact) in zeros {
            let state = step.state_at(time);
            self.events.push(Occurrence { event, time, state: state.clone(), contact });
            let passed = &mut self.contacts[event].zeros;
            *passed += u64::from(contact != Contact::Start);
            if contact != Contact::Start && self.system.events()[event].ends_at == Some(*passed) {
                return Some(Moment { time, state });
            }
        }
        None
    }

    pub(in crate::taylor) fn finished(self, end: Moment) -> Solution {
        Solution { samples: self.samples, events: self.events, end, steps: self.steps }
    }

    pub(in crate::taylor) fn stopped(self, cause: Cause, end: Moment) -> Result<Solution, IntegrationError> {
        Err(IntegrationError::Stopped { cause, solution: Box::new(self.finished(end)) })
    }
}

/// The formula of an event that contains a |…| or a sign.
fn kinked(system: &System, event: usize) -> Option<Linearised> {
    let first_sign = system.tape().inputs() - system.moduli();
    let is_kinked = |formula: &Linearised| formula.inputs().any(|input| input >= first_sign);
    (system.moduli() > 0).then(|| linearised(system, event)).filter(is_kinked)
}

/// The formula of an event, as a function of the state.
fn linearised(system: &System, event: usize) -> Linearised {
    Linearised::new(system.tape(), [system.event(event)].into_iter(), system.layout().numbers())
}

/// The rounding error of the formula of an event in a state, with these open parameters and signs.
fn rounding(of: &mut Linearised, system: &System, event: usize, at: &Moment, constants: &[f64]) -> f64 {
    of.evaluate(&[&at.state[..], &[at.time], constants].concat());
    of.error(system.event(event))
}

/// The error of an event's formula at the start, from rounding and half a unit in the last place of each component.
fn event_error_at_start(system: &System, trajectory: &Trajectory<'_>, event: usize) -> f64 {
    let Trajectory { start, parameters, .. } = trajectory;
    let mut formula = linearised(system, event);
    // The effect of a rounding error is the same for either sign of a |…|.
    let constants = [&parameters[..], &vec![1.0; system.moduli()]].concat();
    let rounding = rounding(&mut formula, system, event, start, &constants);
    let typed = start.state.iter().zip(formula.slopes(system.event(event)));
    rounding + typed.map(|(value, slope)| half_ulp(*value) * slope.abs()).sum::<f64>()
}
