//! A table of cells, and the numbers of chosen columns.

use std::convert::Infallible;
use std::str::FromStr;

use super::MeasurementError;
use super::dialect::{Delimiter, Row};
use super::number::{Cell, DecimalComma};
use super::text::decode;
use crate::quantity::excerpt;

/// Whether the first row names the columns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Header {
    /// It does when not one of its cells is a number.
    #[default]
    Detect,
    /// It does.
    Present,
    /// It does not.
    Absent,
}

/// How a file is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// What stands between cells; told from the file when not given.
    pub delimiter: Option<Delimiter>,
    /// Whether the first row names the columns.
    pub header: Header,
    /// The most bytes that are read.
    pub size_limit: usize,
}

impl Options {
    /// 64 MiB: a million rows of a period table.
    pub const DEFAULT_SIZE_LIMIT: usize = 64 << 20;
}

impl Default for Options {
    fn default() -> Self {
        Self { delimiter: None, header: Header::Detect, size_limit: Self::DEFAULT_SIZE_LIMIT }
    }
}

/// A column, by its number counted from one or by its name without regard to case.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Column {
    /// Counted from one.
    Number(usize),
    /// As in the header.
    Name(String),
}

/// A whole number is a number, anything else a name.
impl FromStr for Column {
    type Err = Infallible;
    fn from_str(text: &str) -> Result<Self, Infallible> {
        let text = text.trim();
        Ok(text.parse().map_or_else(|_| Self::Name(text.into()), Self::Number))
    }
}

/// A rectangular table of cells, perhaps with names over its columns.
///
/// # Examples
/// ```
/// use libration::measurement::{Column, Options, Table};
///
/// let table = Table::read(b"angle;period\n0,5;2,01\n1,0;\n1,5;2,31\n", &Options::default())?;
/// let chosen = table.select(&[Column::Name("Period".into())])?;
/// assert_eq!((chosen.columns[0].as_slice(), chosen.dropped), ([2.01, 2.31].as_slice(), 1));
/// # Ok::<(), libration::measurement::MeasurementError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Table {
    delimiter: Delimiter,
    names: Vec<String>,
    rows: Vec<Row>,
    width: usize,
}

/// The numbers of the chosen columns, in the rows that have them all.
#[derive(Clone, Debug, PartialEq)]
pub struct Selection {
    /// One vector for each chosen column, all of one length.
    pub columns: Vec<Vec<f64>>,
    /// The line each row came from, counted from one.
    pub lines: Vec<u64>,
    /// How many rows were left out because a chosen cell is empty or NaN.
    pub dropped: usize,
}

impl Table {
    /// The table in these bytes.
    ///
    /// # Errors
    /// Too many bytes, not UTF-8 text, no rows, rows of different lengths.
    pub fn read(bytes: &[u8], options: &Options) -> Result<Self, MeasurementError> {
        if bytes.len() > options.size_limit {
            return Err(MeasurementError::TooLarge { size: bytes.len(), limit: options.size_limit });
        }
        let text = decode(bytes)?;
        let delimiter = options.delimiter.unwrap_or_else(|| Delimiter::sniff(&text));
        let mut rows = delimiter.rows(&text);
        let width = common_width(&rows)?;
        let names = match rows.first() {
            Some(first) if is_header(first, options.header, delimiter.decimal_comma()) => {
                rows.remove(0).cells
            }
            _ => Vec::new(),
        };
        if rows.is_empty() {
            return Err(MeasurementError::Empty);
        }
        Ok(Self { delimiter, names, rows, width })
    }

    /// What stands between the cells.
    #[must_use]
    pub fn delimiter(&self) -> Delimiter {
        self.delimiter
    }

