//! The fit as a sheet with a table of laws, as JSON and as CSV.

use super::input::Measured;
use crate::failure::Failure;
use crate::output::json::{self, Record};
use crate::output::table::{Column, Table, sheet, write_text};
use crate::output::{self, Form, csv, number};
use libration::quantity::Quantity;
use libration_lab::fit::{CountedAs, LengthFit, LengthsFit, LengthsWarning};
use serde_json::Value;
use std::io::{self, Write};

/// The name of the warning that belongs beside gravity.
const CONTRADICTED: &str = "gravity_contradicted";

/// What is said about the measurements.
pub(super) struct Answer<'a> {
    pub(super) measured: &'a Measured,
    pub(super) fit: &'a LengthsFit,
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
        let best = self.fit.best();
        let offset = best.offset;
        let none = "the rows do not determine an offset";
        let record = Record::new()
            .with("rows", self.measured.table.len())
            .with("rows_incomplete", self.measured.dropped)
            .with("told_from_file", self.measured.told.clone())
            .with("weighting", self.weighting())
            .with("law", best.model.name())
            .number("gravity_m_per_s2", best.g.value)
            .number("gravity_uncertainty_m_per_s2", self.fit.combined.standard)
            .number_or("offset_m", offset.map(|offset| offset.value), none)
            .number_or("offset_uncertainty_m", offset.and_then(|offset| offset.uncertainty), none)
            .with("laws", self.fit.fits.iter().map(|fit| law_record(fit).into()).collect::<Vec<Value>>());
        let record = output::warnings::fields(record, self.warnings());
        output::combined::fields(output::scatter::fields(record, best.scatter()), &self.fit.combined)
    }

    /// The warnings with the options that help, and names that stay.
    fn warnings(&self) -> Vec<(&'static str, String)> {
        let half = self.measured.half_periods;
        let text = |warning: &LengthsWarning| match warning {
            LengthsWarning::NowhereOnEarth { counted: Some(CountedAs::WholeThoughHalf) } if !half => {
                format!("{warning} (--half-periods)")
            }
            LengthsWarning::NowhereOnEarth { counted: Some(CountedAs::HalfThoughWhole) } if half => {
                format!("{warning} (leave out --half-periods)")
            }
            LengthsWarning::Bent { radius: Some(_) } => format!("{warning} (--bob-radius)"),
            LengthsWarning::OffsetLargerThanBob => format!("{warning} (--length-unit)"),
            _ => warning.to_string(),
        };
        self.fit.warnings.iter().map(|warning| (warning.name(), text(warning))).collect()
    }

    fn weighting(&self) -> &'static str {
        match (self.measured.period_uncertainties.is_some(), self.measured.length_uncertainties.is_some()) {
            (true, true) => "uncertainties of periods and lengths",
            (true, false) => "uncertainties of periods",
            (false, _) => "none: uncertainties from the scatter",
        }
    }

    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let names = [
            "law",
            "g_m_per_s2",
            "g_uncertainty_m_per_s2",
            "offset_m",
            "offset_uncertainty_m",
            "chi2_per_dof",
            "aicc",
        ];
        csv::line(out, &names)?;
        for fit in &self.fit.fits {
            let [offset, spread] = parts(fit.offset);
            let [g, of_g] = parts(Some(fit.g));
            let rest = [fit.chi2_per_dof(), fit.aicc].map(|value| value.unwrap_or(f64::NAN));
            let values = [[g, of_g, offset, spread].as_slice(), &rest].concat();
            let numbers = values.into_iter().map(number::exact);
            csv::line(out, &[fit.model.name().to_owned()].into_iter().chain(numbers).collect::<Vec<_>>())?;
        }
        Ok(())
    }

    fn write_sheet(&self, out: &mut dyn Write) -> io::Result<()> {
        sheet(out, &self.lines())?;
        writeln!(out)?;
        let numbers = ["g / m/s²", "± / m/s²", "δ / mm", "± / mm", "χ²/dof", "AICc", "by chance"];
        let numbers = numbers.map(Column::numbers).to_vec();
        let mut table = Table::new([vec![Column::words("law")], numbers].concat());
        for fit in &self.fit.fits {
            table.row(out, cells(fit))?;
        }
        table.finish(out)?;
        writeln!(out)?;
        output::combined::write_table(out, &self.fit.combined)?;
        for (_, warning) in self.warnings().iter().filter(|(name, _)| *name != CONTRADICTED) {
            write_text(out, "note: ", warning)?;
        }
        Ok(())
    }

    fn lines(&self) -> Vec<(&'static str, String)> {
        let best = self.fit.best();
        let dropped = self.measured.dropped;
        let incomplete =
            if dropped > 0 { format!(", {dropped} incomplete ones left out") } else { String::new() };
        let mut lines = vec![
            ("rows", format!("{}{incomplete}", self.measured.table.len())),
            ("weights", self.weighting().to_owned()),
            (
                "gravity",
                number::with_uncertainty(best.g.value, self.fit.combined.standard, "m/s²")
                    + &output::scatter::remark(best.scatter()),
            ),
            ("expanded", output::combined::expanded(&self.fit.combined)),
        ];
        if !self.measured.told.is_empty() {
            lines.insert(1, ("units", self.measured.told.join("; ")));
        }
        let contradicted = self.warnings().into_iter().filter(|(name, _)| *name == CONTRADICTED);
        lines.extend(contradicted.map(|(_, doubt)| ("doubtful", doubt)));
        if let Some(offset) = best.offset {
            let millimetres = [offset.value, offset.uncertainty.unwrap_or(0.0)].map(|metres| 1e3 * metres);
            let text = number::with_uncertainty(millimetres[0], millimetres[1], "mm");
            lines.push(("δ, offset", format!("{text}  (to be added to the lengths)")));
        }
        if let Some(correlation) = best.correlation {
            lines.push(("correlation", format!("{} of g and δ", number::rounded(correlation, 3))));
        }
        if let Some(known) = self.fit.known_gyration {
            lines.push(("bob", format!("2r²/5 = {} m² is part of every law", number::rounded(known, 4))));
        }
        lines
    }
}

