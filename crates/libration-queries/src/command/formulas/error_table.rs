//! The table that the searches begin with, which Ctrl-C ends.

use crate::interrupt::{self, Cancellation};
use crate::query_error::QueryError;
use libration::period_formulas::{ErrorTable, PeriodFormula};

pub(super) fn error_table(formulas: &[PeriodFormula]) -> Result<ErrorTable, QueryError> {
    interrupt::listen()?;
    let table = ErrorTable::new(formulas, &Cancellation);
    table.map_err(|_| QueryError::cancelled("interrupted: nothing is written"))
}
