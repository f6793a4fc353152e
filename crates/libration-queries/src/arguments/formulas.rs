//! The formulas a question is about.

use libration::catalogue::UnknownKey;
use libration::period_formulas::{PeriodFormula, catalogue};

/// The option that chooses formulas.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct FormulaChoice {
    /// Keys of formulas (`libration formulas` lists them)
    #[arg(long, value_name = "KEY,KEY", value_delimiter = ',', value_parser = formula)]
    formulas: Vec<PeriodFormula>,
}

impl FormulaChoice {
    /// The formulas requested; empty if none was.
    pub(crate) fn chosen(&self) -> &[PeriodFormula] {
        &self.formulas
    }

    /// The formulas requested; the whole catalogue if none was requested.
    pub(crate) fn chosen_or_all(&self) -> &[PeriodFormula] {
        if self.formulas.is_empty() { catalogue() } else { &self.formulas }
    }
}

/// The formula of a key, in which `-` may stand for `_`.
pub(crate) fn formula(key: &str) -> Result<PeriodFormula, UnknownKey> {
    PeriodFormula::by_key(&key.trim().replace('-', "_"))
}
