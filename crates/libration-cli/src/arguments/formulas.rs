//! The formulas a question is about.

use libration::period_formulas::{self, PeriodFormula};

/// The option that chooses formulas.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct FormulaChoice {
    /// Formulas by their keys (see `libration formulas`)
    #[arg(long, value_name = "KEY,KEY", value_delimiter = ',', value_parser = period_formulas::by_key)]
    formulas: Vec<PeriodFormula>,
}

impl FormulaChoice {
    /// The formulas asked for; none if none was.
    pub(crate) fn chosen(&self) -> &[PeriodFormula] {
        &self.formulas
    }

    /// The formulas asked for; the whole catalogue if none was.
    pub(crate) fn chosen_or_all(&self) -> Vec<PeriodFormula> {
        if self.formulas.is_empty() { period_formulas::catalogue() } else { self.formulas.clone() }
    }
}
