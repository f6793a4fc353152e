//! The table that the searches begin with, which Ctrl-C ends.

use crate::failure::Failure;
use crate::interrupt;
use libration::period_formulas::{ErrorTable, PeriodFormula};
use libration::watch::{Progress, Watch};

pub(super) fn error_table(formulas: &[PeriodFormula]) -> Result<ErrorTable, Failure> {
    interrupt::listen()?;
    let ask = |_: Progress| interrupt::go_on();
    let table = ErrorTable::new_watched(formulas, &Watch::new(&ask));
    table.map_err(|_| Failure::Interrupted("interrupted: nothing is written".to_owned()))
}
