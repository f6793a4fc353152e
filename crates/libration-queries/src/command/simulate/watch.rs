//! Processing of each step of the integration after it is computed.

use super::events::Happening;
use super::motion::SimulatedMotion;
use super::precision::Precision;
use super::report::{AnswerWriter, Sample, Summary};
use super::resume::{Keeper, Mark, State};
use super::tally::Tally;
use crate::figure::simulation::Trace;
use crate::interrupt;
use crate::output::progress::ProgressLine;
use crate::query_error::QueryError;
use libration::systems::EnergyBalance;
use libration::taylor::{AcceptedStep, Moment, MomentErrors, StateErrors};
use std::io::{self, Write};
use std::iter::Peekable;
use std::ops::ControlFlow;

/// Writes the samples and events of each step, updates the energy account, marks where the run may be continued, and shows
/// its progress.
pub(super) struct Watch<'a> {
    motion: &'a SimulatedMotion<'a>,
    report: &'a mut dyn AnswerWriter,
    out: Tally<'a>,
    balance: Option<EnergyBalance<'a>>,
    errors: Option<StateErrors>,
    pub(super) trace: Option<Trace<'a>>,
    /// Error in writing.
    pub(super) failure: Option<QueryError>,
    times: Peekable<Box<dyn Iterator<Item = f64> + 'a>>,
    /// The last time.
    last: f64,
    /// Numbers of samples and events written.
    rows: [usize; 2],
    state: State,
    keeper: Option<Keeper>,
    progress: ProgressLine,
}

impl<'a> Watch<'a> {
    pub(super) fn new(
        motion: &'a SimulatedMotion,
        report: &'a mut dyn AnswerWriter,
        out: &'a mut dyn Write,
        balance: Option<EnergyBalance<'a>>,
        errors: Option<StateErrors>,
        trace: Option<Trace<'a>>,
        keeper: Option<Keeper>,
    ) -> Self {
        let mark = motion.earlier.as_ref().and_then(|earlier| earlier.mark().cloned());
        Self {
            motion,
            report,
            out: Tally::new(out),
            balance,
            errors,
            trace,
            failure: None,
            times: motion.times.iter().peekable(),
            last: motion.times.last(),
            rows: [0; 2],
            state: State { question: motion.question.clone(), mark },
            keeper,
            progress: ProgressLine::new(),
        }
    }

    pub(super) fn begin(&mut self) -> io::Result<()> {
        self.report.begin(self.motion, &mut self.out)
    }

    /// Takes a sample or an event of the earlier result.
    pub(super) fn earlier(&mut self, row: &Happening) -> Result<(), QueryError> {
        if !row.kind.is_empty() {
            return Ok(self.happening(row)?);
        }
        self.times.next();
        let moment = Moment { time: row.time, state: row.state.clone() };
        if let Some(trace) = &mut self.trace {
            trace.earlier(&moment);
        }
        Ok(self.sample(&moment, row.errors.clone())?)
    }

    /// Writes the samples that the start itself is.
    pub(super) fn start(&mut self, start: &Moment) -> io::Result<()> {
        while let Some(time) = self.times.next_if(|time| (time - start.time).abs() <= 0.0) {
            let errors = self.errors.as_mut().map(|errors| self.motion.own_errors(Some(errors.at_start())));
            self.sample(&Moment { time, state: start.state.clone() }, errors)?;
        }
        Ok(())
    }