    /// The names of the columns; empty when the table has no header.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// How many columns there are.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// The numbers in these columns, row by row; rows that lack one of them are dropped and counted.
    ///
    /// # Errors
    /// No such column, a name that several columns bear, a cell that is text, no complete row.
    pub fn select(&self, columns: &[Column]) -> Result<Selection, MeasurementError> {
        let places: Vec<usize> = columns.iter().map(|column| self.place(column)).collect::<Result<_, _>>()?;
        let mut selection =
            Selection { columns: vec![Vec::new(); places.len()], lines: Vec::new(), dropped: 0 };
        for row in &self.rows {
            match self.numbers(row, &places)? {
                Some(numbers) => selection.push(row.line, &numbers),
                None => selection.dropped += 1,
            }
        }
        if selection.lines.is_empty() {
            return Err(MeasurementError::NothingComplete(self.rows.len()));
        }
        Ok(selection)
    }

    fn place(&self, column: &Column) -> Result<usize, MeasurementError> {
        match column {
            Column::Number(number) if (1..=self.width).contains(number) => Ok(number - 1),
            Column::Number(number) => Err(self.no_such_column(&number.to_string())),
            Column::Name(name) => self.place_of_name(name),
        }
    }

    fn place_of_name(&self, name: &str) -> Result<usize, MeasurementError> {
        let same = |other: &String| other.trim().to_lowercase() == name.trim().to_lowercase();
        let mut places = (0..self.names.len()).filter(|&place| same(&self.names[place]));
        match (places.next(), places.next()) {
            (Some(place), None) if place < self.width => Ok(place),
            (Some(_), Some(_)) => Err(MeasurementError::AmbiguousColumn(excerpt(name))),
            _ => Err(self.no_such_column(name)),
        }
    }

    fn no_such_column(&self, asked: &str) -> MeasurementError {
        let available = if self.names.is_empty() {
            format!("columns 1 to {} and no header", self.width)
        } else {
            format!("columns 1 to {}, named {}", self.width, excerpt_of_names(&self.names))
        };
        MeasurementError::NoSuchColumn { asked: excerpt(asked), available }
    }

    /// The numbers of a row, or nothing when one of them is missing.
    fn numbers(&self, row: &Row, places: &[usize]) -> Result<Option<Vec<f64>>, MeasurementError> {
        let mut numbers = Vec::with_capacity(places.len());
        let mut complete = true;
        for &place in places {
            let cell = &row.cells[place];
            match Cell::parse(cell, self.delimiter.decimal_comma()) {
                Cell::Number(number) => numbers.push(number),
                Cell::Missing => complete = false,
                Cell::Text => {
                    let cell = excerpt(cell);
                    return Err(MeasurementError::NotANumber { line: row.line, column: place + 1, cell });
                }
            }
        }
        Ok(complete.then_some(numbers))
    }
}

impl Selection {
    fn push(&mut self, line: u64, numbers: &[f64]) {
        self.lines.push(line);
        for (column, &number) in self.columns.iter_mut().zip(numbers) {
            column.push(number);
        }
    }
}

fn excerpt_of_names(names: &[String]) -> String {
    const SHOWN: usize = 10;
    let shown: Vec<String> = names.iter().take(SHOWN).map(|name| format!("`{}`", excerpt(name))).collect();
    shown.join(", ") + if names.len() > SHOWN { ", …" } else { "" }
}

fn is_header(row: &Row, header: Header, comma: DecimalComma) -> bool {
    let is_number = |cell: &String| matches!(Cell::parse(cell, comma), Cell::Number(_));
    match header {
        Header::Present => true,
        Header::Absent => false,
        Header::Detect => !row.cells.iter().any(is_number),
    }
}

/// The width of the table: empty cells may follow the last column, in some rows or in all.
fn common_width(rows: &[Row]) -> Result<usize, MeasurementError> {
    let first = rows.first().ok_or(MeasurementError::Empty)?.cells.len();
    let width = rows.iter().map(Row::filled).filter(|&filled| filled <= first).max().unwrap_or(first);
    match rows.iter().find(|row| row.cells.len() < width || row.filled() > width) {
        Some(row) if row.filled() > width => {
            Err(MeasurementError::Ragged { line: row.line, found: row.filled(), expected: width })
        }
        Some(row) => {
            Err(MeasurementError::Ragged { line: row.line, found: row.cells.len(), expected: width })
        }
        None => Ok(width),
    }
}
