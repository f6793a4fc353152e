//! The orbit as a sheet with its harmonics, JSON and CSV.

use super::OrbitResult;
use super::fields::{of_orbit, of_term};
use crate::output::table::{Table, paragraph, write_text};
use crate::output::{Form, csv, json};
use std::io::{self, Write};

/// Width at which lines are broken, in columns.
const COLUMNS: usize = 100;
/// Harmonics below their error or this fraction of the largest are omitted from tables, as are those beyond a number for each coordinate.
const SHOWN: f64 = 1e-12;
const MOST: usize = 12;

impl OrbitResult {
    /// Writes the result in the given form; the table lists the harmonics only if requested.
    pub(super) fn write(&self, out: &mut dyn Write, form: Form, listed: bool) -> io::Result<()> {
        let fields = of_term();
        match form {
            Form::Json => {
                let terms = self.terms().map(|term| fields.record(&term));
                json::document_with_list(out, of_orbit().record(self), "harmonics", terms)
            }
            Form::Csv => {
                csv::line(out, &fields.csv_names())?;
                self.terms().try_for_each(|term| csv::line(out, &fields.csv_cells(&term)))
            }
            Form::Table => self.write_sheet(out, listed),
        }
    }

    fn write_sheet(&self, out: &mut dyn Write, listed: bool) -> io::Result<()> {
        for (name, text) in of_orbit().lines(self) {
            writeln!(out, "{}", paragraph(&format!("{name:<19}"), &text, COLUMNS))?;
        }
        if !listed {
            return Ok(());
        }
        writeln!(out)?;
        let fields = of_term();
        let mut table = Table::new(fields.columns());
        let largest = self.terms().map(|term| term.term.amplitude()).fold(0.0, f64::max);
        let (mut left_out, mut count) = (false, (String::new(), 0));
        for term in self.terms().filter(|term| term.term.amplitude() > term.error.max(SHOWN * largest)) {
            if count.0 != term.coordinate {
                count = (term.coordinate.to_owned(), 0);
            }
            count.1 += 1;
            if count.1 > MOST {
                left_out = true;
            } else {
                table.row(out, fields.cells(&term))?;
            }
        }
        table.finish(out)?;
        if left_out {
            write_text(out, "", "Higher harmonics are in --json and --csv.")?;
        }
        Ok(())
    }
}
