//! Where the numbers of a text begin, and what the lines above them are.

use super::dialect::{Dialect, Row, SAMPLE};
use super::heading::{Heading, bare};
use super::number::{Cell, DecimalMark};
use super::table::Header;
use super::text::COMMENT;
use super::{MeasurementError, Unit};

/// More columns than any instrument writes.
const MOST_COLUMNS: usize = 10_000;

/// Where the parts of a text are.
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
}

impl Layout {
    pub(super) fn of(text: &str, dialect: Dialect, header: Header) -> Result<Self, MeasurementError> {
        let mut above: Vec<Row> = dialect.rows(text).take(SAMPLE).collect();
        refuse_long_cells(&above)?;
        let Extent { filled, length } = Extent::of(&above, dialect.mark)?;
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
        let names = Names::of(text, above, width, dialect, header, first_line)?;
        Ok(Self { headings: names.headings, header_line: names.line, first_line, preamble: names.preamble })
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

/// A quote that is not closed makes one cell of all that follows.
fn refuse_long_cells(rows: &[Row]) -> Result<(), MeasurementError> {
    match rows.iter().find(|row| row.cells.iter().any(|cell| cell.contains('\n'))) {
        Some(row) => Err(MeasurementError::UnclosedQuote { line: row.line }),
        None => Ok(()),
    }
}

/// How wide the rows with numbers are.
struct Extent {
    /// Cells up to the last one that is filled in any of them, those longer than most aside.
    filled: usize,
    /// Cells of most of them, with the empty ones at the end.
    length: usize,
}

impl Extent {
    fn of(rows: &[Row], mark: DecimalMark) -> Result<Self, MeasurementError> {
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

/// The first row with numbers where most rows have them, and nothing else there.
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

/// Rows of numbers above the first good row would be left out in silence.
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

/// What the lines above the numbers say.
struct Names {
    headings: Vec<Heading>,
    line: Option<u64>,
    preamble: Vec<(u64, String)>,
}

impl Names {
    fn of(
        text: &str,
        mut above: Vec<Row>,
        width: usize,
        dialect: Dialect,
        header: Header,
        first_line: u64,
    ) -> Result<Self, MeasurementError> {
        let units = units_below(&mut above);
        let names = match above.pop() {
            Some(row) if header == Header::Detect && row.filled() == 1 && width > 1 => {
                above.push(row);
                None
            }
            Some(row) => Some(row),
            None => in_comment(text, width, dialect, first_line),
        };
        let short_names = units.is_some()
            && names.is_some()
            && above
                .last()
                .is_some_and(|row| Some(row.filled()) == names.as_ref().map(Row::filled) && row.filled() > 1);
        let names = if short_names { above.pop() } else { names };
        let cells = match &names {
            Some(row) => name_cells(row, width)?,
            None => vec![String::new(); width],
        };
        let groups = groups(&cells, &mut above);
        let heading = |(place, name): (usize, &String)| {
            Heading::read(
                name,
                units.as_ref().and_then(|row| row.cells.get(place)),
                groups.get(place).map(String::as_str),
            )
        };
        let headings = cells.iter().enumerate().map(heading).collect();
        let preamble =
            above.iter().map(|row| (row.line, row.cells.iter().collect::<Vec<_>>().join(" "))).collect();
        Ok(Self { headings, line: names.map(|row| row.line), preamble })
    }
}

/// A last line that holds nothing but units, with a line as long above it.
fn units_below(above: &mut Vec<Row>) -> Option<Row> {
    let [.., names, units] = &above[..] else { return None };
    let known = |cell: &str| bare(cell).parse::<Unit>().is_ok();
    let is_unit = |cell: &str| cell.is_empty() || known(cell) || cell.starts_with(['(', '[']);
    let are_units = units.cells.iter().any(known) && units.cells.iter().all(is_unit);
    if are_units && names.filled() >= units.filled() { above.pop() } else { None }
}

/// The last comment above the numbers, if it names what is known here in as many cells.
fn in_comment(text: &str, width: usize, dialect: Dialect, first_line: u64) -> Option<Row> {
    let lines = (1..first_line).zip(text.lines()).filter(|(_, line)| line.trim_start().starts_with(COMMENT));
    let (line, comment) = lines.last()?;
    let row = dialect.rows(comment.trim_start().trim_start_matches(COMMENT)).next()?;
    let row = Row { line, cells: row.cells };
    let cells = name_cells(&row, width).ok()?;
    let knows = |cell: &String| Heading::read(cell, None, None).quantity != super::Quantity::Other;
    (cells.len() == width && row.filled() == width && cells.iter().any(knows)).then_some(row)
}

/// As many names as columns; words that blanks have torn apart are joined at brackets and strokes.
fn name_cells(row: &Row, width: usize) -> Result<Vec<String>, MeasurementError> {
    let mut cells: Vec<String> = row.cells.iter().map(String::from).collect();
    if row.filled() > width {
        cells = joined(&cells);
    }
    let filled = cells.iter().rposition(|cell| !cell.is_empty()).map_or(0, |last| last + 1);
    if filled > width || cells.len() < width {
        return Err(MeasurementError::HeaderWidth { line: row.line, names: filled, columns: width });
    }
    cells.truncate(width);
    Ok(cells)
}

fn joined(cells: &[String]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for cell in cells {
        match names.last_mut() {
            Some(name) if cell.starts_with(['(', '[', '/']) || name.ends_with('/') => {
                name.push(' ');
                name.push_str(cell);
            }
            _ => names.push(cell.clone()),
        }
    }
    names
}

/// Titles over groups of columns, as Tracker writes them when it exports several tracks at once.
fn groups(names: &[String], above: &mut Vec<Row>) -> Vec<String> {
    let repeats = |name: &String| !name.is_empty() && names.iter().filter(|other| *other == name).count() > 1;
    let has_titles = above.last().is_some_and(|row| row.filled() > 1 && row.filled() <= names.len());
    if !names.iter().any(repeats) || !has_titles {
        return Vec::new();
    }
    let titles = above.pop().map(|row| row.cells).unwrap_or_default();
    let mut current = String::new();
    (0..names.len())
        .map(|place| {
            if let Some(title) = titles.get(place).filter(|title| !title.is_empty()) {
                current = title.into();
            }
            current.clone()
        })
        .collect()
}
