//! Quantities expected in the columns of a table, and their units: from an option, else from the header, else SI units.

use super::CountedOptions;
use libration_lab::measurement::{Column, MeasurementError, Role, Table, TableQuantity, Unit, WrittenUnit};

/// Beginnings of headings of amplitudes where they are not needed.
pub(crate) const AMPLITUDES: &[&str] = &["amplitude", "angle", "theta", "θ", "amplitud", "ampiezza"];

/// The quantity expected in a column, and the options given for it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wanted {
    /// The name of the quantity in roles.
    pub(super) name: &'static str,
    pub(super) role: Role,
    /// Beginnings of headings without which the column is not inferred.
    pub(super) only_named: Option<&'static [&'static str]>,
    /// The option for the unit, and the unit if it is given.
    pub(super) option: Option<(&'static str, Option<Unit>)>,
    /// Index of the column to which these uncertainties belong.
    pub(super) uncertainties_of: Option<usize>,
    /// Options for times that may last several periods.
    pub(super) counted: Option<CountedOptions>,
}

impl Wanted {
    /// Periods, from times that may consist of several periods.
    pub(crate) fn periods(counted: CountedOptions) -> Self {
        Self {
            name: "period",
            only_named: None,
            role: Role::Times,
            option: None,
            uncertainties_of: None,
            counted: Some(counted),
        }
    }

    /// Times, or numbers without a unit, of a name for roles.
    pub(crate) fn times(name: &'static str) -> Self {
        Self {
            name,
            only_named: None,
            role: Role::Times,
            option: None,
            uncertainties_of: None,
            counted: None,
        }
    }

    pub(crate) fn lengths(said: Option<impl Into<Unit>>) -> Self {
        let option = Some(("--length-unit", said.map(Into::into)));
        Self {
            name: "length",
            only_named: None,
            role: Role::Lengths,
            option,
            uncertainties_of: None,
            counted: None,
        }
    }

    pub(crate) fn amplitudes(said: Option<impl Into<Unit>>) -> Self {
        let option = Some(("--amplitude-unit", said.map(Into::into)));
        Self {
            name: "amplitude",
            only_named: None,
            role: Role::Angles,
            option,
            uncertainties_of: None,
            counted: None,
        }
    }

    pub(crate) fn frequencies(said: Option<impl Into<Unit>>) -> Self {
        let option = Some(("--frequency-unit", said.map(Into::into)));
        Self {
            name: "frequency",
            only_named: None,
            role: Role::Frequencies,
            option,
            uncertainties_of: None,
            counted: None,
        }
    }

    pub(crate) fn displacements(said: Option<impl Into<Unit>>) -> Self {
        let option = Some(("--amplitude-unit", said.map(Into::into)));
        Self {
            name: "amplitude",
            only_named: None,
            role: Role::Displacements,
            option,
            uncertainties_of: None,
            counted: None,
        }
    }

    pub(crate) fn phases(said: Option<impl Into<Unit>>) -> Self {
        let option = Some(("--phase-unit", said.map(Into::into)));
        Self {
            name: "phase",
            only_named: None,
            role: Role::Angles,
            option,
            uncertainties_of: None,
            counted: None,
        }
    }

