//! Delimiter of the cells and notation of the numbers, inferred from the lines themselves.

use std::borrow::Cow;
use std::fmt;

use csv::{Position, ReaderBuilder, StringRecord, Trim};

use super::Unit;
use super::compound::CompoundNumbers;
use super::number::{Cell, DecimalMark, SIGNS, Written};
use super::text::{COMMENT, is_blank_or_comment};

/// Lines looked at to tell the dialect.
pub(super) const SAMPLE: usize = 1000;

/// Delimiter of the cells of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Delimiter {
    /// A tab.
    Tab,
    /// A semicolon.
    Semicolon,
    /// A comma; a decimal comma then needs quotes around the number.
    Comma,
    /// Any run of spaces and tabs.
    Whitespace,
}

impl Delimiter {
    /// The name in the plural, for sentences.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Tab => "tabs",
            Self::Semicolon => "semicolons",
            Self::Comma => "commas",
            Self::Whitespace => "blanks",
        }
    }
}

impl fmt::Display for Delimiter {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::Tab => "tab",
            Self::Semicolon => "semicolon",
            Self::Comma => "comma",
            Self::Whitespace => "space",
        })
    }
}

impl fmt::Display for DecimalMark {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::Point => "point",
            Self::Comma => "comma",
        })
    }
}

/// Rules by which a text is split into numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dialect {
    /// Delimiter of the cells.
    pub delimiter: Delimiter,
    /// Decimal mark of the numbers.
    pub mark: DecimalMark,
    /// `true` if cells have units or uncertainties, as `10cm` and `1.234(5)` have.
    pub units: bool,
}

/// A row that is neither blank nor a comment, with the number of its first line.
#[derive(Clone, Debug)]
pub(super) struct TextRow {
    pub(super) line: u64,
    pub(super) cells: StringRecord,
    /// The units removed from cells; empty if no cell has one.
    pub(super) units: Vec<Option<Unit>>,
    /// The uncertainties removed from cells; empty if no cell has one.
    pub(super) uncertainties: Vec<Option<f64>>,
}

impl TextRow {
    /// The cells up to the last one that is not empty.
    pub(super) fn filled(&self) -> usize {
        let from_the_end = (0..self.cells.len()).rev().find(|&index| !self.cells[index].is_empty());
        from_the_end.map_or(0, |last| last + 1)
    }

    pub(super) fn kinds(&self, mark: DecimalMark) -> impl Iterator<Item = Cell> {
        self.cells.iter().map(move |cell| Cell::parse(cell, mark))
    }

    pub(super) fn numbers(&self, mark: DecimalMark) -> usize {
        self.kinds(mark).filter(|cell| cell.is_number()).count()
    }

    /// Returns `true` if the row has a number, and no cell of text.
    pub(super) fn is_of_numbers(&self, mark: DecimalMark) -> bool {
        self.numbers(mark) > 0 && self.kinds(mark).all(|cell| cell != Cell::Text)
    }

    fn is_data(&self) -> bool {
        self.filled() > 0 && !self.cells[0].starts_with(COMMENT)
    }
}

impl Dialect {
    /// Plain numbers.
    pub(super) const fn new(delimiter: Delimiter, mark: DecimalMark) -> Self {
        Self { delimiter, mark, units: false }
    }

    /// The dialect with units in its cells, if this text has a column of which most cells have one.
    pub(super) fn with_units_of(self, text: &str) -> Self {
        let units = self.units || self.has_units(&sample(text));
        Self { units, ..self }
    }

    fn has_units(self, sample: &str) -> bool {
        let plain = Self { units: false, ..self };
        let mut balance: Vec<(i64, u32)> = vec![];
        let mut compound = ColumnsOfCompounds::default();
        for row in plain.rows(sample) {
            balance.resize(balance.len().max(row.cells.len()), (0, 0));
            let written = compound.written(&row, self.mark);
            // A length with a fraction of an inch may be the only one among plain numbers.
            if compound.has_fraction(&row, &written) {
                return true;
            }
            for ((cell, written), (more, with_unit)) in row.cells.iter().zip(written).zip(&mut balance) {
                match written {
                    Some(_) => (*more, *with_unit) = (*more + 1, *with_unit + 1),
                    None if Cell::parse(cell, self.mark).is_number() => *more -= 1,
                    None => {}
                }
            }
        }
        balance.into_iter().any(|(more, with_unit)| more >= 0 && with_unit >= 2)
    }

