//! Times, numbers of swings, periods and amplitudes among the columns of a table, by their names.

use libration_lab::measurement::{Column, Table};
use std::fmt;

/// The quantity that the amplitudes are measured against.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Against {
    Time,
    Swings,
}

/// Names of numbers of swings, in lower case.
const NUMBERS: [&str; 18] = [
    "n",
    "no",
    "no.",
    "nr",
    "k",
    "i",
    "number",
    "count",
    "swing",
    "swings",
    "cycle",
    "cycles",
    "oscillation",
    "oscillations",
    "period number",
    "swing number",
    "number of swings",
    "number of oscillations",
];
/// Names of times, in lower case.
const TIMES: [&str; 6] = ["t", "time", "zeit", "temps", "tiempo", "tempo"];

/// The quantity that the name of a column says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Named {
    Position(Against),
    Period,
    Other,
}

/// The columns by their names: positions, amplitudes, both uncertainties, numbers of swings, periods.
#[derive(Clone, Debug)]
pub(super) struct Roles {
    columns: [Option<usize>; 6],
    against: Against,
}

impl Roles {
    /// Finds the columns; `None` where no name of a position is known, or no column is left for the amplitudes.
    pub(super) fn of(table: &Table) -> Option<Self> {
        let values = table.value_columns();
        let find = |kind: Named| values.iter().find(|it| named(table, &it.values) == kind);
        let [time, swings] = [Against::Time, Against::Swings].map(|kind| find(Named::Position(kind)));
        let (position, amplitude) = (time.or(swings)?, find(Named::Other)?);
        let [of_position, of_amplitude] =
            [position, amplitude].map(|it| it.uncertainties.as_ref().and_then(number));
        Some(Self {
            columns: [
                number(&position.values),
                number(&amplitude.values),
                of_position,
                of_amplitude,
                time.and(swings).and_then(|it| number(&it.values)),
                find(Named::Period).and_then(|it| number(&it.values)),
            ],
            against: if time.is_some() { Against::Time } else { Against::Swings },
        })
    }

    /// The columns as an option names them.
    pub(super) fn texts(&self) -> Vec<String> {
        self.columns.iter().map(|it| it.map_or("-".to_owned(), |number| number.to_string())).collect()
    }

    pub(super) fn against(&self) -> Against {
        self.against
    }
}

fn number(column: &Column) -> Option<usize> {
    match column {
        Column::Number(number) => Some(*number),
        Column::Name(_) => None,
    }
}

/// The columns in a sentence.
impl fmt::Display for Roles {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let position = if self.against == Against::Time { "times" } else { "numbers of swings" };
        let of_position = format!("uncertainties of the {position}");
        let names = [
            position,
            "amplitudes",
            &of_position,
            "uncertainties of the amplitudes",
            "numbers of swings",
            "periods",
        ];
        let found = self.columns.iter().zip(names);
        let found = found.filter_map(|(column, name)| Some(format!("{name} in column {}", (*column)?)));
        f.write_str(&found.collect::<Vec<_>>().join(", "))
    }
}

/// The position that the name of a column says; `None` where it says another quantity or nothing.
pub(super) fn against(table: &Table, column: &Column) -> Option<Against> {
    match named(table, column) {
        Named::Position(against) => Some(against),
        Named::Period | Named::Other => None,
    }
}

fn named(table: &Table, column: &Column) -> Named {
    let header = match column {
        Column::Number(number) => table.names().get(number - 1).map_or("", String::as_str),
        Column::Name(name) => name,
    };
    let name = header.split(['(', '[', '/', ',', '_']).next().unwrap_or_default().trim();
    let lower = name.to_lowercase();
    match () {
        () if name == "T" || lower == "period" => Named::Period,
        () if TIMES.contains(&lower.as_str()) => Named::Position(Against::Time),
        () if NUMBERS.contains(&lower.as_str()) => Named::Position(Against::Swings),
        () => Named::Other,
    }
}
