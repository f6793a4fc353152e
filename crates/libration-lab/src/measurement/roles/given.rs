//! Roles of columns that a user gives: `3=period`, `4=period-uncertainty`, `5=ignore`.

use super::{ColumnRole, TableQuantity, UncertaintyKind};
use crate::measurement::table::Table;
use crate::measurement::{Choice, Column, MeasurementError, Suggestion};

/// Roles that are not inferred.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GivenRoles {
    /// Columns with their roles.
    pub roles: Vec<(Column, ColumnRole)>,
    /// `true` if no other column has a role.
    pub are_all: bool,
}

impl ColumnRole {
    /// The role of this word, where these quantities are needed.
    ///
    /// # Errors
    /// A word of no role, with those that would do.
    pub fn parse(word: &str, needed: &[TableQuantity]) -> Result<Self, MeasurementError> {
        let of_quantities = (0..needed.len()).flat_map(|quantity| {
            let of_kind = move |kind: UncertaintyKind| {
                (format!("{}-{}", needed[quantity].name, kind.word()), Self::Uncertainty(quantity, kind))
            };
            [(needed[quantity].name.to_owned(), Self::Reading(quantity))]
                .into_iter()
                .chain(UncertaintyKind::ALL.map(of_kind))
        });
        let others = [
            ("swings", Self::Swings),
            ("readings", Self::Readings),
            ("group", Self::Group),
            ("ignore", Self::Ignored),
        ];
        let all: Vec<(String, Self)> =
            of_quantities.chain(others.map(|(word, role)| (word.to_owned(), role))).collect();
        let entry = all.iter().find(|(name, _)| name.eq_ignore_ascii_case(word.trim()));
        entry.map(|(_, role)| *role).ok_or_else(|| MeasurementError::NoSuch {
            what: "role",
            asked: word.trim().to_owned(),
            available: all.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>().join(", "),
        })
    }
}

impl GivenRoles {
    /// The given role of each column.
    pub(super) fn places(
        &self,
        table: &Table,
        needed: &[TableQuantity],
    ) -> Result<Vec<Option<ColumnRole>>, MeasurementError> {
        let rest = self.are_all.then_some(ColumnRole::Ignored);
        let mut roles = vec![rest; table.width()];
        for (column, role) in &self.roles {
            roles[table.sheet().index_of(column)?] = Some(*role);
        }
        for (quantity, named) in needed.iter().enumerate() {
            let of_quantity = |role: &&Option<ColumnRole>| matches!(role, Some(ColumnRole::Uncertainty(of, _)) if *of == quantity);
            if roles.iter().filter(of_quantity).count() > 1 {
                let question = format!("two columns are uncertainties of the {}", named.name);
                let choices = vec![Suggestion::new(Choice::Role, "COLUMN=ignore")];
                return Err(MeasurementError::Undecided { question, choices });
            }
        }
        Ok(roles)
    }
}