    /// The dialect in which most sample rows are rows of at least two numbers or, if there are none, most cells are
    /// numbers; the first of several equal ones. Given settings are kept.
    pub(super) fn sniff(text: &str, delimiter: Option<Delimiter>, mark: Option<DecimalMark>) -> Self {
        let sample = sample(text);
        let mut best = (Self::new(Delimiter::Whitespace, DecimalMark::Point), None);
        let with_units = Self::all().map(|dialect| Self { units: true, ..dialect });
        for dialect in Self::all().chain(with_units.filter(|dialect| dialect.has_units(&sample))) {
            let is_given = delimiter.is_none_or(|given| given == dialect.delimiter)
                && mark.is_none_or(|given| given == dialect.mark);
            let merit = is_given.then(|| dialect.merit(&sample));
            if merit > best.1 {
                best = (dialect, merit);
            }
        }
        best.0
    }

    /// All delimiters, in the order of preference.
    fn all() -> impl Iterator<Item = Self> {
        let delimiters = [Delimiter::Tab, Delimiter::Semicolon, Delimiter::Comma, Delimiter::Whitespace];
        let marks = [DecimalMark::Point, DecimalMark::Comma];
        delimiters.into_iter().flat_map(move |delimiter| marks.map(|mark| Self::new(delimiter, mark)))
    }

    /// The number of rows of two numbers or more, of cells with numbers, and of rows of one number. The names above the first row of numbers may
    /// contain numbers too.
    fn merit(self, sample: &str) -> (usize, usize, usize) {
        let (mut rows, mut cells, mut above, mut single) = (0, 0, 0, 0);
        for row in self.rows(sample) {
            let is_of_numbers = row.is_of_numbers(self.mark);
            rows += usize::from(is_of_numbers && row.filled() >= 2);
            single += usize::from(is_of_numbers && row.filled() == 1);
            let numbers = if row.filled() >= 2 { row.numbers(self.mark) } else { 0 };
            if rows == 0 { above += numbers } else { cells += numbers }
        }
        (rows, if rows == 0 { above } else { cells }, single)
    }
}

/// The first lines with content.
pub(super) fn sample(text: &str) -> String {
    let lines = text.lines().filter(|line| !is_blank_or_comment(line)).take(SAMPLE);
    lines.collect::<Vec<_>>().join("\n")
}

impl Dialect {
    /// The rows of the text, its blank lines and comments left out.
    pub(super) fn rows(self, text: &str) -> impl Iterator<Item = TextRow> {
        let rows: Box<dyn Iterator<Item = TextRow>> = match self.delimiter {
            Delimiter::Tab => Box::new(delimited_rows(text, b'\t')),
            Delimiter::Semicolon => Box::new(delimited_rows(text, b';')),
            Delimiter::Comma if self.mark == DecimalMark::Comma => {
                Box::new(delimited_rows(text, b',').map(with_pairs_joined))
            }
            Delimiter::Comma => Box::new(delimited_rows(text, b',')),
            Delimiter::Whitespace => Box::new(spaced_rows(text)),
        };
        let rows = rows.filter(TextRow::is_data);
        let mut compound = ColumnsOfCompounds::default();
        rows.map(move |row| if self.units { compound.without_units(row, self.mark) } else { row })
    }
}

/// Kinds of the numbers of two units in each column, by the headings above them.
#[derive(Default)]
struct ColumnsOfCompounds(Vec<CompoundNumbers>);

