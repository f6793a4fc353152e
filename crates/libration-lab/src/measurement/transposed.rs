//! Tables with their quantities in rows: the name in the first cell, the values after it.

use super::dialect::{Delimiter, Dialect, TextRow};
use super::heading::Heading;
use super::number::{Cell, Written};
use super::role::Role;

/// Most quantities of such a table, with functions of them and repeated readings.
const MOST_ROWS: usize = 20;

/// The text with rows and columns exchanged, where each row is a name and at least two numbers, and two names say a quantity or one has a unit.
pub(super) fn exchanged(text: &str, dialect: Dialect) -> Option<(String, Dialect)> {
    let plain = Dialect { units: false, ..dialect };
    let rows: Vec<TextRow> = plain.rows(text).take(MOST_ROWS + 1).collect();
    // Titles above the table have one cell.
    let rows = &rows[rows.iter().take_while(|row| row.filled() == 1).count()..];
    let width = rows.iter().map(TextRow::filled).max()?;
    let is_quantity = |row: &TextRow| {
        // `20 cm` begins a row of readings.
        if Written::parse(&row.cells[0], dialect.mark).is_some() {
            return false;
        }
        let mut cells = row.cells.iter().map(|cell| Cell::parse(cell, dialect.mark));
        cells.next() == Some(Cell::Text)
            && cells.all(|cell| cell != Cell::Text)
            && row.numbers(dialect.mark) > 1
    };
    if width < 3 || !(2..=MOST_ROWS).contains(&rows.len()) || !rows.iter().all(is_quantity) {
        return None;
    }
    let says = |row: &&TextRow| {
        let heading = Heading::read(&row.cells[0], None, None);
        [Role::Times, Role::Lengths, Role::Angles, Role::Frequencies]
            .iter()
            .any(|role| role.is_said_by(&heading))
    };
    let has_unit = |row: &TextRow| Heading::read(&row.cells[0], None, None).unit.is_some();
    if rows.iter().filter(says).count() < 2 && !rows.iter().any(has_unit) {
        return None;
    }
    let column = |index: usize| {
        let cells: Vec<&str> = rows.iter().map(|row| row.cells.get(index).unwrap_or_default()).collect();
        cells.join("\t")
    };
    let lines: Vec<String> = (0..width).map(column).collect();
    Some((lines.join("\n"), Dialect { delimiter: Delimiter::Tab, ..plain }))
}
