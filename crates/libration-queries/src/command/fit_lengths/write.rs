//! The fit as a sheet with a table of laws, as JSON and as CSV.

use super::fields::{self, FitLengthsResult};
use crate::output::groups::{self, Groups};
use crate::output::json;
use crate::output::normal_gravity;
use crate::output::table::{sheet, write_text};
use crate::output::{self, Form, number};
use crate::query_error::QueryError;
use libration_lab::fit::Uncertain;
use std::io::{self, Write};

/// The name of the warning that is printed with gravity.
const CONTRADICTED: &str = "gravity_contradicted";

impl FitLengthsResult<'_> {
    pub(super) fn write(&self, out: &mut dyn Write, form: Form) -> Result<(), QueryError> {
        match form {
            Form::Json => {
                let record = fields::of_answer().record(self);
                let record = normal_gravity::fields().added_to(record, &self.normal);
                let record = Groups::added_to(self.groups, &groups::GRAVITY, record);
                let record = output::budget::rows_added_to(record, &self.fit.budget);
                json::document(out, output::combined::of_independent().added_to(record, &self.fit.combined))?;
            }
            Form::Csv => fields::of_law().write_csv(out, &self.fit.fits)?,
            Form::Table => self.write_sheet(out)?,
        }
        Ok(())
    }

    fn write_sheet(&self, out: &mut dyn Write) -> io::Result<()> {
        sheet(out, &self.lines())?;
        writeln!(out)?;
        fields::of_law().write_table(out, &self.fit.fits)?;
        if let Some(groups) = self.groups {
            writeln!(out)?;
            groups.write_table(out)?;
        }
        writeln!(out)?;
        output::budget::write_tables(out, &self.fit.budget, &self.fit.combined)?;
        for (_, warning) in self.warnings().iter().filter(|(name, _)| *name != CONTRADICTED) {
            write_text(out, "note: ", warning)?;
        }
        Ok(())
    }

    /// The centre of mass and the radius of gyration of a bar.
    fn of_bar(&self) -> Vec<(&'static str, String)> {
        let metres =
            |quantity: Uncertain| number::with_uncertainty(quantity.value, quantity.uncertainty, "m");
        let centre = self.fit.best().offset.map(|offset| Uncertain { value: -offset.value, ..offset });
        let text = |centre| format!("{}  (of the scale of the positions)", metres(centre));
        let centre = centre.map(|centre| ("centre of mass", text(centre)));
        let radius = self.radius_of_gyration().ok();
        let radius = radius.map(|radius| {
            ("k, gyration", format!("{}  (the period is least at this distance)", metres(radius)))
        });
        centre.into_iter().chain(radius).collect()
    }

    pub(super) fn lines(&self) -> Vec<(&'static str, String)> {
        let best = self.fit.best();
        let dropped = self.table.dropped;
        let incomplete =
            if dropped > 0 { format!(", {dropped} incomplete rows left out") } else { String::new() };
        let mut lines = vec![
            ("rows", format!("{}{incomplete}", self.table.measured.table.len())),
            ("weights", self.weighting().to_owned()),
            (
                "gravity",
                number::with_uncertainty(best.g.value, self.fit.combined.standard, "m/s²")
                    + &output::scatter::remark(best.scatter()),
            ),
            ("expanded", output::combined::expanded(&self.fit.combined)),
        ];
        lines.extend(self.normal.map(|normal| normal.line()));
        if !self.table.inferences.sentences.is_empty() {
            lines.insert(1, ("read as", self.table.inferences.sentences.join("; ")));
        }
        let contradicted = self.warnings().into_iter().filter(|(name, _)| *name == CONTRADICTED);
        lines.extend(contradicted.map(|(_, doubt)| ("warning", doubt)));
        if best.model.is_of_bars() {
            lines.extend(self.of_bar());
        } else if let Some(offset) = best.offset {
            let millimetres = [offset.value, offset.uncertainty].map(|metres| 1e3 * metres);
            let text = number::with_uncertainty(millimetres[0], millimetres[1], "mm");
            lines.push(("δ, offset", format!("{text}  (to be added to the lengths)")));
        }
        if let Some(law) = self.fit.power_law {
            let seconds = number::with_uncertainty(law.factor.value, law.factor.uncertainty, "s");
            let text = format!("{}  (T = a·Lⁿ with a = {seconds}; 1/2 of a simple pendulum)", law.exponent);
            lines.push(("exponent n", text));
        }
        if let Some(correlation) = best.correlation {
            lines.push(("correlation", format!("{} between g and δ", number::rounded(correlation, 3))));
        }
        if let Some(groups) = self.groups {
            lines.push(("g, groups", groups.line()));
        }
        if let Some(gyration) = self.fit.known_gyration {
            lines
                .push(("bob", format!("κ = I/m = {} m² is part of every law", number::rounded(gyration, 4))));
        }
        lines
    }
}
