//! The columns of a table in units of the SI.

use super::column_units::ColumnUnits;
use super::si_rows::SiRows;
use super::{ChosenColumns, ColumnsOption, Inferences, TableFit, Wanted};
use crate::call::in_words;
use crate::query_error::QueryError;
use libration_lab::fit::RepeatedReadings;
use libration_lab::measurement::{Column, Readings, RepeatedRows, Table, Unit};

/// The numbers of chosen columns in units of the SI, in the rows that have them all.
#[derive(Clone, Debug)]
pub(crate) struct ColumnsInSi<const N: usize> {
    /// Values, or means of repeated readings, and standard uncertainties.
    pub(crate) columns: [Option<Vec<f64>>; N],
    /// Repeated readings of the values.
    pub(crate) repeated: [Option<RepeatedReadings>; N],
    /// Standard uncertainties of single values by the rounding to their last digit, row by row.
    pub(crate) rounding: [Vec<f64>; N],
    /// The line each row came from, counted from one.
    pub(crate) lines: Vec<u64>,
    /// Number of incomplete rows.
    pub(crate) dropped: usize,
    /// Standard uncertainties of the periods by the common error of all timings, row by row.
    pub(crate) shared_timing: Option<Vec<f64>>,
    /// Number of periods that the times of each column lasted, where no column numbers them.
    pub(crate) counts: [f64; N],
    /// Names of the groups of the rows.
    pub(crate) groups: Option<Vec<String>>,
    /// Settings inferred from the file.
    pub(crate) inferences: Inferences,
    /// Units in which the columns were read.
    pub(crate) units: [Unit; N],
    /// `true` where the header or an option states the unit.
    pub(crate) are_stated: [bool; N],
}

impl ColumnsOption {
    /// The chosen columns in SI units. A refusal names the fit that suits the headings, if it is not `command`.
    pub(crate) fn read<const N: usize>(
        &self,
        file: &str,
        table: &Table,
        wanted: &[Wanted; N],
        group: Option<&Column>,
        command: &str,
    ) -> Result<ColumnsInSi<N>, QueryError> {
        let read = self.choose(file, table, wanted, group).and_then(|chosen| {
            ColumnsInSi::from_table(table, &chosen, wanted)
                .map_err(|error| QueryError::no_result(file, error))
        });
        read.map_err(|error| match TableFit::of(table).filter(|fit| fit.command != command) {
            Some(fit) => error.with_hint(&format!("the columns are those of <libration {}>", fit.command)),
            None => error,
        })
    }
}

impl<const N: usize> ColumnsInSi<N> {
    /// The columns, with a sentence if they are those of several groups that a fit does not distinguish.
    pub(crate) fn of_all_groups(mut self) -> Self {
        let is_of_several = self.groups.iter().any(|names| names.iter().any(|name| *name != names[0]));
        if is_of_several {
            let text = "all groups are fitted together (<--run> chooses some)";
            self.inferences.sentences.push(in_words(text));
        }
        self
    }

    /// The chosen columns of a table, or the reason why they do not suit the fit.
    pub(crate) fn from_table(
        table: &Table,
        chosen: &ChosenColumns<N>,
        wanted: &[Wanted; N],
    ) -> Result<Self, String> {
        let asked: Vec<Vec<Column>> = chosen
            .columns
            .iter()
            .cloned()
            .chain(
                [&chosen.column_of_swings, &chosen.column_of_readings]
                    .map(|column| column.iter().cloned().collect()),
            )
            .collect();
        let read = table.readings(&asked).map_err(|error| error.to_string())?;
        let labels = |read: &Readings| {
            let labels = chosen.column_of_groups.as_ref().map(|column| table.labels(column, &read.rows));
            labels.transpose().map_err(|error| error.to_string())
        };
        let names = labels(&read)?;
        let (read, repeated_rows) = read.once(names.as_deref());
        let units = ColumnUnits::from_headings(table, chosen, wanted, &read)?;
        let names = labels(&read)?;
        let (read, ignored) = chosen.rows.choose(read, wanted[0], units.units[0], names.as_deref())?;
        let numbers = |index: usize, column: &Option<Column>| -> Option<Vec<f64>> {
            column.as_ref().map(|_| read.quantities[index].iter().map(|reading| reading[0]).collect())
        };
        let swings = numbers(N, &chosen.column_of_swings);
        let numbers_of_readings = numbers(N + 1, &chosen.column_of_readings);
        let rows = SiRows { table, chosen, wanted, units: &units, read: &read, swings, numbers_of_readings };
        let rows = rows.checked()?;
        let repeated: [Option<RepeatedReadings>; N] = std::array::from_fn(|index| rows.repeated(index));
        let groups = labels(&read)?;
        let sheet = table.chosen_sheet().map(|name| format!("sheet `{name}` is read"));
        let of_readings = (0..N).flat_map(|index| rows.described(index, repeated[index].as_ref()));
        let is_repeated =
            |index: usize| wanted[index].uncertainties_of.is_some_and(|of| repeated[of].is_some());
        let of_headings = (0..N).filter_map(|index| rows.described_uncertainty(index, is_repeated(index)));
        let sentences = sheet
            .into_iter()
            .chain(table.notes())
            .chain(repeated_rows.iter().map(repeats))
            .chain(ignored)
            .chain(chosen.notes.iter().cloned())
            .chain(units.inferences.iter().cloned())
            .chain(of_headings)
            .chain(of_readings)
            .collect();
        let stated = std::array::from_fn(|index| (units.units[index], units.are_stated[index]));
        let counts = chosen.column_of_swings.is_none().then_some(units.counts);
        let read_columns = chosen.roles.iter().map(|role| role.with_units(wanted, stated, counts)).collect();
        Ok(Self {
            columns: std::array::from_fn(|index| rows.column(index, &repeated)),
            rounding: std::array::from_fn(|index| rows.rounding(index)),
            shared_timing: (0..N).find_map(|index| rows.shared_timing(index)),
            groups,
            lines: read.lines.clone(),
            dropped: read.dropped,
            counts: units.counts,
            units: units.units,
            are_stated: std::array::from_fn(|index| units.are_stated[index] || wanted[index].states_unit()),
            repeated,
            inferences: Inferences { sentences, columns: read_columns },
        })
    }
}

/// A sentence about rows that repeat others.
fn repeats(rows: &RepeatedRows) -> String {
    match rows {
        RepeatedRows::Passage { lines: [first, last], of: [first_of, last_of] } => {
            format!(
                "lines {first} to {last} repeat lines {first_of} to {last_of}, number by number: they count once"
            )
        }
        RepeatedRows::Each(times) => format!("each row is repeated in {times} lines: it counts once"),
    }
}
