//! A normal form as a sheet with words, JSON and CSV.

use super::ResonanceResult;
use super::fields::{of_answer, of_exchange, of_term, told};
use crate::output::number::{rounded, short};
use crate::output::table::{paragraph, sheet, write_text};
use crate::output::{Form, csv, json};
use libration::normal_form::SlowTerm;
use std::io::{self, Write};

/// Width at which lines are broken, in columns.
const COLUMNS: usize = 100;

impl ResonanceResult {
    /// Writes the result in the given form; the table lists the terms only if requested.
    pub(super) fn write(&self, out: &mut dyn Write, form: Form, listed: bool) -> io::Result<()> {
        let fields = of_term();
        match form {
            Form::Json => {
                let terms = self.form.slow_terms.iter().map(|term| fields.record(term));
                json::document_with_list(out, of_answer().record(self), "slow_terms", terms)
            }
            Form::Csv => {
                csv::line(out, &fields.csv_names())?;
                self.form.slow_terms.iter().try_for_each(|term| csv::line(out, &fields.csv_cells(term)))
            }
            Form::Table => self.write_sheet(out, listed),
        }
    }

    fn write_sheet(&self, out: &mut dyn Write, listed: bool) -> io::Result<()> {
        let mut lines = of_answer().lines(self);
        let equations = self.model.equation().to_string();
        lines.extend(equations.split("; ").map(|equation| ("equation", equation.to_owned())));
        for (number, mode) in (1..).zip(&self.form.modes.modes) {
            let parts = self.form.modes.variables.iter().zip(&mode.shape);
            let parts: Vec<String> =
                parts.map(|(name, part)| format!("{name} {}", short(part.re, 6))).collect();
            let text = format!("{number}: ω = {} rad/s, {}", rounded(mode.frequency(), 12), parts.join(", "));
            lines.push(("mode", text));
        }
        for (name, text) in lines {
            writeln!(out, "{}", paragraph(&format!("{name:<10}"), &text, COLUMNS))?;
        }
        if listed && !self.form.slow_terms.is_empty() {
            writeln!(out)?;
            of_term().write_table(out, &self.form.slow_terms)?;
        }
        writeln!(out)?;
        write_text(out, "", &self.words())?;
        match &self.exchange {
            Some(Ok(both)) => {
                writeln!(out)?;
                let lines: Vec<_> =
                    of_exchange().lines(both).into_iter().filter(|(_, text)| !text.is_empty()).collect();
                sheet(out, &lines)
            }
            Some(Err(reason)) => write_text(out, "", &format!("No exchange: {reason}.")),
            None => Ok(()),
        }
    }

    fn words(&self) -> String {
        let resonant: Vec<&SlowTerm> =
            self.form.slow_terms.iter().filter(|term| !term.is_of_every_system()).collect();
        let kept = match resonant.len() {
            0 => "No resonance to this order: each mode keeps its amplitude, which only shifts frequencies."
                .to_owned(),
            1 => "One resonant term lets modes exchange energy.".to_owned(),
            more => format!("{more} resonant terms let modes exchange energy."),
        };
        match self.form.small_divisors.first() {
            Some(smallest) => {
                format!("{kept} The smallest divisor of the removed terms is that of {}.", told(smallest))
            }
            None => kept,
        }
    }
}
