//! Excel workbooks of before 2007 (BIFF8), as older versions of phyphox write them: their numbers and words.
//!
//! # References
//! Microsoft Open Specifications MS-CFB (the compound file) and MS-XLS (the records in it).

mod compound_file;
pub(crate) mod records;
pub(crate) mod strings;

use super::super::MeasurementError;
use super::Page;
use super::date_formats::DateFormats;
use super::grid::CellGrid;
use records::{Record, Records};

/// A worksheet: where its records begin, and its name.
struct Worksheet {
    start: usize,
    name: String,
}

/// Data that the worksheets have in common.
#[derive(Default)]
struct Workbook {
    worksheets: Vec<Worksheet>,
    strings: Vec<String>,
    formats: DateFormats,
}

/// The worksheets as text.
pub(super) fn pages(bytes: &[u8], limit: usize) -> Result<Vec<Page<'static>>, MeasurementError> {
    let stream = compound_file::stream(bytes, "Workbook")
        .ok_or_else(|| damaged("it contains no workbook in a known format"))?;
    let workbook = Workbook::read(&stream)?;
    let mut left = limit;
    let mut pages = Vec::new();
    for worksheet in &workbook.worksheets {
        let text = workbook.text(&stream, worksheet.start, left)?;
        left = left.saturating_sub(text.len());
        pages.push(Page::of_worksheet(worksheet.name.clone(), text));
    }
    Ok(pages)
}

impl Workbook {
    fn read(stream: &[u8]) -> Result<Self, MeasurementError> {
        let mut workbook = Self::default();
        for record in Records::new(stream) {
            let record = record.ok_or_else(cut_off)?;
            match record.kind {
                Record::BEGINNING if record.u16(0) != Some(0x0600) => {
                    return Err(damaged("it is of a version before Excel 97"));
                }
                Record::PASSWORD => return Err(damaged("it is protected by a password")),
                Record::WORKSHEET => workbook.worksheets.extend(worksheet(&record)),
                Record::STRINGS => workbook.strings = strings::table(&record),
                Record::FORMAT => workbook.add_format(&record),
                Record::CELL_STYLE => workbook.formats.add_style(record.u16(2).unwrap_or(0)),
                Record::END => break,
                _ => {}
            }
        }
        Ok(workbook)
    }

    fn add_format(&mut self, record: &Record<'_>) {
        let text = record.data.get(2..).and_then(strings::long);
        if let (Some(number), Some(text)) = (record.u16(0), text) {
            self.formats.add_format(number, &text);
        }
    }

    /// The cells of the worksheet whose records begin here.
    fn text(&self, stream: &[u8], start: usize, limit: usize) -> Result<String, MeasurementError> {
        let mut grid = CellGrid::new(limit);
        let (mut depth, mut result_of) = (0_usize, None);
        for record in Records::new(stream.get(start..).ok_or_else(cut_off)?) {
            let record = record.ok_or_else(cut_off)?;
            match record.kind {
                Record::BEGINNING => depth += 1,
                Record::END if depth <= 1 => return grid.into_text(),
                Record::END => depth -= 1,
                // Charts in a worksheet have records of their own.
                _ if depth == 1 => result_of = self.cell(&record, result_of, &mut grid)?,
                _ => {}
            }
        }
        Err(cut_off())
    }

    /// Adds the cell of a record; returns the position of a formula whose text follows in the next record.
    fn cell(
        &self,
        record: &Record<'_>,
        result_of: Option<(u32, u32)>,
        grid: &mut CellGrid,
    ) -> Result<Option<(u32, u32)>, MeasurementError> {
        match record.kind {
            Record::NUMBER | Record::SMALL_NUMBER | Record::SMALL_NUMBERS => self.numbers(record, grid)?,
            Record::SHARED_STRING | Record::LABEL | Record::BOOLEAN_OR_ERROR => {
                let (row, column) = record.row_and_column().ok_or_else(cell_cut_off)?;
                grid.text(row, column, &self.words(record).ok_or_else(cell_cut_off)?)?;
            }
            Record::FORMULA => return self.result(record, grid),
            Record::RESULT_STRING => {
                if let Some((row, column)) = result_of {
                    grid.text(row, column, &strings::long(record.data).ok_or_else(cell_cut_off)?)?;
                }
            }
            _ => return Ok(result_of),
        }
        Ok(None)
    }

    /// One number, or several side by side.
    fn numbers(&self, record: &Record<'_>, grid: &mut CellGrid) -> Result<(), MeasurementError> {
        let (row, first) = record.row_and_column().ok_or_else(cell_cut_off)?;
        if record.kind == Record::NUMBER {
            return self.number(grid, row, first, record.u16(4), record.f64(6).ok_or_else(cell_cut_off)?);
        }
        let last =
            if record.kind == Record::SMALL_NUMBERS { record.data.len().saturating_sub(2) } else { 10 };
        for (column, at) in (first..).zip((4..last).step_by(6)) {
            let number = record.u32(at + 2).map(records::small_number).ok_or_else(cell_cut_off)?;
            self.number(grid, row, column, record.u16(at), number)?;
        }
        Ok(())
    }

    fn words(&self, record: &Record<'_>) -> Option<String> {
        match record.kind {
            Record::SHARED_STRING => self.strings.get(usize::try_from(record.u32(6)?).ok()?).cloned(),
            Record::LABEL => strings::long(record.data.get(6..)?),
            _ => Some(truth(record.data.get(6..8)?).to_owned()),
        }
    }

    /// The number that a formula gave when the file was saved, or the position of its text.
    fn result(
        &self,
        record: &Record<'_>,
        grid: &mut CellGrid,
    ) -> Result<Option<(u32, u32)>, MeasurementError> {
        let (row, column) = record.row_and_column().ok_or_else(cell_cut_off)?;
        match record.data.get(6..14).ok_or_else(cell_cut_off)? {
            [0, .., 0xff, 0xff] => return Ok(Some((row, column))),
            [_, .., 0xff, 0xff] => grid.text(row, column, "error")?,
            _ => self.number(grid, row, column, record.u16(4), record.f64(6).ok_or_else(cell_cut_off)?)?,
        }
        Ok(None)
    }

    /// A number, or a text for a date, which as a plain number of days would be misread.
    fn number(
        &self,
        grid: &mut CellGrid,
        row: u32,
        column: u32,
        style: Option<u16>,
        number: f64,
    ) -> Result<(), MeasurementError> {
        if style.is_some_and(|style| self.formats.is_date(style)) {
            return grid.text(row, column, &format!("date {number}"));
        }
        grid.number(row, column, number)
    }
}

fn worksheet(record: &Record<'_>) -> Option<Worksheet> {
    const OF_CELLS: u8 = 0;
    let start = usize::try_from(record.u32(0)?).ok()?;
    let is_worksheet = record.data.get(5) == Some(&OF_CELLS);
    let name = strings::short(record.data.get(6..)?)?;
    is_worksheet.then_some(Worksheet { start, name })
}

fn truth(bytes: &[u8]) -> &'static str {
    match bytes {
        [0, 0] => "false",
        [1, 0] => "true",
        _ => "error",
    }
}

fn cell_cut_off() -> MeasurementError {
    damaged("a cell of it is cut off")
}

fn damaged(why: &str) -> MeasurementError {
    MeasurementError::DamagedWorkbook(why.to_owned())
}

fn cut_off() -> MeasurementError {
    damaged("it is cut off")
}
