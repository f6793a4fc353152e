//! Tables to read: aligned columns with their units, written as they grow.

mod layout;

use super::screen;
use layout::{ColumnPlace, Layout, lines};
use std::io::{self, Write};

/// Rows that are held back to find the widths of the columns.
const HELD_BACK: usize = 500;

/// A column: its title with the unit, and the side its entries stand on.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    pub(crate) title: String,
    side: Side,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Left,
    Right,
}

impl Column {
    /// A column of numbers.
    pub(crate) fn numbers(title: impl Into<String>) -> Self {
        Self { title: title.into(), side: Side::Right }
    }

    pub(crate) fn is_of_numbers(&self) -> bool {
        self.side == Side::Right
    }

    /// A column of words.
    pub(crate) fn words(title: impl Into<String>) -> Self {
        Self { title: title.into(), side: Side::Left }
    }
}

/// A table in the making; [`Table::finish`] writes what was held back.
///
/// It heeds the width of the screen: titles and words are folded, and columns that still have no room side by side
/// stand in blocks one below the other, each with the first column.
#[derive(Debug)]
pub(crate) struct Table {
    columns: Vec<Column>,
    held: Vec<Vec<String>>,
    layout: Option<Layout>,
    room: usize,
}

impl Table {
    pub(crate) fn new(columns: Vec<Column>) -> Self {
        Self { columns, held: vec![], layout: None, room: screen::width() }
    }

    pub(crate) fn row(&mut self, out: &mut dyn Write, cells: Vec<String>) -> io::Result<()> {
        if let Some(layout) = self.layout.as_ref().filter(|_| self.held.is_empty())
            && layout.is_one_block()
            && layout.holds(&self.columns, &cells)
        {
            return self.write(out, &layout.blocks[0], &cells);
        }
        self.held.push(cells);
        if self.held.len() == HELD_BACK { self.release(out) } else { Ok(()) }
    }

    pub(crate) fn finish(mut self, out: &mut dyn Write) -> io::Result<()> {
        if self.layout.is_none() || !self.held.is_empty() { self.release(out) } else { Ok(()) }
    }

    /// Finds the widths of the rows held back and writes them below the titles.
    fn release(&mut self, out: &mut dyn Write) -> io::Result<()> {
        let held = std::mem::take(&mut self.held);
        let layout = Layout::new(&self.columns, &held, self.room);
        let titles: Vec<String> = self.columns.iter().map(|column| column.title.clone()).collect();
        let mut is_first = self.layout.is_none();
        for block in &layout.blocks {
            if !std::mem::take(&mut is_first) {
                writeln!(out)?;
            }
            self.write(out, block, &titles)?;
            held.iter().try_for_each(|cells| self.write(out, block, cells))?;
        }
        self.layout = Some(layout);
        Ok(())
    }

    fn write(&self, out: &mut dyn Write, places: &[ColumnPlace], cells: &[String]) -> io::Result<()> {
        lines(places, &self.columns, cells).iter().try_for_each(|line| writeln!(out, "{line}"))
    }
}

/// Longer lines of text are hard to read on any screen.
const WIDEST_TEXT: usize = 100;

/// Writes a sheet of named values, one below the other; long ones are folded beside their name.
pub(crate) fn sheet(out: &mut dyn Write, lines: &[(&str, String)]) -> io::Result<()> {
    let width = lines.iter().map(|(name, _)| screen::columns_of(name)).max().unwrap_or(0);
    for (name, value) in lines {
        write_text(out, &format!("{}  ", screen::padded(name, width)), value)?;
    }
    Ok(())
}

/// Writes a sentence or two in lines, after a name that the further lines stand beside.
pub(crate) fn write_text(out: &mut dyn Write, name: &str, text: &str) -> io::Result<()> {
    writeln!(out, "{}", paragraph(name, text, WIDEST_TEXT))
}

