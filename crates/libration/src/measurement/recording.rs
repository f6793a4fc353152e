//! A file of measurements: what it is, its sheets, and what was told from it.

use super::choices::{Choices, Finding};
use super::dialect::Dialect;
use super::sheet::Sheet;
use super::table::Options;
use super::text::{Encoding, decode};
use super::{Choice, Column, MeasurementError};

/// What kind of file it is.
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

/// A file of measurements, read and not yet interpreted.
///
/// # Examples
/// ```
/// use libration::measurement::{Choices, Options, Recording};
///
/// let file = "Time (s);Angle (deg)\n0,00;30,0\n0,05;29,1\n0,10;26,4\n";
/// let recording = Recording::read(file.as_bytes(), &Options::default())?;
/// let traces = recording.traces(&Choices::default())?;
/// assert_eq!(traces.traces[0].times(), [0.0, 0.05, 0.1]);
/// # Ok::<(), libration::measurement::MeasurementError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    format: Format,
    sheets: Vec<Sheet>,
}

impl Recording {
    /// The recording in these bytes.
    ///
    /// # Errors
    /// Too many bytes, not a known kind of file, no rows, rows of different lengths, a dialect that the file does not decide.
    pub fn read(bytes: &[u8], options: &Options) -> Result<Self, MeasurementError> {
        if bytes.len() > options.size_limit {
            return Err(MeasurementError::TooLarge { size: bytes.len(), limit: options.size_limit });
        }
        let (text, encoding) = decode(bytes)?;
        let dialect = Dialect::sniff(&text, options.delimiter, options.decimal);
        let sheet = Sheet::read("", &text, dialect, options)?;
        Ok(Self { format: Format::Text(encoding), sheets: vec![sheet] })
    }

    /// What kind of file it is.
    #[must_use]
    pub fn format(&self) -> Format {
        self.format
    }

    /// Its tables; a text file has one.
    #[must_use]
    pub fn sheets(&self) -> &[Sheet] {
        &self.sheets
    }

    pub(super) fn into_first_sheet(mut self) -> Sheet {
        self.sheets.swap_remove(0)
    }

    /// What was told from the file in reading it.
    #[must_use]
    pub fn findings(&self) -> Vec<Finding> {
        self.sheets.iter().flat_map(Sheet::findings).collect()
    }

    /// The sheet that is chosen, or the only one.
    pub(super) fn sheet(&self, choices: &Choices) -> Result<&Sheet, MeasurementError> {
        match &choices.sheet {
            None => Ok(&self.sheets[0]),
            Some(asked) => self.sheet_named(asked),
        }
    }

    fn sheet_named(&self, asked: &Column) -> Result<&Sheet, MeasurementError> {
        let (found, text) = match asked {
            Column::Number(number) => (self.sheets.get(number.wrapping_sub(1)), number.to_string()),
            Column::Name(name) => {
                let named = |sheet: &&Sheet| sheet.name.to_lowercase() == name.trim().to_lowercase();
                (self.sheets.iter().find(named), name.clone())
            }
        };
        let names: Vec<String> = self.sheets.iter().map(|sheet| format!("`{}`", sheet.name)).collect();
        found.ok_or_else(|| MeasurementError::NoSuch {
            what: "sheet",
            asked: text,
            available: names.join(", "),
        })
    }
}

impl Sheet {
    fn findings(&self) -> Vec<Finding> {
        let Dialect { delimiter, mark } = self.dialect;
        let mut findings = vec![
            Finding::new(format!("cells are separated by {delimiter}"), Choice::Delimiter),
            Finding::new(format!("numbers have a decimal {mark}"), Choice::Decimal),
        ];
        let header = match self.header_line {
            Some(line) => format!("line {line} names the columns"),
            None => "there is no header".to_owned(),
        };
        findings.push(Finding::new(header, Choice::Header));
        if let Some((line, text)) = self.preamble.first() {
            let more = self.preamble.len() - 1;
            let more = if more > 0 { format!(" and {more} more lines") } else { String::new() };
            let text = crate::quantity::excerpt(text);
            findings.push(Finding::new(
                format!("line {line} (`{text}`){more} above the header are left out"),
                Choice::Header,
            ));
        }
        findings
    }
}
