//! Role of a chosen column, and the information in its heading: a unit, or another quantity.

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
    /// Displacements of any kind: angles, lengths, or readings of an instrument.
    Displacements,
}

/// The unit that is written over a column.
#[derive(Clone, Debug, PartialEq)]
pub enum WrittenUnit {
    /// No unit.
    Nothing,
    /// A unit that fits the role of the column.
    Known(Unit),
    /// A text in place of a unit, as written.
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

/// Names in lower case in tables of results, other than those in recordings.
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
            "svingningstid",
            "heilahdusaika",
            "perioda",
            "lengésidő",
            "periyot",
            "περίοδος",
            "период",
            "період",
            "perioadă",
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
            "længde",
            "lengde",
            "pituus",
            "délka",
            "dĺžka",
            "hossz",
            "uzunluk",
            "μήκος",
            "длина",
            "довжина",
            "lungime",
            "duljina",
            "dolžina",
        ],
    ),
    (Role::Angles, &["amplitude", "amplitudes", "ampiezza", "amplitud", "amplituda", "амплитуда"]),
];

impl Role {
    /// Quantity of the column according to its heading, if it is not this role.
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

    /// Returns `true` if the heading gives the column this role by its unit or, without one, by its name.
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

/// Returns `true` for a name of lengths, perhaps with other words: `L`, `Pendellänge l`.
pub(super) fn is_name_of_length(name: &str) -> bool {
    let name = name.to_lowercase();
    let names = NAMES.iter().filter(|(role, _)| *role == Role::Lengths).flat_map(|(_, names)| names.iter());
    names.into_iter().any(|of| name == **of || of.chars().count() > 1 && name.contains(of))
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
