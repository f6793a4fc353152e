//! The fit as a sheet with a table of laws, as JSON and as CSV.

use super::fields::{self, FitPeriodsResult};
use crate::output::groups::{self, Groups};
use crate::output::json::{self, Record};
use crate::output::normal_gravity;
use crate::output::table::sheet;
use crate::output::{self, Form, number};
use crate::query_error::QueryError;
use libration_lab::fit::PeriodsWarning;
use std::io::{self, Write};

impl FitPeriodsResult<'_> {
    pub(super) fn write(&self, out: &mut dyn Write, form: Form) -> Result<(), QueryError> {
        match form {
            Form::Json => json::document(out, self.record())?,
            Form::Csv => fields::of_law().write_csv(out, &self.laws())?,
            Form::Table => self.write_sheet(out)?,
        }
        Ok(())
    }

    fn record(&self) -> Record {
        let record = fields::of_answer().record(self);
        let record = normal_gravity::fields().added_to(record, &self.normal);
        let record = Groups::added_to(self.groups, &groups::T0, record);
        match self.budget {
            Some(budget) => output::budget::added_to(record, budget),
            None => record,
        }
    }

    fn write_sheet(&self, out: &mut dyn Write) -> io::Result<()> {
        sheet(out, &self.lines())?;
        writeln!(out)?;
        fields::of_law().write_table(out, &self.laws())?;
        if let Some(groups) = self.groups {
            writeln!(out)?;
            groups.write_table(out)?;
        }
        let Some(budget) = self.budget else { return Ok(()) };
        writeln!(out)?;
        output::budget::write_table(out, budget)
    }

    pub(super) fn lines(&self) -> Vec<(&'static str, String)> {
        let exact = &self.fit.exact;
        let warnings = self.fit.warnings();
        let (grave, others): (Vec<_>, Vec<_>) =
            warnings.iter().partition(|warning| !matches!(warning, PeriodsWarning::Scatter(_)));
        let said = |warning: &&PeriodsWarning| ("warning", warning.to_string());
        let mut lines: Vec<(&'static str, String)> = grave.iter().map(said).collect();
        let first = lines.len();
        lines.extend([
            ("rows", self.rows_line()),
            ("weights", self.weighting().to_owned()),
            (
                "T₀, exact law",
                number::with_uncertainty(exact.t0.value, exact.t0.uncertainty, "s")
                    + &output::scatter::remark(exact.scatter()),
            ),
            ("β", self.beta_line()),
        ]);
        lines.extend(others.iter().map(said));
        if !self.measured.inferences.sentences.is_empty() {
            lines.insert(first + 1, ("read as", self.measured.inferences.sentences.join("; ")));
        }
        if let Some(groups) = self.groups {
            lines.push(("T₀, groups", groups.line()));
        }
        if let (Some(budget), Some(length)) = (self.budget, self.length) {
            lines.extend(output::budget::lines(budget, length, self.normal));
        }
        lines
    }

    fn rows_line(&self) -> String {
        let mut line = self.fit.table.len().to_string();
        if self.measured.dropped > 0 {
            line += &format!(", {} incomplete rows left out", self.measured.dropped);
        }
        let outliers = self.outlier_lines();
        if !outliers.is_empty() {
            let fate = if self.fit.table.len() < self.measured.rows.len() { "left out" } else { "included" };
            let shown: Vec<String> = outliers.iter().take(10).map(ToString::to_string).collect();
            let more = if outliers.len() > shown.len() { ", …" } else { "" };
            let (outlier, lines) =
                if outliers.len() == 1 { ("outlier", "line") } else { ("outliers", "lines") };
            line += &format!("; {} {outlier} {fate} ({lines} {}{more})", outliers.len(), shown.join(", "));
        }
        line
    }

    fn beta_line(&self) -> String {
        match &self.fit.beta {
            Ok(beta) => {
                format!("{}  (1 is the exact law)", beta.beta.factor)
            }
            Err(error) => format!("none: {error}"),
        }
    }
}
