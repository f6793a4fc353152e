//! Roles of the columns of a table: given by `--columns` and `--role`, else inferred from headings, units, values and neighbours.

use super::inferences::{Inferences, ReadColumn};
use super::table_rows::RowOptions;
use super::undecided::what_would_decide;
use super::{AmplitudeUnit, CountedOptions, LengthUnit, Wanted, optional_column};
use crate::call::in_words;
use crate::query_error::{QueryError, option};
use libration_lab::measurement::{
    Column, ColumnRole, GivenRoles, MeasurementError, QuantityColumns, Table, TableQuantity, TableRoles,
    UncertaintyKind,
};

/// Options for the columns of two quantities, their uncertainties, and further columns.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct ColumnsOption {
    /// Columns of both quantities, of the uncertainties of both, and of further ones, by number or name; - for none [default: from
    /// headings, units and values]
    #[arg(long, value_name = "COLUMN,…", value_delimiter = ',')]
    columns: Vec<String>,
    /// Role of a column: a quantity, as in 2=period (several columns are repeated readings); its uncertainty, as in 3=period-uncertainty, period-half-width, period-resolution or, of means of several readings, period-deviation; swings, readings, group, ignore
    #[arg(long, value_name = "COLUMN=ROLE", conflicts_with = "columns")]
    role: Vec<String>,
    #[command(flatten)]
    rows: RowOptions,
}

/// The option for a column of groups.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct GroupOption {
    /// Column of the names of groups, whose results are compared and averaged [default: a column named so in the header]
    #[arg(long, value_name = "COLUMN", value_parser = super::table::column)]
    pub(crate) group: Option<Column>,
}

/// Chosen columns, in the order of the wanted quantities.
#[derive(Clone, Debug)]
pub(crate) struct ChosenColumns<const N: usize> {
    /// Columns of each quantity, or the one of its uncertainties.
    pub(super) columns: [Vec<Column>; N],
    /// Kinds of the uncertainties.
    pub(super) kinds: [UncertaintyKind; N],
    /// `true` for quantities whose columns contain squares.
    pub(super) are_squares: [bool; N],
    /// Numbers of swings of a reading by a column of quotients.
    pub(super) swings: [Option<f64>; N],
    pub(super) column_of_swings: Option<Column>,
    /// Column of the numbers of readings of which the values are means.
    pub(super) column_of_readings: Option<Column>,
    pub(super) column_of_groups: Option<Column>,
    /// Inferences, and columns that are not used.
    pub(super) notes: Vec<String>,
    /// The columns with their roles.
    pub(super) roles: Vec<ReadColumn>,
    /// The rows that are used.
    pub(super) rows: RowOptions,
    /// `true` if an option names all, which wins over the names in the header.
    pub(super) is_said: bool,
}

impl<const N: usize> ChosenColumns<N> {
    /// The first column at the position of a wanted quantity.
    pub(crate) fn column(&self, index: usize) -> Option<&Column> {
        self.columns[index].first()
    }
}

impl ColumnsOption {
    /// The option with these roles of columns, and the same rows.
    pub(crate) fn with_roles(&self, role: Vec<String>) -> Self {
        Self { columns: vec![], role, rows: self.rows.clone() }
    }

    /// The first of the columns that are named in the order of the quantities.
    pub(crate) fn first(&self) -> Option<Column> {
        optional_column(self.columns.first()?)
    }

    /// Returns `true` if an option names columns or roles.
    pub(crate) fn are_given(&self) -> bool {
        !self.columns.is_empty() || !self.role.is_empty()
    }

    /// Returns `true` if a column is given the role of this name.
    pub(crate) fn gives_role(&self, name: &str) -> bool {
        self.role.iter().any(|role| role.rsplit_once('=').is_some_and(|(_, role)| role.trim() == name))
    }

