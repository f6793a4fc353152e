//! The budget of the uncertainty of g, as a table and as JSON.

use super::json::Record;
use super::table::{Column, Table};
use super::{combined, number};
use libration::quantity::Quantity;
use libration_lab::fit::{Budget, BudgetRow, Correction, GRAVITY_ON_EARTH};
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
    let length = number::with_uncertainty(length.value, length.uncertainty.unwrap_or(0.0), "m");
    let gravity = number::with_uncertainty(budget.g, budget.uncertainty, "m/s²");
    let mut lines = vec![("gravity", format!("{gravity}  (length {length})"))];
    lines.push(("expanded", combined::expanded(&budget.combined)));
    lines.extend(doubts(budget).into_iter().map(|doubt| ("doubtful", doubt)));
    lines
}

/// What is doubtful about g and its uncertainty.
pub(crate) fn doubts(budget: &Budget) -> Vec<String> {
    contradiction(budget).into_iter().chain(budget.warnings()).collect()
}

/// The fields of a budget and of the uncertainty of g.
pub(crate) fn fields(record: Record, budget: &Budget) -> Record {
    combined::fields(record.with("budget", records(budget)), &budget.combined)
}

/// What to think of a gravity that is found nowhere on Earth, by more than three of its uncertainties.
pub(crate) fn contradiction(budget: &Budget) -> Option<String> {
    let likely = 0.5 * (GRAVITY_ON_EARTH[0] + GRAVITY_ON_EARTH[1]);
    found_nowhere(budget.g, budget.uncertainty).map(|doubt| {
        format!(
            "{doubt}: if the period is right, the length is about {} m and not {} m. Check that it \
             is the length of this run, from the pivot to the middle of the bob, and that periods are whole ones",
            number::rounded(budget.length * likely / budget.g, 3),
            number::short(budget.length, 6)
        )
    })
}

/// What gravity is on Earth, when this one differs from it by more than three of its uncertainties.
pub(crate) fn found_nowhere(g: f64, uncertainty: f64) -> Option<String> {
    let [least, greatest] = GRAVITY_ON_EARTH;
    let margin = 3.0 * uncertainty;
    (g < least - margin || g > greatest + margin).then(|| {
        let [least, greatest] = GRAVITY_ON_EARTH.map(|bound| number::rounded(bound, 3));
        format!("gravity is {least} to {greatest} m/s² on Earth")
    })
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
