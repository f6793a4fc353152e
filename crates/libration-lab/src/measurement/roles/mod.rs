//! The roles of the columns of a table: readings of a quantity, their uncertainties, numbers of swings, groups.
//!
//! # Method
//! Roles that are given stay. A quantity takes the columns whose names or units say it; of several the largest set of repeated readings
//! (`readings`), which have one name but for a number and agree within half of each other. A quantity that no heading names takes the
//! first column of values that is left. Columns of uncertainties go with the quantity that their headings name (`uncertainties`); where two
//! assignments are as good, the table is refused. A standard deviation next to a number of readings is that of single ones. Means, squares and other functions of the readings are left out, as are columns of words.

mod given;
mod kinds;
mod number_of_readings;
mod questions;
mod readings;
mod uncertainties;

pub use given::GivenRoles;
use kinds::Kind;

use super::heading::Heading;
use super::role::Role;
use super::table::Table;
use super::{Column, MeasurementError};

/// A quantity that is needed from a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TableQuantity {
    /// The name in options: `length`, `period`.
    pub name: &'static str,
    /// The kind of values in its columns.
    pub role: Role,
    /// If `Some`, the column is taken only if its heading begins with one of these words in lower case.
    pub only_named: Option<&'static [&'static str]>,
}

/// Kind of a written uncertainty.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UncertaintyKind {
    /// A standard uncertainty.
    Standard,
    /// The half-width of an interval in which all values are equally probable.
    HalfWidth,
    /// The step of a display, to which values are rounded.
    Resolution,
    /// The standard deviation of single readings, of which the value is the mean.
    Deviation,
}

impl UncertaintyKind {
    /// The standard uncertainty: a half-width over √3, half a step over √3 (Guide to the Expression of Uncertainty in Measurement, 4.3.7); that of a single
    /// reading where it is a standard deviation.
    ///
    /// # Examples
    /// ```
    /// use libration_lab::measurement::UncertaintyKind;
    /// assert!((UncertaintyKind::Resolution.standard(0.01) - 0.002887).abs() < 1e-6);
    /// ```
    #[must_use]
    pub fn standard(self, written: f64) -> f64 {
        match self {
            Self::Standard | Self::Deviation => written,
            Self::HalfWidth => written / 3.0_f64.sqrt(),
            Self::Resolution => written / 12.0_f64.sqrt(),
        }
    }

    /// All kinds.
    pub(super) const ALL: [Self; 4] = [Self::Standard, Self::HalfWidth, Self::Resolution, Self::Deviation];

    /// The end of its word in options: `uncertainty`, `half-width`, `resolution`, `deviation`.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Standard => "uncertainty",
            Self::HalfWidth => "half-width",
            Self::Resolution => "resolution",
            Self::Deviation => "deviation",
        }
    }
}

/// Role of a column; a quantity is given by its index among those that are needed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnRole {
    /// A reading of a quantity; several columns of one quantity are repeated readings.
    Reading(usize),
    /// The uncertainties of a quantity.
    Uncertainty(usize, UncertaintyKind),
    /// The number of swings that each time of the row lasts.
    Swings,
    /// The number of readings whose mean is the value of the row.
    Readings,
    /// Names of groups, one for each row.
    Group,
    /// Not used.
    Ignored,
}

/// The columns of a quantity.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct QuantityColumns {
    /// The columns of readings, one or more; empty if the table does not have the quantity.
    pub readings: Vec<Column>,
    /// The column of uncertainties.
    pub uncertainties: Option<(Column, UncertaintyKind)>,
    /// `true` if the readings are squares of the quantity.
    pub are_squares: bool,
    /// The number of swings of each reading by a column of their means over that number.
    pub swings: Option<f64>,
}

/// The roles of all columns of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct TableRoles {
    /// Columns of each quantity, in the order in which they are needed.
    pub quantities: Vec<QuantityColumns>,
    /// The column of numbers of swings.
    pub swings: Option<Column>,
    /// The column of numbers of readings, if uncertainties are standard deviations of single ones.
    pub readings: Option<Column>,
    /// The column of names of groups.
    pub group: Option<Column>,
    /// Columns that are not used and that no option names.
    pub unused: Vec<Column>,
    /// Inferences, as sentences without a full stop.
    pub notes: Vec<String>,
}

/// Name of a quantity that times of day can be; periods cannot.
const POSITION: &str = "position";

