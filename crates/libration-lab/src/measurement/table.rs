//! A table of cells, and the numbers of chosen columns.

use super::dialect::{Delimiter, Dialect};
use super::options::ReadOptions;
use super::recording::Recording;
use super::sheet::Sheet;
use super::{Column, MeasurementError};

/// A rectangular table of cells, perhaps with names over its columns.
///
/// # Examples
/// ```
/// use libration_lab::measurement::{Column, ReadOptions, Table};
///
/// let table = Table::read(b"angle;period\n0,5;2,01\n1,0;\n1,5;2,31\n", &ReadOptions::default())?;
/// let chosen = table.select(&[Column::Name("Period".into())])?;
/// assert_eq!((chosen.columns[0].as_slice(), chosen.dropped), ([2.01, 2.31].as_slice(), 1));
/// # Ok::<(), libration_lab::measurement::MeasurementError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Table {
    sheet: Sheet,
    names: Vec<String>,
    /// Number of sheets in the file.
    sheets: usize,
}

/// The numbers of the chosen columns, in the rows that have them all.
#[derive(Clone, Debug, PartialEq)]
pub struct Selection {
    /// One vector for each chosen column, all of one length.
    pub columns: Vec<Vec<f64>>,
    /// The line each row came from, counted from one.
    pub lines: Vec<u64>,
    /// Number of rows that were left out because a chosen cell is empty or NaN.
    pub dropped: usize,
}

impl Table {
    /// The table in these bytes; of a workbook, the first sheet with two columns of numbers.
    ///
    /// # Errors
    /// Those of [`Recording::read`].
    pub fn read(bytes: &[u8], options: &ReadOptions) -> Result<Self, MeasurementError> {
        let recording = Recording::read(bytes, options)?;
        let (sheet, sheets) = recording.into_sheet_of_numbers();
        let named = sheet.header_line.is_some();
        let names = sheet.channels.iter().filter(|_| named).map(|it| it.heading.text.clone()).collect();
        Ok(Self { sheet, names, sheets })
    }

    pub(super) fn sheet(&self) -> &Sheet {
        &self.sheet
    }

    /// The name of the sheet that is read, of a workbook with several.
    #[must_use]
    pub fn chosen_sheet(&self) -> Option<&str> {
        (self.sheets > 1).then_some(self.sheet.name.as_str())
    }

    /// Delimiter of the cells.
    #[must_use]
    pub fn delimiter(&self) -> Delimiter {
        let Dialect { delimiter, .. } = self.sheet.dialect;
        delimiter
    }

    /// The names of the columns; empty when the table has no header.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Number of columns.
    #[must_use]
    pub fn width(&self) -> usize {
        self.sheet.channels.len()
    }

    /// The numbers in these columns, row by row; rows that lack one of them are dropped and counted.
    ///
    /// # Errors
    /// No such column, a name that several columns bear, a cell that is text, no complete row.
    pub fn select(&self, columns: &[Column]) -> Result<Selection, MeasurementError> {
        let places: Vec<usize> =
            columns.iter().map(|column| self.sheet.place(column)).collect::<Result<_, _>>()?;
        let mut selection =
            Selection { columns: vec![Vec::new(); places.len()], lines: Vec::new(), dropped: 0 };
        for row in 0..self.sheet.rows() {
            match self.numbers(row, &places)? {
                Some(numbers) => selection.push(self.sheet.lines[row], &numbers),
                None => selection.dropped += 1,
            }
        }
        if selection.lines.is_empty() {
            return Err(MeasurementError::NothingComplete(self.sheet.rows()));
        }
        Ok(selection)
    }

    /// The numbers of a row, or nothing when one of them is missing.
    fn numbers(&self, row: usize, places: &[usize]) -> Result<Option<Vec<f64>>, MeasurementError> {
        let numbers: Vec<Option<f64>> =
            places.iter().map(|&place| self.sheet.number(place, row)).collect::<Result<_, _>>()?;
        Ok(numbers.into_iter().collect())
    }
}

impl Selection {
    fn push(&mut self, line: u64, numbers: &[f64]) {
        self.lines.push(line);
        for (column, &number) in self.columns.iter_mut().zip(numbers) {
            column.push(number);
        }
    }
}
