//! The fit as a sheet, as JSON and as CSV.

use super::fields::{self, FitGatesResult};
use crate::output::json::{self, Record};
use crate::output::normal_gravity;
use crate::output::table::{sheet, write_text};
use crate::output::{self, Form, number};
use crate::query_error::QueryError;
use libration_lab::fit::Uncertain;
use libration_lab::fit::gates::T0Source;
use std::io::{self, Write};

impl FitGatesResult<'_> {
    pub(super) fn write(&self, out: &mut dyn Write, form: Form) -> Result<(), QueryError> {
        match form {
            Form::Json => json::document(out, self.record())?,
            Form::Csv => fields::of_cycle().write_csv(out, &self.fit.cycles)?,
            Form::Table => self.write_sheet(out)?,
        }
        Ok(())
    }

    fn record(&self) -> Record {
        let record = fields::of_answer().record(self);
        let record = normal_gravity::fields().added_to(record, &self.normal);
        let record = match self.budget {
            Some((budget, _)) => output::budget::added_to(record, budget),
            None => record,
        };
        fields::of_cycles().added_to(record, self)
    }

    fn write_sheet(&self, out: &mut dyn Write) -> io::Result<()> {
        sheet(out, &self.lines())?;
        for finding in &self.findings {
            write_text(out, "detected: ", finding)?;
        }
        for warning in &self.fit.warnings {
            write_text(out, "note: ", &warning.to_string())?;
        }
        let Some((budget, _)) = self.budget else { return Ok(()) };
        writeln!(out)?;
        output::budget::write_table(out, budget)
    }

    pub(super) fn lines(&self) -> Vec<(&'static str, String)> {
        let fit = self.fit;
        let by_scatter = |timing: f64| format!("{} s, from the scatter", number::rounded(timing, 2));
        let said = |quantity: Uncertain, unit: &str| match fit.is_exact(quantity) {
            true => format!("{} {unit}, ± not known", number::rounded(quantity.value, 6)),
            false => number::with_uncertainty(quantity.value, quantity.uncertainty, unit),
        };
        let kind = if fit.edges { "from pairs of edges" } else { "one time each" };
        let mut lines = vec![
            ("passages", format!("{} ({kind}), {} full periods", fit.passages, fit.cycles.len())),
            (
                "gate",
                format!(
                    "{} of a period between passages (0.5 at the centre)",
                    number::rounded(fit.part_between, 3)
                ),
            ),
            ("timing", fit.timing.map_or("not known".to_owned(), by_scatter)),
            ("mean period", said(fit.mean_period, "s")),
        ];
        if let Some(first) = fit.first_period {
            lines.push((
                "first period",
                format!("{}  (all periods, extrapolated back to the release)", said(first, "s")),
            ));
        }
        match fit.t0 {
            Some(t0) => lines.push(("T₀", format!("{}  (from {})", said(t0, "s"), self.source()))),
            None => lines.push(("T₀", "not known".to_owned())),
        }
        if let Some(amplitude) = fit.amplitude {
            let degrees = number::rounded(amplitude.to_degrees(), 4);
            let which = if fit.t0_source == Some(T0Source::Speeds) { "typical" } else { "of the release" };
            lines.push(("amplitude", format!("{degrees}°  ({which})")));
        }
        if let Some(beta) = fit.beta {
            let text = beta.factor;
            lines.push(("β", format!("{text}  (1 is the exact law)")));
        }
        if let Some((budget, length)) = self.budget {
            lines.extend(output::budget::lines(budget, length, self.normal));
        }
        lines
    }
}
