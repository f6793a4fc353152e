//! One table of a recording: channels of numbers under their headings.

use super::blocks::{Blocks, Next};
use super::cell_units::{CellUnits, is_heading_of_units};
use super::dialect::{Dialect, TextRow};
use super::heading::Heading;
use super::layout::TextLayout;
use super::number::{Cell, decimals};
use super::options::ReadOptions;
use super::{Column, MeasurementError};
use libration::quantity::{excerpt, printable};

/// A column: its heading and its cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Heading of the column.
    pub heading: Heading,
    pub(super) cells: Vec<Cell>,
    /// Every cell that is neither a number nor missing, with its row.
    pub(super) words: Vec<(usize, String)>,
    /// The uncertainties contained in cells.
    pub(super) uncertainties: Vec<Option<f64>>,
    /// Largest number of decimals of its numbers.
    pub(super) decimals: u16,
}

impl Channel {
    /// A column with the group of each row.
    fn of_groups(groups: Vec<String>) -> Self {
        Self {
            heading: Heading::read("group", None, None),
            cells: vec![Cell::Text; groups.len()],
            uncertainties: vec![None; groups.len()],
            decimals: 0,
            words: groups.into_iter().enumerate().collect(),
        }
    }

    /// The numbers, `None` where the cell is empty or not a number.
    pub fn numbers(&self) -> impl Iterator<Item = Option<f64>> {
        self.cells.iter().map(|cell| match cell {
            Cell::Number(number) => Some(*number),
            _ => None,
        })
    }

    /// Number of cells that are numbers.
    #[must_use]
    pub fn count(&self) -> usize {
        self.numbers().flatten().count()
    }

    /// Number of cells that are empty, or marked as missing.
    #[must_use]
    pub fn blanks(&self) -> usize {
        self.cells.len() - self.count() - self.words.len()
    }

    /// The cells that are neither numbers nor missing, with their rows from zero.
    #[must_use]
    pub fn words(&self) -> &[(usize, String)] {
        &self.words
    }

    /// The cell as a label: a word, or a number in short form; `None` if it is missing.
    pub(super) fn label(&self, row: usize) -> Option<String> {
        match self.cells[row] {
            Cell::Number(number) => Some(number.to_string()),
            Cell::Missing => None,
            Cell::Text => {
                let at = self.words.binary_search_by_key(&row, |(row, _)| *row).ok()?;
                Some(self.words[at].1.clone())
            }
        }
    }

    /// The smallest and the largest number.
    #[must_use]
    pub fn range(&self) -> Option<(f64, f64)> {
        self.numbers().flatten().fold(None, |range, number| {
            let (low, high) = range.unwrap_or((number, number));
            Some((f64::min(low, number), f64::max(high, number)))
        })
    }

    /// Returns `true` if the column has at least two numbers and each is above the one before.
    pub(super) fn increases(&self) -> bool {
        let numbers: Vec<f64> = self.numbers().flatten().collect();
        self.words.is_empty() && numbers.len() > 1 && numbers.windows(2).all(|pair| pair[0] < pair[1])
    }
}

/// A table of a recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// The name in a workbook or an archive; empty for a text file.
    pub name: String,
    /// Delimiter of its cells and notation of its numbers.
    pub dialect: Dialect,
    /// The line of the names of the columns, if there is one.
    pub header_line: Option<u64>,
    /// The line that contains both header and first row, if there is one.
    pub divided_line: Option<u64>,
    /// The lines above the header, which are left out.
    pub preamble: Vec<(u64, String)>,
    /// Lines that were left out below the header or moved, as sentences without a full stop.
    pub remarks: Vec<String>,
    /// Names in the header that have no column below them.
    pub names_without_column: Vec<String>,
    /// The columns.
    pub channels: Vec<Channel>,
    /// The line of each row, counted from one.
    pub lines: Vec<u64>,
}

