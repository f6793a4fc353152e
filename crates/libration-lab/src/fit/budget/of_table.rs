//! The budget of g from a table of several lengths.

use super::inputs::{GravityLaw, Inputs};
use super::{Apparatus, BudgetError, BudgetRow, Contribution, Correction, MeasuredPeriod};

/// Corrections of g from a table, and their contributions to its uncertainty.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::fit) struct TableBudget {
    /// Rows after those of the fitted line.
    pub(in crate::fit) rows: Vec<BudgetRow>,
    /// Contributions besides those of the fitted line.
    pub(in crate::fit) contributions: Vec<Contribution>,
}

/// Contributions other than those of the fitted line.
pub(in crate::fit) fn of_table(
    typical: &Apparatus,
    period: &MeasuredPeriod,
    is_bar: bool,
    law: GravityLaw<'_>,
) -> Result<TableBudget, BudgetError> {
    let inputs = Inputs::of_table(typical, period, law)?;
    Ok(TableBudget { rows: inputs.rows_of_table(is_bar), contributions: inputs.contributions() })
}

/// Computes the budget of g from a law, with fits of the table with changed values; a bar has neither bob nor string. Effects that are not
/// corrected have the sizes for a typical pendulum of the table.
pub(in crate::fit) fn input_row(
    contribution: &Contribution,
    formula: &'static str,
    note: String,
) -> BudgetRow {
    BudgetRow {
        name: contribution.input.name(),
        formula,
        correction: Correction::Input,
        uncertainty: contribution.uncertainty.map(|_| contribution.change().abs()),
        evaluation: contribution.evaluation,
        note,
    }
}
