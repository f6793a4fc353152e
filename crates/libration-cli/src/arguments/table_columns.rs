//! Which columns of a table are meant: said by `--columns`, else inferred from the header, else the first ones.

use super::optional_column;
use crate::failure::Failure;
use libration_lab::measurement::{Column, Table};

/// The columns of two quantities, of the uncertainties of both, and of what else there may be.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct ColumnsOption {
    /// Columns of both quantities, of the uncertainties of both, and of further ones, by number or name; - for none [default: by the header, else 1,2 or 1,2,3,4]
    #[arg(long, value_name = "COLUMN,…", value_delimiter = ',')]
    columns: Vec<String>,
}

impl ColumnsOption {
    /// The columns, in this order: two quantities, their uncertainties, others. `needed` names the first two.
    pub(crate) fn choose<const N: usize>(
        &self,
        file: &str,
        table: &Table,
        needed: &str,
    ) -> Result<[Option<Column>; N], Failure> {
        let first = |count| (1..=count).map(|number| Some(Column::Number(number))).collect();
        let told = by_header(table).filter(|columns| columns.len() <= N);
        let columns: Vec<Option<Column>> = match (self.columns.len(), told, table.width()) {
            (0, Some(columns), _) => columns,
            (0, None, 3) if N == WITH_THIRD && table.names().get(2).is_some_and(|name| is_phase(name)) => {
                [first(2), vec![None, None, Some(Column::Number(3))]].concat()
            }
            (0, None, 2) => first(2),
            (0, None, 4..) => first(4),
            (0, None, width) => {
                let reason = format!("the table has {width} columns, not 2 or 4: say which with --columns");
                return Err(Failure::no_answer(file, reason));
            }
            (given, ..) if (2..=N).contains(&given) => {
                self.columns.iter().map(|text| optional_column(text)).collect()
            }
            (given, ..) => {
                let reason = format!("{given} columns given: name 2 to {N}, as in 1,2,-,3");
                return Err(Failure::usage("--columns", reason));
            }
        };
        if columns[0].is_none() || columns[1].is_none() {
            let reason = format!("{needed} are needed: - stands only for an uncertainty");
            return Err(Failure::usage("--columns", reason));
        }
        Ok(std::array::from_fn(|index| columns.get(index).cloned().flatten()))
    }
}

/// Of three quantities and their uncertainties.
const WITH_THIRD: usize = 6;

fn is_phase(name: &str) -> bool {
    let name = name.to_lowercase();
    ["phase", "lag", "phi", "φ"].iter().any(|word| name.starts_with(word))
}

/// Two columns of values, and what the header says are their uncertainties; then perhaps a third with its own.
fn by_header(table: &Table) -> Option<Vec<Option<Column>>> {
    let columns = table.value_columns()?;
    let (both, third) = columns.split_at_checked(2)?;
    let [first, second] = both else { return None };
    let mut found: Vec<Option<Column>> = [first, second].map(|it| Some(it.values.clone())).to_vec();
    found.extend([first, second].map(|it| it.uncertainties.clone()));
    match third {
        [] => Some(found),
        [third] => {
            found.extend([Some(third.values.clone()), third.uncertainties.clone()]);
            Some(found)
        }
        _ => None,
    }
}