    /// The same, inferred only from a heading that begins like this.
    pub(crate) fn only_named(self, beginnings: &'static [&'static str]) -> Self {
        Self { only_named: Some(beginnings), ..self }
    }

    /// The quantity; `None` for uncertainties.
    pub(super) fn quantity(self) -> Option<TableQuantity> {
        let quantity = TableQuantity { name: self.name, role: self.role, only_named: self.only_named };
        self.uncertainties_of.is_none().then_some(quantity)
    }

    /// Returns `true` if these are amplitudes of a pendulum whose unit neither a heading nor an option states.
    pub(super) fn may_be_degrees(self, is_written: bool) -> bool {
        let are_amplitudes = self.role == Role::Angles && self.name == "amplitude";
        are_amplitudes && self.uncertainties_of.is_none() && !is_written && !self.states_unit()
    }

    /// Returns `true` if an option states the unit.
    pub(super) fn states_unit(self) -> bool {
        self.option.is_some_and(|(_, unit)| unit.is_some())
    }

    pub(super) fn uncertainties_of(self) -> Option<usize> {
        self.uncertainties_of
    }

    /// The uncertainties of the column at this index.
    pub(crate) fn uncertainties(self, of: usize) -> Self {
        Self { uncertainties_of: Some(of), ..self }
    }

    pub(super) fn usual(self) -> Unit {
        match self.role {
            Role::Times => Unit::Second,
            Role::Lengths => Unit::Metre,
            Role::Angles | Role::Displacements => Unit::Radian,
            Role::Frequencies => Unit::RadianPerSecond,
        }
    }

    fn written(self, table: &Table, column: &Column, is_said: bool) -> Result<WrittenUnit, MeasurementError> {
        match self.uncertainties_of {
            Some(_) => table.unit_of_chosen(column, self.role),
            None if is_said => table.unit_of_chosen(column, self.role),
            None => table.unit(column, self.role),
        }
    }

    /// The fraction of the values to which 1 corresponds in a column of relative uncertainties.
    pub(super) fn fraction(self, table: &Table, column: &Column) -> Result<Option<f64>, String> {
        match self.uncertainties_of {
            Some(_) => table.fraction(column).map_err(refusal),
            None => Ok(None),
        }
    }

    /// The unit of a column, with a sentence if it comes from the header.
    pub(super) fn unit(
        self,
        table: &Table,
        column: &Column,
        usual: Unit,
        is_said: bool,
    ) -> Result<(Unit, Option<String>), String> {
        let written = self.written(table, column, is_said).map_err(refusal)?;
        let name = table.describe(column).map_err(refusal)?;
        let said = self.option.and_then(|(option, said)| Some((option, said?)));
        Ok(match (said, written) {
            (Some((option, unit)), WrittenUnit::Known(other)) if unit != other => (
                unit,
                Some(format!("{name} is read in {unit} (<{option}>), not in {other} as its header says")),
            ),
            (Some((_, unit)), _) => (unit, None),
            (None, WrittenUnit::Known(unit)) => (unit, Some(format!("{name} is in {unit}"))),
            (None, WrittenUnit::Nothing)
                if self.role == Role::Frequencies && self.uncertainties_of.is_none() =>
            {
                return Err(format!(
                    "{name} has no unit, and frequencies are in Hz as often as in rad/s: give it by <--frequency-unit>"
                ));
            }
            (None, WrittenUnit::Nothing) => (usual, None),
            (None, WrittenUnit::Unknown(text)) => match self.option {
                Some((option, _)) if self.uncertainties_of.is_none() => {
                    return Err(format!(
                        "{name}: `{text}` is not a known unit of {}: name it by <{option}> if it is one of those, or else convert the \
                         numbers",
                        self.role
                    ));
                }
                None if self.uncertainties_of.is_none() && is_no_unit_of_times(&text) => {
                    return Err(format!(
                        "{name}: `{text}` is not a unit of {}: give a column of periods themselves, in s, ms, us or min",
                        self.role
                    ));
                }
                _ => (usual, Some(format!("{name} is taken in {usual}: `{text}` is not a known unit"))),
            },
        })
    }
}

/// `s²`, `1/s`, and the T0 of a ratio T/T0.
fn is_no_unit_of_times(text: &str) -> bool {
    text.contains(['^', '²', '/']) || ["t0", "t_0", "t₀", "t_{0}"].contains(&text.to_lowercase().as_str())
}

/// The reason of a refusal, with the option that chooses columns.
pub(super) fn refusal(error: MeasurementError) -> String {
    match error {
        MeasurementError::HoldsOther { .. } => format!("{error} (<--columns>)"),
        _ => error.to_string(),
    }
}
