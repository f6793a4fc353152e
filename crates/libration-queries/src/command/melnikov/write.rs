//! A Melnikov function as a sheet with words, JSON and CSV.

use super::MelnikovResult;
use super::fields::{of_answer, of_crossing, of_resonance, separatrix};
use crate::output::number::{at_most, rounded, short, to_its_error};
use crate::output::table::{Table, paragraph, write_text};
use crate::output::{Form, csv, json};
use libration::melnikov::Melnikov;
use std::io::{self, Write};

/// Width at which lines are broken, in columns.
const COLUMNS: usize = 100;
/// Overlap above which motions between resonances are chaotic by experience; the criterion itself has 1.
const OVERLAP: f64 = 2.0 / 3.0;

impl MelnikovResult {
    /// Writes the result in the given form; the table lists the resonances only if requested.
    pub(super) fn write(&self, out: &mut dyn Write, form: Form, listed: bool) -> io::Result<()> {
        match form {
            Form::Json => {
                let fields = of_resonance();
                let resonances = self.neighbours().map(|neighbour| fields.record(&neighbour));
                json::document_with_list(out, of_answer().record(self), "resonances", resonances)
            }
            Form::Csv => {
                let fields = of_resonance();
                csv::line(out, &fields.csv_names())?;
                self.neighbours().try_for_each(|neighbour| csv::line(out, &fields.csv_cells(&neighbour)))
            }
            Form::Table => self.write_sheet(out, listed),
        }
    }

    fn write_sheet(&self, out: &mut dyn Write, listed: bool) -> io::Result<()> {
        let lines = of_answer().lines(self);
        for (name, text) in lines.into_iter().filter(|(_, text)| !text.is_empty()) {
            writeln!(out, "{}", paragraph(&format!("{name:<13}"), &text, COLUMNS))?;
        }
        writeln!(out)?;
        for melnikov in &self.separatrices {
            write_text(out, "", &told(melnikov, self.at.is_some()))?;
        }
        if let (true, Some(thresholds)) = (listed, &self.thresholds) {
            writeln!(out)?;
            if thresholds.is_empty() {
                write_text(out, "", "No threshold in the range.")?;
            } else {
                of_crossing().write_table(out, thresholds)?;
                if let Some(reason) =
                    thresholds.iter().find_map(|threshold| threshold.tangency.as_ref().err())
                {
                    write_text(out, "", &format!("The tangency is not known: {reason}."))?;
                }
            }
        }
        if listed && !self.resonances.is_empty() {
            writeln!(out)?;
            let fields = of_resonance();
            let mut table = Table::new(fields.columns());
            self.neighbours().try_for_each(|neighbour| table.row(out, fields.cells(&neighbour)))?;
            table.finish(out)?;
            writeln!(out)?;
            write_text(out, "", &self.overlaps())?;
        }
        Ok(())
    }

    fn overlaps(&self) -> String {
        let overlaps = || self.neighbours().filter_map(|neighbour| neighbour.overlap());
        let most = overlaps().fold(0.0, f64::max);
        match overlaps().count() {
            0 => "No two resonances of one kind are adjacent.".to_owned(),
            _ if most < OVERLAP => format!(
                "Neighbouring resonances do not overlap: the sum of half-widths is {} of their distance at most.",
                short(most, 3)
            ),
            _ => format!(
                "Neighbouring resonances overlap, the sum of half-widths is up to {} of their distance: from about 2/3 on most undamped motions between them are chaotic.",
                short(most, 3)
            ),
        }
    }
}

fn told(melnikov: &Melnikov, at_threshold: bool) -> String {
    let name = separatrix(melnikov.direction);
    let mut sum = known_digits(melnikov.mean, melnikov.mean_error, 12);
    let terms = (1..).zip(&melnikov.harmonics).zip(&melnikov.harmonic_errors);
    for ((k, value), error) in terms.filter(|((_, value), error)| value.abs() > **error) {
        let phase = value.argument().to_degrees();
        let size = known_digits(phase.abs(), (error / value.abs()).to_degrees(), 8);
        let turned = match &size[..] {
            "0" => String::new(),
            size => format!(" {} {size}°", if phase < 0.0 { "-" } else { "+" }),
        };
        let multiple = if k == 1 { String::new() } else { k.to_string() };
        sum = format!("{sum} + {} cos({multiple}φ{turned})", known_digits(value.abs(), *error, 12));
    }
    let error = at_most(melnikov.error());
    let factor = melnikov.threshold_factor();
    let consequence = match melnikov.has_simple_zeros() {
        _ if melnikov.harmonics.is_empty() => {
            "nothing depends on the phase, and the manifolds do not cross".to_owned()
        }
        None if at_threshold => "it touches zero".to_owned(),
        None => "its error does not decide whether it has zeros".to_owned(),
        Some(true) if factor <= 0.0 => {
            "it has simple zeros, so that the manifolds of the upright position cross, however weak the drive is"
                .to_owned()
        }
        Some(true) => format!(
            "it has simple zeros, so that the manifolds of the upright position cross; they cross above {} of this drive",
            rounded(factor, 6)
        ),
        Some(false) => format!(
            "it has no zeros, and the manifolds do not cross; they cross above {} times this drive",
            rounded(factor, 6)
        ),
    };
    format!(
        "On the {name} separatrix M(φ) = {sum}, to {error}, with φ the phase of the drive at the bottom: {consequence}."
    )
}

/// A value to at most this many digits, without those beyond its error and without zeros at the end.
fn known_digits(value: f64, error: f64, most: usize) -> String {
    let digits = to_its_error(value, error, most);
    digits.parse().map_or(digits, |rounded| short(rounded, most))
}
