//! The harmonics as a sheet with a table for each trace, as JSON, and as CSV of all windows.

use super::{SpectrumResult, fields};
use crate::figure::measured_spectrum::{MeasuredSpectrum, unit_scale};
use crate::output::number::short;
use crate::output::table::{sheet, write_text};
use crate::output::{Form, json};
use crate::query_error::QueryError;
use libration_lab::measurement::Observable;
use std::io::{self, Write};

impl SpectrumResult {
    pub(super) fn write(&self, out: &mut dyn Write, form: Form) -> Result<(), QueryError> {
        match form {
            Form::Json => json::document(out, fields::of_answer().record(self))?,
            Form::Csv => {
                let lines: Vec<_> = self.spectra.iter().flat_map(fields::all_lines).collect();
                fields::of_line().write_csv(out, &lines)?;
            }
            Form::Table => self.write_sheets(out)?,
        }
        Ok(())
    }

    fn write_sheets(&self, out: &mut dyn Write) -> io::Result<()> {
        for (number, measured) in self.spectra.iter().enumerate() {
            if number > 0 {
                writeln!(out)?;
            }
            sheet(out, &self.head(measured))?;
            writeln!(out)?;
            fields::of_line().write_table(out, &measured.means())?;
            for remark in &measured.spectrum.remarks {
                write_text(out, "note: ", &remark.to_string())?;
            }
        }
        self.left_out.iter().try_for_each(|reason| write_text(out, "left out: ", reason))
    }

    fn head(&self, measured: &MeasuredSpectrum) -> Vec<(&'static str, String)> {
        let spectrum = &measured.spectrum;
        let (first, last) = (&spectrum.windows[0], &spectrum.windows[spectrum.windows.len() - 1]);
        let rows: usize = spectrum.windows.iter().map(|window| window.rows).sum();
        let between = |first: f64, last: f64, unit: &str| match spectrum.windows.len() {
            1 => format!("{}{unit}", short(first, 5)),
            _ => {
                format!("{}{unit} in the first window, {}{unit} in the last", short(first, 5), short(last, 5))
            }
        };
        let (unit, scale) = unit_scale(spectrum.observable);
        let name = if measured.name.is_empty() { vec![] } else { vec![("run", measured.name.clone())] };
        let windows = if spectrum.windows.len() == 1 { "window" } else { "windows" };
        [
            vec![("file", self.file.clone())],
            name,
            vec![
                ("rows", format!("{rows} in {} {windows} of swings", spectrum.windows.len())),
                ("frequency", between(first.frequency.value, last.frequency.value, " Hz")),
                (
                    "amplitude",
                    between(first.amplitude.value.to_degrees(), last.amplitude.value.to_degrees(), "°"),
                ),
                (
                    "unit",
                    match spectrum.observable {
                        Observable::Angle => "degrees of angle, means of the windows".to_owned(),
                        Observable::AngularVelocity => {
                            format!("{unit} of angular velocity, means of the windows")
                        }
                    },
                ),
                (
                    "noise",
                    match spectrum.weighted {
                        true => format!("{} of the uncertainties of the rows", short(spectrum.noise, 3)),
                        false => format!("a row scatters by {}", short(scale * spectrum.noise, 3)),
                    },
                ),
            ],
        ]
        .concat()
    }
}
