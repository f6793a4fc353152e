//! A table of answers, to read or as CSV.

use super::Fields;
use crate::output::csv;
use crate::output::table::Table;
use std::io::{self, Write};

impl<A> Fields<A> {
    /// Writes the names of the fields, and a line for each answer.
    pub(crate) fn write_csv<'a>(
        &self,
        out: &mut dyn Write,
        answers: impl IntoIterator<Item = &'a A>,
    ) -> io::Result<()>
    where
        A: 'a,
    {
        csv::line(out, &self.csv_names())?;
        answers.into_iter().try_for_each(|answer| csv::line(out, &self.csv_cells(answer)))
    }

    /// Writes a table with a row for each answer.
    pub(crate) fn write_table<'a>(
        &self,
        out: &mut dyn Write,
        answers: impl IntoIterator<Item = &'a A>,
    ) -> io::Result<()>
    where
        A: 'a,
    {
        let mut table = Table::new(self.columns());
        answers.into_iter().try_for_each(|answer| table.row(out, self.cells(answer)))?;
        table.finish(out)
    }
}
