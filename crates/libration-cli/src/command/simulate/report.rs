//! The answer as JSON and CSV, sample by sample, so that long runs need no memory.

use super::run::{Ending, Motion};
use super::sheet::Sheet;
use crate::output::json::{self, Record};
use crate::output::{Form, csv};
use libration::taylor::Moment;
use serde_json::Value;
use std::io::{self, Write};

/// A form of the answer.
pub(super) trait Report {
    fn begin(&mut self, motion: &Motion, out: &mut dyn Write) -> io::Result<()>;
    fn sample(&mut self, moment: &Moment, out: &mut dyn Write) -> io::Result<()>;
    fn end(&mut self, summary: &Summary, out: &mut dyn Write) -> io::Result<()>;
}

/// What is known when the integration has ended.
pub(super) struct Summary {
    pub(super) steps: usize,
    /// The drift of the energy, or why there is none.
    pub(super) drift: Result<f64, String>,
    pub(super) ending: Ending,
}

pub(super) fn of_form(form: Form) -> Box<dyn Report> {
    match form {
        Form::Json => Box::new(Json::default()),
        Form::Csv => Box::new(Csv),
        Form::Table => Box::new(Sheet::default()),
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
}

impl Report for Json {
    fn begin(&mut self, motion: &Motion, out: &mut dyn Write) -> io::Result<()> {
        let head = Record::new().with("system", name(motion)).with("state", motion.model.state_names());
        json::begin_document(out, head)?;
        self.samples.begin(out, "samples")
    }

    fn sample(&mut self, moment: &Moment, out: &mut dyn Write) -> io::Result<()> {
        self.samples.item(out, record(moment))
    }

    fn end(&mut self, summary: &Summary, out: &mut dyn Write) -> io::Result<()> {
        self.samples.end(out)?;
        let tail = Record::new().with("events", Vec::<Value>::new());
        let tail = match &summary.drift {
            Ok(drift) => tail.number("energy_drift", *drift),
            Err(reason) => tail.number_or("energy_drift", None, reason),
        };
        let tail = tail.with("steps", summary.steps);
        let tail = match &summary.ending {
            Ending::Complete => tail,
            Ending::Interrupted(_) => tail.with("interrupted", true),
            Ending::Stopped(reason) => tail.with("stopped", reason.as_str()),
        };
        json::end_document(out, tail)
    }
}

fn record(moment: &Moment) -> Record {
    let state: Vec<Value> = moment.state.iter().map(|&value| json::number(value)).collect();
    Record::new().number("time", moment.time).with("state", state)
}

/// Lines of numbers below their names.
#[derive(Debug)]
struct Csv;

impl Report for Csv {
    fn begin(&mut self, motion: &Motion, out: &mut dyn Write) -> io::Result<()> {
        let names = [vec!["time".to_owned()], motion.model.state_names()].concat();
        csv::line(out, &names)
    }

    fn sample(&mut self, moment: &Moment, out: &mut dyn Write) -> io::Result<()> {
        csv::numbers(out, &[&[moment.time], moment.state.as_slice()].concat())
    }

    fn end(&mut self, _: &Summary, _: &mut dyn Write) -> io::Result<()> {
        Ok(())
    }
}
