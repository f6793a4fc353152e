//! The column with the number of readings of which each row holds the mean and the standard deviation.

use super::kinds::{Kind, is_of_counts};
use super::questions::is_named_period;
use super::{ColumnRole, RoleSearch, UncertaintyKind};
use crate::measurement::counted_periods::{SwingNumbers, counted, swing_numbers};
use crate::measurement::heading::Heading;
use crate::measurement::{Choice, CountedPeriods, MeasurementError, Role, Suggestion};

impl RoleSearch<'_> {
    /// The index of the column of numbers of readings: a given one, one with such a name, or one named `n` next to periods, which are not times of
    /// n swings.
    pub(super) fn number_of_readings(&self) -> Option<usize> {
        let given = self.with_role(ColumnRole::Readings).first().copied();
        let open = || (0..self.kinds.len()).filter(|&column| self.roles[column].is_none());
        let named = || open().find(|&column| self.kinds[column] == Kind::NumbersOfReadings);
        let is_bare = |column: &usize| {
            self.kinds[*column] == Kind::Swings
                && swing_numbers(&self.heading(*column).text) == SwingNumbers::Possible
                && is_of_counts(&self.table.sheet().channels[*column])
        };
        let are_swings = !self.with_role(ColumnRole::Swings).is_empty();
        let bare = || open().find(is_bare).filter(|_| self.says_swings() && !are_swings);
        given.or_else(named).or_else(bare)
    }

    /// Returns `true` if a column of readings is headed as a period, and not as a time.
    pub(super) fn has_named_periods(&self) -> bool {
        self.has_times(is_named_period)
    }

    /// Returns `true` if a heading states the number of swings of its times: `T`, `10T`.
    fn says_swings(&self) -> bool {
        self.has_times(|heading| matches!(counted(&heading.text), CountedPeriods::Said(_)))
    }

    fn has_times(&self, is_so: impl Fn(&Heading) -> bool) -> bool {
        let is_time = |column: usize| match self.roles[column] {
            Some(ColumnRole::Reading(of)) => {
                self.needed[of].role == Role::Times && is_so(self.heading(column))
            }
            _ => false,
        };
        (0..self.kinds.len()).any(is_time)
    }

    /// Gives the column its role where standard deviations need it.
    pub(super) fn assign_number_of_readings(&mut self) -> Result<(), MeasurementError> {
        let is_deviation = |role: &Option<ColumnRole>| {
            matches!(role, Some(ColumnRole::Uncertainty(_, UncertaintyKind::Deviation)))
        };
        let Some(column) = self.roles.iter().position(is_deviation) else { return Ok(()) };
        let Some(number) = self.number_of_readings() else {
            let choices = vec![Suggestion::new(Choice::Role, "COLUMN=readings")];
            let question = format!(
                "{} holds standard deviations of single readings, whose number is needed",
                self.describe(column)
            );
            return Err(MeasurementError::Undecided { question, choices });
        };
        self.roles[number] = Some(ColumnRole::Readings);
        Ok(())
    }
}
