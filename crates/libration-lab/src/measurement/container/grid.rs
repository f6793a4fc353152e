//! The cells of a spreadsheet as text with tabs between them, a line for each row.

use super::super::MeasurementError;

/// Cells in any order, and the bytes their text will take.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    cells: Vec<(u32, u32, String)>,
    bytes: usize,
    limit: usize,
}

impl Grid {
    /// No cells yet, and a limit to what they may take.
    pub(super) fn new(limit: usize) -> Self {
        Self { cells: Vec::new(), bytes: 0, limit }
    }

    /// Adds a number as the shortest decimal that reads back the same.
    pub(super) fn number(&mut self, row: u32, column: u32, number: f64) -> Result<(), MeasurementError> {
        self.text(row, column, &number.to_string())
    }

    /// Adds words; tabs, line ends and quotes in them become blanks.
    pub(super) fn text(&mut self, row: u32, column: u32, text: &str) -> Result<(), MeasurementError> {
        let text = text.replace(['\t', '\n', '\r', '"', '\0'], " ");
        self.bytes = self.bytes.saturating_add(text.len() + 1);
        self.check(self.bytes)?;
        self.cells.push((row, column, text));
        Ok(())
    }

    fn check(&self, size: usize) -> Result<(), MeasurementError> {
        if size > self.limit { Err(MeasurementError::TooLarge { size, limit: self.limit }) } else { Ok(()) }
    }

    /// The text; a cell that was added twice is what it was first.
    pub(super) fn into_text(mut self) -> Result<String, MeasurementError> {
        self.cells.sort_by_key(|(row, column, _)| (*row, *column));
        self.cells.dedup_by_key(|(row, column, _)| (*row, *column));
        let mut text = String::new();
        let (mut at_row, mut at_column) = (0, 0);
        for (row, column, cell) in &self.cells {
            if *row > at_row {
                self.repeat(&mut text, '\n', *row - at_row)?;
                (at_row, at_column) = (*row, 0);
            }
            self.repeat(&mut text, '\t', *column - at_column)?;
            at_column = *column;
            text.push_str(cell);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_keep_their_places_and_far_ones_are_refused() {
        let mut grid = Grid::new(1000);
        grid.number(2, 1, -0.25).unwrap();
        grid.text(0, 0, "a\tb").unwrap();
        assert_eq!(grid.into_text().unwrap(), "a b\n\n\t-0.25");
        let mut far = Grid::new(1000);
        far.number(0, 2000, 1.0).unwrap();
        assert!(far.into_text().is_err());
        assert!(Grid::new(5).text(0, 0, "abcdef").is_err());
    }
}
