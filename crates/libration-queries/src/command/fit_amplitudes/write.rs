//! The fit as a sheet with a table of laws, as JSON and as CSV.

use super::fields::{self, FitAmplitudesResult};
use crate::output::json;
use crate::output::table::{sheet, write_text};
use crate::output::{self, Form, number};
use crate::query_error::QueryError;
use libration_lab::fit::amplitudes::Position;
use libration_lab::fit::{Quality, Uncertain};
use std::io::{self, Write};

/// The name of the warning that precedes the result.
const REFUTED: &str = "law_refuted";

impl FitAmplitudesResult<'_> {
    pub(super) fn write(&self, out: &mut dyn Write, form: Form) -> Result<(), QueryError> {
        match form {
            Form::Json => json::document(out, fields::of_answer().record(self))?,
            Form::Csv => fields::of_law().write_csv(out, &self.fit.laws)?,
            Form::Table => self.write_sheet(out)?,
        }
        Ok(())
    }

    fn write_sheet(&self, out: &mut dyn Write) -> io::Result<()> {
        let warnings = self.warnings();
        let (refuted, others): (Vec<_>, Vec<_>) = warnings.iter().partition(|(name, _)| *name == REFUTED);
        for (_, warning) in refuted {
            write_text(out, "warning: ", warning)?;
        }
        sheet(out, &self.lines())?;
        writeln!(out)?;
        fields::of_law().write_table(out, &self.fit.laws)?;
        for (_, warning) in others {
            write_text(out, "note: ", warning)?;
        }
        Ok(())
    }

    pub(super) fn lines(&self) -> Vec<(&'static str, String)> {
        let (fit, law) = (self.fit, self.fit.law());
        let dropped = self.file.dropped;
        let incomplete =
            if dropped > 0 { format!(", {dropped} incomplete rows left out") } else { String::new() };
        let mut lines = vec![("rows", format!("{}{incomplete}", self.file.measured.table.len()))];
        if !self.file.inferences.sentences.is_empty() {
            lines.push(("read as", self.file.inferences.sentences.join("; ")));
        }
        lines.push(("weights", self.weighting().to_owned()));
        lines.push(("law", format!("{} damping{}", law.damping, output::scatter::remark(law.scatter()))));
        lines.push(("amplitude", format!("{}  (at the first row)", self.amplitude(law.first_amplitude))));
        lines.extend(
            law.zero.map(|zero| ("zero", format!("{}  (reading at the equilibrium)", self.reading(zero)))),
        );
        for coefficient in self.coefficients() {
            let (value, unit, note) = match coefficient.of.coefficient {
                Some(value) => (value, coefficient.unit, ""),
                None => (coefficient.of.rate, coefficient.rate_unit, self.of_rate()),
            };
            lines.push((coefficient.of.term.name(), said(value, &unit) + note));
        }
        lines.extend(fit.period.map(|period| ("T₀", said(period, "s") + "  (of the damped swings)")));
        lines.extend(fit.natural_frequency.map(|omega0| ("ω0", said(omega0, "rad/s"))));
        lines.push(("decay", self.decay()));
        lines.push((
            "Q",
            self.quality()
                .map_or_else(|reason| format!("not known: {reason}"), |quality| self.of_quality(quality)),
        ));
        lines.extend(fit.last_quality.map(|quality| ("Q, last row", self.of_quality(quality))));
        let decrement = fit.quality.and_then(|quality| quality.log_decrement());
        lines.extend(decrement.map(|decrement| ("decrement", said(decrement, "") + "  (π/√(Q² − 1/4))")));
        lines
    }

    /// The meaning of a coefficient, called c.
    fn of_rate(&self) -> &'static str {
        match self.against() {
            Position::Time => "  (c·ω0ⁿ⁻¹, as the period is not known)",
            Position::Swings => "  (c·ω0ⁿ⁻¹·T₀, as the period is not known)",
        }
    }

    fn decay(&self) -> String {
        let unit = match self.against() {
            Position::Time => "s",
            Position::Swings => "swings",
        };
        let at = if self.is_linear() { "at every amplitude" } else { "at the rate at the first row" };
        format!("by a factor of e in {}  ({at})", said(self.fit.decay, unit))
    }

    fn is_linear(&self) -> bool {
        self.fit.law().damping.to_string() == "linear"
    }

    fn of_quality(&self, quality: Quality) -> String {
        let at = quality.amplitude.map_or("ω0/c, at every amplitude".to_owned(), |amplitude| {
            format!("2πE/ΔE at {}", self.size(amplitude))
        });
        format!("{}  ({at})", said(quality.factor, ""))
    }

    /// An amplitude of the law, in degrees if it is an angle.
    fn amplitude(&self, of: Uncertain) -> String {
        match self.unit() {
            "rad" => said(degrees(of), "°"),
            unit => said(of, unit),
        }
    }

    /// A reading of the scale, in metres where displacements are turned into angles.
    fn reading(&self, of: Uncertain) -> String {
        if self.file.measured.is_horizontal { said(of, "m") } else { self.amplitude(of) }
    }

    fn size(&self, amplitude: f64) -> String {
        match self.unit() {
            "rad" => format!("{}°", number::short(amplitude.to_degrees(), 3)),
            unit => format!("{} {unit}", number::short(amplitude, 3)),
        }
    }
}

fn said(value: Uncertain, unit: &str) -> String {
    let unit = match unit {
        "1" => String::new(),
        unit => unit.replace("^2", "²"),
    };
    number::with_uncertainty(value.value, value.uncertainty, &unit)
}

fn degrees(of: Uncertain) -> Uncertain {
    Uncertain { value: of.value.to_degrees(), uncertainty: of.uncertainty.to_degrees() }
}
