//! Beginning of the numbers of a text, and the roles of the lines above them.

use super::MeasurementError;
use super::dialect::{Dialect, SAMPLE, TextRow};
use super::header::{self, Names};
use super::heading::Heading;
use super::number::{Cell, DecimalMark};
use super::options::Header;
use libration::quantity::excerpt;

/// More columns than any instrument writes.
const MOST_COLUMNS: usize = 10_000;

/// Fewest rows of a recording, whose first line may have been cut: a shorter table was typed.
const RECORDED: usize = 50;

/// Parts of a text.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TextLayout {
    /// One for each column.
    pub(super) headings: Vec<Heading>,
    /// The line that names the columns.
    pub(super) header_line: Option<u64>,
    /// The line of the first row of numbers.
    pub(super) first_line: u64,
    /// The first line, if it is not a row like those of a long recording below it, as at the start of a serial connection.
    pub(super) broken: Option<(u64, String)>,
    /// The lines above the header that are not numbers.
    pub(super) preamble: Vec<(u64, String)>,
    /// Names in the header beyond the last column.
    pub(super) beyond: Vec<String>,
    /// `true` for columns of numbers.
    pub(super) are_numbers: Vec<bool>,
}

impl TextLayout {
    pub(super) fn read(text: &str, dialect: Dialect, header: Header) -> Result<Self, MeasurementError> {
        let mut above: Vec<TextRow> = dialect.rows(text).take(SAMPLE).collect();
        refuse_long_cells(&above)?;
        let Extent { filled, length } = Extent::new(&above, dialect.mark)?;
        let balance = balance(&above, filled, dialect.mark);
        let body = match header {
            Header::Detect => first_of_numbers(&above, &balance, dialect.mark),
            Header::Absent => Some(0),
            Header::Present => Some(1),
            Header::Line(line) => Some(row_at(&above, line)? + 1),
        };
        let body = body.filter(|&body| body < above.len()).ok_or(MeasurementError::Empty)?;
        let (first_line, below) = (above[body].line, above.len() - body);
        above.truncate(body);
        let mut broken = None;
        if header == Header::Detect {
            let checked = refuse_numbers(&above, dialect.mark, |row| is_header(row, &above, text, filled));
            match (checked, &above[..]) {
                (Err(MeasurementError::NeitherHeaderNorNumbers { line }), [only]) if below >= RECORDED => {
                    broken = Some((line, excerpt(&only.cells.iter().collect::<Vec<_>>().join(" "))));
                    above.clear();
                }
                (checked, _) => checked?,
            }
        }
        // A column may be named and have no numbers.
        let named = above.iter().rev().take(3).map(TextRow::filled).filter(|&names| names <= length).max();
        let width = named.unwrap_or(0).max(filled).max(1);
        let names = Names::read(text, above, width, dialect, header, first_line)?;
        Ok(Self {
            headings: names.headings,
            header_line: names.line,
            first_line,
            broken,
            preamble: names.preamble,
            beyond: names.beyond,
            are_numbers: balance.into_iter().map(|excess| excess > 0).collect(),
        })
    }
}

