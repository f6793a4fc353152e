//! The cells of a worksheet.

use super::super::super::MeasurementError;
use super::super::grid::CellGrid;
use super::super::part::ArchiveFile;
use super::contents::{Contents, TextElements};
use super::damaged;
use super::elements::{Element, Onward, Piece, walk};

/// The last cell of the largest worksheet is `XFD1048576`.
pub const MOST_ROWS: u32 = 1_048_576;
/// Its column, counted from one.
pub const MOST_COLUMNS: u32 = 16_384;

/// The cells as text.
pub(super) fn text(
    part: &ArchiveFile,
    contents: &Contents<'_>,
    limit: usize,
) -> Result<String, MeasurementError> {
    let mut cells = Cells { contents, grid: CellGrid::new(limit), next: (0, 0), cell: None };
    walk(part, |piece| cells.take(&piece))?;
    cells.grid.into_text()
}

/// Cells of a worksheet that have been read so far.
struct Cells<'a> {
    contents: &'a Contents<'a>,
    grid: CellGrid,
    /// Row and column of a cell without an address.
    next: (u32, u32),
    cell: Option<UnfinishedCell>,
}

/// A cell that has begun.
struct UnfinishedCell {
    position: (u32, u32),
    kind: String,
    style: u16,
    /// Its value as in the file, which for shared strings is a number, and `true` while it is being read.
    value: String,
    is_value: bool,
    words: TextElements,
}

impl Cells<'_> {
    fn take(&mut self, piece: &Piece<'_>) -> Result<Onward, MeasurementError> {
        match (piece, &mut self.cell) {
            (Piece::Start(element), None) if element.name() == "row" => {
                if let Some(number) = element.attribute("r")? {
                    self.next = (row(&number).ok_or_else(|| beyond(&number))?, 0);
                }
            }
            (Piece::End(name), None) if name == "row" => self.next = (self.next.0 + 1, 0),
            (Piece::Start(element), None) if element.name() == "c" => self.cell = Some(self.begun(element)?),
            (Piece::End(name), Some(_)) if name == "c" => self.end_cell()?,
            (Piece::End(name), None) if name == "sheetData" => return Ok(Onward::Enough),
            (piece, Some(cell)) => cell.take(piece),
            _ => {}
        }
        Ok(Onward::More)
    }

    fn begun(&self, element: &Element<'_>) -> Result<UnfinishedCell, MeasurementError> {
        let address = match element.attribute("r")? {
            Some(address) => position_of(&address).ok_or_else(|| beyond(&address))?,
            None => self.next,
        };
        Ok(UnfinishedCell {
            position: address,
            kind: element.attribute("t")?.unwrap_or_default(),
            style: element.number("s")?.unwrap_or(0),
            value: String::new(),
            is_value: false,
            words: TextElements::default(),
        })
    }

    fn end_cell(&mut self) -> Result<(), MeasurementError> {
        let Some(UnfinishedCell { position: (row, column), kind, style, value, mut words, .. }) =
            self.cell.take()
        else {
            return Ok(());
        };
        self.next = (row, column + 1);
        let value = value.trim();
        match kind.as_str() {
            "inlineStr" => self.grid.text(row, column, &words.finish()),
            _ if value.is_empty() => Ok(()),
            "s" => {
                let string = value.parse().ok().and_then(|index: usize| self.contents.strings.get(index));
                self.grid.text(
                    row,
                    column,
                    string.ok_or_else(|| damaged(format!("string {value} is not in it")))?,
                )
            }
            "b" => self.grid.text(row, column, if value == "1" { "true" } else { "false" }),
            "" | "n" => match value.parse::<f64>() {
                // Dates are counted in days: as plain numbers they would be taken for something else.
                Ok(number) if self.contents.formats.is_date(style) => {
                    self.grid.text(row, column, &format!("date {number}"))
                }
                Ok(number) => self.grid.number(row, column, number),
                Err(_) => self.grid.text(row, column, value),
            },
            _ => self.grid.text(row, column, value),
        }
    }
}

impl UnfinishedCell {
    fn take(&mut self, piece: &Piece<'_>) {
        match piece {
            Piece::Start(element) if element.name() == "v" => self.is_value = true,
            Piece::End(name) if name == "v" => self.is_value = false,
            Piece::Letters(letters) if self.is_value => self.value.push_str(letters),
            piece => self.words.take(piece),
        }
    }
}

/// Row and column of an address such as `B7`, from zero, if a worksheet can have them.
pub fn position_of(address: &str) -> Option<(u32, u32)> {
    let (letters, number) = address.split_at(address.find(|letter: char| letter.is_ascii_digit())?);
    let column = letters.bytes().try_fold(0_u32, |sum, letter| {
        let digit =
            letter.is_ascii_alphabetic().then(|| u32::from(letter.to_ascii_uppercase() - b'A') + 1)?;
        Some(26 * sum + digit).filter(|&column| column <= MOST_COLUMNS)
    })?;
    Some((row(number)?, column.checked_sub(1)?))
}

/// The row of this number, from zero.
fn row(number: &str) -> Option<u32> {
    number.parse().ok().filter(|number| (1..=MOST_ROWS).contains(number)).map(|number: u32| number - 1)
}

fn beyond(address: &str) -> MeasurementError {
    let address = libration::quantity::excerpt(address);
    damaged(format!("`{address}` in it is beyond what a worksheet can hold"))
}
