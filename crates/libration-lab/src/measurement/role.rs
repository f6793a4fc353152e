//! What a chosen column is to hold, and what its heading says of it: a unit, or something else than it is to hold.

use super::heading::{Heading, Measures};
use super::sheet::Sheet;
use super::table::Table;
use super::{Column, MeasurementError, Quantity, Unit};
use std::fmt;

/// What a chosen column is to hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Times, such as periods.
    Times,
    /// Lengths.
    Lengths,
    /// Angles, such as amplitudes.
    Angles,
}

/// The unit that is written over a column.
#[derive(Clone, Debug, PartialEq)]
pub enum WrittenUnit {
    /// None.
    Nothing,
    /// One of what the column is to hold.
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
        })
    }
}

/// Names in lower case that a table of results has, other than those of recordings.
const NAMES: [(Role, &[&str]); 3] = [
    (Role::Times, &["period", "periods", "half period", "periode", "période", "periodo", "schwingungsdauer"]),
    (Role::Lengths, &["l", "length", "lengths", "länge", "longueur", "lunghezza", "longitud"]),
    (Role::Angles, &["amplitude", "amplitudes", "ampiezza", "amplitud"]),
];

impl Role {
    /// What the heading says the column holds, when that is not this.
    fn contradicted_by(self, heading: &Heading) -> Option<&'static str> {
        let by_unit = heading.unit.and_then(|unit| self.other_than(unit.measures()));
        by_unit.or_else(|| self.contradicted_by_name(heading))
    }

    fn other_than(self, measured: Measures) -> Option<&'static str> {
        match (self, measured) {
            (Self::Times, Measures::Time)
            | (Self::Lengths, Measures::Length)
            | (Self::Angles, Measures::Angle) => None,
            (_, Measures::Time) => Some("times"),
            (_, Measures::Length) => Some("lengths"),
            (_, Measures::Angle) => Some("angles"),
            (_, Measures::AngularVelocity) => Some("angular velocities"),
        }
    }

    fn contradicted_by_name(self, heading: &Heading) -> Option<&'static str> {
        let name = heading.name.to_lowercase().replace('_', " ");
        let named = NAMES.iter().find(|(_, names)| names.contains(&name.as_str())).map(|(role, _)| *role);
        let measured = match (heading.quantity, named) {
            (Quantity::Time, _) | (_, Some(Self::Times)) => Measures::Time,
            (Quantity::Angle, _) | (_, Some(Self::Angles)) => Measures::Angle,
            (Quantity::AngularVelocity, _) => Measures::AngularVelocity,
            (_, Some(Self::Lengths)) => Measures::Length,
            _ => return None,
        };
        self.other_than(measured)
    }

    fn unit_of(self, heading: &Heading) -> WrittenUnit {
        match (heading.unit, &heading.unit_text) {
            (Some(Unit::Count | Unit::Pixel), Some(text)) | (None, Some(text)) => {
                WrittenUnit::Unknown(text.clone())
            }
            (Some(unit), _) => WrittenUnit::Known(unit),
            (None, None) => WrittenUnit::Nothing,
        }
    }
}

impl Table {
    /// The unit that is written over a column of such values.
    ///
    /// # Errors
    /// No such column; a heading that says that the column holds something else, or uncertainties.
    ///
    /// # Examples
    /// ```
    /// use libration_lab::measurement::{Column, Options, Role, Table, Unit, WrittenUnit};
    ///
    /// let table = Table::read(b"L (cm),T (s)\n25,1.0\n50,1.4\n", &Options::default())?;
    /// assert_eq!(table.unit(&Column::Number(1), Role::Lengths)?, WrittenUnit::Known(Unit::Centimetre));
    /// assert!(table.unit(&Column::Number(1), Role::Times).is_err());
    /// # Ok::<(), libration_lab::measurement::MeasurementError>(())
    /// ```
    pub fn unit(&self, column: &Column, role: Role) -> Result<WrittenUnit, MeasurementError> {
        let (sheet, place) = (self.sheet(), self.sheet().place(column)?);
        let heading = &sheet.channels[place].heading;
        match role.contradicted_by(heading) {
            _ if heading.is_uncertainty => Err(holds_other(sheet, place, "uncertainties", role)),
            Some(other) => Err(holds_other(sheet, place, other, role)),
            None => Ok(role.unit_of(heading)),
        }
    }

    /// The unit that is written over a column of uncertainties of such values.
    ///
    /// # Errors
    /// No such column; a heading with a unit or a name of something else.
    pub fn unit_of_uncertainty(&self, column: &Column, role: Role) -> Result<WrittenUnit, MeasurementError> {
        let (sheet, place) = (self.sheet(), self.sheet().place(column)?);
        let heading = &sheet.channels[place].heading;
        match role.contradicted_by(heading) {
            Some(other) => Err(holds_other(sheet, place, other, role)),
            None => Ok(role.unit_of(heading)),
        }
    }

    /// `` column 2 (`Angle`) ``, as messages name it.
    ///
    /// # Errors
    /// No such column.
    pub fn describe(&self, column: &Column) -> Result<String, MeasurementError> {
        self.sheet().place(column).map(|place| self.sheet().describe(place))
    }
}

fn holds_other(sheet: &Sheet, place: usize, found: &'static str, role: Role) -> MeasurementError {
    MeasurementError::HoldsOther { column: sheet.describe(place), found, expected: role }
}
