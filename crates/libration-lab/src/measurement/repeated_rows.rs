//! Rows that stand in a table more than once: a table that was pasted twice, or each row in two lines.
//!
//! Readings with few digits coincide, so that single equal rows are left as they are. A whole passage of three values of the first quantity or more, in the
//! same order and with all of its numbers, is taken for a copy. Where rounding makes it coincide the errors are the same ones too, and do not average.

use super::table::Readings;
use std::collections::HashMap;
use std::ops::Range;

/// Different values of the first quantity that make a passage.
const FEWEST_VALUES: usize = 3;
/// Tables of more rows are recordings and not typed or pasted by hand.
const MOST_ROWS: usize = 2000;

/// Rows that repeat others, as lines of the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RepeatedRows {
    /// A repeated passage.
    Passage {
        /// First and last line of the copy.
        lines: [u64; 2],
        /// First and last line of the passage that it repeats.
        of: [u64; 2],
    },
    /// Each row is repeated in this number of successive lines.
    Each(usize),
}

impl Readings {
    /// The rows without copies of others, and those copies. `labels` are names of the rows, such as their groups: rows with different names are different.
    ///
    /// # Examples
    /// ```
    /// use libration_lab::measurement::{Column, ReadOptions, RepeatedRows, Table};
    ///
    /// let text = b"L (m),T (s)\n0.2,0.90\n0.3,1.10\n0.4,1.27\n0.2,0.90\n0.3,1.10\n0.4,1.27\n";
    /// let columns = [1, 2].map(|number| vec![Column::Number(number)]);
    /// let readings = Table::read(text, &ReadOptions::default())?.readings(&columns)?;
    /// let (once, repeated) = readings.once(None);
    /// assert_eq!(once.lines, [2, 3, 4]);
    /// assert_eq!(repeated, [RepeatedRows::Passage { lines: [5, 7], of: [2, 4] }]);
    /// # Ok::<(), libration_lab::measurement::MeasurementError>(())
    /// ```
    #[must_use]
    pub fn once(self, labels: Option<&[String]>) -> (Self, Vec<RepeatedRows>) {
        let rows = self.lines.len();
        if rows > MOST_ROWS {
            return (self, vec![]);
        }
        let keys: Vec<RowKey> = (0..rows).map(|row| self.key(row, labels)).collect();
        if let Some(times) = times_of_each(&keys) {
            let kept: Vec<usize> = (0..rows).step_by(times).collect();
            return (self.only(&kept), vec![RepeatedRows::Each(times)]);
        }
        let passages = passages(&keys);
        let is_copy = |row: &usize| passages.iter().any(|(copy, _)| copy.contains(row));
        let kept: Vec<usize> = (0..rows).filter(|row| !is_copy(row)).collect();
        let ends = |rows: &Range<usize>| [self.lines[rows.start], self.lines[rows.end - 1]];
        let repeated = passages
            .iter()
            .map(|(copy, of)| RepeatedRows::Passage { lines: ends(copy), of: ends(of) })
            .collect();
        (self.only(&kept), repeated)
    }

    fn key(&self, row: usize, labels: Option<&[String]>) -> RowKey {
        let bits = |numbers: &Vec<f64>| numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
        let bits_of = |of: &Option<Vec<f64>>| of.iter().map(|of| of[row].to_bits()).collect();
        RowKey {
            numbers: self.quantities.iter().map(|of| bits(&of[row])).collect(),
            uncertainties: self.uncertainties.iter().map(bits_of).collect(),
            label: labels.and_then(|labels| labels.get(row).cloned()),
        }
    }

    /// The rows with these indices, counted from zero.
    #[must_use]
    pub fn only(&self, rows: &[usize]) -> Self {
        Self {
            quantities: self.quantities.iter().map(|of| chosen(of, rows)).collect(),
            uncertainties: self
                .uncertainties
                .iter()
                .map(|of| of.as_ref().map(|of| chosen(of, rows)))
                .collect(),
            lines: chosen(&self.lines, rows),
            rows: chosen(&self.rows, rows),
            dropped: self.dropped,
        }
    }
}

fn chosen<T: Clone>(all: &[T], rows: &[usize]) -> Vec<T> {
    rows.iter().filter_map(|&row| all.get(row).cloned()).collect()
}

/// All numbers of a row.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
struct RowKey {
    numbers: Vec<Vec<u64>>,
    uncertainties: Vec<Vec<u64>>,
    label: Option<String>,
}

/// Number of different values of the first quantity.
fn values(keys: &[RowKey]) -> usize {
    let mut first: Vec<_> = keys.iter().filter_map(|key| key.numbers.first()).collect();
    first.sort();
    first.dedup();
    first.len()
}

/// The number of successive lines, two or more, in which each row is repeated.
fn times_of_each(keys: &[RowKey]) -> Option<usize> {
    let times = keys.iter().take_while(|key| **key == keys[0]).count();
    let is_each = times > 1
        && keys.len().is_multiple_of(times)
        && keys.chunks(times).all(|rows| rows.iter().all(|row| *row == rows[0]));
    (is_each && values(keys) >= FEWEST_VALUES).then_some(times)
}

/// Passages that repeat earlier ones, from their first occurrence on.
fn passages(keys: &[RowKey]) -> Vec<(Range<usize>, Range<usize>)> {
    let mut first: HashMap<&RowKey, usize> = HashMap::new();
    let (mut passages, mut row) = (vec![], 0);
    while row < keys.len() {
        let of = *first.entry(&keys[row]).or_insert(row);
        let rows = keys[of..row].iter().zip(&keys[row..]).take_while(|(one, other)| one == other).count();
        if values(&keys[row..row + rows]) >= FEWEST_VALUES {
            passages.push((row..row + rows, of..of + rows));
            row += rows;
        } else {
            row += 1;
        }
    }
    passages
}
