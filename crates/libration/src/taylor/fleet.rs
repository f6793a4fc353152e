//! Many motions, as many at a time as there are lanes.

use std::ops::ControlFlow;

use super::flight::Flight;
use super::record::Record;
use super::{Cause, Checkpoint, Effort, IntegrationError, Launch, Solution, Step, System};

type Outcome = Result<Solution, IntegrationError>;

/// The lanes, and what is known of the motions in them.
#[derive(Debug)]
pub(super) struct Fleet<'a, const N: usize> {
    system: &'a System,
    effort: Effort,
    flight: Flight<'a, N>,
    records: [Option<Record<'a>>; N],
    /// Where the motions go on from, if they do not begin.
    checkpoint: Option<&'a Checkpoint>,
}

/// What a step of one motion has brought.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arrived<'s, const N: usize> {
    pub(super) step: Step<'s>,
    pub(super) flight: &'s Flight<'s, N>,
    pub(super) record: &'s Record<'s>,
    pub(super) lane: usize,
}

impl<'a, const N: usize> Fleet<'a, N> {
    pub(super) fn new(system: &'a System, effort: &Effort) -> Self {
        let records = std::array::from_fn(|_| None);
        let flight = Flight::new(system, *effort);
        Self { system, effort: *effort, flight, records, checkpoint: None }
    }

    /// The same, for motions that go on from a checkpoint.
    pub(super) fn going_on_from(self, checkpoint: Option<&'a Checkpoint>) -> Self {
        Self { checkpoint, ..self }
    }

    /// All motions to their ends.
    pub(super) fn travel(
        &mut self,
        launches: &'a [Launch<'_>],
        mut watch: impl FnMut(usize, &Arrived<'_, N>) -> ControlFlow<()>,
    ) -> Vec<Outcome> {
        let mut outcomes: Vec<Option<Outcome>> = launches.iter().map(|_| None).collect();
        let mut waiting = launches.iter().enumerate();
        let mut interrupted = false;
        loop {
            for lane in 0..N {
                while self.records[lane].is_none() && !interrupted {
                    let Some((number, launch)) = waiting.next() else { break };
                    outcomes[number] = self.launch(lane, number, launch).err();
                }
            }
            if self.records.iter().all(Option::is_none) {
                break;
            }
            let ahead = self.flight.look_ahead();
            for (lane, ahead) in ahead.into_iter().enumerate() {
                let Some(record) = self.records[lane].take() else { continue };
                let number = record.number;
                match self.advance(lane, record, ahead, &mut interrupted, &mut watch) {
                    Ok(record) => self.records[lane] = Some(record),
                    Err(outcome) => {
                        self.flight.rest(lane);
                        outcomes[number] = Some(outcome);
                    }
                }
            }
            self.flight.go_on();
        }
        let never = |launch: &Launch<'_>| {
            Record::new(0, launch, self.system).stopped(Cause::Interrupted, launch.start.clone())
        };
        outcomes
            .into_iter()
            .zip(launches)
            .map(|(outcome, launch)| outcome.unwrap_or_else(|| never(launch)))
            .collect()
    }

    /// Puts a motion into a lane; the outcome when it has no way to go.
    fn launch(&mut self, lane: usize, number: usize, launch: &'a Launch<'_>) -> Result<(), Outcome> {
        let Effort { relative, absolute, .. } = self.effort;
        launch.check(self.system).map_err(Err)?;
        if !self.effort.is_possible() {
            return Err(Err(IntegrationError::Tolerance { relative, absolute }));
        }
        let mut record = Record::new(number, launch, self.system);
        if let Some(checkpoint) = self.checkpoint {
            record.resume(checkpoint);
        }
        record.sample_start();
        match record.goal() {
            None => Err(Ok(record.solution(launch.start.clone()))),
            Some(goal) => {
                self.flight.launch(lane, &launch.start, &launch.parameters, goal);
                if let Some(checkpoint) = self.checkpoint {
                    self.flight.resume(lane, checkpoint);
                }
                self.records[lane] = Some(record);
                Ok(())
            }
        }
    }

    /// Takes the next step of one motion; the outcome when it is the last one.
    fn advance(
        &self,
        lane: usize,
        mut record: Record<'a>,
        ahead: Result<(), Cause>,
        interrupted: &mut bool,
        watch: &mut impl FnMut(usize, &Arrived<'_, N>) -> ControlFlow<()>,
    ) -> Result<Record<'a>, Outcome> {
        let allowed =
            if *interrupted { Err(Cause::Interrupted) } else { record.has_steps_left(&self.effort) };
        if let Err(cause) = allowed.and(ahead) {
            let moment = self.flight.moment(lane);
            let too_large = cause == Cause::Singularity && record.overflows(&moment);
            return Err(record.stopped(if too_large { Cause::Overflow } else { cause }, moment));
        }
        let step = self.flight.step(lane);
        let end = record.take(&step, |event| self.flight.event(event, lane), self.effort.relative);
        let arrived = Arrived { step, flight: &self.flight, record: &record, lane };
        let stop = watch(record.number, &arrived).is_break();
        let arrived = self.flight.end(lane);
        if let Some(end) = end {
            return Err(Ok(record.solution(end)));
        }
        if record.goal().is_none() {
            return Err(Ok(record.solution(arrived)));
        }
        *interrupted |= stop;
        if stop { Err(record.stopped(Cause::Interrupted, arrived)) } else { Ok(record) }
    }
}
