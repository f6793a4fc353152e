//! Excel workbooks since 2007.

use std::io::Cursor;

use calamine::{DataRef, Reader, Xlsx, XlsxError};

use super::super::MeasurementError;
use super::Page;
use super::grid::Grid;

/// The worksheets. Cells are read one by one: a reader of whole ranges would make room for what two far cells span.
pub(super) fn pages(bytes: &[u8], limit: usize) -> Result<Vec<Page<'static>>, MeasurementError> {
    let mut workbook = Xlsx::new(Cursor::new(bytes)).map_err(damaged)?;
    let mut left = limit;
    let mut pages = Vec::new();
    for name in workbook.sheet_names() {
        let mut grid = Grid::new(left);
        let mut cells = match workbook.worksheet_cells_reader(&name) {
            // A chart sheet has no cells.
            Err(XlsxError::NotAWorksheet(_)) => continue,
            cells => cells.map_err(damaged)?,
        };
        while let Some(cell) = cells.next_cell().map_err(damaged)? {
            add(&mut grid, cell.get_position(), cell.get_value())?;
        }
        let text = grid.into_text()?;
        left = left.saturating_sub(text.len());
        pages.push(Page::of_worksheet(name, text));
    }
    Ok(pages)
}

fn add(grid: &mut Grid, (row, column): (u32, u32), value: &DataRef<'_>) -> Result<(), MeasurementError> {
    match value {
        DataRef::Empty => Ok(()),
        #[expect(clippy::cast_precision_loss, reason = "the format itself holds all numbers as f64")]
        DataRef::Int(number) => grid.number(row, column, *number as f64),
        DataRef::Float(number) => grid.number(row, column, *number),
        DataRef::String(text) | DataRef::DateTimeIso(text) | DataRef::DurationIso(text) => {
            grid.text(row, column, text)
        }
        DataRef::SharedString(text) => grid.text(row, column, text),
        DataRef::Bool(state) => grid.text(row, column, if *state { "true" } else { "false" }),
        // Dates are counted in days: as plain numbers they would be taken for something else.
        DataRef::DateTime(date) => grid.text(row, column, &format!("date {}", date.as_f64())),
        DataRef::Error(error) => grid.text(row, column, &error.to_string()),
    }
}

fn damaged(error: XlsxError) -> MeasurementError {
    MeasurementError::DamagedWorkbook(error.to_string())
}
