//! Tables to read: aligned columns with their units, written as they grow.

mod layout;

use super::screen;
use layout::{ColumnPlace, TableLayout, lines};
use std::io::{self, Write};

/// Number of rows that are held back to find the widths of the columns.
pub const HELD_BACK: usize = 500;

/// A column: its title with the unit, and the alignment of its entries.
#[derive(Clone, Debug)]
pub struct Column {
    /// The title with the unit.
    pub title: String,
    side: Side,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Left,
    Right,
}

impl Column {
    /// A column of numbers.
    pub fn numbers(title: impl Into<String>) -> Self {
        Self { title: title.into(), side: Side::Right }
    }

    pub(crate) fn is_of_numbers(&self) -> bool {
        self.side == Side::Right
    }

    /// A column of words.
    pub fn words(title: impl Into<String>) -> Self {
        Self { title: title.into(), side: Side::Left }
    }
}

/// A table that is written row by row; [`Table::finish`] writes the rows held back.
///
/// It fits the width of the screen: titles and words are folded, and columns that still have no room side by side are
/// put into blocks one below the other, each with the first column.
#[derive(Debug)]
pub struct Table {
    columns: Vec<Column>,
    held: Vec<Vec<String>>,
    layout: Option<TableLayout>,
    /// The width of the screen.
    pub room: usize,
}

impl Table {
    /// A table without rows.
    pub fn new(columns: Vec<Column>) -> Self {
        Self { columns, held: vec![], layout: None, room: screen::width() }
    }

    /// Adds a row, and writes it when the widths are known.
    pub fn row(&mut self, out: &mut dyn Write, mut cells: Vec<String>) -> io::Result<()> {
        cells.iter_mut().for_each(screen::clean);
        if let Some(layout) = self.layout.as_ref().filter(|_| self.held.is_empty())
            && layout.is_one_block()
            && layout.holds(&self.columns, &cells)
        {
            return self.write(out, &layout.blocks[0], &cells);
        }
        self.held.push(cells);
        if self.held.len() == HELD_BACK { self.release(out) } else { Ok(()) }
    }

    /// Writes the rows that were held back.
    pub fn finish(mut self, out: &mut dyn Write) -> io::Result<()> {
        if self.layout.is_none() || !self.held.is_empty() { self.release(out) } else { Ok(()) }
    }

    /// Finds the widths of the rows held back and writes them below the titles.
    fn release(&mut self, out: &mut dyn Write) -> io::Result<()> {
        let held = std::mem::take(&mut self.held);
        let layout = TableLayout::new(&self.columns, &held, self.room);
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

    fn write(&self, out: &mut dyn Write, widths: &[ColumnPlace], cells: &[String]) -> io::Result<()> {
        lines(widths, &self.columns, cells).iter().try_for_each(|line| writeln!(out, "{line}"))
    }
}

/// Longest line of text in columns: longer ones are hard to read.
const WIDEST_TEXT: usize = 100;

/// Writes a sheet of named values, one below the other; long ones are folded next to their name.
pub(crate) fn sheet(out: &mut dyn Write, lines: &[(&str, String)]) -> io::Result<()> {
    let width = lines.iter().map(|(name, _)| screen::columns_of(name)).max().unwrap_or(0);
    for (name, value) in lines {
        write_text(out, &format!("{}  ", screen::padded(name, width)), value)?;
    }
    Ok(())
}

/// Writes sentences in lines, after a name next to which the further lines are indented.
pub(crate) fn write_text(out: &mut dyn Write, name: &str, text: &str) -> io::Result<()> {
    writeln!(out, "{}", paragraph(name, text, WIDEST_TEXT))
}

/// Text broken at blanks before this column or the end of the screen, further lines indented as far as the first word.
pub fn paragraph(first: &str, text: &str, column: usize) -> String {
    let indent = screen::columns_of(first);
    let room = column.min(screen::width()).saturating_sub(indent);
    let mut text = text.to_owned();
    screen::clean(&mut text);
    first.to_owned() + &screen::folded(&text, room).join(&format!("\n{:indent$}", ""))
}
