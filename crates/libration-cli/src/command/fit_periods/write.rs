//! The fit as a sheet with a table of laws, as JSON and as CSV.

use super::input::Measured;
use crate::failure::Failure;
use crate::output::json::{self, Record};
use crate::output::table::{Column, Table, sheet};
use crate::output::{self, Form, csv, number};
use libration::quantity::Quantity;
use libration_lab::fit::{Budget, FitError, LawFit, PeriodFit, Weighting};
use serde_json::Value;
use std::io::{self, Write};

/// What is said about the measurements.
pub(super) struct Answer<'a> {
    pub(super) measured: &'a Measured,
    pub(super) fit: &'a PeriodFit,
    pub(super) budget: Option<&'a Budget>,
    pub(super) length: Option<Quantity>,
}

impl Answer<'_> {
    pub(super) fn write(&self, out: &mut dyn Write, form: Form) -> Result<(), Failure> {
        match form {
            Form::Json => json::document(out, self.record())?,
            Form::Csv => self.write_csv(out)?,
            Form::Table => self.write_sheet(out)?,
        }
        Ok(())
    }

    /// The laws with their keys: the exact one, the constant period, the formulas.
    fn laws(&self) -> impl Iterator<Item = (&str, Result<&LawFit, &FitError>)> {
        let fixed = [&self.fit.exact, &self.fit.constant].map(|law| (law.key.as_str(), Ok(law)));
        fixed.into_iter().chain(self.fit.others.iter().map(|(key, law)| (key.as_str(), law.as_ref())))
    }

    fn record(&self) -> Record {
        let laws: Vec<Value> = self.laws().map(|(key, law)| law_record(key, law).into()).collect();
        let record = Record::new()
            .with("rows", self.fit.table.len())
            .with("rows_incomplete", self.measured.dropped)
            .with("told_from_file", self.measured.told.clone())
            .with("weighting", weighting(self.fit.weighting))
            .with("outlier_lines", self.outlier_lines())
            .with("laws", laws);
        let record = output::warnings::fields(record, self.warnings());
        self.gravity_fields(self.beta_fields(record))
    }

    /// What is doubtful about the rows, and about gravity, with names that stay.
    fn warnings(&self) -> Vec<(&'static str, String)> {
        let of_rows = self.fit.warnings().into_iter().map(|warning| (warning.name(), warning.to_string()));
        of_rows.chain(self.budget.into_iter().flat_map(output::budget::warnings)).collect()
    }

    fn beta_fields(&self, record: Record) -> Record {
        let beta = self.fit.beta.as_ref();
        let why_none = beta.err().map(ToString::to_string).unwrap_or_default();
        let beta = beta.ok();
        record
            .number_or("beta", beta.map(|beta| beta.beta.factor.value), &why_none)
            .number_or("beta_uncertainty", beta.map(|beta| beta.beta.factor.uncertainty), &why_none)
            .number_or(
                "beta_uncertainty_scaled",
                beta.and_then(|beta| beta.uncertainty_scaled),
                "chi² per degree of freedom is needed to scale it",
            )
    }

    fn gravity_fields(&self, record: Record) -> Record {
        let why_none = "give --length to have gravity";
        let gravity = self.budget.map(|budget| budget.g);
        let uncertainty = self.budget.map(|budget| budget.uncertainty);
        let record = record.number_or("gravity_m_per_s2", gravity, why_none).number_or(
            "gravity_uncertainty_m_per_s2",
            uncertainty,
            why_none,
        );
        match self.budget {
            Some(budget) => output::budget::fields(record, budget),
            None => record,
        }
    }

    fn outlier_lines(&self) -> Vec<u64> {
        self.fit.outliers.iter().filter_map(|&row| self.measured.lines.get(row).copied()).collect()
    }

    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        csv::line(out, &["key", "t0_s", "t0_uncertainty_s", "chi2_per_dof", "rms_s"])?;
        for (key, law) in self.laws() {
            let values = law.map_or([f64::NAN; 4], |law| {
                [law.t0, law.t0_uncertainty, law.chi2_per_dof().unwrap_or(f64::NAN), law.rms]
            });
            csv::line(out, &[vec![key.to_owned()], values.map(number::exact).to_vec()].concat())?;
        }
        Ok(())
    }

    fn write_sheet(&self, out: &mut dyn Write) -> io::Result<()> {
        sheet(out, &self.lines())?;
        writeln!(out)?;
        let numbers = ["T₀ / s", "± / s", "χ²/dof", "rms residual / s"].map(Column::numbers);
        let mut table = Table::new([vec![Column::words("law")], numbers.to_vec()].concat());
        for (key, law) in self.laws() {
            let cells = law.map_or_else(
                |_| std::array::from_fn(|_| "–".to_owned()),
                |law| {
                    [
                        number::rounded(law.t0, 8),
                        number::rounded(law.t0_uncertainty, 2),
                        law.chi2_per_dof().map_or("–".to_owned(), |chi2| number::rounded(chi2, 4)),
                        number::rounded(law.rms, 3),
                    ]
                },
            );
            table.row(out, [vec![key.to_owned()], cells.to_vec()].concat())?;
        }
        table.finish(out)?;
        let Some(budget) = self.budget else { return Ok(()) };
        writeln!(out)?;
        output::budget::write_table(out, budget)
    }

    fn lines(&self) -> Vec<(&'static str, String)> {
        let exact = &self.fit.exact;
        let mut lines = vec![
            ("rows", self.rows_line()),
            ("weights", weighting(self.fit.weighting).to_owned()),
            (
                "T₀, exact law",
                number::with_uncertainty(exact.t0, exact.t0_uncertainty, "s")
                    + &output::scatter::remark(exact.scatter()),
            ),
            ("β", self.beta_line()),
        ];
        lines.extend(self.fit.warnings().iter().map(|warning| ("doubtful", warning.to_string())));
        if !self.measured.told.is_empty() {
            lines.insert(1, ("units", self.measured.told.join("; ")));
        }
        if let (Some(budget), Some(length)) = (self.budget, self.length) {
            lines.extend(output::budget::lines(budget, length));
        }
        lines
    }

    fn rows_line(&self) -> String {
        let mut line = self.fit.table.len().to_string();
        if self.measured.dropped > 0 {
            line += &format!(", {} incomplete ones left out", self.measured.dropped);
        }
        let outliers = self.outlier_lines();
        if !outliers.is_empty() {
            let fate = if self.fit.table.len() < self.measured.rows.len() { "left out" } else { "kept" };
            let shown: Vec<String> = outliers.iter().take(10).map(ToString::to_string).collect();
            let more = if outliers.len() > shown.len() { ", …" } else { "" };
            line += &format!("; {} outliers {fate} (lines {}{more})", outliers.len(), shown.join(", "));
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

fn law_record(key: &str, law: Result<&LawFit, &FitError>) -> Record {
    let record = Record::new().with("key", key);
    match law {
        Ok(law) => output::scatter::fields(record, law.scatter())
            .number("t0_s", law.t0)
            .number("t0_uncertainty_s", law.t0_uncertainty)
            .number_or("chi2_per_dof", law.chi2_per_dof(), "the table has no uncertainties of the periods")
            .number("rms_s", law.rms),
        Err(error) => ["t0_s", "t0_uncertainty_s", "chi2_per_dof", "rms_s", "birge_ratio"]
            .into_iter()
            .fold(record, |record, name| record.with(name, Value::Null))
            .note(&error.to_string()),
    }
}

fn weighting(weighting: Weighting) -> &'static str {
    match weighting {
        Weighting::PeriodsAndAmplitudes => "uncertainties of periods and amplitudes",
        Weighting::Periods => "uncertainties of periods",
        Weighting::Scatter => "none: uncertainties from the scatter",
    }
}
