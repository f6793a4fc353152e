//! A file of measurements: its kind, its sheets, and the settings inferred from it.

use super::ambiguity;
use super::choices::{Choices, Finding, Suggestion};
use super::container::{self, Format, Page};
use super::dialect::{Delimiter, Dialect};
use super::glued;
use super::line_ends;
use super::markup;
use super::number::DecimalMark;
use super::options::{Header, ReadOptions};
use super::sheet::Sheet;
use super::transposed;
use super::{Choice, Column, MeasurementError};
use libration::quantity::excerpt;
use std::borrow::Cow;

/// A file of measurements, read and not yet interpreted.
///
/// # Examples
/// ```
/// use libration_lab::measurement::{Choices, ReadOptions, Recording};
///
/// let file = "Time (s);Angle (deg)\n0,00;30,0\n0,05;29,1\n0,10;26,4\n";
/// let recording = Recording::read(file.as_bytes(), &ReadOptions::default())?;
/// let traces = recording.traces(&Choices::default())?;
/// assert_eq!(traces.traces[0].times(), [0.0, 0.05, 0.1]);
/// # Ok::<(), libration_lab::measurement::MeasurementError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    format: Format,
    sheets: Vec<Sheet>,
    /// Tables without columns of numbers, with the reasons.
    left_out: Vec<(String, MeasurementError)>,
}

impl Recording {
    /// The recording in these bytes.
    ///
    /// # Errors
    /// Too many bytes, not a known kind of file, no rows, rows of different lengths, a dialect that the file does not decide.
    pub fn read(bytes: &[u8], options: &ReadOptions) -> Result<Self, MeasurementError> {
        let (format, pages) = container::pages(bytes, options.size_limit)?;
        let mut recording = Self { format, sheets: Vec::new(), left_out: Vec::new() };
        for page in pages {
            match read_page(&page, options) {
                Ok(sheet) => recording.sheets.push(sheet),
                Err(error) => recording.left_out.push((page.name, error)),
            }
        }
        match recording.left_out.first() {
            Some((_, error)) if recording.sheets.is_empty() => Err(error.clone()),
            None if recording.sheets.is_empty() => Err(MeasurementError::Empty),
            _ => Ok(recording),
        }
    }

    /// Format of the file.
    #[must_use]
    pub fn format(&self) -> Format {
        self.format
    }

    /// The tables of the file; a text file has one.
    #[must_use]
    pub fn sheets(&self) -> &[Sheet] {
        &self.sheets
    }

    /// The chosen sheet, else the first one with two columns of numbers, else the first one; and the number of sheets.
    pub(super) fn into_sheet(mut self, asked: Option<&Column>) -> Result<(Sheet, usize), MeasurementError> {
        let count = self.sheets.len();
        if let Some(asked) = asked {
            return Ok((self.sheet_named(asked)?.clone(), count));
        }
        let of_numbers =
            |sheet: &Sheet| sheet.channels.iter().filter(|channel| channel.count() > 1).count() > 1;
        let index = self.sheets.iter().position(of_numbers).unwrap_or(0);
        Ok((self.sheets.swap_remove(index), count))
    }

    /// Inferences made in reading the file.
    #[must_use]
    pub fn findings(&self) -> Vec<Finding> {
        let of_text = matches!(self.format, Format::Text(_) | Format::Zip);
        let left_out = self.left_out.iter();
        let left_out = left_out.map(|(name, why)| Finding::fact(format!("`{name}` is left out: {why}")));
        left_out.chain(self.sheets.iter().flat_map(|sheet| sheet.findings(of_text))).collect()
    }

    /// Result from the chosen sheet, or from the only one that gives a result.
    pub(super) fn in_one_sheet<T>(
        &self,
        choices: &Choices,
        give: impl Fn(&Sheet) -> Result<T, MeasurementError>,
    ) -> Result<T, MeasurementError> {
        match (&choices.sheet, &self.sheets[..]) {
            (Some(asked), _) => give(self.sheet_named(asked)?),
            (None, [only]) => give(only),
            (None, sheets) => {
                let (mut given, mut reason) = (Vec::new(), None);
                for sheet in sheets {
                    match give(sheet) {
                        Ok(one) => given.push((&sheet.name, one)),
                        Err(error) => reason = reason.or(Some((&sheet.name, error))),
                    }
                }
                match (given.len(), reason) {
                    (1, _) => Ok(given.swap_remove(0).1),
                    (0, Some((name, error))) => {
                        Err(MeasurementError::OfSheet { name: name.clone(), error: error.into() })
                    }
                    _ => Err(several_sheets(given.into_iter().map(|(name, _)| name))),
                }
            }
        }
    }

