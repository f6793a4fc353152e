//! The cells of a spreadsheet as text with tabs between them, a line for each row.

use super::super::MeasurementError;
use super::super::ambiguity::may_be_thousands;
use super::super::number::{Cell, DecimalMark, Written};
use libration::internals::InOrder;

/// Cells in any order, and the bytes their text will take.
#[derive(Clone, Debug)]
pub struct CellGrid {
    cells: Vec<(u32, u32, String)>,
    bytes: usize,
    limit: usize,
}

impl CellGrid {
    /// An empty grid, with a limit to the size of its cells.
    pub fn new(limit: usize) -> Self {
        Self { cells: Vec::new(), bytes: 0, limit }
    }

    /// Adds a number as the shortest decimal that reads back the same.
    pub fn number(&mut self, row: u32, column: u32, number: f64) -> Result<(), MeasurementError> {
        self.text(row, column, &number.to_string())
    }

    /// Adds words; tabs, line ends and quotes in them become blanks.
    pub fn text(&mut self, row: u32, column: u32, text: &str) -> Result<(), MeasurementError> {
        let text = text.replace(['\t', '\n', '\r', '"', '\0'], " ");
        self.bytes = self.bytes.saturating_add(text.len() + 1);
        self.check(self.bytes)?;
        self.cells.push((row, column, text));
        Ok(())
    }

    fn check(&self, size: usize) -> Result<(), MeasurementError> {
        if size > self.limit { Err(MeasurementError::TooLarge { size, limit: self.limit }) } else { Ok(()) }
    }

    /// The text, with points for decimal commas unless all may be marks of thousands; of a cell that was added twice the first value counts. Files
    /// omit blank cells: rows that begin with a number are extended to the length of the longest of them.
    pub fn into_text(mut self) -> Result<String, MeasurementError> {
        self.cells.put_in_order_by(|(row, column, _)| (*row, *column));
        self.cells.dedup_by_key(|(row, column, _)| (*row, *column));
        let is_open = |cell: &(u32, u32, String)| has_decimal_comma(&cell.2) && !may_be_thousands(&cell.2);
        if self.cells.iter().any(is_open) {
            for (.., text) in self.cells.iter_mut().filter(|cell| has_decimal_comma(&cell.2)) {
                *text = text.replace(',', ".");
            }
        }
        let rows = || self.cells.chunk_by(|one, next| one.0 == next.0);
        let is_of_numbers = |row: &[(u32, u32, String)]| row[0].2.parse::<f64>().is_ok();
        let ends = rows().filter(|row| is_of_numbers(row)).map(|row| row[row.len() - 1].1);
        let last = ends.max().unwrap_or(0);
        let mut text = String::new();
        let mut at_row = 0;
        for row in rows() {
            self.repeat(&mut text, '\n', row[0].0 - at_row)?;
            at_row = row[0].0;
            let mut at_column = 0;
            for (_, column, cell) in row {
                self.repeat(&mut text, '\t', *column - at_column)?;
                at_column = *column;
                text.push_str(cell);
            }
            if is_of_numbers(row) {
                self.repeat(&mut text, '\t', last - at_column)?;
            }
        }
        Ok(text)
    }

    fn repeat(&self, text: &mut String, letter: char, times: u32) -> Result<(), MeasurementError> {
        let times = usize::try_from(times).unwrap_or(usize::MAX);
        self.check(text.len().saturating_add(times))?;
        text.extend(std::iter::repeat_n(letter, times));
        Ok(())
    }
}

/// Returns `true` if a text is a number with a decimal comma, perhaps with a unit or an uncertainty.
fn has_decimal_comma(text: &str) -> bool {
    let is_number = |mark| Cell::parse(text, mark).is_number() || Written::parse(text, mark).is_some();
    text.contains(',') && is_number(DecimalMark::Comma)
}
