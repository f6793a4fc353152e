//! The fit as a sheet with a table of models, as JSON and as CSV.

use super::fields::{self, FitResponseResult};
use crate::call::in_words;
use crate::output::table::{sheet, write_text};
use crate::output::{Form, json, number, scatter};
use crate::query_error::QueryError;
use libration_lab::fit::response::{AmplitudeErrors, FittedJump};
use std::io::{self, Write};

impl FitResponseResult<'_> {
    pub(super) fn write(&self, out: &mut dyn Write, form: Form) -> Result<(), QueryError> {
        match form {
            Form::Json => json::document(out, fields::of_answer().record(self))?,
            Form::Csv => fields::of_model().write_csv(out, &self.fit.fits)?,
            Form::Table => self.write_sheet(out)?,
        }
        Ok(())
    }

    fn write_sheet(&self, out: &mut dyn Write) -> io::Result<()> {
        sheet(out, &self.lines())?;
        writeln!(out)?;
        fields::of_model().write_table(out, &self.fit.fits)?;
        for reason in &self.fit.left_out {
            write_text(out, "left out: ", &reason.to_string())?;
        }
        for (_, warning) in self.warnings() {
            write_text(out, "note: ", &warning)?;
        }
        Ok(())
    }

    pub(super) fn lines(&self) -> Vec<(&'static str, String)> {
        let best = self.fit.best();
        let unit = self.file.unit;
        let dropped = self.file.dropped;
        let incomplete =
            if dropped > 0 { format!(", {dropped} incomplete rows left out") } else { String::new() };
        let mut lines = vec![("rows", format!("{}{incomplete}", self.file.measured.table.len()))];
        if !self.file.inferences.sentences.is_empty() {
            lines.push(("read as", self.file.inferences.sentences.join("; ")));
        }
        if self.file.measured.table.leads() {
            lines.push((
                "phases",
                "are leads of the response over the drive: their signs are changed".to_owned(),
            ));
        }
        let of = |quantity: libration_lab::fit::Uncertain, unit: &str| {
            number::with_uncertainty(quantity.value, quantity.uncertainty, unit)
        };
        let other = match self.file.measured.table.amplitude_errors() {
            AmplitudeErrors::Absolute => in_words("; <--errors=relative> for equal parts of the amplitudes"),
            AmplitudeErrors::Relative | AmplitudeErrors::Stated => String::new(),
        };
        lines.push(("weights", format!("{}{other}", self.weighting())));
        lines.push(("model", best.model.name().to_owned()));
        let remark = scatter::remark(best.scatter());
        lines.push(("ω0", of(best.natural_frequency, "rad/s") + &remark));
        let damping = of(best.damping, "1/s");
        lines.push(match best.damping.value > best.damping.uncertainty {
            true => ("damping c", format!("{damping}  (quality ω0/c = {})", best.quality())),
            false => ("damping c", damping),
        });
        lines.push(("drive A", of(best.drive, &format!("{unit}/s²"))));
        if let Some(cubic) = best.cubic {
            lines.push(("cubic κ", of(cubic, &format!("1/(s² {unit}²)"))));
        }
        lines.extend(self.curve.jumps.iter().map(|jump| ("jump", self.jump(jump))));
        lines
    }

    /// `rising: at 3.2931 ± 0.0012 rad/s from 2.5 m to 0.15 m`.
    fn jump(&self, jump: &FittedJump) -> String {
        let amplitude = |value: f64| match self.file.is_angle() {
            true => format!("{}°", number::rounded(value.to_degrees(), 4)),
            false => format!("{} {}", number::rounded(value, 4), self.file.unit),
        };
        let at = number::with_uncertainty(jump.frequency.value, jump.frequency.uncertainty, "rad/s");
        let way = if jump.rising { "rising" } else { "falling" };
        let to = jump.to_amplitude.map_or(String::new(), |to| format!(" to {}", amplitude(to)));
        format!("{way}: at {at} from {}{to}", amplitude(jump.amplitude))
    }
}
