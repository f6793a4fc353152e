//! An entry of the catalogue of formulas.

use libration::period_formulas::PeriodFormula;

/// A formula with what is known about its error.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) formula: PeriodFormula,
    /// The amplitude (rad) up to which the formula meets the tolerance, if one was given.
    pub(super) holds_to: Option<f64>,
    /// `true` if its error curve is shown.
    pub(super) is_sheet: bool,
}
