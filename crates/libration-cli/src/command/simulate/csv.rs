//! The answer as lines of numbers below their names.

use super::events::Happening;
use super::fields;
use super::motion::SimulatedMotion;
use super::report::{AnswerWriter, Sample, Summary};
use crate::output::field::Fields;
use crate::output::{csv, number};
use std::io::{self, Write};

/// If events are looked for they stand among the samples in the order of time, with their kind in a last column, which is empty in
/// samples.
pub(super) struct Csv {
    of_time: Fields<f64>,
    with_events: bool,
}

impl Csv {
    pub(super) fn new() -> Self {
        Self { of_time: fields::of_time(), with_events: false }
    }

    fn line(&self, time: f64, numbers: [&[f64]; 2], kind: &str, out: &mut dyn Write) -> io::Result<()> {
        let mut cells = self.of_time.csv_cells(&time);
        cells.extend(numbers.concat().into_iter().map(number::exact));
        cells.extend(self.with_events.then(|| kind.to_owned()));
        csv::line(out, &cells)
    }
}

impl AnswerWriter for Csv {
    fn begin(&mut self, motion: &SimulatedMotion, out: &mut dyn Write) -> io::Result<()> {
        self.with_events = !motion.watched.is_empty();
        let mut names =
            [self.of_time.csv_names(), motion.model.state_names(), motion.column_names()].concat();
        names.extend(self.with_events.then(|| fields::EVENT.0.to_owned()));
        csv::line(out, &names)
    }

    fn sample(&mut self, Sample { moment, columns }: &Sample, out: &mut dyn Write) -> io::Result<()> {
        self.line(moment.time, [&moment.state, columns.as_deref().unwrap_or(&[])], "", out)
    }

    fn event(&mut self, happening: &Happening, out: &mut dyn Write) -> io::Result<()> {
        let columns = happening.columns.as_deref().unwrap_or(&[]);
        self.line(happening.time, [&happening.state, columns], &happening.kind, out)
    }

    fn end(&mut self, _: &Summary, _: &mut dyn Write) -> io::Result<()> {
        Ok(())
    }
}
