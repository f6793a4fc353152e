//! The columns of a table that hold values, each with that of its uncertainties.

use super::Column;
use super::heading::Heading;
use super::table::Table;

/// A column of values.
#[derive(Clone, Debug, PartialEq)]
pub struct ValueColumn {
    /// The column.
    pub values: Column,
    /// That of their uncertainties.
    pub uncertainties: Option<Column>,
}

impl Table {
    /// The columns of values with those of their uncertainties, as the header says which are which: `±` belongs to the column
    /// before it, `u(T)` to that of the same name, or else to the one before it. None where the header speaks of no uncertainty,
    /// or where two would belong to one column.
    ///
    /// # Examples
    /// ```
    /// use libration_lab::measurement::{Column, ReadOptions, Table};
    ///
    /// let table = Table::read(b"L,+-,T,+-\n0.25,0.01,1.00,0.02\n0.50,0.01,1.42,0.02\n", &ReadOptions::default())?;
    /// let columns = table.value_columns().unwrap();
    /// assert_eq!(columns[1].values, Column::Number(3));
    /// assert_eq!(columns[1].uncertainties, Some(Column::Number(4)));
    /// # Ok::<(), libration_lab::measurement::MeasurementError>(())
    /// ```
    #[must_use]
    pub fn value_columns(&self) -> Option<Vec<ValueColumn>> {
        let headings: Vec<&Heading> = self.sheet().channels.iter().map(|channel| &channel.heading).collect();
        let values: Vec<usize> =
            (0..headings.len()).filter(|&place| !headings[place].is_uncertainty).collect();
        let mut found: Vec<(usize, Option<usize>)> = values.iter().map(|&place| (place, None)).collect();
        for place in (0..headings.len()).filter(|&place| headings[place].is_uncertainty) {
            let is_same = |value: &usize| headings[place].is_of_the_same(headings[*value]);
            let named = values.iter().position(is_same);
            let before = values.iter().position(|&value| value + 1 == place);
            let of = if headings[place].is_bare_uncertainty() { before } else { named.or(before) };
            let (_, uncertainties) = &mut found[of?];
            if uncertainties.replace(place).is_some() {
                return None;
            }
        }
        let column = |place: usize| Column::Number(place + 1);
        let is_told = values.len() < headings.len();
        is_told.then(|| {
            found
                .into_iter()
                .map(|(place, of)| ValueColumn { values: column(place), uncertainties: of.map(column) })
                .collect()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::ReadOptions;
    use super::*;

    fn found(header: &str) -> Option<Vec<(usize, Option<usize>)>> {
        let row = vec!["1.5"; header.split(',').count()].join(",");
        let table =
            Table::read(format!("{header}\n{row}\n{row}\n").as_bytes(), &ReadOptions::default()).unwrap();
        let number = |column: &Column| match column {
            Column::Number(number) => *number,
            Column::Name(_) => 0,
        };
        let pair = |it: &ValueColumn| (number(&it.values), it.uncertainties.as_ref().map(number));
        Some(table.value_columns()?.iter().map(pair).collect())
    }

    #[test]
    fn uncertainties_go_with_the_values_that_their_headings_name() {
        for (header, expected) in [
            ("A,±,T,±", vec![(1, Some(2)), (3, Some(4))]),
            ("A (deg),T (s),error (s)", vec![(1, None), (2, Some(3))]),
            ("A,T,u(A),u(T)", vec![(1, Some(3)), (2, Some(4))]),
            ("L,T,σ_T", vec![(1, None), (2, Some(3))]),
            ("L,10T,u(10T)", vec![(1, None), (2, Some(3))]),
        ] {
            assert_eq!(found(header), Some(expected), "{header}");
        }
        assert_eq!(found("A,T"), None);
        assert_eq!(found("±,A,T"), None);
        assert_eq!(found("T,u(T),σ_T"), None);
    }
}