    fn sheet_named(&self, asked: &Column) -> Result<&Sheet, MeasurementError> {
        let (chosen, text) = match asked {
            Column::Number(number) => (self.sheets.get(number.wrapping_sub(1)), number.to_string()),
            Column::Name(name) => {
                let named = |sheet: &&Sheet| sheet.name.to_lowercase() == name.trim().to_lowercase();
                (self.sheets.iter().find(named), name.clone())
            }
        };
        let names: Vec<String> = self.sheets.iter().map(|sheet| format!("`{}`", sheet.name)).collect();
        chosen.ok_or_else(|| MeasurementError::NoSuch {
            what: "sheet",
            asked: text,
            available: names.join(", "),
        })
    }
}

fn several_sheets<'a>(names: impl Iterator<Item = &'a String>) -> MeasurementError {
    let question = "several sheets have the requested columns".to_owned();
    MeasurementError::Undecided {
        question,
        choices: names.map(|name| Suggestion::new(Choice::Sheet, name)).collect(),
    }
}

fn read_page(page: &Page<'_>, options: &ReadOptions) -> Result<Sheet, MeasurementError> {
    if let Some(dialect) = page.dialect {
        let text = ambiguity::of_cells(&page.text, options)?;
        return transposed_sheet(page, &text, dialect, options)
            .unwrap_or_else(|| Sheet::read(&page.name, &text, dialect, options));
    }
    let text =
        if options.delimiter.is_some() { Cow::Borrowed(&*page.text) } else { markup::plain(&page.text) };
    let text = line_ends::within_cells_removed(&text);
    let dialect = Dialect::sniff(&text, options.delimiter, options.decimal);
    if let Some(sheet) = transposed_sheet(page, &text, dialect, options) {
        return sheet;
    }
    if let Some((text, line)) = glued::divided(&text, dialect).filter(|_| options.header == Header::Detect) {
        let sheet = Sheet::read(&page.name, &text, dialect, options)?;
        return Ok(sheet.with_header_in_first_row(line));
    }
    let sheet = Sheet::read(&page.name, &text, dialect, options);
    let has_half_of_names = || match &sheet {
        Err(MeasurementError::HeaderWidth { names, columns, .. }) => *columns == 2 * *names,
        _ => ambiguity::are_decimals_below_one_name(&text),
    };
    if dialect.delimiter == Delimiter::Comma && options.decimal.is_none() && has_half_of_names() {
        // Half as many names as numbers: the commas are decimal ones too.
        let commas = Dialect { mark: DecimalMark::Comma, ..dialect };
        return Sheet::read(&page.name, &text, commas, options).or(sheet);
    }
    let sheet = sheet?;
    ambiguity::refuse(&text, &sheet, options)?;
    Ok(sheet)
}

/// The sheet of a text whose quantities stand in rows.
fn transposed_sheet(
    page: &Page<'_>,
    text: &str,
    dialect: Dialect,
    options: &ReadOptions,
) -> Option<Result<Sheet, MeasurementError>> {
    let exchanged = (options.header == Header::Detect).then(|| transposed::exchanged(text, dialect));
    let (text, dialect) = exchanged.flatten()?;
    let sheet = Sheet::read(&page.name, &text, dialect, options);
    Some(sheet.map(Sheet::with_rows_of_columns))
}

/// The finding that a line is the header and the first row.
pub(super) fn divided(line: u64) -> String {
    format!("line {line} is read as the header and the first row, without a line end between them")
}

impl Sheet {
    /// Inferences made in reading the sheet; a workbook has no dialect to report.
    fn findings(&self, of_text: bool) -> Vec<Finding> {
        let Dialect { delimiter, mark, .. } = self.dialect;
        let of = if self.name.is_empty() { String::new() } else { format!("`{}`: ", self.name) };
        let mut findings = Vec::new();
        if of_text {
            let text = format!("{of}cells are separated by {}", delimiter.name());
            findings.push(Finding::new(text, Choice::Delimiter));
            findings.push(Finding::new(format!("{of}numbers have a decimal {mark}"), Choice::Decimal));
        }
        let header = match self.header_line {
            Some(line) => format!("{of}line {line} names the columns"),
            None => format!("{of}there is no header"),
        };
        findings.push(Finding::new(header, Choice::Header));
        if let Some(line) = self.divided_line {
            findings.push(Finding::new(format!("{of}{}", divided(line)), Choice::Header));
        }
        findings
            .extend(self.remarks.iter().map(|remark| Finding::new(format!("{of}{remark}"), Choice::Header)));
        if let Some(first) = self.names_without_column.first() {
            let (columns, names) =
                (self.channels.len(), self.channels.len() + self.names_without_column.len());
            let text = format!(
                "{of}the header has {names} names and the rows have {columns} cells: `{}` and what follows it have no column",
                excerpt(first)
            );
            findings.push(Finding::new(text, Choice::Header));
        }
        if let Some((line, text)) = self.preamble.first() {
            let (more, verb) = match self.preamble.len() - 1 {
                0 => (String::new(), "is"),
                1 => (" and another line".to_owned(), "are"),
                more => (format!(" and {more} more lines"), "are"),
            };
            let text =
                format!("{of}line {line} (`{}`){more} above the header {verb} left out", excerpt(text));
            findings.push(Finding::new(text, Choice::Header));
        }
        findings
    }
}
