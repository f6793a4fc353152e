//! The fit as a sheet, as JSON and as CSV.

use crate::failure::Failure;
use crate::output::json::{self, Record};
use crate::output::table::{sheet, write_text};
use crate::output::{self, Form, csv, number};
use libration::quantity::Quantity;
use libration_lab::fit::Budget;
use libration_lab::fit::gates::{GateCycle, GatesFit, T0Source};
use serde_json::Value;
use std::io::{self, Write};

/// What is said about the times.
pub(super) struct Answer<'a> {
    pub(super) fit: &'a GatesFit,
    /// With the length.
    pub(super) budget: Option<(&'a Budget, Quantity)>,
    pub(super) findings: Vec<String>,
    pub(super) incomplete: usize,
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

    fn record(&self) -> Record {
        let fit = self.fit;
        let part = |quantity: Option<Quantity>| quantity.map(|found| found.value);
        let spread = |quantity: Option<Quantity>| quantity.and_then(|found| found.uncertainty);
        let no_t0 = "give the amplitude of the first swing, or the length and the diameter of the bob";
        let no_beta = "amplitudes by the speed at the gate are needed, which fall";
        let no_gravity = "give --length, and what gives T0, to have gravity";
        let record = Record::new()
            .with("passages", fit.passages)
            .with("edges", fit.edges)
            .with("unpaired_edges", fit.unpaired)
            .with("double_triggers", fit.double_triggers)
            .with("missed_passages", fit.missed)
            .with("rows_incomplete", self.incomplete)
            .number("part_between_passages", fit.part_between)
            .number("timing_s", fit.timing)
            .number("mean_period_s", fit.mean_period.value)
            .number("mean_period_uncertainty_s", fit.mean_period.uncertainty.unwrap_or(f64::NAN))
            .number_or("t0_s", part(fit.t0), no_t0)
            .number_or("t0_uncertainty_s", spread(fit.t0), no_t0)
            .with("t0_by", source(fit.t0_source))
            .number_or("beta", fit.beta.map(|beta| beta.factor.value), no_beta)
            .number_or("beta_uncertainty", fit.beta.map(|beta| beta.factor.uncertainty), no_beta)
            .number_or("gravity_m_per_s2", self.budget.map(|(budget, _)| budget.g), no_gravity)
            .number_or(
                "gravity_uncertainty_m_per_s2",
                self.budget.map(|(budget, _)| budget.uncertainty),
                no_gravity,
            );
        let record = match self.budget {
            Some((budget, _)) => output::budget::fields(record, budget),
            None => record,
        };
        let record = record
            .with("cycles", fit.cycles.iter().map(|cycle| cycle_record(cycle).into()).collect::<Vec<Value>>())
            .with("told_from_file", self.findings.clone());
        output::warnings::fields(record, self.warnings())
    }

    /// With names that stay.
    fn warnings(&self) -> Vec<(&'static str, String)> {
        let of_times = self.fit.warnings.iter().map(|warning| (warning.name(), warning.to_string()));
        of_times
            .chain(self.budget.into_iter().flat_map(|(budget, _)| output::budget::warnings(budget)))
            .collect()
    }

    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        csv::line(out, &["time_s", "period_s", "side", "amplitude_rad"])?;
        for cycle in &self.fit.cycles {
            let amplitude = cycle.amplitude.map_or(String::new(), number::exact);
            let [time, period] = [cycle.time, cycle.period].map(number::exact);
            csv::line(out, &[time, period, cycle.side.to_string(), amplitude])?;
        }
        Ok(())
    }

    fn write_sheet(&self, out: &mut dyn Write) -> io::Result<()> {
        sheet(out, &self.lines())?;
        for finding in &self.findings {
            write_text(out, "read: ", finding)?;
        }
        for warning in &self.fit.warnings {
            write_text(out, "note: ", &warning.to_string())?;
        }
        let Some((budget, _)) = self.budget else { return Ok(()) };
        writeln!(out)?;
        output::budget::write_table(out, budget)
    }

    fn lines(&self) -> Vec<(&'static str, String)> {
        let fit = self.fit;
        let said = |quantity: Quantity, unit: &str| {
            number::with_uncertainty(quantity.value, quantity.uncertainty.unwrap_or(0.0), unit)
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
            ("timing", format!("{} s, by the scatter", number::rounded(fit.timing, 2))),
            ("mean period", said(fit.mean_period, "s")),
        ];
        if let Some(first) = fit.first_period {
            lines
                .push(("first period", format!("{}  (all, followed back to the release)", said(first, "s"))));
        }
        match fit.t0 {
            Some(t0) => lines.push(("T₀", format!("{}  (by {})", said(t0, "s"), source(fit.t0_source)))),
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
            lines.extend(output::budget::lines(budget, length));
        }
        lines
    }
}

fn source(source: Option<T0Source>) -> &'static str {
    match source {
        Some(T0Source::Speeds) => "the speeds at the gate",
        Some(T0Source::FirstAmplitude) => "the amplitude of the release",
        None => "nothing",
    }
}

fn cycle_record(cycle: &GateCycle) -> Record {
    let record =
        Record::new().number("time_s", cycle.time).number("period_s", cycle.period).with("side", cycle.side);
    match cycle.amplitude {
        Some(amplitude) => record.number("amplitude_rad", amplitude),
        None => record.with("amplitude_rad", Value::Null),
    }
}
