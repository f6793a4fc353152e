//! A table of motions: each row has the values of parameters and the initial values of one motion, below their names.

use super::system::GivenSystem;
use super::values::plain_name;
use super::{bare, lines};
use crate::query_error::QueryError;
use libration::quantity::BareRadians;
use std::path::Path;

/// More motions than this are never requested.
const MOST_MOTIONS: usize = 1_000_000;

/// Title of columns of names, such as `light`.
const NAME: &str = "name";

/// A table in which every row has as many cells as there are columns.
#[derive(Debug)]
pub(crate) struct MotionTable {
    pub(crate) columns: Vec<MotionColumn>,
    pub(crate) rows: Vec<MotionRow>,
}

/// The title and the meaning of a column.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MotionColumn {
    pub(crate) title: String,
    pub(crate) meaning: Meaning,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Meaning {
    /// The name of the motion.
    Name,
    Parameter,
    /// A number of the state at the start, or all of a family, `x[i]`.
    Initial,
}

/// One motion.
#[derive(Debug)]
pub(crate) struct MotionRow {
    /// The number of its line in the file.
    pub(crate) line: usize,
    /// Cells as text.
    pub(crate) cells: Vec<String>,
}

impl MotionTable {
    /// Reads a file, or the standard input.
    pub(crate) fn read(path: &Path, system: &GivenSystem<'_>) -> Result<Self, QueryError> {
        let text = lines::text(path)?;
        let mut lines = lines::numbered(&text);
        let of_file = |reason: &str| QueryError::no_result(&path.display().to_string(), reason);
        let (number, header) = lines.next().ok_or_else(|| of_file(EMPTY))?;
        let separator = separator(header);
        let columns = columns(&cells(header, separator), system);
        let columns = columns.map_err(|reason| at_line(path, number, &reason))?;
        let mut rows = vec![];
        for (line, text) in lines {
            let row = MotionRow { line, cells: cells(text, separator) };
            check(&row, &columns).map_err(|reason| at_line(path, line, &reason))?;
            rows.push(row);
            if rows.len() > MOST_MOTIONS {
                return Err(of_file("it has more than a million motions: give a part of it"));
            }
        }
        if rows.is_empty() {
            return Err(of_file(EMPTY));
        }
        let table = Self { columns, rows };
        table.say_bare_angle(system);
        Ok(table)
    }

    /// Writes a note on the first angle without a unit that may have been meant in degrees.
    fn say_bare_angle(&self, system: &GivenSystem<'_>) {
        let angles = system.angles();
        let cells = self.rows.iter().flat_map(|row| self.cells_of(row, Meaning::Initial));
        let mut cells = cells.filter(|(title, _)| angles.iter().any(|angle| angle == title));
        if let Some((_, first)) = cells.find(|(_, cell)| BareRadians::in_text(cell).is_some()) {
            bare::say(first);
        }
    }

    /// The cells of a row under the columns with one meaning, with their titles.
    pub(crate) fn cells_of<'a>(
        &'a self,
        row: &'a MotionRow,
        meaning: Meaning,
    ) -> impl Iterator<Item = (&'a str, &'a str)> {
        let cells = self.columns.iter().zip(&row.cells);
        let wanted = cells.filter(move |(column, _)| column.meaning == meaning);
        wanted.map(|(column, cell)| (column.title.as_str(), cell.as_str()))
    }
}

const EMPTY: &str = "the file has no motions: write names of parameters and initial values in the first line, such as \
                     theta,omega0, and one motion in each line below";

/// A failure at a line of a file.
pub(crate) fn at_line(path: &Path, line: usize, reason: &impl std::fmt::Display) -> QueryError {
    QueryError::no_result(&format!("{}, line {line}", path.display()), reason)
}

fn separator(header: &str) -> char {
    ['\t', ';'].into_iter().find(|separator| header.contains(*separator)).unwrap_or(',')
}

/// The cells of a line, without quotation marks around them.
fn cells(line: &str, separator: char) -> Vec<String> {
    let mut quoted = false;
    let ends = |letter: char| {
        quoted ^= letter == '"';
        letter == separator && !quoted
    };
    let cells = line.split(ends).map(str::trim);
    let unquoted = |cell: &str| match cell.strip_prefix('"').and_then(|cell| cell.strip_suffix('"')) {
        Some(inner) => inner.replace("\"\"", "\"").trim().to_owned(),
        None => cell.to_owned(),
    };
    cells.map(unquoted).collect()
}

fn columns(titles: &[String], system: &GivenSystem<'_>) -> Result<Vec<MotionColumn>, String> {
    let mut columns: Vec<MotionColumn> = vec![];
    for (index, title) in titles.iter().enumerate() {
        let column = column(title, system).ok_or_else(|| no_column(index, title, system))?;
        if columns.contains(&column) {
            return Err(format!("there are two columns `{title}`: give one"));
        }
        if column.meaning == Meaning::Parameter && system.counts(&column.title) {
            return Err(format!(
                "`{title}` sets the number of coordinates of all motions: give it by <--set>"
            ));
        }
        if column.meaning == Meaning::Parameter && system.gives(&column.title) {
            return Err(format!("`{title}` has a value by an option already: give the option or the column"));
        }
        columns.push(column);
    }
    match columns.iter().all(|column| column.meaning == Meaning::Name) {
        true => {
            Err("it names neither a parameter nor an initial value, so that all motions are the same"
                .to_owned())
        }
        false => Ok(columns),
    }
}

fn column(title: &str, system: &GivenSystem<'_>) -> Option<MotionColumn> {
    let column = |title: &str, meaning| Some(MotionColumn { title: title.to_owned(), meaning });
    let plain = plain_name(title);
    match () {
        () if title.eq_ignore_ascii_case(NAME) => column(NAME, Meaning::Name),
        () if system.state_names().contains(&plain) => column(&plain, Meaning::Initial),
        () if system.gives(&plain) || system.counts(&plain) || system.free_parameters().contains(&plain) => {
            column(&plain, Meaning::Parameter)
        }
        () if title.contains('[') => column(title, Meaning::Initial),
        () => None,
    }
}

fn no_column(index: usize, title: &str, system: &GivenSystem<'_>) -> String {
    if title.is_empty() {
        return format!("column {} has no name", index + 1);
    }
    let parameters = system.free_parameters();
    let parameters = if parameters.is_empty() { "none".to_owned() } else { parameters.join(", ") };
    format!(
        "`{title}` is neither a parameter ({parameters}) nor an initial value ({}) nor `{NAME}`",
        system.state_names().join(", ")
    )
}

fn check(row: &MotionRow, columns: &[MotionColumn]) -> Result<(), String> {
    let (got, wanted) = (row.cells.len(), columns.len());
    if got != wanted {
        let cells = if got == 1 { "cell" } else { "cells" };
        return Err(format!("{got} {cells} below {wanted} names: give one each"));
    }
    let mut cells = columns.iter().zip(&row.cells);
    match cells.find(|(column, cell)| cell.is_empty() && column.meaning != Meaning::Name) {
        Some((column, _)) => Err(format!("{} has no value: give it one in each line", column.title)),
        None => Ok(()),
    }
}
