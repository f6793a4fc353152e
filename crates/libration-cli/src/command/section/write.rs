//! The points of a section as table, JSON and CSV.

use super::Answer;
use crate::output::json::{self, Record};
use crate::output::table::{Column, Table, sheet};
use crate::output::{Form, csv, number};
use serde_json::Value;
use std::io::{self, Write};

impl Answer<'_> {
    /// In the form asked for; the table lists the points only if that is wanted.
    pub(super) fn write(&self, out: &mut dyn Write, form: Form, listed: bool) -> io::Result<()> {
        match form {
            Form::Json => self.write_json(out),
            Form::Csv => self.write_csv(out),
            Form::Table => self.write_table(out, listed),
        }
    }

    /// Number of the motion, time and state of each point.
    fn rows(&self) -> impl Iterator<Item = (usize, f64, Vec<f64>)> + '_ {
        let motions = (1..).zip(&self.sections);
        motions
            .flat_map(|(number, section)| section.points.iter().map(move |point| (number, point)))
            .map(|(number, point)| (number, point.time, self.options.shown(&point.state, &self.angles)))
    }

    fn is_complete(&self) -> bool {
        self.sections.iter().all(|section| section.stopped.is_none())
    }

    fn write_json(&self, out: &mut dyn Write) -> io::Result<()> {
        let head = Record::new()
            .with("system", self.model.key())
            .with("equation", self.model.equation().to_string())
            .with("section", self.place.as_str())
            .with("skipped", self.points.skipped)
            .with("state", self.model.state_names())
            .with("initial", self.starts.clone())
            .with("complete", self.is_complete());
        let points = self.rows().map(|(motion, time, state)| {
            let state: Vec<Value> = state.into_iter().map(json::number).collect();
            Record::new().with("motion", motion).number("time", time).with("state", state)
        });
        json::document_with_list(out, head, "points", points)
    }

    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let names = self.model.state_names();
        csv::line(out, &[vec!["motion".to_owned(), "time".to_owned()], names].concat())?;
        for (motion, time, state) in self.rows() {
            let numbers = [time].into_iter().chain(state).map(number::exact);
            csv::line(out, &std::iter::once(motion.to_string()).chain(numbers).collect::<Vec<_>>())?;
        }
        Ok(())
    }

    fn write_table(&self, out: &mut dyn Write, listed: bool) -> io::Result<()> {
        let count: usize = self.sections.iter().map(|section| section.points.len()).sum();
        sheet(
            out,
            &[
                ("system", self.model.title().to_owned()),
                ("equation", self.model.equation().to_string()),
                (
                    "points",
                    format!("{count}, {}, after {} of the transient", self.place, self.points.skipped),
                ),
            ],
        )?;
        if !listed {
            return Ok(());
        }
        writeln!(out)?;
        let titles = ["motion".to_owned(), "time".to_owned()].into_iter().chain(self.model.state_names());
        let mut table = Table::new(titles.map(Column::numbers).collect());
        for (motion, time, state) in self.rows() {
            let numbers = [time].into_iter().chain(state).map(|value| number::rounded(value, 10));
            table.row(out, std::iter::once(motion.to_string()).chain(numbers).collect())?;
        }
        table.finish(out)
    }
}