fn parts(quantity: Option<Quantity>) -> [f64; 2] {
    quantity.map_or([f64::NAN; 2], |found| [found.value, found.uncertainty.unwrap_or(f64::NAN)])
}

fn cells(fit: &LengthFit) -> Vec<String> {
    let [offset, spread] = parts(fit.offset).map(|metres| 1e3 * metres);
    let or_dash =
        |value: f64, digits| if value.is_nan() { "–".to_owned() } else { number::rounded(value, digits) };
    let [chi2, aicc, chance] =
        [fit.chi2_per_dof(), fit.aicc, fit.chance].map(|value| value.unwrap_or(f64::NAN));
    vec![
        fit.model.name().to_owned(),
        number::rounded(fit.g.value, 6),
        or_dash(fit.g.uncertainty.unwrap_or(f64::NAN), 2),
        or_dash(offset, 4),
        or_dash(spread, 2),
        or_dash(chi2, 4),
        or_dash(aicc, 5),
        if chance < 1e-15 { "<1e-15".to_owned() } else { or_dash(chance, 2) },
    ]
}

fn law_record(fit: &LengthFit) -> Record {
    let [g, of_g] = parts(Some(fit.g));
    let (offset, gyration) = (fit.offset, fit.gyration);
    let free = "not free in this law";
    output::scatter::fields(Record::new(), fit.scatter())
        .with("law", fit.model.name())
        .number("g_m_per_s2", g)
        .number("g_uncertainty_m_per_s2", of_g)
        .number_or("offset_m", offset.map(|found| found.value), free)
        .number_or("offset_uncertainty_m", offset.and_then(|found| found.uncertainty), free)
        .number_or("gyration_m2", gyration.map(|found| found.value), free)
        .number_or("gyration_uncertainty_m2", gyration.and_then(|found| found.uncertainty), free)
        .number_or("correlation_of_g_and_offset", fit.correlation, free)
        .number_or("chi2_per_dof", fit.chi2_per_dof(), "the table has no uncertainties of the periods")
        .with("dof", fit.dof)
        .number_or("aicc", fit.aicc, "too few rows")
        .number_or("chance_of_last_parameter", fit.chance, "nothing but g is free, or too few rows")
}
