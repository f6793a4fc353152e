//! A table of results, to read or as CSV.

use super::Fields;
use crate::output::csv;
use crate::output::table::Table;
use std::io::{self, Write};

impl<A> Fields<A> {
    /// Writes the names of the fields, and a line for each result.
    pub(crate) fn write_csv<'a>(
        &self,
        out: &mut dyn Write,
        answers: impl IntoIterator<Item = &'a A>,
    ) -> io::Result<()>
    where
        A: 'a,
    {
        csv::line(out, &self.csv_names())?;
        for answer in answers {
            csv::line(out, &self.csv_cells(answer))?;
        }
        Ok(())
    }

    /// Writes a table with a row for each result.
    pub(crate) fn write_table<'a>(
        &self,
        out: &mut dyn Write,
        answers: impl IntoIterator<Item = &'a A>,
    ) -> io::Result<()>
    where
        A: 'a,
    {
        let mut table = Table::new(self.columns());
        for answer in answers {
            table.row(out, self.cells(answer))?;
        }
        table.finish(out)
    }
}
