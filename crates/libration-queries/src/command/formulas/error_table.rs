//! The table that the searches begin with, which Ctrl-C ends.

use crate::interrupt;
use crate::query_error::QueryError;
use libration::period_formulas::{ErrorTable, PeriodFormula};
use libration::watch::{Progress, Watch};

pub(super) fn error_table(formulas: &[PeriodFormula]) -> Result<ErrorTable, QueryError> {
    interrupt::listen()?;
    let ask = |_: Progress| interrupt::go_on();
    let table = ErrorTable::new_watched(formulas, &Watch::new(&ask));
    table.map_err(|_| QueryError::cancelled("interrupted: nothing is written"))
}
