//! `libration formulas`: the catalogue, the formulas within a tolerance, and crossovers.

mod catalogue;
mod crossovers;
mod entry;
mod error_table;
mod formula_sheet;

use crate::arguments::{self, FormulaChoice};
use crate::output::FormOptions;
use crate::output::description::Answers;
use crate::query_error::{QueryError, option};
use entry::Entry;
use libration::period_formulas::PeriodFormula;
use libration::quantity::Angle;
use std::io::Write;

/// The catalogue of formulas for the period: their errors, ranges of validity and crossovers
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration formulas
  libration formulas molina                               # its sheet
  libration formulas --tolerance 1e-3                     # range of each
  libration formulas --amplitude 90deg --tolerance 1e-3   # simplest first
  libration formulas --crossovers --formulas denman,black_vel_3,butikov")
)]
pub(crate) struct Formulas {
    /// Keys of formulas whose sheets are shown: formula, derivation, source, error curve
    #[arg(value_name = "KEY", value_parser = arguments::formula, conflicts_with_all = ["amplitude", "tolerance", "crossovers", "formulas"])]
    keys: Vec<PeriodFormula>,
    /// List only formulas within the tolerance at this amplitude and all smaller ones
    #[arg(long, requires = "tolerance", value_parser = arguments::angle)]
    amplitude: Option<Angle>,
    /// Largest acceptable fractional error of the period, such as 1e-3 or 0.1%
    #[arg(long, value_parser = arguments::fractional_error)]
    tolerance: Option<f64>,
    /// List the amplitudes at which one formula becomes better than another
    #[arg(long, conflicts_with_all = ["amplitude", "tolerance"])]
    crossovers: bool,
    #[command(flatten)]
    formulas: FormulaChoice,
    #[command(flatten)]
    form: FormOptions,
}

impl Formulas {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        if !self.keys.is_empty() {
            let sheets: Vec<_> =
                self.keys.iter().map(|key| Entry { is_sheet: true, ..entry(key, None) }).collect();
            return Ok(catalogue::write(out, self.form.form(), &sheets)?);
        }
        let formulas = self.formulas.chosen_or_all();
        if self.crossovers {
            return crossovers::write(out, self.form.form(), formulas);
        }
        let entries = match self.tolerance {
            None => formulas.iter().map(|formula| entry(formula, None)).collect(),
            Some(tolerance) => self.sufficient(formulas, tolerance)?,
        };
        Ok(catalogue::write(out, self.form.form(), &entries)?)
    }

    /// The formulas that meet the tolerance, each with the amplitude up to which it does.
    fn sufficient(&self, formulas: &[PeriodFormula], tolerance: f64) -> Result<Vec<Entry>, QueryError> {
        let table = error_table::error_table(formulas)?;
        let row = |key: &str| table.formulas().position(|formula| formula.key() == key);
        let holds_to = |key: &str| row(key).map(|index| table.holds_to(index, tolerance));
        let chosen: Vec<&PeriodFormula> = match &self.amplitude {
            Some(amplitude) => table.simplest(&arguments::one_amplitude(amplitude)?.angle(), tolerance),
            None => formulas.iter().collect(),
        };
        if chosen.is_empty() {
            let reason = format!(
                "no formula is within the tolerance {tolerance:?} there: give a larger tolerance, or use the exact period"
            );
            return Err(QueryError::no_result(option("amplitude"), reason));
        }
        Ok(chosen.into_iter().map(|formula| entry(formula, holds_to(formula.key()))).collect())
    }
}

fn entry(formula: &PeriodFormula, holds_to: Option<f64>) -> Entry {
    Entry { formula: formula.clone(), holds_to, is_sheet: false }
}

pub(crate) fn answers() -> Vec<Answers> {
    vec![catalogue::answers(), crossovers::answers()]
}
