//! The samples and events of a motion that is known.

use super::events::Happening;
use super::motion::SimulatedMotion;
use super::report::{AnswerWriter, Sample};
use libration::taylor::{Moment, SampledErrors, Solution};
use std::io::{self, Write};

/// A line of a result.
pub(super) enum SimulatedRow {
    Sample(Sample),
    Event(Happening),
}

impl SimulatedRow {
    pub(super) fn write(&self, report: &mut dyn AnswerWriter, out: &mut dyn Write) -> io::Result<()> {
        match self {
            Self::Sample(sample) => report.sample(sample, out),
            Self::Event(event) => report.event(event, out),
        }
    }

    /// The time, state and columns, and the kind of the event, which is empty in samples.
    pub(super) fn parts(&self) -> (f64, [&[f64]; 2], &str) {
        match self {
            Self::Sample(Sample { moment, columns, .. }) => {
                (moment.time, [&moment.state, columns.as_deref().unwrap_or(&[])], "")
            }
            Self::Event(Happening { time, kind, state, columns, .. }) => {
                (*time, [state, columns.as_deref().unwrap_or(&[])], kind)
            }
        }
    }
}

impl SimulatedMotion<'_> {
    /// Samples and events in the order of the times, with their errors if known.
    pub(super) fn rows<'s>(
        &'s self,
        solution: &'s Solution,
        errors: Option<&'s SampledErrors<'_>>,
    ) -> impl Iterator<Item = SimulatedRow> + 's {
        let backward = !self.goes_both_ways() && self.times.last() < 0.0;
        let is_before = move |a: f64, b: f64| if backward { a >= b } else { a <= b };
        let mut samples = solution.samples.iter().peekable();
        let mut events = solution.events.iter().peekable();
        std::iter::from_fn(move || {
            let upto = events.peek().map(|event| event.time);
            let sample = samples.next_if(|moment| upto.is_none_or(|time| is_before(moment.time, time)));
            if let Some(moment) = sample {
                let columns = self.columns_at(moment);
                let errors = errors.map(|errors| self.own_errors(errors.of_sample(moment.time).cloned()));
                return Some(SimulatedRow::Sample(Sample {
                    moment: self.motion_state(moment),
                    columns,
                    errors,
                }));
            }
            let event = events.next()?;
            let moment = Moment { time: event.time, state: event.state.clone() };
            let (columns, state) = (self.columns_at(&moment), self.motion_state(&moment).state);
            let errors = errors.map(|errors| self.own_errors(errors.of_event(event).cloned()));
            Some(SimulatedRow::Event(Happening { columns, state, errors, ..self.watched.happening(event) }))
        })
    }
}
