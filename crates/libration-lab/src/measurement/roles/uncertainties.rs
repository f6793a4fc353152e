//! Columns of uncertainties and the quantities to which they belong.

use super::kinds::Kind;
use super::{ColumnRole, RoleSearch, UncertaintyKind};
use crate::measurement::heading::words::{is_deviation, without_uncertainty};
use crate::measurement::{Choice, MeasurementError, Role, Suggestion};

impl RoleSearch<'_> {
    /// Assigns columns of uncertainties to quantities: `±` to the column before it, or to the last one before it that has none yet, or to that
    /// of its unit; `u(T)` and `dT` to that of the same name; `T uncertainty` to the only one of which it can be the symbol or the initial. Of two for one quantity the first is
    /// taken. Repeated readings have the uncertainty of their scatter.
    pub(super) fn assign_uncertainties(&mut self) -> Result<(), MeasurementError> {
        let columns: Vec<usize> =
            (0..self.kinds.len()).filter(|&column| self.kind_of(column).is_some()).collect();
        let mut open = vec![];
        for column in columns {
            match self.value_of(column) {
                Some(value) => self.give(column, value),
                None if self.heading(column).is_bare_uncertainty() => {}
                None => open.push(column),
            }
        }
        for (column, value) in self.by_symbols(&open)? {
            self.give(column, value);
        }
        Ok(())
    }

    /// The kind of uncertainty of a column without a role.
    fn kind_of(&self, column: usize) -> Option<UncertaintyKind> {
        match self.kinds[column] {
            _ if self.roles[column].is_some() => None,
            Kind::Uncertainties => Some(UncertaintyKind::Standard),
            Kind::HalfWidths => Some(UncertaintyKind::HalfWidth),
            Kind::Resolutions => Some(UncertaintyKind::Resolution),
            _ => None,
        }
    }

    fn quantity_of(&self, value: usize) -> Option<usize> {
        match self.roles[value] {
            Some(ColumnRole::Reading(quantity)) => Some(quantity),
            _ => None,
        }
    }

    fn has_uncertainties(&self, quantity: usize) -> bool {
        let is_of = |role: &Option<ColumnRole>| matches!(role, Some(ColumnRole::Uncertainty(of, _)) if *of == quantity);
        self.roles.iter().any(is_of)
    }

    fn give(&mut self, column: usize, value: usize) {
        let (Some(quantity), Some(kind)) = (self.quantity_of(value), self.kind_of(column)) else { return };
        let is_of_single = kind == UncertaintyKind::Standard
            && self.kinds[value] != Kind::Squares
            && is_deviation(&self.heading(column).text)
            && self.number_of_readings().is_some();
        let kind = if is_of_single { UncertaintyKind::Deviation } else { kind };
        let is_repeated = self.readings_of(quantity) > 1.0 && kind != UncertaintyKind::Resolution;
        if is_repeated {
            let note = format!(
                "{} is not used: the scatter of the readings is their uncertainty (<--role> {}={}-uncertainty)",
                self.describe(column),
                column + 1,
                self.needed[quantity].name
            );
            self.notes.push(note);
            self.roles[column] = Some(ColumnRole::Ignored);
        } else if !self.has_uncertainties(quantity) {
            self.roles[column] = Some(ColumnRole::Uncertainty(quantity, kind));
        }
    }

    /// The column of values that a heading names, or that is next to it.
    fn value_of(&self, column: usize) -> Option<usize> {
        let values = || {
            (0..self.kinds.len())
                .filter(|&index| matches!(self.kinds[index], Kind::Values | Kind::Means | Kind::Squares))
        };
        let heading = self.heading(column);
        // `None` for an uncertainty with a unit and values without one.
        let fits = |value: &usize| match (heading.unit, &self.heading(*value)) {
            (Some(unit), of) if of.unit.is_some() => Some(of.unit.is_some_and(|of| unit.measures_as(of))),
            (Some(_), of) if of.unit_text.is_none() => None,
            _ => Some(true),
        };
        let before = values().find(|value| value + 1 == column && fits(value) != Some(false));
        if heading.is_bare_uncertainty() {
            // A bare one after those of other columns is of the last column that has none, unless its unit is that of another one only.
            let is_open =
                |value: &usize| self.quantity_of(*value).is_some_and(|of| !self.has_uncertainties(of));
            let mut earlier =
                values().filter(|value| *value < column && is_open(value) && fits(value) != Some(false));
            let before = before.or_else(|| earlier.next_back());
            let of_unit = || {
                heading.unit.and_then(|_| values().find(|value| is_open(value) && fits(value) == Some(true)))
            };
            return before.filter(|value| fits(value).is_some()).or_else(of_unit).or(before);
        }
        let same = || values().filter(|&value| heading.is_of_the_same(self.heading(value)));
        // T may be a period next to times t.
        let written = heading.uncertainty_of.as_ref().unwrap_or(&heading.name);
        let same = same().find(|&value| self.heading(value).name == *written).or_else(|| same().next());
        same.or_else(|| before.filter(|_| self.candidates(column).is_empty()))
    }

    /// The columns of readings of which a name can be the symbol or the initial.
    fn candidates(&self, candidate: usize) -> Vec<usize> {
        let heading = self.heading(candidate);
        let (plain, _) = without_uncertainty(heading.uncertainty_of.as_ref().unwrap_or(&heading.name));
        if plain.chars().count() != 1 {
            return vec![];
        }
        let is_of = |column: &usize| {
            let Some(quantity) = self.quantity_of(*column) else { return false };
            let name = self.heading(*column).name.to_lowercase();
            name.starts_with(&plain) || symbols(self.needed[quantity].role).contains(&plain.as_str())
        };
        (0..self.kinds.len()).filter(is_of).collect()
    }

    /// The only assignment of these columns to different columns of readings; an error if there are several.
    fn by_symbols(&self, open: &[usize]) -> Result<Vec<(usize, usize)>, MeasurementError> {
        let open: Vec<usize> =
            open.iter().copied().filter(|&column| !self.candidates(column).is_empty()).collect();
        let mut assignments: Vec<Vec<usize>> = vec![vec![]];
        for &column in &open {
            let longer = |taken: Vec<usize>| {
                let free: Vec<usize> =
                    self.candidates(column).into_iter().filter(|value| !taken.contains(value)).collect();
                free.into_iter().map(move |value| [taken.clone(), vec![value]].concat())
            };
            assignments = assignments.into_iter().flat_map(longer).take(100).collect();
        }
        match &assignments[..] {
            [only] => Ok(open.into_iter().zip(only.iter().copied()).collect()),
            _ => Err(self.undecided(open[0])),
        }
    }

    fn undecided(&self, column: usize) -> MeasurementError {
        let choice = |value: usize| {
            let name = self.quantity_of(value).map_or("", |quantity| self.needed[quantity].name);
            Suggestion::new(Choice::Role, format!("{}={name}-uncertainty", column + 1))
        };
        MeasurementError::Undecided {
            question: format!("{} may belong to several columns", self.describe(column)),
            choices: self.candidates(column).into_iter().map(choice).collect(),
        }
    }
}

/// Usual symbols of a quantity, in lower case.
fn symbols(role: Role) -> &'static [&'static str] {
    match role {
        Role::Times => &["t"],
        Role::Lengths => &["l"],
        Role::Angles | Role::Displacements => &["a", "θ", "ϑ", "φ"],
        Role::Frequencies => &["f", "ω", "ν"],
    }
}
