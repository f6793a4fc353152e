//! Tables to read: aligned columns with their units, written as they grow.

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
#[derive(Debug)]
pub(crate) struct Table {
    columns: Vec<Column>,
    held: Vec<Vec<String>>,
    widths: Option<Vec<usize>>,
}

impl Table {
    pub(crate) fn new(columns: Vec<Column>) -> Self {
        Self { columns, held: vec![], widths: None }
    }

    pub(crate) fn row(&mut self, out: &mut dyn Write, cells: Vec<String>) -> io::Result<()> {
        if let Some(widths) = &self.widths {
            return self.line(out, &cells, widths);
        }
        self.held.push(cells);
        if self.held.len() == HELD_BACK { self.release(out) } else { Ok(()) }
    }

    pub(crate) fn finish(mut self, out: &mut dyn Write) -> io::Result<()> {
        if self.widths.is_none() { self.release(out) } else { Ok(()) }
    }

    /// Fixes the widths and writes the titles and the rows held back.
    fn release(&mut self, out: &mut dyn Write) -> io::Result<()> {
        let titles: Vec<String> = self.columns.iter().map(|column| column.title.clone()).collect();
        let held = std::mem::take(&mut self.held);
        let widths = widths(&titles, &held);
        self.line(out, &titles, &widths)?;
        for cells in &held {
            self.line(out, cells, &widths)?;
        }
        self.widths = Some(widths);
        Ok(())
    }

    fn line(&self, out: &mut dyn Write, cells: &[String], widths: &[usize]) -> io::Result<()> {
        let aligned =
            cells.iter().zip(widths).zip(&self.columns).map(|((cell, &width), column)| match column.side {
                Side::Left => format!("{cell:<width$}"),
                Side::Right => format!("{cell:>width$}"),
            });
        writeln!(out, "{}", aligned.collect::<Vec<_>>().join("  ").trim_end())
    }
}

fn widths(titles: &[String], rows: &[Vec<String>]) -> Vec<usize> {
    let width = |index: usize, title: &String| {
        let cells = rows.iter().filter_map(|row| row.get(index));
        cells.chain([title]).map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    titles.iter().enumerate().map(|(index, title)| width(index, title)).collect()
}

/// Writes a sheet of named values, one below the other.
pub(crate) fn sheet(out: &mut dyn Write, lines: &[(&str, String)]) -> io::Result<()> {
    let width = lines.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    for (name, value) in lines {
        writeln!(out, "{name:<width$}  {value}")?;
    }
    Ok(())
}

/// Text broken at blanks before this column, further lines indented as far as the first word.
pub(crate) fn paragraph(first: &str, text: &str, column: usize) -> String {
    let indent = first.chars().count();
    let (mut written, mut width) = (first.to_owned(), indent);
    for (place, word) in text.split_whitespace().enumerate() {
        let letters = word.chars().count();
        if place > 0 && width + 1 + letters > column {
            written.push_str(&format!("\n{:indent$}", ""));
            width = indent;
        } else if place > 0 {
            written.push(' ');
            width += 1;
        }
        written.push_str(word);
        width += letters;
    }
    written
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(rows: usize) -> String {
        let mut out = vec![];
        let mut table = Table::new(vec![Column::words("name"), Column::numbers("x / m")]);
        for row in 0..rows {
            table.row(&mut out, vec!["θ".to_owned(), row.to_string()]).unwrap();
        }
        table.finish(&mut out).unwrap();
        String::from_utf8(out).unwrap()
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
}