impl ColumnsOfCompounds {
    /// The cells of a row that are more than plain numbers; the names in a row without numbers are headings of the next rows.
    fn written<'a>(&mut self, row: &'a TextRow, mark: DecimalMark) -> Vec<Option<Written<'a>>> {
        let of_cell = |(column, cell): (usize, &'a str)| {
            let of_column = self.0.get(column).copied().unwrap_or_default();
            of_column.parse(cell, mark).or_else(|| Written::parse(cell, mark))
        };
        let written: Vec<_> = row.cells.iter().enumerate().map(of_cell).collect();
        if row.numbers(mark) == 0 && written.iter().all(Option::is_none) {
            self.0.resize(self.0.len().max(row.cells.len()), CompoundNumbers::default());
            for (kind, name) in self.0.iter_mut().zip(&row.cells).filter(|(_, name)| !name.is_empty()) {
                *kind = CompoundNumbers::below(name);
            }
        }
        written
    }

    /// Returns `true` if a row has a whole number and a fraction below the heading of a length.
    fn has_fraction(&self, row: &TextRow, written: &[Option<Written<'_>>]) -> bool {
        let cells = self.0.iter().zip(&row.cells).zip(written);
        cells.into_iter().any(|((kind, cell), written)| {
            *kind == CompoundNumbers::Lengths && written.is_some() && cell.contains('/')
        })
    }

    /// The row with plain numbers in place of those with units and uncertainties.
    fn without_units(&mut self, row: TextRow, mark: DecimalMark) -> TextRow {
        let plain = |cell| Written { number: Cow::Borrowed(cell), uncertainty: None, unit: None };
        let written = self.written(&row, mark).into_iter().zip(&row.cells);
        let cells: Vec<Written<'_>> =
            written.map(|(written, cell)| written.unwrap_or_else(|| plain(cell))).collect();
        TextRow {
            line: row.line,
            cells: cells.iter().map(|cell| cell.number.as_ref()).collect(),
            units: cells.iter().map(|cell| cell.unit).collect(),
            uncertainties: cells.iter().map(|cell| cell.uncertainty).collect(),
        }
    }
}

/// A row of whole numbers with pairs joined, where commas are decimal commas and delimiters too: `0,5,1,2` is 0.5 and 1.2.
fn with_pairs_joined(row: TextRow) -> TextRow {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let is_whole = |text: &str| digits(text.trim_start_matches(['-', '+', '−']));
    let is_fraction = |text: &str| {
        text.split_once(['e', 'E']).map_or(digits(text), |(start, power)| digits(start) && is_whole(power))
    };
    let cells: Vec<&str> = row.cells.iter().collect();
    let (pairs, rest) = cells.as_chunks::<2>();
    if !rest.is_empty() || !pairs.iter().all(|[whole, fraction]| is_whole(whole) && is_fraction(fraction)) {
        return row;
    }
    let joined = pairs.iter().map(|[whole, fraction]| format!("{whole},{fraction}")).collect();
    TextRow { line: row.line, cells: joined, ..row }
}

fn delimited_rows(text: &str, delimiter: u8) -> impl Iterator<Item = TextRow> {
    let reader = ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(Trim::All)
        .delimiter(delimiter)
        .from_reader(text.as_bytes());
    let row = |cells: StringRecord| TextRow {
        line: cells.position().map_or(0, |position| first_line(text, position)),
        cells,
        units: vec![],
        uncertainties: vec![],
    };
    reader
        .into_records()
        .map(move |record| row(record.expect("UTF-8 in memory with rows of any width is always read")))
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

/// Rows with blanks between their cells; a sign of uncertainty joins the numbers before and after it.
fn spaced_rows(text: &str) -> impl Iterator<Item = TextRow> {
    let row = |(line, text): (u64, &str)| {
        let signed =
            SIGNS.iter().fold(text.to_owned(), |text, sign| text.replace(&format!(" {sign} "), sign));
        let cells = StringRecord::from_iter(signed.split_whitespace());
        TextRow { line, cells, units: vec![], uncertainties: vec![] }
    };
    (1..).zip(text.lines()).map(row)
}
