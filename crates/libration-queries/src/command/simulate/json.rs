//! The result as one JSON document.

use super::events::Happening;
use super::fields;
use super::motion::SimulatedMotion;
use super::report::{AnswerWriter, Sample, Summary};
use crate::output::field::Fields;
use crate::output::json;
use std::io::{self, Write};

pub(super) struct Json {
    of_sample: Fields<Sample>,
    samples: json::ListWriter,
    /// Events, which follow the samples.
    happenings: Vec<Happening>,
}

impl Json {
    pub(super) fn new() -> Self {
        Self { of_sample: fields::of_sample(), samples: json::ListWriter::default(), happenings: vec![] }
    }
}

impl AnswerWriter for Json {
    fn begin(&mut self, motion: &SimulatedMotion, out: &mut dyn Write) -> io::Result<()> {
        json::begin_document(out, fields::of_motion().record(motion))?;
        self.samples.begin(out, "samples")
    }

    fn sample(&mut self, sample: &Sample, out: &mut dyn Write) -> io::Result<()> {
        self.samples.item(out, self.of_sample.record(sample))
    }

    fn event(&mut self, happening: &Happening, _: &mut dyn Write) -> io::Result<()> {
        self.happenings.push(happening.clone());
        Ok(())
    }

    fn end(&mut self, summary: &Summary, out: &mut dyn Write) -> io::Result<()> {
        self.samples.end(out)?;
        let (mut events, of_event) = (json::ListWriter::default(), fields::of_event());
        events.begin(out, "events")?;
        self.happenings.iter().try_for_each(|event| events.item(out, of_event.record(event)))?;
        events.end(out)?;
        json::end_document(out, fields::of_summary().record(summary))
    }
}
