//! The golden tables in `data`: comma-separated, with source, licence and meaning in `#` lines and one line of column names.

use crate::ulp::{Truth, from_hex};
use std::path::Path;

/// A table by its path under `data`.
#[derive(Debug)]
pub struct Table {
    names: Vec<String>,
    rows: Vec<Vec<String>>,
}

/// One row, whose cells are accessed by column name.
#[derive(Clone, Copy, Debug)]
pub struct Row<'a> {
    table: &'a Table,
    cells: &'a [String],
}

impl Table {
    /// Reads the table at a path below `data`.
    pub fn read(path: &str) -> Self {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("data").join(path);
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(file).unwrap();
        let names = reader.headers().unwrap().iter().map(str::to_owned).collect();
        let rows =
            reader.records().map(|record| record.unwrap().iter().map(str::to_owned).collect()).collect();
        Self { names, rows }
    }

    /// The rows in their order.
    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.rows.iter().map(|cells| Row { table: self, cells })
    }
}

impl<'a> Row<'a> {
    /// The cell in the column of this name.
    pub fn text(self, name: &str) -> &'a str {
        let column = self.table.names.iter().position(|heading| heading == name);
        &self.cells[column.unwrap_or_else(|| panic!("no column {name}"))]
    }

    /// An input: the nearest `f64` to the decimal, or the exact hexadecimal value of a column whose name ends in `_hex`.
    pub fn input(self, name: &str) -> f64 {
        let text = self.text(name);
        if name.ends_with("_hex") { from_hex(text) } else { text.parse().unwrap() }
    }

    /// The true value in the column of this name.
    pub fn truth(self, name: &str) -> Truth {
        Truth::from_decimal(self.text(name))
    }
}
