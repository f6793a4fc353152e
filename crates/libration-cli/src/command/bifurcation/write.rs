//! The points of a bifurcation diagram as table, JSON and CSV.

use super::{Diagram, Sweep};
use crate::output::json::{self, Record};
use crate::output::table::{Column, Table, sheet};
use crate::output::{Form, csv, number};
use serde_json::Value;
use std::io::{self, Write};

/// One point: the sweep, the value of the parameter, time and state.
pub(crate) struct Row {
    sweep: &'static str,
    value: f64,
    time: f64,
    state: Vec<f64>,
}

impl Diagram<'_> {
    /// In the form asked for; the table lists the points only if that is wanted.
    pub(super) fn write(&self, out: &mut dyn Write, form: Form, listed: bool) -> io::Result<()> {
        match form {
            Form::Json => self.write_json(out),
            Form::Csv => self.write_csv(out),
            Form::Table => self.write_table(out, listed),
        }
    }

    /// All points, with angles folded if that is wanted.
    pub(crate) fn rows(&self) -> impl Iterator<Item = Row> + '_ {
        let columns =
            self.sweeps.iter().flat_map(|sweep| sweep.columns.iter().map(move |it| (sweep.name, it)));
        columns
            .flat_map(|(sweep, column)| column.section.points.iter().map(move |it| (sweep, column.value, it)))
            .map(|(sweep, value, point)| Row {
                sweep,
                value,
                time: point.time,
                state: self.options.shown(&point.state, &self.angles),
            })
    }
    /// Whether each sweep has all values.
    pub(super) fn is_complete(&self) -> bool {
        self.sweeps.iter().all(|sweep: &Sweep| sweep.columns.len() == self.parameter.values.len())
    }

    fn write_json(&self, out: &mut dyn Write) -> io::Result<()> {
        let stopped: Vec<String> = self.stopped().collect();
        let head = Record::new()
            .with("system", self.model.key())
            .with("equation", self.model.equation().to_string())
            .with("parameter", self.parameter.name.as_str())
            .with("section", self.place.as_str())
            .with("skipped", self.points.skipped)
            .with("state", self.model.state_names())
            .with("complete", self.is_complete())
            .with("stopped", stopped);
        let points = self.rows().map(|row| {
            let state: Vec<Value> = row.state.into_iter().map(json::number).collect();
            let place = Record::new().with("sweep", row.sweep).number("value", row.value);
            place.number("time", row.time).with("state", state)
        });
        json::document_with_list(out, head, "points", points)
    }

    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let head = ["sweep", &self.parameter.name, "time"].map(str::to_owned).to_vec();
        csv::line(out, &[head, self.model.state_names()].concat())?;
        for row in self.rows() {
            let numbers = [row.value, row.time].into_iter().chain(row.state).map(number::exact);
            csv::line(out, &std::iter::once(row.sweep.to_owned()).chain(numbers).collect::<Vec<_>>())?;
        }
        Ok(())
    }

    fn write_table(&self, out: &mut dyn Write, listed: bool) -> io::Result<()> {
        let points = format!(
            "{} for each value, {}, after {} of the transient",
            self.points.kept, self.place, self.points.skipped
        );
        let mut lines = vec![
            ("system", self.model.title().to_owned()),
            ("equation", self.model.equation().to_string()),
            ("points", points),
        ];
        lines.extend(self.stopped().map(|text| ("stopped", text)));
        sheet(out, &lines)?;
        if !listed {
            return Ok(());
        }
        writeln!(out)?;
        let titles = ["sweep", &self.parameter.name, "time"].map(str::to_owned).into_iter();
        let titles = titles.chain(self.model.state_names());
        let mut table = Table::new(titles.map(Column::numbers).collect());
        for row in self.rows() {
            let numbers =
                [row.value, row.time].into_iter().chain(row.state).map(|value| number::short(value, 10));
            table.row(out, std::iter::once(row.sweep.to_owned()).chain(numbers).collect())?;
        }
        table.finish(out)
    }

    /// The values for which the motion stopped early, and why.
    fn stopped(&self) -> impl Iterator<Item = String> + '_ {
        let columns = self.sweeps.iter().flat_map(|sweep| &sweep.columns);
        columns.filter_map(|column| {
            let ending = column.section.stopped?;
            Some(format!("{} = {}: {ending}", self.parameter.name, number::short(column.value, 10)))
        })
    }
}
