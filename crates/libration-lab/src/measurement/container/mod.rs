//! Files that hold several tables: Excel workbooks and archives of text files, each table as a text.

mod archive;
pub(crate) mod date_formats;
mod entry_name;
pub(crate) mod grid;
mod part;
mod unpacked;
pub(crate) mod xls;
pub(crate) mod xlsx;

use super::MeasurementError;
use super::dialect::{Delimiter, Dialect};
use super::number::DecimalMark;
use super::text::{Encoding, decode};
use std::borrow::Cow;

/// Format of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Format {
    /// Text in this encoding.
    Text(Encoding),
    /// An Excel workbook of before 2007.
    Xls,
    /// An Excel workbook.
    Xlsx,
    /// An archive of text files, as phyphox exports.
    Zip,
}

/// A table as text, with its name in the file; empty for a text file.
#[derive(Clone, Debug)]
pub(super) struct Page<'a> {
    pub(super) name: String,
    pub(super) text: Cow<'a, str>,
    /// The dialect, if the text was made from the cells of a workbook.
    pub(super) dialect: Option<Dialect>,
}

impl Page<'static> {
    fn of_worksheet(name: String, text: String) -> Self {
        let dialect = Dialect::new(Delimiter::Tab, DecimalMark::Point);
        Self { name, text: text.into(), dialect: Some(dialect) }
    }
}

/// The tables of a file, whose total size is limited.
pub(super) fn pages(bytes: &[u8], limit: usize) -> Result<(Format, Vec<Page<'_>>), MeasurementError> {
    if bytes.len() > limit {
        return Err(MeasurementError::TooLarge { size: bytes.len(), limit });
    }
    match bytes {
        [0xd0, 0xcf, 0x11, 0xe0, ..] => Ok((Format::Xls, xls::pages(bytes, limit)?)),
        [b'P', b'K', 3, 4, ..] => archive::pages(bytes, limit),
        _ => {
            let (text, encoding) = decode(bytes)?;
            Ok((Format::Text(encoding), vec![Page { name: String::new(), text, dialect: None }]))
        }
    }
}