    /// The columns in the order of the wanted quantities, the values of two quantities first.
    pub(crate) fn choose<const N: usize>(
        &self,
        file: &str,
        table: &Table,
        wanted: &[Wanted; N],
        group: Option<&Column>,
    ) -> Result<ChosenColumns<N>, QueryError> {
        let no_result = |reason: String| QueryError::no_result(file, reason);
        let quantities: Vec<TableQuantity> = wanted.iter().filter_map(|column| column.quantity()).collect();
        if self.columns.is_empty() && self.role.is_empty() && table.names().is_empty() && table.width() > 2 {
            let width = table.width();
            return Err(no_result(format!(
                "the table has {width} columns and no header: choose them by <--columns>, or give each a <--role>"
            )));
        }
        let mut given = match self.columns.len() {
            0 => self.given(&quantities)?,
            count if (2..=N).contains(&count) => self.said(wanted, &quantities)?,
            number => {
                let reason = format!("{number} columns given: name 2 to {N}, as in 1,2,-,3");
                return Err(QueryError::usage(option("columns"), reason));
            }
        };
        given.roles.extend(group.map(|column| (column.clone(), ColumnRole::Group)));
        let roles = table.roles(&quantities, &given).map_err(|error| no_result(refusal(&error)))?;
        Ok(chosen(table, wanted, &roles, !self.columns.is_empty(), self.rows.clone()))
    }

    /// The roles by `--role`.
    fn given(&self, quantities: &[TableQuantity]) -> Result<GivenRoles, QueryError> {
        let usage = |reason: String| QueryError::usage(option("role"), reason);
        let pair = |text: &String| {
            let parts = text.rsplit_once('=').filter(|(column, _)| !column.trim().is_empty());
            let (column, role) = parts.ok_or_else(|| {
                usage(format!("`{text}` is not a role: give COLUMN=ROLE, such as 3=period"))
            })?;
            let role = ColumnRole::parse(role, quantities).map_err(|error| usage(error.to_string()))?;
            Ok((column.parse().unwrap_or_else(|never| match never {}), role))
        };
        let roles = self.role.iter().map(pair).collect::<Result<_, QueryError>>()?;
        Ok(GivenRoles { roles, are_all: false })
    }

    /// The roles by `--columns`.
    fn said<const N: usize>(
        &self,
        wanted: &[Wanted; N],
        quantities: &[TableQuantity],
    ) -> Result<GivenRoles, QueryError> {
        let columns: Vec<Option<Column>> = self.columns.iter().map(|text| optional_column(text)).collect();
        if columns[0].is_none() || columns[1].is_none() {
            let names =
                quantities.iter().take(2).map(|quantity| quantity.name).collect::<Vec<_>>().join(" and ");
            let reason = format!("{names} are needed: - stands only for an uncertainty");
            return Err(QueryError::usage(option("columns"), reason));
        }
        let role = |index: usize| match wanted[index].uncertainties_of() {
            Some(of) => ColumnRole::Uncertainty(index_of(wanted, of), UncertaintyKind::Standard),
            None => ColumnRole::Reading(index_of(wanted, index)),
        };
        let roles =
            columns.into_iter().enumerate().filter_map(|(index, column)| Some((column?, role(index))));
        Ok(GivenRoles { roles: roles.collect(), are_all: true })
    }
}

/// Index of the quantity at a position among the wanted ones.
fn index_of<const N: usize>(wanted: &[Wanted; N], index: usize) -> usize {
    wanted[..index].iter().filter(|column| column.uncertainties_of().is_none()).count()
}

/// The columns at the positions of the wanted quantities.
fn chosen<const N: usize>(
    table: &Table,
    wanted: &[Wanted; N],
    roles: &TableRoles,
    is_said: bool,
    rows: RowOptions,
) -> ChosenColumns<N> {
    let of = |index: usize| -> &QuantityColumns {
        &roles.quantities[index_of(wanted, wanted[index].uncertainties_of().unwrap_or(index))]
    };
    let columns = |index: usize| match wanted[index].uncertainties_of() {
        None => of(index).readings.clone(),
        Some(_) => of(index).uncertainties.iter().map(|(column, _)| column.clone()).collect(),
    };
    let kind = |index: usize| {
        of(index).uncertainties.as_ref().map_or(UncertaintyKind::Standard, |uncertainty| uncertainty.1)
    };
    let is_inferred = !is_said;
    ChosenColumns {
        columns: std::array::from_fn(columns),
        kinds: std::array::from_fn(kind),
        are_squares: std::array::from_fn(|index| of(index).are_squares),
        swings: std::array::from_fn(|index| of(index).swings),
        column_of_swings: roles.swings.clone(),
        column_of_readings: roles.readings.clone(),
        column_of_groups: roles.group.clone(),
        notes: if is_inferred { notes(table, wanted, roles) } else { vec![] },
        roles: ReadColumn::all(table, wanted, roles),
        rows,
        is_said,
    }
}

