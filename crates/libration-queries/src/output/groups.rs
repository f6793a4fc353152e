//! Results of groups and their weighted mean.

use super::field::{Field, Fields};
use super::json::Record;
use super::table::Column;
use super::{json, number};
use libration_lab::fit::{GroupMean, GroupResult, Uncertain};
use serde_json::Value;
use std::collections::BTreeMap;
use std::io::{self, Write};

/// Results of the groups of one quantity.
#[derive(Clone, Debug)]
pub(crate) struct Groups {
    rows: Vec<GroupRow>,
    mean: Option<GroupMean>,
    names: &'static FieldNames,
}

/// A group with its result, or the reason why there is none.
#[derive(Clone, Debug)]
struct GroupRow {
    name: String,
    rows: usize,
    result: Result<Uncertain, String>,
    stands_out: bool,
}

/// Names of the fields of a quantity: value, uncertainty, expanded, shared.
#[derive(Debug)]
pub(crate) struct FieldNames {
    fields: [&'static str; 4],
    unit: &'static str,
    columns: [&'static str; 2],
}

pub(crate) const GRAVITY: FieldNames = FieldNames {
    fields: [
        "gravity_m_per_s2",
        "gravity_uncertainty_m_per_s2",
        "gravity_expanded_uncertainty_m_per_s2",
        "gravity_shared_uncertainty_m_per_s2",
    ],
    unit: "m/s²",
    columns: ["g / m/s²", "± / m/s²"],
};

pub(crate) const T0: FieldNames = FieldNames {
    fields: ["t0_s", "t0_uncertainty_s", "t0_expanded_uncertainty_s", "t0_shared_uncertainty_s"],
    unit: "s",
    columns: ["T₀ / s", "± / s"],
};

impl Groups {
    /// Fits each group of rows; `shared` is the standard uncertainty of their common errors. `None` for a single group.
    pub(crate) fn fitted(
        groups: &[String],
        names: &'static FieldNames,
        shared: f64,
        fit: impl Fn(&[usize]) -> Result<(Uncertain, f64), String>,
    ) -> Option<Self> {
        let mut members: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
        for (row, group) in groups.iter().enumerate() {
            members.entry(group).or_default().push(row);
        }
        if members.len() < 2 {
            return None;
        }
        let (mut results, mut rows) = (vec![], vec![]);
        for (name, members) in members {
            let name = if name.is_empty() { "without a name" } else { name }.to_owned();
            let outcome = fit(&members);
            if let Ok((value, degrees_of_freedom)) = &outcome {
                let (value, degrees_of_freedom) = (*value, *degrees_of_freedom);
                results.push(GroupResult {
                    name: name.clone(),
                    rows: members.len(),
                    value,
                    degrees_of_freedom,
                });
            }
            let result = outcome.map(|(value, _)| value);
            rows.push(GroupRow { name, rows: members.len(), result, stands_out: false });
        }
        let mean = GroupMean::new(&results, shared);
        let out = mean.as_ref().and_then(|mean| mean.standing_out).map(|index| results[index].name.clone());
        for row in &mut rows {
            row.stands_out = out.as_ref() == Some(&row.name);
        }
        Some(Self { rows, mean, names })
    }

    /// The mean in one line.
    pub(crate) fn line(&self) -> String {
        let Some(mean) = &self.mean else { return "no mean: fewer than two groups have a result".to_owned() };
        let total = mean.total();
        let out = self.rows.iter().find(|row| row.stands_out);
        let out = out.map_or_else(String::new, |row| format!("; {} stands out", row.name));
        format!(
            "{}  (U = {} with 95 %, Birge ratio {}{out})",
            number::with_uncertainty(total.value, total.uncertainty, self.names.unit),
            number::rounded(mean.expanded(), 2),
            number::rounded(mean.scatter.birge_ratio(), 3)
        )
    }

    pub(crate) fn write_table(&self, out: &mut dyn Write) -> io::Result<()> {
        of_row(self.names).write_table(out, &self.rows)
    }

    /// The columns of the groups.
    pub(crate) fn columns(&self) -> Vec<Column> {
        of_row(self.names).columns()
    }

    /// The cells of all groups.
    pub(crate) fn cells(&self) -> Vec<Vec<String>> {
        of_row(self.names).rows(&self.rows)
    }

    /// The record with the groups.
    pub(crate) fn added_to(this: Option<&Self>, names: &'static FieldNames, record: Record) -> Record {
        fields(names).added_to(record, &this)
    }
}

/// The fields of groups, omitted from JSON if there are none.
pub(crate) fn fields<'a>(names: &'static FieldNames) -> Fields<Option<&'a Groups>> {
    type Of<'a> = Field<Option<&'a Groups>>;
    let rows: fn(&Option<&'a Groups>) -> Option<Value> =
        |answer| answer.map(|groups| of_row(groups.names).records(&groups.rows));
    let mean: fn(&Option<&'a Groups>) -> Option<Value> = |answer| {
        let groups = (*answer)?;
        groups.mean.as_ref()?;
        Some(of_mean(groups.names).record(groups).into())
    };
    Fields::from([
        Of::present_nested("groups[].", &of_row(names), rows),
        Of::present_nested("group_mean.", &of_mean(names), mean),
    ])
}

fn of_row(names: &'static FieldNames) -> Fields<GroupRow> {
    type Of = Field<GroupRow>;
    Fields::from([
        Of::value("group", "", "name of the group", |row| row.name.clone().into())
            .words("group", |row| row.name.clone()),
        Of::value("rows", "1", "number of its rows", |row| row.rows.into())
            .numeral("rows", |row| row.rows.to_string()),
        Of::known(names.fields[0], names.unit, "result of its rows", |row| {
            row.result.clone().map(|result| result.value)
        })
        .rounded(names.columns[0], 6)
        .or("–"),
        Of::known(
            names.fields[1],
            names.unit,
            "standard uncertainty by errors that are not common to all groups",
            |row| row.result.clone().map(|result| result.uncertainty),
        )
        .rounded(names.columns[1], 2)
        .or("–"),
        Of::value("stands_out", "", "true if it is farther from the others than chance explains", |row| {
            row.stands_out.into()
        })
        .words("", |row| if row.stands_out { "stands out".to_owned() } else { String::new() }),
    ])
}

fn of_mean(names: &'static FieldNames) -> Fields<Groups> {
    type Of = Field<Groups>;
    fn mean(groups: &Groups, part: fn(&GroupMean) -> f64) -> Option<f64> {
        groups.mean.as_ref().map(part)
    }
    Fields::from([
        Of::nullable(names.fields[0], names.unit, "weighted mean of the groups", |groups| {
            mean(groups, |mean| mean.value.value)
        }),
        Of::nullable(
            names.fields[1],
            names.unit,
            "its standard uncertainty, with the shared part",
            |groups| mean(groups, |mean| mean.total().uncertainty),
        ),
        Of::nullable(names.fields[2], names.unit, "its expanded uncertainty", |groups| {
            mean(groups, GroupMean::expanded)
        }),
        Of::nullable(
            names.fields[3],
            names.unit,
            "standard uncertainty by errors common to all groups",
            |groups| mean(groups, |mean| mean.shared),
        ),
        Of::nullable("birge_ratio", "1", "scatter of the groups over their uncertainties", |groups| {
            mean(groups, |mean| mean.scatter.birge_ratio())
        }),
        Of::value(
            "effective_degrees_of_freedom",
            "1",
            "degrees of freedom of the standard uncertainty, null where they are infinite",
            |groups| json::number(groups.mean.as_ref().map_or(f64::NAN, |mean| mean.degrees_of_freedom)),
        ),
    ])
}
