//! The units that are written over the columns of a table.

use super::role::{Role, WrittenUnit, is_name_of_length};
use super::sheet::Sheet;
use super::table::Table;
use super::{Column, MeasurementError, QuantityKind};

impl Table {
    /// The unit in the heading of a column of such values.
    ///
    /// # Errors
    /// No such column; a heading that says that the column holds something else, or uncertainties.
    ///
    /// # Examples
    /// ```
    /// use libration_lab::measurement::{Column, ReadOptions, Role, Table, Unit, WrittenUnit};
    ///
    /// let table = Table::read(b"L (cm),T (s)\n25,1.0\n50,1.4\n", &ReadOptions::default())?;
    /// assert_eq!(table.unit(&Column::Number(1), Role::Lengths)?, WrittenUnit::Known(Unit::Centimetre));
    /// assert!(table.unit(&Column::Number(1), Role::Times).is_err());
    /// # Ok::<(), libration_lab::measurement::MeasurementError>(())
    /// ```
    pub fn unit(&self, column: &Column, role: Role) -> Result<WrittenUnit, MeasurementError> {
        let (sheet, index) = (self.sheet(), self.sheet().index_of(column)?);
        let heading = &sheet.channels[index].heading;
        match role.contradicted_by(heading) {
            _ if heading.is_uncertainty => Err(holds_other(sheet, index, "uncertainties", role)),
            Some(other) => Err(holds_other(sheet, index, other, role)),
            None => Ok(role.unit_written_in(heading)),
        }
    }

    /// The unit in the heading of a column that the user has chosen for such values, whatever its name.
    ///
    /// # Errors
    /// No such column; a unit of something else.
    pub fn unit_of_chosen(&self, column: &Column, role: Role) -> Result<WrittenUnit, MeasurementError> {
        let (sheet, index) = (self.sheet(), self.sheet().index_of(column)?);
        let heading = &sheet.channels[index].heading;
        match role.contradicted_by_unit(heading) {
            Some(other) => Err(holds_other(sheet, index, other, role)),
            None => Ok(role.unit_written_in(heading)),
        }
    }

    /// Returns `true` if the heading of a column says angles, and not a deflection, which may be a length.
    #[must_use]
    pub fn names_angles(&self, column: &Column) -> bool {
        let heading = |index: usize| &self.sheet().channels[index].heading;
        let is_angle = |name: &str| !["auslenkung", "deflection"].contains(&name.to_lowercase().as_str());
        self.sheet()
            .index_of(column)
            .is_ok_and(|index| heading(index).is(QuantityKind::Angle) && is_angle(&heading(index).name))
    }

    /// Returns `true` if the name of a column says lengths of a pendulum, whatever its unit is: `L`, `string length`.
    #[must_use]
    pub fn names_lengths(&self, column: &Column) -> bool {
        let position = self.sheet().index_of(column);
        position.is_ok_and(|index| is_name_of_length(&self.sheet().channels[index].heading.name))
    }

    /// `` column 2 (`Angle`) ``, as messages name it.
    ///
    /// # Errors
    /// No such column.
    pub fn describe(&self, column: &Column) -> Result<String, MeasurementError> {
        self.sheet().index_of(column).map(|index| self.sheet().describe(index))
    }
}

fn holds_other(sheet: &Sheet, column: usize, content: &'static str, role: Role) -> MeasurementError {
    MeasurementError::HoldsOther { column: sheet.describe(column), content, expected: role }
}
