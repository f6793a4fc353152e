//! ZIP archives: an Excel workbook, or text files side by side.

use std::borrow::Cow;

use super::super::MeasurementError;
use super::super::text::decode;
use super::part::ArchiveFile;
use super::unpacked::parts;
use super::{Format, Page, xlsx};

pub(super) fn pages(bytes: &[u8], limit: usize) -> Result<(Format, Vec<Page<'_>>), MeasurementError> {
    let parts = parts(bytes, limit)?;
    let has = |name: &str| parts.iter().any(|part| part.name == name);
    if has("xl/workbook.xml") {
        return Ok((Format::Xlsx, xlsx::pages(&parts, limit)?));
    }
    if has("content.xml") {
        return Err(MeasurementError::NotText("an OpenDocument spreadsheet"));
    }
    let pages: Vec<Page> = parts.into_iter().filter(is_table).map(page).collect::<Result<_, _>>()?;
    if pages.is_empty() {
        return Err(MeasurementError::NotText("a ZIP archive without a workbook or text file"));
    }
    Ok((Format::Zip, pages))
}

/// Text files, but not those in which phyphox describes the telephone and the clock.
fn is_table(part: &ArchiveFile) -> bool {
    let name = part.name.to_lowercase();
    let is_text = [".csv", ".txt", ".tsv", ".dat"].iter().any(|ending| name.ends_with(ending));
    is_text && !name.split('/').rev().skip(1).any(|folder| folder == "meta" || folder == "__macosx")
}

fn page(part: ArchiveFile) -> Result<Page<'static>, MeasurementError> {
    let (text, _) = decode(&part.bytes)?;
    let file = part.name.rsplit('/').next().unwrap_or_default();
    let name = file.rsplit_once('.').map_or(file, |(stem, _)| stem).to_owned();
    Ok(Page { name, text: Cow::Owned(text.into_owned()), dialect: None })
}