fn row_at(rows: &[TextRow], line: u64) -> Result<usize, MeasurementError> {
    let index = rows.iter().position(|row| row.line == line);
    index.ok_or_else(|| MeasurementError::NoSuch {
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
fn refuse_long_cells(rows: &[TextRow]) -> Result<(), MeasurementError> {
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
    fn new(rows: &[TextRow], mark: DecimalMark) -> Result<Self, MeasurementError> {
        let rows: Vec<&TextRow> = rows.iter().filter(|row| row.numbers(mark) > 0).collect();
        let count = |length: usize| rows.iter().filter(|row| row.cells.len() == length).count();
        let mut lengths: Vec<usize> = rows.iter().map(|row| row.cells.len()).collect();
        lengths.dedup();
        // Of several that are as frequent the first.
        let length = lengths.into_iter().rev().max_by_key(|&length| count(length)).unwrap_or(0);
        if length > MOST_COLUMNS {
            let location = "the table".to_owned();
            return Err(MeasurementError::TooMany {
                what: "columns",
                count: length,
                location,
                limit: MOST_COLUMNS,
            });
        }
        let usual = rows.iter().filter(|row| row.cells.len() <= length);
        Ok(Self { filled: usual.map(|row| row.filled()).max().unwrap_or(0), length })
    }
}

/// Number of rows with a number in each column less that of rows with text.
fn balance(rows: &[TextRow], width: usize, mark: DecimalMark) -> Vec<i64> {
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
    balance
}

/// The first row with numbers where most rows have them, and nothing else there.
fn first_of_numbers(rows: &[TextRow], balance: &[i64], mark: DecimalMark) -> Option<usize> {
    rows.iter().position(|row| {
        let is_fine = |(balance, cell): (&i64, Cell)| *balance < 0 || cell != Cell::Text;
        let numbers =
            balance.iter().zip(row.kinds(mark)).filter(|(balance, cell)| **balance >= 0 && cell.is_number());
        let has_all = row.filled() <= balance.len() && row.cells.len() >= balance.len();
        has_all && numbers.count() > 0 && balance.iter().zip(row.kinds(mark)).all(is_fine)
    })
}

/// Refuses rows of numbers above the first complete row, which would be left out silently.
fn refuse_numbers(
    above: &[TextRow],
    mark: DecimalMark,
    is_header: impl Fn(&TextRow) -> bool,
) -> Result<(), MeasurementError> {
    let last = above.len().saturating_sub(1);
    let is_bad = |(index, row): &(usize, &TextRow)| {
        let has_numbers = || row.numbers(mark) > 0 || all_begin_with_digits(row);
        row.is_of_numbers(mark) || *index == last && has_numbers() && !is_header(row)
    };
    match above.iter().enumerate().find(is_bad) {
        Some((_, row)) => match row.cells.iter().find(|cell| mark.is_missed_in(cell)) {
            Some(cell) => {
                Err(MeasurementError::MixedMarks { lines: vec![row.line], cell: excerpt(cell), mark })
            }
            None => Err(MeasurementError::NeitherHeaderNorNumbers { line: row.line }),
        },
        None => Ok(()),
    }
}

/// Returns `true` if a row with numbers names columns: `L (m),1,2,3`, `,1. Messung,2. Messung` below the names of the other columns, and
/// `L (cm)   10 T (s)` with wide blanks between names; alone `10 T (s)`.
fn is_header(row: &TextRow, above: &[TextRow], text: &str, width: usize) -> bool {
    let cells = || row.cells.iter().filter(|cell| !cell.is_empty());
    let numbers: Vec<f64> = cells().filter_map(|cell| cell.parse().ok()).collect();
    let are_counted =
        numbers.iter().zip(1_i32..).all(|(number, ordinal)| number.total_cmp(&ordinal.into()).is_eq());
    let is_numbered = numbers.len() > 1 && are_counted && numbers.len() < cells().count();
    let is_ordinal = |cell: &str| {
        let rest = cell.trim_start_matches(|letter: char| letter.is_ascii_digit());
        rest.len() < cell.len()
            && rest.trim_start_matches(['.', '°', 'º', 'ª']).trim().chars().all(char::is_alphabetic)
    };
    let above = above.iter().rev().find(|other| other.line < row.line);
    let is_over = |above: &TextRow| {
        (0..row.cells.len()).any(|index| {
            row.cells[index].is_empty() && above.cells.get(index).is_some_and(|cell| !cell.is_empty())
        })
    };
    let is_below = above.is_some_and(is_over) && cells().all(is_ordinal);
    let names = header::between_wide_blanks(row, text).unwrap_or_default();
    let are_names = match &names[..] {
        [name] => width == 1 && is_counted_name(name),
        _ => width > 1 && names.len() == width && names.len() < row.cells.len(),
    };
    is_numbered || is_below || are_names
}

/// A name with a unit that begins with a count: `10 T (s)`, `10T/s`, but neither `15 s`, `1.50 (2)` nor `15.02 s (Ada)`.
fn is_counted_name(name: &str) -> bool {
    let spaced = name.replace('/', " / ");
    let (units, words): (Vec<&str>, Vec<&str>) =
        spaced.split_whitespace().partition(|word| word.starts_with(['(', '[', '/']));
    let has_letter = |word: &str| word.contains(char::is_alphabetic);
    let has_unit = units.into_iter().any(|unit| unit == "/" || has_letter(unit));
    has_unit && words.iter().any(|word| has_letter(word)) && !words[0].contains(['.', ','])
}

fn all_begin_with_digits(row: &TextRow) -> bool {
    let begins = |cell: &str| {
        cell.trim_start_matches(['-', '+', '.', '−', '"', '\'']).starts_with(|c: char| c.is_ascii_digit())
    };
    row.cells.iter().filter(|cell| !cell.is_empty()).all(begins)
}
