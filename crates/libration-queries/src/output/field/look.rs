//! Look of a field: in a column of a table, or on a line of a sheet.

use super::content::Values;
use crate::output::number;

/// A value as printed below its title, or after it.
pub(super) struct Shown {
    pub(super) title: &'static str,
    pub(super) look: Look,
}

pub(super) enum Look {
    Rounded(usize),
    Short(usize),
    /// An angle, which is in radians otherwise.
    Degrees(usize),
    /// A number followed by its unit.
    WithUnit(usize),
    /// The text at this index among the values.
    Words(usize),
    Numeral(usize),
}

impl Look {
    pub(super) fn is_of_words(&self) -> bool {
        matches!(self, Self::Words(_))
    }

    /// Moves the values of the look after `before` others.
    pub(super) fn behind(&mut self, before: usize) {
        if let Self::Words(index) | Self::Numeral(index) = self {
            *index += before;
        }
    }

    /// The text of a number with this unit, or of the result; `None` if there is no number.
    pub(super) fn text(&self, value: Option<f64>, unit: &str, values: Values<'_>) -> Option<String> {
        match *self {
            Self::Rounded(digits) => value.map(|value| number::rounded(value, digits)),
            Self::Short(digits) => value.map(|value| number::short(value, digits)),
            Self::Degrees(digits) => value.map(|value| number::rounded(value.to_degrees(), digits)),
            Self::WithUnit(digits) => value.map(|value| with_unit(value, unit, digits)),
            Self::Words(index) | Self::Numeral(index) => values(index).to_cell(),
        }
    }
}

fn with_unit(value: f64, unit: &str, digits: usize) -> String {
    match unit {
        "1" => number::rounded(value, digits),
        "s" => number::seconds(value, digits),
        unit => format!("{} {unit}", number::rounded(value, digits)),
    }
}
