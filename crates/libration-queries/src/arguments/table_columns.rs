//! Choice of the columns of a table: given by `--columns`, else inferred from the header, else the first ones.

use super::optional_column;
use crate::query_error::{QueryError, option};
use libration_lab::measurement::{Column, Table};

/// The columns of two quantities, of the uncertainties of both, and of what else there may be.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct ColumnsOption {
    /// Columns of both quantities, of the uncertainties of both, and of further ones, by number or name; - for none [default: the first two of values, with the uncertainties that the header names]
    #[arg(long, value_name = "COLUMN,…", value_delimiter = ',')]
    columns: Vec<String>,
}

/// Chosen columns, in the order of what is wanted.
#[derive(Clone, Debug)]
pub(crate) struct ChosenColumns<const N: usize> {
    pub(super) columns: [Option<Column>; N],
    /// Columns that are not used, where they were not chosen by an option.
    pub(super) note: Option<String>,
    /// `true` if an option names them, which wins over the names in the header.
    pub(super) is_said: bool,
}

impl<const N: usize> ChosenColumns<N> {
    /// The column of the first quantity.
    pub(crate) fn first(&self) -> Option<&Column> {
        self.columns[0].as_ref()
    }
}

impl ColumnsOption {
    /// The option with these columns.
    pub(crate) fn of(columns: Vec<String>) -> Self {
        Self { columns }
    }

    /// Returns whether the option names columns.
    pub(crate) fn are_given(&self) -> bool {
        !self.columns.is_empty()
    }

    /// The columns, in this order: two quantities, their uncertainties, others. `needed` names the first two.
    pub(crate) fn choose<const N: usize>(
        &self,
        file: &str,
        table: &Table,
        needed: &str,
    ) -> Result<ChosenColumns<N>, QueryError> {
        match self.columns.len() {
            0 if table.names().is_empty() && table.width() > 2 => {
                let width = table.width();
                let reason =
                    format!("the table has {width} columns and no header: choose them by <--columns>");
                Err(QueryError::no_result(file, reason))
            }
            0 => inferred(table).ok_or_else(|| {
                let width = table.width();
                let reason = format!("{needed} are needed, and the table has {width} column of numbers");
                QueryError::no_result(file, reason)
            }),
            given if (2..=N).contains(&given) => self.said(needed),
            given => {
                let reason = format!("{given} columns given: name 2 to {N}, as in 1,2,-,3");
                Err(QueryError::usage(option("columns"), reason))
            }
        }
    }

    fn said<const N: usize>(&self, needed: &str) -> Result<ChosenColumns<N>, QueryError> {
        let columns: Vec<Option<Column>> = self.columns.iter().map(|text| optional_column(text)).collect();
        if columns[0].is_none() || columns[1].is_none() {
            let reason = format!("{needed} are needed: - stands only for an uncertainty");
            return Err(QueryError::usage(option("columns"), reason));
        }
        let columns = std::array::from_fn(|index| columns.get(index).cloned().flatten());
        Ok(ChosenColumns { columns, note: None, is_said: true })
    }
}

/// Number of columns of three quantities and their uncertainties.
const WITH_THIRD: usize = 6;

fn holds_phases(table: &Table, column: &Column) -> bool {
    let Column::Number(number) = column else { return false };
    let name = table.names().get(number - 1).map_or_else(String::new, |name| name.to_lowercase());
    ["phase", "lag", "phi", "φ"].iter().any(|word| name.starts_with(word))
}

/// The first two columns of values, with what the header says are their uncertainties; a third one of phases where that is wanted. No other
/// column is used, as it may as well hold repeated readings.
fn inferred<const N: usize>(table: &Table) -> Option<ChosenColumns<N>> {
    let values = table.value_columns();
    let [first, second, others @ ..] = &values[..] else { return None };
    let third = others.first().filter(|it| N >= WITH_THIRD && holds_phases(table, &it.values));
    let found = [
        Some(&first.values),
        Some(&second.values),
        first.uncertainties.as_ref(),
        second.uncertainties.as_ref(),
        third.map(|it| &it.values),
        third.and_then(|it| it.uncertainties.as_ref()),
    ];
    let columns: [Option<Column>; N] = std::array::from_fn(|index| found.get(index)?.cloned());
    let is_used = |column: &Column| columns.iter().flatten().any(|used| used == column);
    let unused: Vec<String> = (1..=table.width())
        .map(Column::Number)
        .filter(|column| !is_used(column))
        .filter_map(|column| table.describe(&column).ok())
        .collect();
    let note = (!unused.is_empty()).then(|| {
        format!(
            "not used: {}; a column is an uncertainty where its header or --columns says so",
            unused.join(", ")
        )
    });
    Some(ChosenColumns { columns, note, is_said: false })
}
