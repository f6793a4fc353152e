//! ZIP archives: an Excel workbook, or text files side by side.

use std::borrow::Cow;
use std::io::{Cursor, Read};

use zip::ZipArchive;
use zip::result::ZipError;

use super::super::MeasurementError;
use super::super::text::decode;
use super::part::Part;
use super::{Format, Page, xlsx};

/// More files than any export has.
const MOST_FILES: usize = 1000;

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

/// All files, unpacked. Sizes are counted and not believed: what is written in the archive may be wrong.
fn parts(bytes: &[u8], limit: usize) -> Result<Vec<Part>, MeasurementError> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(damaged)?;
    if archive.len() > MOST_FILES {
        return Err(MeasurementError::DamagedArchive(format!("it has {} files", archive.len())));
    }
    let (mut parts, mut size) = (Vec::new(), 0);
    for index in 0..archive.len() {
        let file = archive.by_index(index).map_err(damaged)?;
        let name = file.name().map_err(damaged)?.into_owned();
        let mut bytes = Vec::new();
        let room = u64::try_from(limit - size).unwrap_or(u64::MAX);
        file.take(room.saturating_add(1)).read_to_end(&mut bytes).map_err(|error| damaged(error.into()))?;
        size += bytes.len();
        if size > limit {
            return Err(MeasurementError::TooLarge { size, limit });
        }
        parts.push(Part { name, bytes });
    }
    Ok(parts)
}

/// Text files, but not those in which phyphox describes the telephone and the clock.
fn is_table(part: &Part) -> bool {
    let name = part.name.to_lowercase();
    let is_text = [".csv", ".txt", ".tsv", ".dat"].iter().any(|ending| name.ends_with(ending));
    is_text && !name.split('/').rev().skip(1).any(|folder| folder == "meta" || folder == "__macosx")
}

fn page(part: Part) -> Result<Page<'static>, MeasurementError> {
    let (text, _) = decode(&part.bytes)?;
    let file = part.name.rsplit('/').next().unwrap_or_default();
    let name = file.rsplit_once('.').map_or(file, |(stem, _)| stem).to_owned();
    Ok(Page { name, text: Cow::Owned(text.into_owned()), dialect: None })
}

fn damaged(error: ZipError) -> MeasurementError {
    MeasurementError::DamagedArchive(error.to_string())
}