impl Table {
    /// Infers the roles of the columns from headings, units and values, unless they are given.
    ///
    /// # Errors
    /// Columns whose roles the table leaves open, with the choices that would decide; too few columns of numbers; no such column.
    ///
    /// # Examples
    /// ```
    /// use libration_lab::measurement::{Column, GivenRoles, ReadOptions, Role, Table, TableQuantity};
    ///
    /// let length = TableQuantity { name: "length", role: Role::Lengths, only_named: None };
    /// let period = TableQuantity { name: "period", role: Role::Times, only_named: None };
    /// let text = b"L (m),t1 (s),t2 (s),T^2 (s^2)\n0.25,1.00,1.01,1.01\n0.50,1.42,1.41,2.0\n";
    /// let roles = Table::read(text, &ReadOptions::default())?.roles(&[length, period], &GivenRoles::default())?;
    /// assert_eq!(roles.quantities[1].readings, [Column::Number(2), Column::Number(3)]);
    /// assert_eq!(roles.unused, [Column::Number(4)]);
    /// # Ok::<(), libration_lab::measurement::MeasurementError>(())
    /// ```
    pub fn roles(
        &self,
        needed: &[TableQuantity],
        given: &GivenRoles,
    ) -> Result<TableRoles, MeasurementError> {
        let roles = given.places(self, needed)?;
        let clock =
            if needed.iter().any(|quantity| quantity.name == POSITION) { Kind::Values } else { Kind::Other };
        let kinds = kinds::of(self, clock);
        let mut search = RoleSearch { table: self, needed, kinds, roles, notes: vec![] };
        search.refuse_tables_side_by_side()?;
        search.refuse_bounds()?;
        search.refuse_full_swings()?;
        search.assign_readings()?;
        search.assign_uncertainties()?;
        search.assign_number_of_readings()?;
        search.assign_rest();
        search.refuse_counts_of_periods(given)?;
        Ok(search.assigned())
    }
}

impl Table {
    /// Returns `true` if headings name these columns of a quantity.
    #[must_use]
    pub fn heads(&self, quantity: &TableQuantity, columns: &QuantityColumns) -> bool {
        let first = columns.readings.first().and_then(|column| self.sheet().index_of(column).ok());
        first.is_some_and(|index| {
            columns.are_squares || quantity.role.is_said_by(&self.sheet().channels[index].heading)
        })
    }
}

/// The search for roles, by indices of columns.
struct RoleSearch<'a> {
    table: &'a Table,
    needed: &'a [TableQuantity],
    kinds: Vec<Kind>,
    roles: Vec<Option<ColumnRole>>,
    notes: Vec<String>,
}

impl RoleSearch<'_> {
    fn heading(&self, column: usize) -> &Heading {
        &self.table.sheet().channels[column].heading
    }

    fn describe(&self, column: usize) -> String {
        self.table.sheet().describe(column)
    }

    /// Indices of the columns with this role.
    fn with_role(&self, role: ColumnRole) -> Vec<usize> {
        (0..self.roles.len()).filter(|&column| self.roles[column] == Some(role)).collect()
    }

    /// Returns `true` if a column of values is free.
    fn is_free(&self, column: usize) -> bool {
        self.roles[column].is_none() && self.kinds[column] == Kind::Values
    }

    fn assign_rest(&mut self) {
        for (kind, role) in [(Kind::Swings, ColumnRole::Swings), (Kind::Group, ColumnRole::Group)] {
            if self.with_role(role).is_empty() {
                let free = (0..self.kinds.len())
                    .find(|&index| self.kinds[index] == kind && self.roles[index].is_none());
                if let Some(column) = free {
                    self.roles[column] = Some(role);
                }
            }
        }
    }

    fn assigned(self) -> TableRoles {
        let column = |index: usize| Column::Number(index + 1);
        let columns = |role| self.with_role(role).into_iter().map(column).collect::<Vec<_>>();
        let of_quantity = |quantity: usize| {
            let readings = self.with_role(ColumnRole::Reading(quantity));
            let uncertainties = UncertaintyKind::ALL.into_iter().find_map(|kind| {
                Some((column(*self.with_role(ColumnRole::Uncertainty(quantity, kind)).first()?), kind))
            });
            QuantityColumns {
                are_squares: !readings.is_empty()
                    && readings.iter().all(|&index| self.kinds[index] == Kind::Squares),
                swings: self.swings_by_a_quotient(&readings),
                readings: readings.into_iter().map(column).collect(),
                uncertainties,
            }
        };
        // Empty columns, and those added to others.
        let is_empty = |index: usize| {
            let channel = &self.table.sheet().channels[index];
            channel.count() == 0 && channel.words.is_empty()
        };
        TableRoles {
            quantities: (0..self.needed.len()).map(of_quantity).collect(),
            swings: columns(ColumnRole::Swings).first().cloned(),
            readings: columns(ColumnRole::Readings).first().cloned(),
            group: columns(ColumnRole::Group).first().cloned(),
            unused: (0..self.roles.len())
                .filter(|&index| self.roles[index].is_none() && !is_empty(index))
                .map(column)
                .collect(),
            notes: self.notes,
        }
    }
}