/// Text broken at blanks before this column or the end of the screen, further lines indented as far as the first word.
pub(crate) fn paragraph(first: &str, text: &str, column: usize) -> String {
    let indent = screen::columns_of(first);
    let room = column.min(screen::width()).saturating_sub(indent);
    first.to_owned() + &screen::folded(text, room).join(&format!("\n{:indent$}", ""))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn in_columns(room: usize, columns: Vec<Column>, rows: impl IntoIterator<Item = Vec<String>>) -> String {
        let mut out = vec![];
        let mut table = Table { room, ..Table::new(columns) };
        for row in rows {
            table.row(&mut out, row).unwrap();
        }
        table.finish(&mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    fn written(rows: usize) -> String {
        let columns = vec![Column::words("name"), Column::numbers("x / m")];
        in_columns(80, columns, (0..rows).map(|row| vec!["θ".to_owned(), row.to_string()]))
    }

    fn cells(texts: &[&str]) -> Vec<String> {
        texts.iter().map(|text| (*text).to_owned()).collect()
    }

    #[test]
    fn columns_are_aligned_by_letters_and_not_by_bytes() {
        assert_eq!(written(2), "name  x / m\nθ         0\nθ         1\n");
    }

    #[test]
    fn paragraphs_are_broken_before_the_column() {
        assert_eq!(paragraph("θ: ", "one two three", 10), "θ: one two\n   three");
        assert_eq!(paragraph("θ: ", "a-very-long-word", 10), "θ: a-very-long-word");
    }

    #[test]
    fn long_tables_lose_no_row() {
        assert_eq!(written(2 * HELD_BACK + 1).lines().count(), 2 * HELD_BACK + 2);
    }

    #[test]
    fn titles_are_folded_before_anything_else() {
        let columns = ["n", "time of the cycle / s", "amplitude / °"].map(Column::numbers).to_vec();
        let table = in_columns(24, columns, [cells(&["1", "2.0064", "60.000000"])]);
        assert_eq!(
            table,
            "n     time of  amplitude\n    the cycle        / °\n          / s\n1      2.0064  60.000000\n"
        );
    }

    #[test]
    fn words_are_folded_where_there_is_no_room() {
        let columns = vec![Column::numbers("n"), Column::words("what")];
        let table =
            in_columns(40, columns, [cells(&["1", "a text that is much longer than the line, by far"])]);
        assert_eq!(table, "n  what\n1  a text that is much longer than the\n   line, by far\n");
    }

    #[test]
    fn columns_without_room_stand_in_a_block_below() {
        let columns = ["t", "one", "two", "three"].map(Column::numbers).to_vec();
        let rows = [cells(&["0", "1.00000000", "2.00000000", "3.00000000"])];
        let table = in_columns(26, columns, rows);
        assert_eq!(
            table,
            "t         one         two\n0  1.00000000  2.00000000\n\nt       three\n0  3.00000000\n"
        );
    }

    /// A column of remarks takes no room, and no block of its own, as long as there are none.
    #[test]
    fn what_has_neither_title_nor_words_is_left_out() {
        let columns = [Column::numbers("n"), Column::numbers("x"), Column::words("")];
        let rows = |remark| [cells(&["1", "2.00000", ""]), cells(&["2", "3.00000", remark])];
        assert_eq!(in_columns(10, columns.to_vec(), rows("")), "n        x\n1  2.00000\n2  3.00000\n");
        assert!(in_columns(30, columns.to_vec(), rows("← least")).ends_with("2  3.00000  ← least\n"));
        let late = (0..=HELD_BACK).map(|row| cells(&["1", "2", if row < HELD_BACK { "" } else { "← last" }]));
        assert!(in_columns(80, columns.to_vec(), late).ends_with("1  2  ← last\n"));
    }

    #[test]
    fn a_row_that_is_wider_than_those_before_begins_a_new_head() {
        let rows = (0..=HELD_BACK).map(|row| vec![if row < HELD_BACK { "1" } else { "1000" }.to_owned()]);
        let table = in_columns(80, vec![Column::numbers("n")], rows);
        assert!(table.ends_with("1\n\n   n\n1000\n"), "{}", &table[table.len() - 20..]);
        assert_eq!(table.matches('n').count(), 2);
    }
}
