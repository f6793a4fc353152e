//! What stands between the cells, told from the lines themselves.

use csv::{Position, ReaderBuilder, StringRecord, Trim};

use super::number::{Cell, DecimalComma};
use super::text::is_blank_or_comment;

/// Lines looked at to tell the delimiter.
const SAMPLE: usize = 50;

/// What stands between the cells of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Delimiter {
    /// A tab.
    Tab,
    /// A semicolon.
    Semicolon,
    /// A comma; decimals then have a point.
    Comma,
    /// Any run of spaces and tabs.
    Whitespace,
}

/// A row that is neither blank nor a comment, with the number of its first line.
#[derive(Clone, Debug)]
pub(super) struct Row {
    pub(super) line: u64,
    pub(super) cells: Vec<String>,
}

impl Row {
    /// The cells up to the last one that is not empty.
    pub(super) fn filled(&self) -> usize {
        self.cells.iter().rposition(|cell| !cell.is_empty()).map_or(0, |last| last + 1)
    }

    fn is_data(&self) -> bool {
        self.filled() > 0 && !self.cells[0].starts_with('#')
    }
}

impl Delimiter {
    /// The delimiter under which most sample lines are rows of at least two numbers, or failing that rows of
    /// as many cells as the first; the earlier variant when two do equally well.
    pub(super) fn sniff(text: &str) -> Self {
        let sample: Vec<&str> = text.lines().filter(|line| !is_blank_or_comment(line)).take(SAMPLE).collect();
        let sample = sample.join("\n");
        let mut best = (Self::Whitespace, (0, 0));
        for delimiter in [Self::Tab, Self::Semicolon, Self::Comma, Self::Whitespace] {
            let merit = delimiter.merit(&sample);
            if merit > best.1 {
                best = (delimiter, merit);
            }
        }
        best.0
    }

    /// The number of rows of numbers, then of rows as wide as the first; rows of one cell do not count.
    fn merit(self, sample: &str) -> (usize, usize) {
        let mut rows = self.rows(sample);
        rows.retain(|row| row.filled() >= 2);
        let of_numbers =
            |row: &&Row| row.cells.iter().all(|cell| Cell::parse(cell, self.decimal_comma()) != Cell::Text);
        let width = rows.first().map_or(0, Row::filled);
        (rows.iter().filter(of_numbers).count(), rows.iter().filter(|row| row.filled() == width).count())
    }

    /// Whether a comma in a cell can be a decimal comma.
    pub(super) fn decimal_comma(self) -> DecimalComma {
        if self == Self::Comma { DecimalComma::Refused } else { DecimalComma::Allowed }
    }

    /// The rows of the text, its blank lines and comments left out.
    pub(super) fn rows(self, text: &str) -> Vec<Row> {
        let mut rows = match self {
            Self::Tab => delimited_rows(text, b'\t'),
            Self::Semicolon => delimited_rows(text, b';'),
            Self::Comma => delimited_rows(text, b','),
            Self::Whitespace => spaced_rows(text),
        };
        rows.retain(Row::is_data);
        rows
    }
}

fn delimited_rows(text: &str, delimiter: u8) -> Vec<Row> {
    let reader = ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(Trim::All)
        .delimiter(delimiter)
        .from_reader(text.as_bytes());
    let row = |record: StringRecord| Row {
        line: record.position().map_or(0, |position| first_line(text, position)),
        cells: record.iter().map(String::from).collect(),
    };
    reader
        .into_records()
        .map(|record| row(record.expect("UTF-8 in memory with rows of any width is always read")))
        .collect()
}

/// The line of a record: its position is where the one before it ended, blank lines and comments may follow.
fn first_line(text: &str, position: &Position) -> u64 {
    let rest = usize::try_from(position.byte()).ok().and_then(|byte| text.get(byte..)).unwrap_or("");
    let (mut line, mut lines) = (position.line(), rest.lines());
    while lines.next().is_some_and(|text| text.is_empty() || text.starts_with('#')) {
        line += 1;
    }
    line
}

fn spaced_rows(text: &str) -> Vec<Row> {
    let cells = |line: &str| line.split_whitespace().map(String::from).collect();
    (1..).zip(text.lines()).map(|(line, text)| Row { line, cells: cells(text) }).collect()
}
