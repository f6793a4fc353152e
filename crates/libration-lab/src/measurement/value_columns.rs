//! The columns of a table that hold values, each with that of its uncertainties.

use super::Column;
use super::heading::Heading;
use super::table::Table;

/// A column of values.
#[derive(Clone, Debug, PartialEq)]
pub struct ValueColumn {
    /// The column.
    pub values: Column,
    /// The column of their uncertainties.
    pub uncertainties: Option<Column>,
}

impl Table {
    /// The columns of values with those of their uncertainties, as the header says which are which: `±` belongs to the column before it, or to the
    /// last one before it that has none yet, `u(T)` and `dT` to that of the same name, or else to the one before it. Of two that would belong to one
    /// column the first does. Columns of words are left out.
    ///
    /// # Examples
    /// ```
    /// use libration_lab::measurement::{Column, ReadOptions, Table};
    ///
    /// let table = Table::read(b"L,+-,T,+-\n0.25,0.01,1.00,0.02\n0.50,0.01,1.42,0.02\n", &ReadOptions::default())?;
    /// let columns = table.value_columns();
    /// assert_eq!(columns[1].values, Column::Number(3));
    /// assert_eq!(columns[1].uncertainties, Some(Column::Number(4)));
    /// # Ok::<(), libration_lab::measurement::MeasurementError>(())
    /// ```
    #[must_use]
    pub fn value_columns(&self) -> Vec<ValueColumn> {
        let channels = &self.sheet().channels;
        let headings: Vec<&Heading> = channels.iter().map(|channel| &channel.heading).collect();
        let values: Vec<usize> = (0..headings.len())
            .filter(|&place| !headings[place].is_uncertainty && !channels[place].is_of_words())
            .collect();
        let mut found: Vec<(usize, Option<usize>)> = values.iter().map(|&place| (place, None)).collect();
        for place in (0..headings.len()).filter(|&place| headings[place].is_uncertainty) {
            let is_same = |value: &usize| headings[place].is_of_the_same(headings[*value]);
            let named = values.iter().position(is_same);
            let before = values.iter().position(|&value| value + 1 == place);
            // A bare one after those of other columns is of the last column that has none.
            let open = || found.iter().rposition(|&(value, of)| value < place && of.is_none());
            let is_bare = headings[place].is_bare_uncertainty();
            let of = if is_bare { before.or_else(open) } else { named.or(before) };
            if let Some(of) = of {
                found[of].1.get_or_insert(place);
            }
        }
        let column = |place: usize| Column::Number(place + 1);
        let value = |(place, of): (usize, Option<usize>)| ValueColumn {
            values: column(place),
            uncertainties: of.map(column),
        };
        found.into_iter().map(value).collect()
    }
}