/// A fit to a table whose headings name both of its quantities.
#[derive(Clone, Debug)]
pub(crate) struct TableFit {
    /// Words of the command.
    pub(crate) command: &'static str,
    /// Roles of the columns, or the reasons why they are undecided.
    pub(crate) read_as: Inferences,
}

impl TableFit {
    /// The fit of periods against lengths or amplitudes, where the headings name both.
    pub(crate) fn of(table: &Table) -> Option<Self> {
        let periods = Wanted::periods(CountedOptions::default());
        let lengths = Wanted::lengths(None::<LengthUnit>);
        let amplitudes = Wanted::amplitudes(None::<AmplitudeUnit>);
        [("fit lengths", lengths), ("fit periods", amplitudes)].into_iter().find_map(|(command, first)| {
            let wanted = [first, periods, first.uncertainties(0), periods.uncertainties(1)];
            let quantities: Vec<TableQuantity> =
                wanted.iter().filter_map(|column| column.quantity()).collect();
            let roles = table.roles(&quantities, &GivenRoles::default()).ok()?;
            let are_named = quantities
                .iter()
                .zip(&roles.quantities)
                .all(|(quantity, columns)| table.heads(quantity, columns));
            let are_periods = are_named && !begins_at_zero(table, &roles.quantities[1].readings);
            are_periods.then(|| {
                let columns = ReadColumn::all(table, &wanted, &roles);
                Self { command, read_as: Inferences { sentences: notes(table, &wanted, &roles), columns } }
            })
        })
    }
}

/// `true` for times of a recording, which begin at zero, or cells that are not numbers.
fn begins_at_zero(table: &Table, columns: &[Column]) -> bool {
    let read = table.readings(&[columns.to_vec()]);
    let first = read.ok().and_then(|readings| readings.quantities[0].first()?.first().copied());
    first.is_none_or(|first| first <= 0.0)
}

/// The roles that were inferred, as sentences.
fn notes<const N: usize>(table: &Table, wanted: &[Wanted; N], roles: &TableRoles) -> Vec<String> {
    let describe = |columns: &[Column]| {
        columns.iter().filter_map(|column| table.describe(column).ok()).collect::<Vec<_>>().join(", ")
    };
    let quantities = wanted.iter().filter_map(|column| column.quantity()).zip(&roles.quantities);
    let read = quantities.flat_map(|(quantity, columns)| {
        let squares = if columns.are_squares { "squares of the " } else { "" };
        let repeated = if columns.readings.len() > 1 { " as repeated readings" } else { "" };
        let values = format!("read as {squares}{}{repeated}: {}", quantity.name, describe(&columns.readings));
        let of_kind = |(column, kind): &(Column, UncertaintyKind)| {
            let column = describe(std::slice::from_ref(column));
            format!("read as {} of the {}: {column}", described(*kind), quantity.name)
        };
        let values = (!columns.readings.is_empty()).then_some(values);
        values.into_iter().chain(columns.uncertainties.as_ref().map(of_kind)).collect::<Vec<_>>()
    });
    let other = |name: &str, column: &Option<Column>| {
        column.as_ref().map(|column| format!("read as {name}: {}", describe(std::slice::from_ref(column))))
    };
    let unused = (!roles.unused.is_empty())
        .then(|| format!("not used: {} (<--role> gives a column another role)", describe(&roles.unused)));
    read.chain(other("numbers of swings", &roles.swings))
        .chain(other("numbers of readings", &roles.readings))
        .chain(other("groups", &roles.group))
        .chain(roles.notes.iter().cloned())
        .chain(unused)
        .map(|note| in_words(&note))
        .collect()
}

fn described(kind: UncertaintyKind) -> &'static str {
    match kind {
        UncertaintyKind::Standard => "standard uncertainty",
        UncertaintyKind::HalfWidth => "half-width",
        UncertaintyKind::Resolution => "resolution",
        UncertaintyKind::Deviation => "standard deviation of single readings",
    }
}

/// The reason of a refusal, with marks of the options.
fn refusal(error: &MeasurementError) -> String {
    match error {
        MeasurementError::TooFewColumns { .. } => error.to_string(),
        _ => what_would_decide(error),
    }
}
