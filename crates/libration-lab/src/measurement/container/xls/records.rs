//! The records of a workbook: kind, length, data, and the data that continue them.

use super::compound_file::{u16_at, u32_at};

/// A record with the data of the records that continue it.
#[derive(Clone, Debug)]
pub struct Record<'a> {
    /// The number of its kind in the format.
    pub kind: u16,
    /// The data of the record.
    pub data: &'a [u8],
    /// Data of each record that continues it.
    pub continued: Vec<&'a [u8]>,
}

impl Record<'_> {
    pub(super) const BEGINNING: u16 = 0x0809;
    /// The end of a part of a workbook.
    pub const END: u16 = 0x000a;
    pub(super) const PASSWORD: u16 = 0x002f;
    pub(super) const WORKSHEET: u16 = 0x0085;
    /// The table of shared strings.
    pub const STRINGS: u16 = 0x00fc;
    pub(super) const FORMAT: u16 = 0x041e;
    pub(super) const CELL_STYLE: u16 = 0x00e0;
    pub(super) const NUMBER: u16 = 0x0203;
    pub(super) const SMALL_NUMBER: u16 = 0x027e;
    pub(super) const SMALL_NUMBERS: u16 = 0x00bd;
    pub(super) const SHARED_STRING: u16 = 0x00fd;
    pub(super) const LABEL: u16 = 0x0204;
    pub(super) const BOOLEAN_OR_ERROR: u16 = 0x0205;
    pub(super) const FORMULA: u16 = 0x0006;
    pub(super) const RESULT_STRING: u16 = 0x0207;
    const CONTINUED: u16 = 0x003c;

    /// Row and column, with which the data of every cell begin.
    pub(super) fn row_and_column(&self) -> Option<(u32, u32)> {
        Some((u32::from(self.u16(0)?), u32::from(self.u16(2)?)))
    }

    pub(super) fn u16(&self, at: usize) -> Option<u16> {
        u16_at(self.data, at)
    }

    pub(super) fn u32(&self, at: usize) -> Option<u32> {
        u32_at(self.data, at)
    }

    pub(super) fn f64(&self, at: usize) -> Option<f64> {
        Some(f64::from_le_bytes(self.data.get(at..at.checked_add(8)?)?.try_into().ok()?))
    }
}

/// The records one by one; `None` for one that is cut off, after which there are no more.
#[derive(Clone, Debug)]
pub struct Records<'a> {
    rest: &'a [u8],
}

impl<'a> Records<'a> {
    /// The records of a stream from its beginning.
    pub fn new(stream: &'a [u8]) -> Self {
        Self { rest: stream }
    }

    fn take(&mut self) -> Option<(u16, &'a [u8])> {
        let (kind, length) = (u16_at(self.rest, 0)?, usize::from(u16_at(self.rest, 2)?));
        let data = self.rest.get(4..4 + length)?;
        self.rest = &self.rest[4 + length..];
        Some((kind, data))
    }
}

impl<'a> Iterator for Records<'a> {
    type Item = Option<Record<'a>>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.rest.is_empty() {
            return None;
        }
        let Some((kind, data)) = self.take() else {
            self.rest = &[];
            return Some(None);
        };
        let mut continued = Vec::new();
        while u16_at(self.rest, 0) == Some(Record::CONTINUED) {
            match self.take() {
                Some((_, data)) => continued.push(data),
                None => break,
            }
        }
        Some(Some(Record { kind, data, continued }))
    }
}

/// A number in four bytes: a whole number or the upper half of a double, perhaps in hundredths.
pub fn small_number(bytes: u32) -> f64 {
    let number = match bytes & 2 {
        0 => f64::from_bits(u64::from(bytes & !3) << 32),
        _ => f64::from(bytes.cast_signed() >> 2),
    };
    if bytes & 1 == 0 { number } else { number / 100.0 }
}
