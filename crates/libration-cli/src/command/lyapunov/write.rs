//! The exponent as a sheet with its convergence, JSON and CSV.

use super::Answer;
use crate::output::json::{self, Record};
use crate::output::table::{Column, Table, paragraph, sheet};
use crate::output::{Form, csv, number};
use serde_json::Value;
use std::io::{self, Write};

/// Where sentences are broken.
const COLUMNS: usize = 100;

impl Answer<'_> {
    /// In the form asked for; the table lists the points only if that is wanted.
    pub(super) fn write(&self, out: &mut dyn Write, form: Form, listed: bool) -> io::Result<()> {
        match form {
            Form::Json => self.write_json(out),
            Form::Csv => self.write_csv(out),
            Form::Table => self.write_sheet(out, listed),
        }
    }

    fn write_json(&self, out: &mut dyn Write) -> io::Result<()> {
        let initial: Vec<Value> = self.initial.iter().map(|value| json::number(*value)).collect();
        let head = Record::new()
            .with("system", self.model.key())
            .with("equation", self.model.equation().to_string())
            .with("state", self.model.state_names())
            .with("initial", initial)
            .number("transient", self.schedule.transient)
            .number("interval", self.schedule.interval)
            .number("exponent", self.found.exponent)
            .number("uncertainty", self.found.uncertainty)
            .with("verdict", self.found.verdict.to_string())
            .with("reason", self.found.verdict.reason());
        let convergence = self.found.convergence.iter();
        let records = convergence
            .map(|(time, exponent)| Record::new().number("time", *time).number("exponent", *exponent));
        json::document_with_list(out, head, "convergence", records)
    }

    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        csv::line(out, &["time", "exponent"])?;
        self.found.convergence.iter().try_for_each(|(time, exponent)| csv::numbers(out, &[*time, *exponent]))
    }

    fn write_sheet(&self, out: &mut dyn Write, listed: bool) -> io::Result<()> {
        let found = &self.found;
        let exponent =
            format!("{} ± {} 1/s", number::rounded(found.exponent, 5), number::rounded(found.uncertainty, 2));
        sheet(
            out,
            &[
                ("system", self.model.title().to_owned()),
                ("equation", self.model.equation().to_string()),
                ("largest Lyapunov exponent", exponent),
            ],
        )?;
        let verdict = format!("{}: {}", found.verdict, found.verdict.reason());
        writeln!(out, "{}", paragraph("verdict                    ", &verdict, COLUMNS))?;
        if !listed {
            return Ok(());
        }
        writeln!(out)?;
        let mut table =
            Table::new(vec![Column::numbers("measured / s"), Column::numbers("exponent / (1/s)")]);
        for (time, exponent) in found.convergence.iter().rev().step_by(4).rev() {
            table.row(out, vec![number::short(*time, 8), number::rounded(*exponent, 6)])?;
        }
        table.finish(out)
    }
}