impl Sheet {
    /// The table in this text.
    pub(super) fn read(
        name: &str,
        text: &str,
        dialect: Dialect,
        options: &ReadOptions,
    ) -> Result<Self, MeasurementError> {
        let dialect = dialect.with_units_of(text);
        let layout = TextLayout::read(text, dialect, options.header)?;
        let mut blocks = Blocks::new(&layout, dialect.mark, options.header);
        let channel =
            |heading| Channel { heading, cells: vec![], words: vec![], uncertainties: vec![], decimals: 0 };
        let mut sheet = Self {
            name: printable(name),
            dialect,
            header_line: layout.header_line,
            divided_line: None,
            preamble: layout.preamble.into_iter().map(|(line, text)| (line, printable(&text))).collect(),
            remarks: vec![],
            names_without_column: layout.beyond.iter().map(|name| printable(name)).collect(),
            channels: layout.headings.into_iter().map(channel).collect(),
            lines: Vec::new(),
        };
        let mut units = CellUnits::of(sheet.channels.len());
        for row in dialect.rows(text).skip_while(|row| row.line < layout.first_line) {
            match blocks.next(sheet.rows(), row)? {
                Next::Rows(rows) => {
                    for row in rows {
                        sheet.push(&row)?;
                        units.push(&row);
                    }
                }
                Next::Nothing => {}
                Next::End => break,
            }
        }
        let below = blocks.finish(sheet.rows(), sheet.preamble.last().map(|(_, text)| text));
        sheet.remarks = below.remarks;
        let cut =
            |(line, text)| format!("line {line} (`{text}`) is left out: it is not a row like those below it");
        sheet.remarks.extend(layout.broken.map(cut));
        sheet.take_columns_of_units(&mut units);
        sheet.take_units(&units)?;
        if !below.groups.is_empty() {
            sheet.channels.push(Channel::of_groups(below.groups));
        }
        Ok(sheet)
    }

    /// The sheet of a table whose rows and columns were exchanged.
    pub(super) fn with_rows_of_columns(mut self) -> Self {
        let text = "the quantities stand in rows, which are read as columns: what is called line 2 is column 2 of the file";
        self.remarks.push(text.to_owned());
        self
    }

    /// Empties columns of units, which become those of the numbers before them, with their uncertainties and repeated readings.
    fn take_columns_of_units(&mut self, units: &mut CellUnits) {
        for index in 1..self.channels.len() {
            let [numbers, channel] = [&self.channels[index - 1], &self.channels[index]];
            let may_be =
                numbers.count() > 0 && channel.count() == 0 && is_heading_of_units(&channel.heading.text);
            if !may_be {
                continue;
            }
            let goes_on = |of: &usize| self.channels[*of].heading.goes_with(&self.channels[of - 1].heading);
            let first = (1..index).rev().find(|of| !goes_on(of)).unwrap_or(0);
            let taken: Vec<usize> =
                (first..index).filter(|of| units.take_words(*of, &channel.words)).collect();
            if !taken.is_empty() {
                let of: Vec<String> = taken.into_iter().map(|of| self.describe(of)).collect();
                self.remarks.push(format!("{} has the units of {}", self.describe(index), of.join(" and ")));
                let channel = &mut self.channels[index];
                channel.cells.fill(Cell::Missing);
                channel.words.clear();
            }
        }
    }

    /// Converts the numbers of each column whose cells have units to the unit of its header, or of its first cell.
    fn take_units(&mut self, units: &CellUnits) -> Result<(), MeasurementError> {
        for index in 0..self.channels.len() {
            let Some(first) = units.first(index) else { continue };
            let column = self.describe(index);
            let channel = &mut self.channels[index];
            let stated = channel.heading.unit;
            let unit = stated.unwrap_or(first);
            units
                .bring(index, &mut channel.cells, &mut channel.uncertainties, unit, stated.is_some())
                .map_err(|mixed| MeasurementError::MixedUnits { column, units: mixed })?;
            channel.heading.set_unit(unit);
        }
        Ok(())
    }

    /// Gives columns without a name that of the column before them, where merged cells named both: all rows have values within a factor of each other.
    pub(super) fn repeat_headings(&mut self) {
        const ALIKE: f64 = 1.1;
        for index in 1..self.channels.len() {
            let [before, channel] = [&self.channels[index - 1], &self.channels[index]];
            let pairs: Vec<_> = before
                .numbers()
                .zip(channel.numbers())
                .filter_map(|(one, other)| Some((one?, other?)))
                .collect();
            let are_alike = pairs.iter().all(|(one, other)| (1.0 / ALIKE..ALIKE).contains(&(one / other)));
            if channel.heading.text.is_empty()
                && !before.heading.text.is_empty()
                && pairs.len() > 1
                && are_alike
            {
                self.channels[index].heading = self.channels[index - 1].heading.clone();
            }
        }
    }

