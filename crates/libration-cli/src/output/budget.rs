//! The budget of the uncertainty of g, as a table and as JSON.

use super::json::Record;
use super::table::{Column, Table};
use super::{combined, number};
use libration::quantity::Quantity;
use libration_lab::fit::{Budget, BudgetRow, Correction};
use serde_json::Value;
use std::io::{self, Write};

/// The budget as two tables: the effects (name, correction, contribution, kind, formula, and with what), and the inputs.
pub(crate) fn write_table(out: &mut dyn Write, budget: &Budget) -> io::Result<()> {
    let mut table = Table::new(columns());
    for row in rows(budget) {
        table.row(out, row)?;
    }
    table.finish(out)?;
    writeln!(out)?;
    combined::write_table(out, &budget.combined)
}

/// g from a length, its expanded uncertainty, and what is doubtful about both, as lines of a sheet.
pub(crate) fn lines(budget: &Budget, length: Quantity) -> Vec<(&'static str, String)> {
    let length = number::quantity(length, "m");
    let gravity = number::quantity(budget.gravity(), "m/s²");
    let mut lines = vec![("gravity", format!("{gravity}  (length {length})"))];
    lines.push(("expanded", combined::expanded(&budget.combined)));
    lines.extend(budget.warnings().iter().map(|doubt| ("doubtful", doubt.to_string())));
    lines
}

/// What is doubtful about g and its uncertainty, with names that stay.
pub(crate) fn warnings(budget: &Budget) -> Vec<(&'static str, String)> {
    budget.warnings().iter().map(|warning| (warning.name(), warning.to_string())).collect()
}

/// The fields of a budget and of the uncertainty of g.
pub(crate) fn fields(record: Record, budget: &Budget) -> Record {
    combined::fields(record.with("budget", records(budget)), &budget.combined)
}

/// The columns of [`rows`].
pub(crate) fn columns() -> Vec<Column> {
    vec![
        Column::words("effect"),
        Column::numbers("correction of g"),
        Column::numbers("u(g) / m/s²"),
        Column::words("type"),
        Column::words("formula"),
        Column::words("with"),
    ]
}

/// The cells of all rows, and of what they are together.
pub(crate) fn rows(budget: &Budget) -> Vec<Vec<String>> {
    let total = number::rounded(budget.uncertainty, 2);
    let total = ["together", "", &total, "", "", ""].map(str::to_owned);
    budget.rows.iter().map(cells).chain([total]).map(Vec::from).collect()
}

/// The cells of a row, as text for people; what is not corrected is in brackets.
fn cells(row: &BudgetRow) -> [String; 6] {
    let percent =
        |part: f64| format!("{}{} %", if part < 0.0 { "" } else { "+" }, number::rounded(100.0 * part, 2));
    let correction = match row.correction {
        Correction::Applied(part) => percent(part),
        Correction::Usually(part) => format!("(about {})", percent(part)),
        Correction::Unknown => "(not known)".to_owned(),
        Correction::Input => String::new(),
    };
    let uncertainty = row.uncertainty.map_or("–".to_owned(), |value| number::rounded(value, 2));
    let note = match row.correction {
        Correction::Usually(_) => format!("not corrected; {}", row.note),
        _ => row.note.clone(),
    };
    [
        row.name.to_owned(),
        correction,
        uncertainty,
        row.evaluation.letter().to_string(),
        row.formula.to_owned(),
        note,
    ]
}

/// The rows as JSON: `correction` is null where none is applied, `usual_size` says how large it would be.
fn records(budget: &Budget) -> Vec<Value> {
    let record = |row: &BudgetRow| {
        let optional = |value: Option<f64>| value.map_or(Value::Null, super::json::number);
        let (applied, usual) = match row.correction {
            Correction::Applied(part) => (Some(part), None),
            Correction::Usually(part) => (None, Some(part)),
            Correction::Unknown | Correction::Input => (None, None),
        };
        Record::new()
            .with("name", row.name)
            .with("formula", row.formula)
            .with("correction", optional(applied))
            .with("usual_size", optional(usual))
            .with("uncertainty_m_per_s2", optional(row.uncertainty))
            .with("type", row.evaluation.letter().to_string())
            .with("with", row.note.as_str())
            .into()
    };
    budget.rows.iter().map(record).collect()
}
