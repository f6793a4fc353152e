//! Excel workbooks since 2007: their numbers and strings.
//!
//! An own reader, because those for whole workbooks bring the letters of every old code page with them, and make room for sizes that a file
//! announces: here nothing is kept but what was read.
//!
//! # References
//! ECMA-376, *Office Open XML file formats*, part 1, 18: the workbook, its styles, shared strings and cells.

pub(crate) mod contents;
mod elements;
pub(crate) mod worksheet;

use super::super::MeasurementError;
use super::Page;
use super::part::ArchiveFile;
use contents::Contents;

/// The worksheets as text; sheets of charts have no cells.
pub(super) fn pages(parts: &[ArchiveFile], limit: usize) -> Result<Vec<Page<'static>>, MeasurementError> {
    let contents = Contents::read(parts)?;
    let mut left = limit;
    let mut pages = Vec::new();
    for (name, part) in &contents.worksheets {
        let text = worksheet::text(part, &contents, left)?;
        left = left.saturating_sub(text.len());
        pages.push(Page::of_worksheet(name.clone(), text));
    }
    Ok(pages)
}

fn damaged(why: impl Into<String>) -> MeasurementError {
    MeasurementError::DamagedWorkbook(why.into())
}
