//! Times on both sides of the start: first backward, then forward, and written in their order.

use super::motion::SimulatedMotion;
use super::report::{AnswerWriter, Sample, Summary};
use super::resume::State;
use super::run::{Outcome, ended};
use crate::failure::Failure;
use crate::interrupt;
use libration::systems::EnergyBalance;
use libration::taylor::{Moment, Solution, Step, System, integrate_both_ways};
use std::io::{self, Write};
use std::ops::ControlFlow;

impl SimulatedMotion<'_> {
    /// Whether there are times before the start and after it.
    pub(super) fn goes_both_ways(&self) -> bool {
        let (first, last) = self.times.ends();
        first < 0.0 && last > 0.0
    }

    /// Refuses what only motions in one direction have.
    pub(super) fn check_both_ways(&self, is_drawn: bool) -> Result<(), Failure> {
        let times: Vec<f64> = self.times.iter().collect();
        if let Some(pair) = times.windows(2).find(|pair| pair[1] < pair[0]) {
            let (before, after) = (pair[0], pair[1]);
            let reason = format!(
                "the time {after:?} follows {before:?}: give times on both sides of the start in ascending order, such as \
                 --times=-10:10:1"
            );
            return Err(Failure::usage("--times", reason));
        }
        let option = match () {
            () if self.earlier.is_some() => "--resume",
            () if self.watched.until().is_some() => "--until",
            () if is_drawn => "--figure",
            () => return Ok(()),
        };
        let reason = "it goes with motions in one direction: give --times all after 0, or all before it";
        Err(Failure::usage(option, reason))
    }

    /// Writes the whole answer when the motion is known.
    pub(super) fn write_both_ways(
        &self,
        system: &System,
        report: &mut dyn AnswerWriter,
        out: &mut dyn Write,
    ) -> Result<Outcome, Failure> {
        let energy = self.model.energy();
        let start = self.beginning();
        let mut balances: Vec<EnergyBalance<'_>> = vec![];
        let follow = |step: &Step<'_>| {
            let wanted = if step.end() < step.start() { 1 } else { 2 };
            if let Ok(energy) = &energy {
                while balances.len() < wanted {
                    balances.push(energy.balance(&start));
                }
            }
            if let Some(balance) = balances.last_mut() {
                balance.record(&Moment { time: step.end(), state: step.state_at(step.end()) });
            }
            if interrupt::asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let times: Vec<f64> = self.times.iter().collect();
        let outcome = integrate_both_ways(system, &start, &times, &self.effort, follow);
        let (ending, solution) = ended(outcome, self)?;
        let drifts = balances.iter().map(|balance| [balance.drift(), balance.drift_uncertainty()]);
        let drift = drifts.fold([0.0; 2], |a, b| [larger(a[0], b[0]), larger(a[1], b[1])]);
        let drift = energy.as_ref().map(|_| drift).map_err(ToString::to_string);
        let state = State { question: self.question.clone(), mark: None };
        let summary = Summary { steps: solution.steps, drift, ending: ending.clone(), state: state.clone() };
        report.begin(self, out)?;
        self.rows(&solution, report, out)?;
        report.end(&summary, out)?;
        out.flush()?;
        Ok(Outcome { ending, state, drawn: vec![] })
    }

    /// Samples and events in the order of time.
    fn rows(
        &self,
        solution: &Solution,
        report: &mut dyn AnswerWriter,
        out: &mut dyn Write,
    ) -> io::Result<()> {
        let mut samples = solution.samples.iter().peekable();
        let mut upto = |end: f64, report: &mut dyn AnswerWriter, out: &mut dyn Write| {
            while let Some(moment) = samples.next_if(|moment| moment.time <= end) {
                let columns = self.columns_at(moment);
                report.sample(&Sample { moment: moment.clone(), columns }, out)?;
            }
            Ok::<(), io::Error>(())
        };
        for event in &solution.events {
            upto(event.time, report, out)?;
            let happening = self.watched.happening(event);
            let moment = Moment { time: event.time, state: event.state.clone() };
            report
                .event(&super::events::Happening { columns: self.columns_at(&moment), ..happening }, out)?;
        }
        upto(f64::INFINITY, report, out)
    }
}

/// NaN if one is.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b <= a { a } else { b }
}