    /// Takes a step; `Break` if there should be no other.
    pub(super) fn follow(&mut self, taken: &AcceptedStep<'_>) -> ControlFlow<()> {
        let step = taken.step();
        if let Some(errors) = &mut self.errors {
            errors.follow(taken);
        }
        if let Some(balance) = &mut self.balance {
            balance.record(
                &self.motion.motion_state(&Moment { time: step.end(), state: step.state_at(step.end()) }),
            );
        }
        if let Some(trace) = &mut self.trace {
            trace.follow(step, taken.ended_at().unwrap_or(step.end()));
        }
        self.failure = self.rows(taken).map_err(QueryError::from).and_then(|()| self.mark(taken)).err();
        let last = self.last;
        self.progress.show(|| format!("t = {:.6} s of {last} s", step.end()));
        if self.failure.is_some() || interrupt::is_cancelled() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// The drift of the energy so far and its uncertainty; NaN if they are unknown.
    pub(super) fn drift(&self) -> [f64; 2] {
        self.balance.as_ref().map_or([f64::NAN; 2], |balance| [balance.drift(), balance.drift_uncertainty()])
    }

    /// The precision of the motion.
    pub(super) fn precision(&self) -> Precision {
        self.motion.precision(self.errors.as_ref())
    }

    /// The state needed to continue.
    pub(super) fn state(&self) -> &State {
        &self.state
    }

    /// Writes the summary of the run.
    pub(super) fn end(&mut self, summary: &Summary) -> io::Result<()> {
        self.report.end(summary, &mut self.out)?;
        self.out.flush()
    }

    fn sample(&mut self, moment: &Moment, errors: Option<MomentErrors>) -> io::Result<()> {
        self.rows[0] += 1;
        let columns = self.motion.columns_at(moment);
        self.report
            .sample(&Sample { moment: self.motion.motion_state(moment), columns, errors }, &mut self.out)
    }

    fn happening(&mut self, happening: &Happening) -> io::Result<()> {
        self.rows[1] += 1;
        if let Some(trace) = &mut self.trace {
            trace.mark(self.motion.watched.coordinate(happening), happening.time, &happening.state);
        }
        let moment = Moment { time: happening.time, state: happening.state.clone() };
        let (columns, state) = (self.motion.columns_at(&moment), self.motion.motion_state(&moment).state);
        self.report.event(&Happening { columns, state, ..happening.clone() }, &mut self.out)
    }

    /// Samples and events of a step in the order of time.
    fn rows(&mut self, taken: &AcceptedStep<'_>) -> io::Result<()> {
        for event in taken.events() {
            self.samples(taken, event.time)?;
            let errors = self.errors.as_mut();
            let errors = errors.map(|errors| self.motion.own_errors(errors.of_event(taken, event)));
            self.happening(&Happening { errors, ..self.motion.watched.happening(event) })?;
        }
        self.samples(taken, taken.ended_at().unwrap_or(taken.step().end()))
    }

    /// The samples of a step up to a time.
    fn samples(&mut self, taken: &AcceptedStep<'_>, end: f64) -> io::Result<()> {
        let step = taken.step();
        let backward = step.end() < step.start();
        let inside = |time: &f64| if backward { *time >= end } else { *time <= end };
        while let Some(time) = self.times.next_if(inside) {
            let moment = Moment { time, state: step.state_at(time) };
            let errors = self.errors.as_mut();
            let errors = errors.map(|errors| self.motion.own_errors(errors.of_sample(taken, &moment)));
            self.sample(&moment, errors)?;
        }
        Ok(())
    }

    /// Marks the end of a step from which a motion without sensitivities can be continued.
    fn mark(&mut self, taken: &AcceptedStep<'_>) -> Result<(), QueryError> {
        if self.motion.sensitivities.is_some() {
            return Ok(());
        }
        let Some(checkpoint) = taken.checkpoint() else { return Ok(()) };
        let [samples, events] = self.rows;
        let energy = self.balance.as_ref().map(|balance| balance.account().clone());
        let (bytes, checksum) = (self.out.bytes, self.out.checksum.value());
        let errors = self.errors.as_ref().map(StateErrors::to_numbers);
        self.state.mark = Some(Mark { checkpoint, samples, events, bytes, checksum, energy, errors });
        if let Some(keeper) = self.keeper.as_mut().filter(|keeper| keeper.is_due()) {
            self.out.flush()?;
            keeper.keep(&self.state)?;
        }
        Ok(())
    }
}