    fn push(&mut self, row: &TextRow) -> Result<(), MeasurementError> {
        let (width, filled) = (self.channels.len(), row.filled());
        if filled > width || row.cells.len() < width {
            let cells = if filled > width { filled } else { row.cells.len() };
            return Err(MeasurementError::Ragged { line: row.line, cells, expected: width });
        }
        let row_index = self.lines.len();
        self.lines.push(row.line);
        for (column, (channel, text)) in self.channels.iter_mut().zip(&row.cells).enumerate() {
            if text.contains('\n') {
                return Err(MeasurementError::UnclosedQuote { line: row.line });
            }
            let cell = Cell::parse(text, self.dialect.mark);
            if cell == Cell::Text {
                channel.words.push((row_index, excerpt(text)));
            }
            if cell.is_number() {
                channel.decimals = channel.decimals.max(decimals(text));
            }
            channel.cells.push(cell);
            channel.uncertainties.push(row.uncertainties.get(column).copied().flatten());
        }
        Ok(())
    }

    /// The sheet with the lines of a file whose header and first row share a line.
    pub(super) fn with_header_in_first_row(mut self, divided: u64) -> Self {
        let of_file = |line: u64| if line > divided { line - 1 } else { line };
        self.lines.iter_mut().for_each(|line| *line = of_file(*line));
        self.divided_line = Some(divided);
        self
    }

    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.lines.len()
    }

    /// The index of a column, from zero.
    ///
    /// # Errors
    /// No such column, or a name that several bear.
    pub fn index_of(&self, column: &Column) -> Result<usize, MeasurementError> {
        match column {
            Column::Number(number) if (1..=self.channels.len()).contains(number) => Ok(number - 1),
            Column::Number(number) => Err(self.no_such_column(&number.to_string())),
            Column::Name(name) => self.index_of_name(name),
        }
    }

    fn index_of_name(&self, name: &str) -> Result<usize, MeasurementError> {
        let bears = |index: &usize| self.channels[*index].heading.is_named(name);
        let mut matches = (0..self.channels.len()).filter(bears);
        match (matches.next(), matches.next()) {
            (Some(index), None) => Ok(index),
            (Some(_), Some(_)) => Err(MeasurementError::AmbiguousColumn(excerpt(name))),
            _ => Err(self.no_such_column(name)),
        }
    }

    fn no_such_column(&self, asked: &str) -> MeasurementError {
        const SHOWN: usize = 10;
        let count = self.channels.len();
        let mut available = format!("columns 1 to {count} and no header");
        if self.header_line.is_some() {
            let names = self
                .channels
                .iter()
                .take(SHOWN)
                .map(|channel| format!("`{}`", excerpt(&channel.heading.text)));
            let names: Vec<String> = names.collect();
            let more = if count > SHOWN { ", …" } else { "" };
            available = format!("columns 1 to {count}, named {}{more}", names.join(", "));
        }
        MeasurementError::NoSuchColumn { asked: excerpt(asked), available }
    }

    /// `column 2 ("Angle")`, as messages name it.
    pub(super) fn describe(&self, index: usize) -> String {
        let text = &self.channels[index].heading.text;
        if text.is_empty() {
            format!("column {}", index + 1)
        } else {
            format!("column {} (`{}`)", index + 1, excerpt(text))
        }
    }

    /// The number in a cell; `None` if it is missing.
    pub(super) fn number(&self, index: usize, row: usize) -> Result<Option<f64>, MeasurementError> {
        match self.channels[index].cells[row] {
            Cell::Number(number) => Ok(Some(number)),
            Cell::Missing => Ok(None),
            Cell::Text => Err(self.not_a_number(index, row)),
        }
    }

    /// Text of a cell that is not a number.
    pub(super) fn word(&self, index: usize, row: usize) -> Option<&str> {
        let words = &self.channels[index].words;
        words.binary_search_by_key(&row, |(row, _)| *row).ok().map(|at| words[at].1.as_str())
    }

    fn not_a_number(&self, index: usize, row: usize) -> MeasurementError {
        let (line, column) = (self.lines[row], index + 1);
        let cell = self.word(index, row).unwrap_or_default().to_owned();
        let mark = self.dialect.mark;
        let words = self.channels[index].words.iter();
        let others: Vec<u64> =
            words.filter(|(_, word)| mark.is_missed_in(word)).map(|(row, _)| self.lines[*row]).collect();
        match () {
            () if cell.starts_with('=') => MeasurementError::Formula { line, column, cell },
            () if mark.is_missed_in(&cell) => MeasurementError::MixedMarks { lines: others, cell, mark },
            () => MeasurementError::NotANumber { line, column, cell },
        }
    }
}
