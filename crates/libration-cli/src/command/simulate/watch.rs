//! What is done with each step of the integration as soon as it is made.

use super::events::Watched;
use super::report::{Report, Summary};
use super::run::Motion;
use crate::figure::simulation::Trace;
use crate::interrupt;
use crate::output::progress::Progress;
use libration::systems::EnergyBalance;
use libration::taylor::{Moment, Occurrence, Step};
use std::io::{self, Write};
use std::iter::Peekable;
use std::ops::ControlFlow;

/// Writes the samples inside each step, accounts for the energy, and shows how far it is.
pub(super) struct Watch<'a> {
    report: &'a mut dyn Report,
    out: &'a mut dyn Write,
    balance: Option<EnergyBalance<'a>>,
    pub(super) trace: Option<Trace>,
    /// What went wrong in writing.
    pub(super) failure: Option<io::Error>,
    times: Peekable<Box<dyn Iterator<Item = f64> + 'a>>,
    last: f64,
    progress: Progress,
}

impl<'a> Watch<'a> {
    pub(super) fn new(
        motion: &'a Motion,
        report: &'a mut dyn Report,
        out: &'a mut dyn Write,
        balance: Option<EnergyBalance<'a>>,
        trace: Option<Trace>,
    ) -> Self {
        let (times, last) = (motion.times_left().peekable(), motion.times.last());
        Self { report, out, balance, trace, failure: None, times, last, progress: Progress::new() }
    }

    /// Takes a sample that was computed before.
    pub(super) fn earlier(&mut self, moment: &Moment) -> io::Result<()> {
        self.account(moment);
        if let Some(trace) = &mut self.trace {
            trace.earlier(moment);
        }
        self.report.sample(moment, self.out)
    }

    /// Writes the samples that the start itself is.
    pub(super) fn start(&mut self, start: &Moment) -> io::Result<()> {
        while let Some(time) = self.times.next_if(|time| *time == start.time) {
            self.report.sample(&Moment { time, state: start.state.clone() }, self.out)?;
        }
        Ok(())
    }

    /// Takes a step, and says whether there should be another.
    pub(super) fn follow(&mut self, step: &Step<'_>) -> ControlFlow<()> {
        self.account(&Moment { time: step.end(), state: step.state_at(step.end()) });
        if let Some(trace) = &mut self.trace {
            trace.follow(step);
        }
        self.failure = self.samples(step).err();
        let last = self.last;
        self.progress.show(|| format!("t = {:.6} s of {last} s", step.end()));
        if self.failure.is_some() || interrupt::asked() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// Marks events in the picture.
    pub(super) fn mark(&mut self, watched: &Watched, events: &[Occurrence]) {
        if let Some(trace) = &mut self.trace {
            for event in events {
                trace.mark(watched.coordinate(event), event.time, &event.state);
            }
        }
    }

    /// The drift of the energy so far; NaN where it has none.
    pub(super) fn drift(&self) -> f64 {
        self.balance.as_ref().map_or(f64::NAN, EnergyBalance::drift)
    }

    /// Writes what is to be said of the whole.
    pub(super) fn end(&mut self, summary: &Summary) -> io::Result<()> {
        self.report.end(summary, self.out)?;
        self.out.flush()
    }

    fn account(&mut self, moment: &Moment) {
        if let Some(balance) = &mut self.balance {
            balance.record(moment);
        }
    }

    fn samples(&mut self, step: &Step<'_>) -> io::Result<()> {
        let backward = step.end() < step.start();
        let inside = |time: &f64| if backward { *time >= step.end() } else { *time <= step.end() };
        while let Some(time) = self.times.next_if(inside) {
            self.report.sample(&Moment { time, state: step.state_at(time) }, self.out)?;
        }
        Ok(())
    }
}
