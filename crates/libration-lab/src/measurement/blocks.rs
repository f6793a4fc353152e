//! Rows of text below the header of a table: notes below the last row, and further tables with the same header.

use super::MeasurementError;
use super::choices::{Choice, Suggestion};
use super::dialect::TextRow;
use super::layout::TextLayout;
use super::number::{Cell, DecimalMark};
use super::options::Header;
use libration::quantity::{excerpt, printable};

/// Tables below one another, separated by rows of text.
pub(super) struct Blocks {
    mark: DecimalMark,
    header: Header,
    are_numbers: Vec<bool>,
    header_line: Option<u64>,
    /// The names of the columns without blanks.
    names: String,
    /// Rows of text after the last row of numbers.
    open: Vec<TextRow>,
    /// First row of each further table, and its title.
    begun: Vec<(usize, Option<String>)>,
    left_out: Vec<(u64, String)>,
    /// The header of another table, which is left out.
    other: Option<TextRow>,
}

/// Rows that follow in a sheet.
pub(super) enum Next {
    Rows(Vec<TextRow>),
    Nothing,
    End,
}

/// Remarks and groups of the rows below the header.
pub(super) struct Below {
    /// Lines that were left out, and tables below one another, as sentences without a full stop.
    pub(super) remarks: Vec<String>,
    /// The title of the table of each row, where there are several tables.
    pub(super) groups: Vec<String>,
}

impl Blocks {
    pub(super) fn new(layout: &TextLayout, mark: DecimalMark, header: Header) -> Self {
        Self {
            mark,
            header,
            are_numbers: layout.are_numbers.clone(),
            header_line: layout.header_line,
            names: layout.headings.iter().map(|heading| joined(&heading.text)).collect(),
            open: vec![],
            begun: vec![],
            left_out: vec![],
            other: None,
        }
    }

    /// Takes the next row of the text, after this number of rows of the sheet. Rows of text wait for the rows below them.
    pub(super) fn next(&mut self, rows: usize, row: TextRow) -> Result<Next, MeasurementError> {
        if self.is_text(&row) {
            self.open.push(row);
            return Ok(Next::Nothing);
        }
        let Some(names) = self.open.pop() else { return Ok(Next::Rows(vec![row])) };
        // Blanks may have separated the words of a name.
        if self.header_line.is_some() && joined(&text_of(&names)) == self.names {
            let title = self.open.pop().map(|row| text_of(&row));
            self.begun.push((rows, title));
            self.leave_out();
            return Ok(Next::Rows(vec![row]));
        }
        let cells = names.cells.iter().filter(|cell| !cell.is_empty()).count();
        let is_header = cells > 1 && names.numbers(self.mark) == 0;
        let Some(header_line) = self.header_line.filter(|_| is_header) else {
            self.open.push(names);
            return Ok(Next::Rows(self.open.drain(..).chain([row]).collect()));
        };
        if matches!(self.header, Header::Line(_)) {
            self.open.clear();
            self.other = Some(names);
            return Ok(Next::End);
        }
        let line = |line: u64| Suggestion::new(Choice::Header, line.to_string());
        let (begins, text) = (names.line, excerpt(&text_of(&names)));
        Err(MeasurementError::Undecided {
            question: format!("a second table begins in line {begins}, with another header (`{text}`)"),
            choices: [header_line, begins].map(line).to_vec(),
        })
    }

    /// Returns `true` if a row has text where other rows have numbers, and no number there. Cells that all begin with digits are wrong numbers.
    fn is_text(&self, row: &TextRow) -> bool {
        let cells = || row.cells.iter().filter(|cell| !cell.is_empty());
        if cells().count() > 1 && cells().all(|cell| cell.starts_with(|letter: char| letter.is_ascii_digit()))
        {
            return false;
        }
        let kinds = || row.kinds(self.mark).zip(&self.are_numbers).filter(|(_, is_number)| **is_number);
        kinds().any(|(cell, _)| cell == Cell::Text) && !kinds().any(|(cell, _)| cell.is_number())
    }

    fn leave_out(&mut self) {
        self.left_out.extend(self.open.drain(..).map(|row| (row.line, text_of(&row))));
    }

    /// The groups of this number of rows, of which the first has this title, and what was left out.
    pub(super) fn finish(mut self, rows: usize, title: Option<&String>) -> Below {
        self.leave_out();
        let text = self.left_out.first().map(|(line, text)| {
            let more = if self.left_out.len() > 1 { "and further lines of text are" } else { "is" };
            format!("line {line} (`{}`) {more} left out", excerpt(text))
        });
        let other = self.other.as_ref().map(|names| {
            let text = excerpt(&text_of(names));
            format!("line {} (`{text}`) begins another table, which is left out", names.line)
        });
        let number = self.begun.len() + 1;
        let several = (number > 1).then(|| {
            format!("{number} tables with the same header stand below one another: each is a group")
        });
        let remarks = text.into_iter().chain(other).chain(several).collect();
        Below { remarks, groups: self.groups(rows, title.cloned()) }
    }

    fn groups(mut self, rows: usize, title: Option<String>) -> Vec<String> {
        if self.begun.is_empty() {
            return vec![];
        }
        self.begun.insert(0, (0, title));
        let has_titles = self.begun.iter().all(|(_, title)| title.is_some());
        let mut groups = vec![];
        for (index, (_, title)) in self.begun.iter().enumerate() {
            let end = self.begun.get(index + 1).map_or(rows, |(next, _)| *next);
            let numbered = format!("table {}", index + 1);
            let title = title.as_deref().filter(|_| has_titles).unwrap_or(&numbered);
            groups.resize(end, excerpt(title));
        }
        groups
    }
}

fn joined(text: &str) -> String {
    text.split_whitespace().collect()
}

fn text_of(row: &TextRow) -> String {
    let cells: Vec<&str> = row.cells.iter().filter(|cell| !cell.is_empty()).collect();
    printable(&cells.join(" "))
}
