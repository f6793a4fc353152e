//! Inferences from a table: sentences for people, and the columns as data for front ends.

use super::Wanted;
use crate::output::field::{Field, Fields};
use crate::output::json;
use libration::internals::InOrder;
use libration_lab::measurement::{Table, TableRoles, Unit};

/// The settings inferred from a table.
#[derive(Clone, Debug, Default)]
pub(crate) struct Inferences {
    pub(crate) sentences: Vec<String>,
    pub(crate) columns: Vec<ReadColumn>,
}

/// A column of a table with its role.
#[derive(Clone, Debug)]
pub(crate) struct ReadColumn {
    /// Number from 1.
    number: usize,
    /// The word of the option for roles.
    role: String,
    /// The index of its quantity among the wanted ones.
    wanted: Option<usize>,
    unit: Option<Unit>,
    is_unit_stated: bool,
    /// Number of periods that each time lasts, of a column of times without a column of such numbers.
    swings: Option<f64>,
}

impl ReadColumn {
    /// All columns with roles, in the order of the table; units are not known here.
    pub(super) fn all(table: &Table, wanted: &[Wanted], roles: &TableRoles) -> Vec<Self> {
        let column = |column, role: &str, wanted| {
            let number = table.index_of(column).ok()? + 1;
            Some(Self {
                number,
                role: role.to_owned(),
                wanted,
                unit: None,
                is_unit_stated: false,
                swings: None,
            })
        };
        let quantities = (0..wanted.len()).filter_map(|index| Some((index, wanted[index].quantity()?)));
        let of_quantities = quantities.zip(&roles.quantities).flat_map(|((index, quantity), columns)| {
            let name = quantity.name;
            let readings = columns.readings.iter().map(move |reading| column(reading, name, Some(index)));
            let uncertainties = columns.uncertainties.iter().map(move |(uncertainty, kind)| {
                let of = |wanted: &Wanted| wanted.uncertainties_of() == Some(index);
                column(uncertainty, &format!("{name}-{}", kind.word()), wanted.iter().position(of))
            });
            readings.chain(uncertainties).collect::<Vec<_>>()
        });
        let others = [("swings", &roles.swings), ("readings", &roles.readings), ("group", &roles.group)];
        let others = others.into_iter().map(|(role, chosen)| column(chosen.as_ref()?, role, None));
        let unused = roles.unused.iter().map(|unread| column(unread, "ignore", None));
        let mut all: Vec<Self> = of_quantities.chain(others).chain(unused).flatten().collect();
        all.put_in_order_by(|read| read.number);
        all
    }

    /// The column with the unit of its quantity, whether a header states it, and the number of swings in times without a column of numbers.
    pub(super) fn with_units<const N: usize>(
        &self,
        wanted: &[Wanted; N],
        units: [(Unit, bool); N],
        counts: Option<[f64; N]>,
    ) -> Self {
        let Some(index) = self.wanted else { return self.clone() };
        let (unit, is_unit_stated) = units[index];
        let swings = counts.filter(|_| wanted[index].counted.is_some()).map(|counts| counts[index]);
        Self { unit: Some(unit), is_unit_stated, swings, ..self.clone() }
    }
}

/// The fields of the columns with their roles.
pub(crate) fn of_columns() -> Fields<ReadColumn> {
    type Of = Field<ReadColumn>;
    Fields::from([
        Of::value("number", "1", "number of the column, from 1", |column| column.number.into()),
        Of::value("role", "", "its role, as --role takes it; ignore if it is not used", |column| {
            column.role.as_str().into()
        }),
        Of::value("unit", "", "unit in which it was read, or null", |column| {
            column.unit.map(|unit| unit.to_string()).into()
        }),
        Of::value("unit_is_stated", "", "true if its header states that unit", |column| {
            column.is_unit_stated.into()
        }),
        Of::value("swings", "1", "number of periods that each of its times lasts, or null", |column| {
            column.swings.map_or(serde_json::Value::Null, json::number)
        }),
    ])
}
