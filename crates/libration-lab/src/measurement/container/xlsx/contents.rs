//! Data that the worksheets of a workbook have in common: their names and parts, shared strings, formats of dates.

use std::collections::BTreeMap;

use super::super::super::MeasurementError;
use super::super::date_formats::DateFormats;
use super::super::part::ArchiveFile;
use super::damaged;
use super::elements::{Onward, Piece, walk};

/// A workbook without its cells.
pub(super) struct Contents<'a> {
    /// Names and cells.
    pub(super) worksheets: Vec<(String, &'a ArchiveFile)>,
    pub(super) strings: Vec<String>,
    pub(super) formats: DateFormats,
}

impl<'a> Contents<'a> {
    pub(super) fn read(parts: &'a [ArchiveFile]) -> Result<Self, MeasurementError> {
        let strings = part(parts, "xl/sharedStrings.xml").map_or(Ok(Vec::new()), strings)?;
        let formats = part(parts, "xl/styles.xml").map_or(Ok(DateFormats::default()), formats)?;
        Ok(Self { worksheets: worksheets(parts)?, strings, formats })
    }
}

/// Programs do not agree on capitals and strokes in the names of parts.
fn part<'a>(parts: &'a [ArchiveFile], name: &str) -> Option<&'a ArchiveFile> {
    parts.iter().find(|part| part.name.replace('\\', "/").eq_ignore_ascii_case(name))
}

fn worksheets(parts: &[ArchiveFile]) -> Result<Vec<(String, &ArchiveFile)>, MeasurementError> {
    let cells = part(parts, "xl/_rels/workbook.xml.rels").map_or(Ok(BTreeMap::new()), cells_of)?;
    let book = part(parts, "xl/workbook.xml").ok_or_else(|| damaged("it has no list of its sheets"))?;
    let mut worksheets = Vec::new();
    walk(book, |piece| {
        if let Piece::Start(element) = piece
            && element.name() == "sheet"
        {
            let name = element.attribute("name")?.unwrap_or_default();
            let relation = element.attribute("id")?.unwrap_or_default();
            let target =
                cells.get(&relation).ok_or_else(|| damaged(format!("sheet `{name}` is not in it")))?;
            if let Some(target) = target {
                let part = part(parts, target).ok_or_else(|| damaged(format!("{target} is not in it")))?;
                worksheets.push((name, part));
            }
        }
        Ok(Onward::More)
    })?;
    Ok(worksheets)
}

/// The parts with the cells of a sheet, by their relation to the workbook; `None` for a sheet of another kind.
fn cells_of(relations: &ArchiveFile) -> Result<BTreeMap<String, Option<String>>, MeasurementError> {
    let mut cells = BTreeMap::new();
    walk(relations, |piece| {
        if let Piece::Start(element) = piece
            && let (Some(id), Some(kind), Some(target)) =
                (element.attribute("Id")?, element.attribute("Type")?, element.attribute("Target")?)
        {
            let path = target.strip_prefix('/').map_or_else(|| format!("xl/{target}"), str::to_owned);
            cells.insert(id, kind.ends_with("/worksheet").then_some(path));
        }
        Ok(Onward::More)
    })?;
    Ok(cells)
}

/// The strings to which cells refer, without their phonetic ones.
fn strings(part: &ArchiveFile) -> Result<Vec<String>, MeasurementError> {
    let mut strings = Vec::new();
    let mut words = TextElements::default();
    walk(part, |piece| {
        words.take(&piece);
        if matches!(&piece, Piece::End(name) if name == "si") {
            strings.push(words.finish());
        }
        Ok(Onward::More)
    })?;
    Ok(strings)
}

/// Gathers the letters of text elements, `t`.
#[derive(Default)]
pub(super) struct TextElements {
    letters: String,
    is_text: bool,
    is_phonetic: bool,
}

impl TextElements {
    pub(super) fn take(&mut self, piece: &Piece<'_>) {
        match piece {
            Piece::Start(element) => self.change(element.name(), true),
            Piece::End(name) => self.change(name, false),
            Piece::Letters(letters) if self.is_text && !self.is_phonetic => self.letters.push_str(letters),
            Piece::Letters(_) => {}
        }
    }

    fn change(&mut self, name: &str, begins: bool) {
        match name {
            "t" => self.is_text = begins,
            "rPh" => self.is_phonetic = begins,
            _ => {}
        }
    }

    /// Returns the text so far, and begins a new one.
    pub(super) fn finish(&mut self) -> String {
        unescaped(&std::mem::take(&mut self.letters))
    }
}

/// Letters that XML cannot hold are written as `_x000D_`.
pub fn unescaped(words: &str) -> String {
    let mut made = String::new();
    let mut rest = words;
    while let Some(at) = rest.find("_x") {
        let (before, escape) = rest.split_at(at);
        made.push_str(before);
        let digits = escape.get(2..6).filter(|_| escape.as_bytes().get(6) == Some(&b'_'));
        match digits.and_then(|digits| u32::from_str_radix(digits, 16).ok()).and_then(char::from_u32) {
            Some(letter) => {
                made.push(letter);
                rest = &escape[7..];
            }
            None => {
                made.push_str("_x");
                rest = &escape[2..];
            }
        }
    }
    made + rest
}

/// The formats of the styles that cells have.
fn formats(part: &ArchiveFile) -> Result<DateFormats, MeasurementError> {
    let mut formats = DateFormats::default();
    // Styles stand in other lists too.
    let mut is_of_cells = false;
    walk(part, |piece| {
        match piece {
            Piece::Start(element) => match element.name() {
                "cellXfs" => is_of_cells = true,
                "xf" if is_of_cells => formats.add_style(element.number("numFmtId")?.unwrap_or(0)),
                "numFmt" => {
                    if let (Some(number), Some(format)) =
                        (element.number("numFmtId")?, element.attribute("formatCode")?)
                    {
                        formats.add_format(number, &format);
                    }
                }
                _ => {}
            },
            Piece::End(name) if name == "cellXfs" => is_of_cells = false,
            _ => {}
        }
        Ok(Onward::More)
    })?;
    Ok(formats)
}
