//! Strings in a workbook: one or two bytes for each letter, and a table of shared ones that extends over several records.

use super::compound_file::{u16_at, u32_at};
use super::records::Record;

const TWO_BYTES: u8 = 1;
const HAS_ASIAN_PHONETICS: u8 = 4;
const HAS_RICH_TEXT: u8 = 8;

/// A string whose length is in one byte.
pub fn short(bytes: &[u8]) -> Option<String> {
    letters(bytes.get(2..)?, usize::from(*bytes.first()?), *bytes.get(1)?)
}

/// A string whose length is in two bytes.
pub fn long(bytes: &[u8]) -> Option<String> {
    letters(bytes.get(3..)?, usize::from(u16_at(bytes, 0)?), *bytes.get(2)?)
}

fn letters(bytes: &[u8], count: usize, flags: u8) -> Option<String> {
    let width = width(flags);
    let bytes = bytes.get(..count.checked_mul(width)?)?;
    let letters: Vec<u16> = units(bytes, width).collect();
    Some(String::from_utf16_lossy(&letters))
}

fn width(flags: u8) -> usize {
    if flags & TWO_BYTES == 0 { 1 } else { 2 }
}

fn units(bytes: &[u8], width: usize) -> impl Iterator<Item = u16> {
    bytes.chunks_exact(width).map(|unit| match unit {
        [low, high] => u16::from_le_bytes([*low, *high]),
        unit => u16::from(unit[0]),
    })
}

/// The shared strings, up to the first incomplete one.
pub fn table(record: &Record<'_>) -> Vec<String> {
    let mut reader = Reader { piece: record.data.get(8..).unwrap_or(&[]), more: record.continued.iter() };
    std::iter::from_fn(|| reader.string()).collect()
}

/// Reads on from one record to the next.
struct Reader<'a> {
    piece: &'a [u8],
    more: std::slice::Iter<'a, &'a [u8]>,
}

impl<'a> Reader<'a> {
    fn string(&mut self) -> Option<String> {
        let head = self.bytes(3)?;
        let (mut left, mut flags) = (usize::from(u16_at(&head, 0)?), head[2]);
        let runs = if flags & HAS_RICH_TEXT == 0 { 0 } else { usize::from(u16_at(&self.bytes(2)?, 0)?) };
        let phonetics = match flags & HAS_ASIAN_PHONETICS {
            0 => 0,
            _ => usize::try_from(u32_at(&self.bytes(4)?, 0)?).ok()?,
        };
        let mut letters = Vec::new();
        while left > 0 {
            if self.piece.is_empty() {
                // A string that goes on in the next record says anew how wide its letters are.
                self.turn()?;
                flags = self.bytes(1)?[0];
            }
            let width = width(flags);
            let here = left.min(self.piece.len() / width);
            if here == 0 {
                return None;
            }
            letters.extend(units(&self.piece[..here * width], width));
            self.piece = &self.piece[here * width..];
            left -= here;
        }
        self.skip(runs.checked_mul(4)?.checked_add(phonetics)?)?;
        Some(String::from_utf16_lossy(&letters))
    }

    fn turn(&mut self) -> Option<()> {
        self.piece = self.more.next().copied()?;
        Some(())
    }

    fn bytes(&mut self, count: usize) -> Option<Vec<u8>> {
        if self.piece.is_empty() {
            self.turn()?;
        }
        let bytes = self.piece.get(..count)?.to_vec();
        self.piece = &self.piece[count..];
        Some(bytes)
    }

    fn skip(&mut self, mut count: usize) -> Option<()> {
        while count > self.piece.len() {
            count -= self.piece.len();
            self.turn()?;
        }
        self.piece = &self.piece[count..];
        Some(())
    }
}
