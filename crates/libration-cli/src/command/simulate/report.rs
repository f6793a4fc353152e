//! The answer as JSON and CSV, sample by sample, so that long runs need no memory.

use super::events::Happening;
use super::resume::State;
use super::run::{Ending, Motion};
use super::sheet::Sheet;
use crate::output::json::{self, Record};
use crate::output::{Form, csv, number};
use libration::taylor::Moment;
use serde_json::Value;
use std::io::{self, Write};

/// A form of the answer.
pub(super) trait Report {
    fn begin(&mut self, motion: &Motion, out: &mut dyn Write) -> io::Result<()>;
    fn sample(&mut self, moment: &Moment, out: &mut dyn Write) -> io::Result<()>;
    /// An event, behind all samples up to its time.
    fn event(&mut self, happening: &Happening, out: &mut dyn Write) -> io::Result<()>;
    fn end(&mut self, summary: &Summary, out: &mut dyn Write) -> io::Result<()>;
}

/// What is known when the integration has ended.
pub(super) struct Summary {
    pub(super) steps: usize,
    /// The drift of the energy and its uncertainty, or why there is none.
    pub(super) drift: Result<[f64; 2], String>,
    pub(super) ending: Ending,
    /// What it takes to go on.
    pub(super) state: State,
}

/// The report in this form; a table lists the samples only if that is wanted.
pub(super) fn of_form(form: Form, listed: bool) -> Box<dyn Report> {
    match form {
        Form::Json => Box::new(Json::default()),
        Form::Csv => Box::new(Csv::default()),
        Form::Table => Box::new(Sheet::new(listed)),
    }
}

/// What the system is called: its key, or the equations as they were understood.
pub(super) fn name(motion: &Motion) -> String {
    motion.model.key().map_or_else(|| motion.model.equation().to_string(), str::to_owned)
}

/// One JSON document.
#[derive(Debug, Default)]
struct Json {
    samples: json::List,
    /// They follow the samples.
    happenings: Vec<Happening>,
}

impl Report for Json {
    fn begin(&mut self, motion: &Motion, out: &mut dyn Write) -> io::Result<()> {
        let head = Record::new()
            .with("system", name(motion))
            .with("equations", motion.model.equation().to_string())
            .with("parameters", parameters(motion))
            .with("state", motion.model.state_names());
        json::begin_document(out, head)?;
        self.samples.begin(out, "samples")
    }

    fn sample(&mut self, moment: &Moment, out: &mut dyn Write) -> io::Result<()> {
        self.samples.item(out, record(moment))
    }

    fn event(&mut self, happening: &Happening, _: &mut dyn Write) -> io::Result<()> {
        self.happenings.push(happening.clone());
        Ok(())
    }

    fn end(&mut self, summary: &Summary, out: &mut dyn Write) -> io::Result<()> {
        self.samples.end(out)?;
        let mut events = json::List::default();
        events.begin(out, "events")?;
        for event in &self.happenings {
            events.item(out, event_record(event))?;
        }
        events.end(out)?;
        let tail = Record::new();
        let tail = match &summary.drift {
            Ok([drift, uncertainty]) => {
                tail.number("energy_drift", *drift).number("energy_drift_uncertainty", *uncertainty)
            }
            Err(reason) => {
                tail.number_or("energy_drift", None, reason).with("energy_drift_uncertainty", Value::Null)
            }
        };
        let tail = tail.with("steps", summary.steps).with("resume", summary.state.to_json());
        let tail = match &summary.ending {
            Ending::Complete => tail,
            Ending::Interrupted(_) => tail.with("interrupted", true),
            Ending::Stopped(reason) => tail.with("stopped", reason.as_str()),
        };
        json::end_document(out, tail)
    }
}

/// The values of the parameters, by name.
fn parameters(motion: &Motion) -> Record {
    let values = motion.model.values().iter();
    values
        .fold(Record::new(), |record, (name, value)| record.number(name, value.to_f64().unwrap_or(f64::NAN)))
}

fn record(moment: &Moment) -> Record {
    Record::new().number("time", moment.time).with("state", values(&moment.state))
}

fn event_record(event: &Happening) -> Record {
    Record::new()
        .number("time", event.time)
        .with("kind", event.kind.as_str())
        .with("state", values(&event.state))
}

fn values(state: &[f64]) -> Vec<Value> {
    state.iter().map(|&value| json::number(value)).collect()
}

/// Lines of numbers below their names. If events are looked for they stand among the samples in the order of time, with their
/// kind in a last column, which is empty in samples.
#[derive(Debug, Default)]
struct Csv {
    with_events: bool,
}

impl Csv {
    fn line(&self, time: f64, state: &[f64], kind: &str, out: &mut dyn Write) -> io::Result<()> {
        let mut cells = vec![number::exact(time)];
        cells.extend(state.iter().map(|&value| number::exact(value)));
        cells.extend(self.with_events.then(|| kind.to_owned()));
        csv::line(out, &cells)
    }
}

impl Report for Csv {
    fn begin(&mut self, motion: &Motion, out: &mut dyn Write) -> io::Result<()> {
        self.with_events = !motion.watched.is_empty();
        let mut names = [vec!["time".to_owned()], motion.model.state_names()].concat();
        names.extend(self.with_events.then(|| "event".to_owned()));
        csv::line(out, &names)
    }

    fn sample(&mut self, moment: &Moment, out: &mut dyn Write) -> io::Result<()> {
        self.line(moment.time, &moment.state, "", out)
    }

    fn event(&mut self, happening: &Happening, out: &mut dyn Write) -> io::Result<()> {
        self.line(happening.time, &happening.state, &happening.kind, out)
    }

    fn end(&mut self, _: &Summary, _: &mut dyn Write) -> io::Result<()> {
        Ok(())
    }
}
