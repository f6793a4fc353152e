//! Role of a chosen column, and the statements of a heading about it: a unit, or another quantity.

use super::heading::{Heading, Measures};
use super::{QuantityKind, Unit};
use std::fmt;

/// Role of a chosen column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Times, such as periods.
    Times,
    /// Lengths.
    Lengths,
    /// Angles, such as amplitudes.
    Angles,
    /// Frequencies, in turns or radians per time.
    Frequencies,
    /// Displacements of any kind: angles, lengths, or what an instrument makes of them.
    Displacements,
}

/// The unit that is written over a column.
#[derive(Clone, Debug, PartialEq)]
pub enum WrittenUnit {
    /// No unit.
    Nothing,
    /// A unit that fits the role of the column.
    Known(Unit),
    /// Something where a unit would be, as it is written.
    Unknown(String),
}

impl fmt::Display for Role {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::Times => "times",
            Self::Lengths => "lengths",
            Self::Angles => "angles",
            Self::Frequencies => "frequencies",
            Self::Displacements => "displacements",
        })
    }
}

/// Names in lower case that a table of results has, other than those of recordings.
const NAMES: [(Role, &[&str]); 3] = [
    (
        Role::Times,
        &[
            "period",
            "periods",
            "half period",
            "periode",
            "période",
            "periodo",
            "período",
            "schwingungsdauer",
            "periodendauer",
            "okres",
            "slingertijd",
            "trillingstijd",
            "svängningstid",
            "periodtid",
        ],
    ),
    (
        Role::Lengths,
        &[
            "l",
            "length",
            "lengths",
            "länge",
            "longueur",
            "lunghezza",
            "longitud",
            "comprimento",
            "lengte",
            "slingerlengte",
            "längd",
            "długość",
            "pendellänge",
            "fadenlänge",
        ],
    ),
    (Role::Angles, &["amplitude", "amplitudes", "ampiezza", "amplitud", "amplituda"]),
];

impl Role {
    /// Quantity that the column holds by its heading, when that is not this role.
    pub(super) fn contradicted_by(self, heading: &Heading) -> Option<&'static str> {
        self.contradicted_by_unit(heading).or_else(|| self.contradicted_by_name(heading))
    }

    /// The quantity of the unit in the heading, when that is not this.
    pub(super) fn contradicted_by_unit(self, heading: &Heading) -> Option<&'static str> {
        heading.unit.and_then(|unit| self.other_than(unit.measures()))
    }

    fn other_than(self, measured: Measures) -> Option<&'static str> {
        match (self, measured) {
            (Self::Times, Measures::Time)
            | (Self::Lengths, Measures::Length)
            | (Self::Angles, Measures::Angle)
            | (Self::Frequencies, Measures::Frequency | Measures::AngularVelocity)
            | (Self::Displacements, Measures::Angle | Measures::Length) => None,
            (_, Measures::Time) => Some("times"),
            (_, Measures::Length) => Some("lengths"),
            (_, Measures::Angle) => Some("angles"),
            (_, Measures::AngularVelocity) => Some("angular velocities"),
            (_, Measures::Frequency) => Some("frequencies"),
        }
    }

    fn contradicted_by_name(self, heading: &Heading) -> Option<&'static str> {
        named(heading).and_then(|measured| self.other_than(measured))
    }

    /// Returns whether the unit of a heading, or without one its name, says that its column holds this.
    pub(super) fn is_said_by(self, heading: &Heading) -> bool {
        let measured = match (heading.unit, &heading.unit_text) {
            (Some(unit), _) => Some(unit.measures()),
            (None, _) => named(heading),
        };
        measured.is_some_and(|measured| self.other_than(measured).is_none())
    }

    pub(super) fn unit_written_in(self, heading: &Heading) -> WrittenUnit {
        match (heading.unit, &heading.unit_text) {
            (Some(Unit::Count | Unit::Pixel), Some(text)) | (None, Some(text)) => {
                WrittenUnit::Unknown(text.clone())
            }
            (Some(unit), _) => WrittenUnit::Known(unit),
            (None, None) => WrittenUnit::Nothing,
        }
    }
}

/// The quantity of a name.
fn named(heading: &Heading) -> Option<Measures> {
    let name = heading.name.to_lowercase().replace('_', " ");
    let named = NAMES.iter().find(|(_, names)| names.contains(&name.as_str())).map(|(role, _)| *role);
    match (heading.quantity, named) {
        (QuantityKind::Time, _) | (_, Some(Role::Times)) => Some(Measures::Time),
        (QuantityKind::Angle, _) | (_, Some(Role::Angles)) => Some(Measures::Angle),
        (QuantityKind::AngularVelocity, _) => Some(Measures::AngularVelocity),
        (_, Some(Role::Lengths)) => Some(Measures::Length),
        _ => None,
    }
}
