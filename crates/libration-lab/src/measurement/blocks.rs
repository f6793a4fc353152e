//! Rows of text below the header of a table: notes below the last row, and further tables with the same header.

use super::MeasurementError;
use super::choices::{Choice, Suggestion};
use super::dialect::Row;
use super::heading::Heading;
use super::number::{Cell, DecimalMark};
use super::options::Header;
use super::sheet::{Channel, Sheet};
use libration::quantity::{excerpt, printable};

/// Tables below one another, separated by rows of text.
pub(super) struct Blocks {
    are_numbers: Vec<bool>,
    mark: DecimalMark,
    header: Header,
    /// Rows of text after the last row of numbers.
    open: Vec<Row>,
    /// First row of each further table, and its title.
    begun: Vec<(usize, Option<String>)>,
    left_out: Vec<(u64, String)>,
    /// The header of another table, which is left out.
    other: Option<Row>,
}

/// Rows that follow in a sheet.
pub(super) enum Next {
    Rows(Vec<Row>),
    Nothing,
    End,
}

impl Blocks {
    pub(super) fn new(are_numbers: Vec<bool>, mark: DecimalMark, header: Header) -> Self {
        Self { are_numbers, mark, header, open: vec![], begun: vec![], left_out: vec![], other: None }
    }

    /// Takes the next row of the text. Rows of text wait for the rows below them.
    pub(super) fn next(&mut self, sheet: &Sheet, row: Row) -> Result<Next, MeasurementError> {
        if self.is_text(&row) {
            self.open.push(row);
            return Ok(Next::Nothing);
        }
        let Some(names) = self.open.pop() else { return Ok(Next::Rows(vec![row])) };
        let is_header = names.filled() > 1 && names.numbers(self.mark) == 0 && sheet.header_line.is_some();
        if is_header && is_header_of(sheet, &names) {
            let title = self.open.pop_if(|row| row.filled() == 1).map(|row| text_of(&row));
            self.begun.push((sheet.rows(), title));
            self.leave_out();
            return Ok(Next::Rows(vec![row]));
        }
        if !is_header {
            self.open.push(names);
            return Ok(Next::Rows(self.open.drain(..).chain([row]).collect()));
        }
        if matches!(self.header, Header::Line(_)) {
            self.left_out.clear();
            self.other = Some(names);
            return Ok(Next::End);
        }
        let line = |line: u64| Suggestion::new(Choice::Header, line.to_string());
        Err(MeasurementError::Undecided {
            question: format!(
                "a second table begins in line {}, with another header (`{}`)",
                names.line,
                excerpt(&text_of(&names))
            ),
            choices: sheet.header_line.into_iter().chain([names.line]).map(line).collect(),
        })
    }

    /// Returns whether a row has text where other rows have numbers, and no number there.
    fn is_text(&self, row: &Row) -> bool {
        let kinds = || row.kinds(self.mark).zip(&self.are_numbers).filter(|(_, is_number)| **is_number);
        kinds().any(|(cell, _)| cell == Cell::Text) && !kinds().any(|(cell, _)| cell.is_number())
    }

    fn leave_out(&mut self) {
        self.left_out.extend(self.open.drain(..).map(|row| (row.line, text_of(&row))));
    }

    /// Adds the groups of the rows and what was left out.
    pub(super) fn finish(mut self, sheet: &mut Sheet) {
        self.leave_out();
        if let Some((line, text)) = self.left_out.first() {
            let more = match self.left_out.len() - 1 {
                0 => "is",
                _ => "and further lines of text are",
            };
            sheet.remarks.push(format!("line {line} (`{}`) {more} left out", excerpt(text)));
        }
        if let Some(names) = &self.other {
            let text = excerpt(&text_of(names));
            sheet
                .remarks
                .push(format!("line {} (`{text}`) begins another table, which is left out", names.line));
        }
        if self.begun.is_empty() {
            return;
        }
        let title = sheet.preamble.last().map(|(_, text)| text.clone());
        self.begun.insert(0, (0, title));
        let has_titles = self.begun.iter().all(|(_, title)| title.is_some());
        let mut words = vec![];
        for (place, (first, title)) in self.begun.iter().enumerate() {
            let last = self.begun.get(place + 1).map_or(sheet.rows(), |(next, _)| *next);
            let numbered = format!("table {}", place + 1);
            let title = title.as_deref().filter(|_| has_titles).unwrap_or(&numbered);
            words.extend((*first..last).map(|row| (row, excerpt(title))));
        }
        sheet.remarks.push(format!(
            "{} tables with the same header stand below one another: each is a group",
            self.begun.len()
        ));
        sheet.channels.push(Channel {
            heading: Heading::read("group", None, None),
            cells: vec![Cell::Text; sheet.rows()],
            words,
            uncertainties: vec![None; sheet.rows()],
            decimals: 0,
        });
    }
}

/// Returns whether a row has the names of the columns again, whose words blanks may have separated.
fn is_header_of(sheet: &Sheet, row: &Row) -> bool {
    let joined = |text: &str| text.split_whitespace().collect::<String>();
    let names: String = sheet.channels.iter().map(|channel| joined(&channel.heading.text)).collect();
    joined(&text_of(row)) == names
}

fn text_of(row: &Row) -> String {
    let cells: Vec<&str> = row.cells.iter().filter(|cell| !cell.is_empty()).collect();
    printable(&cells.join(" "))
}
