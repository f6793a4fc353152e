//! Times on both sides of the start: first backward, then forward, and written in their order.

use super::motion::SimulatedMotion;
use super::report::{AnswerWriter, Summary};
use super::resume::State;
use super::run::{MotionPicture, RunOutcome, ended};
use crate::figure::simulation::{Trace, TwoTraces};
use crate::interrupt;
use crate::query_error::{QueryError, option};
use libration::systems::Energy;
use libration::taylor::{
    AcceptedStep, IntegrationError, Moment, SampledErrors, Solution, System, integrate_both_ways,
};
use std::io::Write;
use std::ops::ControlFlow;

impl<'a> SimulatedMotion<'a> {
    /// Returns `true` if there are times before the start and after it.
    pub(super) fn goes_both_ways(&self) -> bool {
        let (first, last) = self.times.ends();
        first < 0.0 && last > 0.0
    }

    /// Refuses options that need a motion in one direction.
    pub(super) fn check_both_ways(&self, is_animated: bool) -> Result<(), QueryError> {
        let times: Vec<f64> = self.times.iter().collect();
        if let Some(pair) = times.windows(2).find(|pair| pair[1] < pair[0]) {
            let (before, after) = (pair[0], pair[1]);
            let reason = format!(
                "the time {after:?} follows {before:?}: give times on both sides of the start in ascending order, such as \
                 <--times> -10:10:1"
            );
            return Err(QueryError::usage(option("times"), reason));
        }
        let refused = match () {
            () if self.earlier.is_some() => option("resume"),
            () if self.watched.until().is_some() => option("until"),
            () if is_animated => option("animate"),
            () => return Ok(()),
        };
        let reason = "it needs motions in one direction: give <--times> all after 0, or all before it";
        Err(QueryError::usage(refused, reason))
    }

    /// Writes the whole result when the motion is known.
    pub(super) fn write_both_ways(
        &self,
        system: &System,
        figure: Option<MotionPicture<'_>>,
        report: &mut dyn AnswerWriter,
        out: &mut dyn Write,
    ) -> Result<RunOutcome, QueryError> {
        let energy = self.model.energy();
        let (start, times) = (self.beginning(), self.times.iter().collect::<Vec<_>>());
        let new = || SampledErrors::new(system, &start, &self.effort(), &times, self.gradients());
        let mut errors = self.no_errors().is_none().then(new);
        let mut sides = figure.as_ref().map(|_| self.sides());
        let follow = |step: &AcceptedStep<'_>| {
            if let Some(errors) = &mut errors {
                errors.follow(step);
            }
            if let Some(sides) = &mut sides {
                sides.follow(step.step());
            }
            interrupt::check()
        };
        let (outcome, drift) = self.integrate_both_ways(system, energy.as_ref().ok(), follow);
        let (ending, solution) = ended(outcome, self)?;
        let drift = energy.as_ref().map(|_| drift).map_err(ToString::to_string);
        let state = State { question: self.question.clone(), mark: None };
        let (steps, kept) = (solution.steps, Some(state.clone()));
        let precision = self.precision(errors.as_ref().and_then(SampledErrors::worse));
        let summary = Summary { steps, drift, precision, ending: ending.clone(), state: kept };
        report.begin(self, out)?;
        for row in self.rows(&solution, errors.as_ref()) {
            row.write(report, out)?;
        }
        report.end(&summary, out)?;
        out.flush()?;
        let drawn = self.drawn(figure, sides.map(|sides| self.joined(sides, &solution)))?;
        Ok(RunOutcome { ending, state, drawn })
    }

    /// Empty traces on both sides of the start.
    pub(super) fn sides(&self) -> TwoTraces<'a> {
        let ends = (self.times.iter().next().unwrap_or(0.0), self.times.last());
        TwoTraces::new(self.model, self.observables, ends)
    }

    /// The trace of the whole motion with its events.
    pub(super) fn joined<'t>(&self, sides: TwoTraces<'t>, solution: &Solution) -> Trace<'t> {
        let mut trace = sides.joined();
        for event in &solution.events {
            let coordinate = self.watched.coordinate(&self.watched.happening(event));
            trace.mark(coordinate, event.time, &event.state);
        }
        trace
    }

    /// The motion with the drift of its energy on either side and the uncertainty of the drift; `watch` receives each step.
    pub(super) fn integrate_both_ways(
        &self,
        system: &System,
        energy: Option<&Energy>,
        mut watch: impl FnMut(&AcceptedStep<'_>) -> ControlFlow<()>,
    ) -> (Result<Solution, IntegrationError>, [f64; 2]) {
        let start = self.beginning();
        let mut balance = energy.map(|energy| energy.balance(&self.motion_state(&start)));
        let follow = |accepted: &AcceptedStep<'_>| {
            let step = accepted.step();
            if let Some(balance) = &mut balance {
                if step.start().total_cmp(&start.time).is_eq() {
                    balance.return_to_start();
                }
                balance.record(
                    &self.motion_state(&Moment { time: step.end(), state: step.state_at(step.end()) }),
                );
            }
            watch(accepted)
        };
        let times: Vec<f64> = self.times.iter().collect();
        let outcome = integrate_both_ways(system, &start, &times, &self.effort(), follow);
        (outcome, balance.map_or([0.0; 2], |balance| [balance.drift(), balance.drift_uncertainty()]))
    }
}
