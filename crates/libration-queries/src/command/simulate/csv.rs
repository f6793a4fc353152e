//! The result as lines of numbers below their names.

use super::events::Happening;
use super::fields;
use super::motion::SimulatedMotion;
use super::report::{AnswerWriter, Sample, Summary};
use crate::output::csv;
use crate::output::field::Fields;
use libration::taylor::MomentErrors;
use std::io::{self, Write};

/// The output as CSV. Events, if requested, are among the samples in the order of time, with their kind in a last column, which is empty in
/// samples.
pub(super) struct Csv {
    of_time: Fields<f64>,
    with_events: bool,
    with_errors: bool,
}

impl Csv {
    pub(super) fn new() -> Self {
        Self { of_time: fields::of_time(), with_events: false, with_errors: false }
    }

    fn line(
        &self,
        time: f64,
        numbers: [&[f64]; 2],
        errors: Option<&MomentErrors>,
        kind: &str,
        out: &mut dyn Write,
    ) -> io::Result<()> {
        let mut cells = self.of_time.csv_cells(&time);
        cells.extend(numbers.concat().into_iter().map(csv::number));
        // What is not determined has no error.
        let error_text = |error: &f64| csv::number(*error);
        if self.with_errors && self.with_events {
            let of_event = errors.filter(|_| !kind.is_empty());
            cells.push(of_event.map_or(String::new(), |errors| error_text(&errors.time)));
        }
        let errors = errors.into_iter().flat_map(|errors| errors.state.iter().chain(&errors.formulas));
        cells.extend(errors.map(error_text));
        cells.extend(self.with_events.then(|| kind.to_owned()));
        csv::line(out, &cells)
    }
}

impl AnswerWriter for Csv {
    fn begin(&mut self, motion: &SimulatedMotion, out: &mut dyn Write) -> io::Result<()> {
        self.with_events = !motion.watched.is_empty();
        self.with_errors = motion.no_errors().is_none();
        let mut names =
            [self.of_time.csv_names(), motion.model.state_names(), motion.column_names()].concat();
        if self.with_errors {
            names.extend(self.with_events.then(|| fields::TIME_ERROR.0.to_owned()));
            let of_errors = [motion.model.state_names(), motion.column_names()].concat();
            names.extend(of_errors.iter().map(|name| csv::error_of(name)));
        }
        names.extend(self.with_events.then(|| fields::EVENT.0.to_owned()));
        csv::line(out, &names)
    }

    fn sample(&mut self, sample: &Sample, out: &mut dyn Write) -> io::Result<()> {
        let Sample { moment, columns, errors } = sample;
        let numbers = [&moment.state, columns.as_deref().unwrap_or(&[])];
        self.line(moment.time, numbers, errors.as_ref(), "", out)
    }

    fn event(&mut self, happening: &Happening, out: &mut dyn Write) -> io::Result<()> {
        let columns = happening.columns.as_deref().unwrap_or(&[]);
        let (numbers, errors) = ([&*happening.state, columns], happening.errors.as_ref());
        self.line(happening.time, numbers, errors, &happening.kind, out)
    }

    fn end(&mut self, _: &Summary, _: &mut dyn Write) -> io::Result<()> {
        Ok(())
    }
}
