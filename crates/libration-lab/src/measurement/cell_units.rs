//! The units of single cells, as in a column of `10cm` and `1.2m`, or in a column of their own: one for each column of numbers, to which all of
//! them are converted.

use super::Unit;
use super::dialect::TextRow;
use super::number::Cell;

/// Headings of a column of units.
const HEADINGS: [&str; 20] = [
    "unit",
    "units",
    "einheit",
    "einheiten",
    "unité",
    "unités",
    "unite",
    "unidad",
    "unidades",
    "unità",
    "unita",
    "unidade",
    "eenheid",
    "enhet",
    "enhed",
    "jednostka",
    "jednotka",
    "единица",
    "单位",
    "単位",
];

/// Returns `true` for the heading of a column of units.
pub(super) fn is_heading_of_units(text: &str) -> bool {
    HEADINGS.contains(&text.trim().to_lowercase().as_str())
}

/// The units of the cells of each column, row by row.
pub(super) struct CellUnits(Vec<Vec<Option<Unit>>>);

impl CellUnits {
    /// The units of this number of columns, without any row.
    pub(super) fn of(columns: usize) -> Self {
        Self(vec![vec![]; columns])
    }

    pub(super) fn push(&mut self, row: &TextRow) {
        for (column, units) in self.0.iter_mut().enumerate() {
            units.push(row.units.get(column).copied().flatten());
        }
    }

    /// The unit of the first cell of a column with a unit.
    pub(super) fn first(&self, column: usize) -> Option<Unit> {
        self.0[column].iter().flatten().next().copied()
    }

    /// Takes the words of a column of units as those of the numbers in another column, whose cells have none; returns `false` if a word is not a
    /// unit. Where there is one unit alone, it is also that of rows where its cell is blank.
    pub(super) fn take_words(&mut self, column: usize, words: &[(usize, String)]) -> bool {
        let read = words.iter().map(|(row, word)| Some((*row, word.parse().ok()?)));
        let Some(read) = read.collect::<Option<Vec<(usize, Unit)>>>() else { return false };
        let Some((_, first)) = read.first().filter(|_| self.first(column).is_none()) else { return false };
        let only = read.iter().all(|(_, unit)| unit == first).then_some(*first);
        self.0[column].fill(only);
        read.iter().for_each(|(row, unit)| self.0[column][*row] = Some(*unit));
        true
    }

    /// Converts all numbers of a column and their uncertainties to this unit; the error states the mixture: numbers with and without a unit, unless the
    /// heading states the unit of all (`is_stated`), or units of different quantities.
    pub(super) fn bring(
        &self,
        column: usize,
        cells: &mut [Cell],
        uncertainties: &mut [Option<f64>],
        to: Unit,
        is_stated: bool,
    ) -> Result<(), String> {
        let is_of_all = is_stated && self.0[column].iter().flatten().all(|unit| *unit == to);
        for (row, unit) in self.0[column].iter().enumerate() {
            let (cell, uncertainty) = (&mut cells[row], &mut uncertainties[row]);
            match (cell, unit) {
                (Cell::Number(_), None) if !is_of_all => {
                    return Err(format!("numbers in {to} and numbers without a unit"));
                }
                (Cell::Number(_), Some(unit)) if unit.measures() != to.measures() => {
                    return Err(format!("numbers in {to} and numbers in {unit}"));
                }
                (Cell::Number(number), Some(unit)) if *unit != to => {
                    *number = unit.to_si(*number) / to.to_si(1.0);
                    *uncertainty = uncertainty.map(|spread| unit.to_si(spread) / to.to_si(1.0));
                }
                _ => {}
            }
        }
        Ok(())
    }
}
