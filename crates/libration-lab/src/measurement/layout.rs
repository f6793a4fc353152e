//! Beginning of the numbers of a text, and the roles of the lines above them.

use super::MeasurementError;
use super::dialect::{Dialect, Row, SAMPLE};
use super::header::Names;
use super::heading::Heading;
use super::number::{Cell, DecimalMark};
use super::options::Header;

/// More columns than any instrument writes.
const MOST_COLUMNS: usize = 10_000;

/// Parts of a text.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Layout {
    /// One for each column.
    pub(super) headings: Vec<Heading>,
    /// The line that names the columns.
    pub(super) header_line: Option<u64>,
    /// The line of the first row of numbers.
    pub(super) first_line: u64,
    /// The lines above the header that are not numbers.
    pub(super) preamble: Vec<(u64, String)>,
    /// Names in the header beyond the last column.
    pub(super) beyond: Vec<String>,
}

impl Layout {
    pub(super) fn read(text: &str, dialect: Dialect, header: Header) -> Result<Self, MeasurementError> {
        let mut above: Vec<Row> = dialect.rows(text).take(SAMPLE).collect();
        refuse_long_cells(&above)?;
        let Extent { filled, length } = Extent::new(&above, dialect.mark)?;
        let body = match header {
            Header::Detect => first_of_numbers(&above, filled, dialect.mark),
            Header::Absent => Some(0),
            Header::Present => Some(1),
            Header::Line(line) => Some(row_at(&above, line)? + 1),
        };
        let body = body.filter(|&body| body < above.len()).ok_or(MeasurementError::Empty)?;
        let first_line = above[body].line;
        above.truncate(body);
        if header == Header::Detect {
            refuse_numbers(&above, dialect.mark)?;
        }
        // A column may be named and have no numbers.
        let named = above.iter().rev().take(3).map(Row::filled).filter(|&names| names <= length).max();
        let width = named.unwrap_or(0).max(filled).max(1);
        let names = Names::read(text, above, width, dialect, header, first_line)?;
        Ok(Self {
            headings: names.headings,
            header_line: names.line,
            first_line,
            preamble: names.preamble,
            beyond: names.beyond,
        })
    }
}

fn row_at(rows: &[Row], line: u64) -> Result<usize, MeasurementError> {
    let found = rows.iter().position(|row| row.line == line);
    found.ok_or_else(|| MeasurementError::NoSuch {
        what: "line of cells",
        asked: line.to_string(),
        available: format!(
            "{} of them, the first with number {}",
            rows.len(),
            rows.first().map_or(1, |row| row.line)
        ),
    })
}

/// Refuses very long cells: an unclosed quote makes one cell of everything after it.
fn refuse_long_cells(rows: &[Row]) -> Result<(), MeasurementError> {
    match rows.iter().find(|row| row.cells.iter().any(|cell| cell.contains('\n'))) {
        Some(row) => Err(MeasurementError::UnclosedQuote { line: row.line }),
        None => Ok(()),
    }
}

/// Width of the rows with numbers.
struct Extent {
    /// Number of cells up to the last one that is filled in any row, except for rows longer than most.
    filled: usize,
    /// Number of cells of most rows, with the empty ones at the end.
    length: usize,
}

impl Extent {
    fn new(rows: &[Row], mark: DecimalMark) -> Result<Self, MeasurementError> {
        let rows: Vec<&Row> = rows.iter().filter(|row| row.numbers(mark) > 0).collect();
        let count = |length: usize| rows.iter().filter(|row| row.cells.len() == length).count();
        let mut lengths: Vec<usize> = rows.iter().map(|row| row.cells.len()).collect();
        lengths.dedup();
        // Of several that are as frequent the first.
        let length = lengths.into_iter().rev().max_by_key(|&length| count(length)).unwrap_or(0);
        if length > MOST_COLUMNS {
            let place = "the table".to_owned();
            return Err(MeasurementError::TooMany {
                what: "columns",
                count: length,
                place,
                limit: MOST_COLUMNS,
            });
        }
        let usual = rows.iter().filter(|row| row.cells.len() <= length);
        Ok(Self { filled: usual.map(|row| row.filled()).max().unwrap_or(0), length })
    }
}

/// The first row with numbers in the columns in which most rows have them, and no other content in these.
fn first_of_numbers(rows: &[Row], width: usize, mark: DecimalMark) -> Option<usize> {
    let mut balance = vec![0_i64; width];
    for row in rows.iter().filter(|row| row.numbers(mark) > 0) {
        for (balance, cell) in balance.iter_mut().zip(row.kinds(mark)) {
            *balance += match cell {
                Cell::Number(_) => 1,
                Cell::Text => -1,
                Cell::Missing => 0,
            };
        }
    }
    rows.iter().position(|row| {
        let is_fine = |(balance, cell): (&i64, Cell)| *balance < 0 || cell != Cell::Text;
        let numbers =
            balance.iter().zip(row.kinds(mark)).filter(|(balance, cell)| **balance >= 0 && cell.is_number());
        let has_all = row.filled() <= width && row.cells.len() >= width;
        has_all && numbers.count() > 0 && balance.iter().zip(row.kinds(mark)).all(is_fine)
    })
}

/// Refuses rows of numbers above the first complete row, which would be left out silently.
fn refuse_numbers(above: &[Row], mark: DecimalMark) -> Result<(), MeasurementError> {
    let last = above.len().saturating_sub(1);
    let is_bad = |(place, row): &(usize, &Row)| {
        row.is_of_numbers(mark) || *place == last && (row.numbers(mark) > 0 || all_begin_with_digits(row))
    };
    match above.iter().enumerate().find(is_bad) {
        Some((_, row)) => Err(MeasurementError::NeitherHeaderNorNumbers { line: row.line }),
        None => Ok(()),
    }
}

fn all_begin_with_digits(row: &Row) -> bool {
    let begins = |cell: &str| {
        cell.trim_start_matches(['-', '+', '.', '−', '"', '\'']).starts_with(|c: char| c.is_ascii_digit())
    };
    row.cells.iter().filter(|cell| !cell.is_empty()).all(begins)
}
