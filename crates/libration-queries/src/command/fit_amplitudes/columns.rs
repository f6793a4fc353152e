//! Times, numbers of swings, periods and amplitudes among the columns of a table, by their names.

use libration_lab::measurement::{
    Column, Heading, QuantityKind, Table, says_number_of_half_swings, says_number_of_swings,
};

/// The quantity that the amplitudes are measured against.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Against {
    Time,
    Swings,
}

/// Names of numbers of swings, in lower case, that may be other numbers elsewhere.
const NUMBERS: [&str; 12] =
    ["n", "no", "no.", "nr", "k", "i", "number", "count", "swing", "cycle", "oscillation", "schwingung"];
/// The quantity named by the heading of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum NamedQuantity {
    Position(Against),
    Period,
    Other,
}

/// The columns of positions, numbers of swings and periods by their names; amplitudes and uncertainties are left to the reader of tables.
#[derive(Clone, Debug)]
pub(super) struct Roles {
    roles: Vec<String>,
    against: Against,
}

impl Roles {
    /// Finds the columns; `None` if no heading names a position.
    pub(super) fn of(table: &Table) -> Option<Self> {
        let columns: Vec<Column> = (1..=table.width()).map(Column::Number).collect();
        let find = |kind: NamedQuantity| {
            columns.iter().position(|column| named(table, column) == kind).map(|index| index + 1)
        };
        let [time, swings] = [Against::Time, Against::Swings].map(|kind| find(NamedQuantity::Position(kind)));
        let roles = [
            (time.or(swings), POSITION),
            (time.and(swings), SWING_NUMBER),
            (find(NamedQuantity::Period), PERIOD),
        ];
        let given = |(column, role): (Option<usize>, &str)| Some(format!("{}={role}", column?));
        time.or(swings)?;
        Some(Self {
            roles: roles.into_iter().filter_map(given).collect(),
            against: if time.is_some() { Against::Time } else { Against::Swings },
        })
    }

    /// The columns as the option for roles names them.
    pub(super) fn texts(&self) -> Vec<String> {
        self.roles.clone()
    }

    pub(super) fn against(&self) -> Against {
        self.against
    }
}

/// Names of the quantities in roles.
pub(super) const POSITION: &str = "position";
pub(super) const SWING_NUMBER: &str = "swing-number";
pub(super) const PERIOD: &str = "period";

/// The position named by the heading of a column; `None` if it names another quantity or nothing.
pub(super) fn against(table: &Table, column: &Column) -> Option<Against> {
    match named(table, column) {
        NamedQuantity::Position(against) => Some(against),
        NamedQuantity::Period | NamedQuantity::Other => None,
    }
}

/// Returns `true` if the heading of a column names numbers of half swings.
pub(super) fn are_half_swings(table: &Table, column: &Column) -> bool {
    says_number_of_half_swings(header(table, column))
}

fn header<'a>(table: &'a Table, column: &'a Column) -> &'a str {
    match column {
        Column::Number(number) => table.names().get(number - 1).map_or("", String::as_str),
        Column::Name(name) => name,
    }
}

fn named(table: &Table, column: &Column) -> NamedQuantity {
    let header = header(table, column);
    let name = header.split(['(', '[', '/', ',', '_']).next().unwrap_or_default().trim();
    let lower = name.to_lowercase();
    match () {
        () if says_number_of_half_swings(header) => NamedQuantity::Position(Against::Swings),
        () if name == "T" || lower == "period" => NamedQuantity::Period,
        () if Heading::read(header, None, None).is(QuantityKind::Time) => {
            NamedQuantity::Position(Against::Time)
        }
        () if NUMBERS.contains(&lower.as_str()) || says_number_of_swings(name) => {
            NamedQuantity::Position(Against::Swings)
        }
        () => NamedQuantity::Other,
    }
}
