//! The budget of the uncertainty of g, as a table and as JSON.

use super::description::Description;
use super::field::{Field, Fields};
use super::json::Record;
use super::normal_gravity::NormalGravity;
use super::table::{Column, Table};
use super::warnings::NamedWarning;
use super::{combined, number};
use libration::quantity::Quantity;
use libration_lab::fit::{Budget, BudgetRow, CombinedUncertainty, Correction};
use std::io::{self, Write};

/// The budget as two tables: the effects (name, correction, contribution, kind, formula, correlations), and the inputs.
pub(crate) fn write_table(out: &mut dyn Write, budget: &Budget) -> io::Result<()> {
    write_tables(out, &budget.rows, &budget.combined)
}

/// The same from the effects and the inputs.
pub(crate) fn write_tables(
    out: &mut dyn Write,
    effects: &[BudgetRow],
    uncertainty: &CombinedUncertainty,
) -> io::Result<()> {
    let mut table = Table::new(columns());
    for row in rows(effects, uncertainty) {
        table.row(out, row)?;
    }
    table.finish(out)?;
    writeln!(out)?;
    combined::write_table(out, uncertainty)
}

/// g from a length, its expanded uncertainty, and warnings on both, as lines of a sheet.
pub(crate) fn lines(
    budget: &Budget,
    length: Quantity,
    normal: Option<NormalGravity>,
) -> Vec<(&'static str, String)> {
    let length = number::quantity(length, "m");
    let mut lines = if budget.uncertainty > 0.0 {
        let gravity = number::quantity(budget.gravity(), "m/s²");
        vec![
            ("gravity", format!("{gravity}  (length {length})")),
            ("expanded", combined::expanded(&budget.combined)),
        ]
    } else {
        let gravity = number::rounded(budget.g, 5);
        vec![("gravity", format!("{gravity} m/s², uncertainty not known  (length {length})"))]
    };
    lines.extend(normal.map(|normal| normal.line()));
    lines.extend(budget.warnings().iter().map(|doubt| ("warning", doubt.to_string())));
    lines
}

/// The warnings about g and its uncertainty, with stable names.
pub(crate) fn warnings(budget: &Budget) -> Vec<NamedWarning> {
    budget.warnings().iter().map(|warning| (warning.name(), warning.to_string())).collect()
}

/// The effects on g and the inputs of its uncertainty, after other fields.
pub(crate) fn added_to(record: Record, budget: &Budget) -> Record {
    combined::of_uncertainty().added_to(rows_added_to(record, &budget.rows), &budget.combined)
}

/// The effects alone, after other fields.
pub(crate) fn rows_added_to(record: Record, effects: &[BudgetRow]) -> Record {
    of_rows().added_to(record, &effects)
}

/// The description of the effects alone.
pub(crate) fn rows_described() -> Vec<Description> {
    of_rows().described("")
}

fn of_rows<'a>() -> Fields<&'a [BudgetRow]> {
    Fields::from([Field::nested("budget[].", &of_effect(), |effects: &&'a [BudgetRow]| {
        of_effect().records(*effects)
    })])
}

/// Their descriptions.
pub(crate) fn described() -> Vec<Description> {
    [rows_described(), combined::of_uncertainty().described("")].concat()
}

/// Fields of an effect: `correction` is null if none is applied, and `usual_size` is its size if it were applied.
fn of_effect() -> Fields<BudgetRow> {
    type Of = Field<BudgetRow>;
    Fields::from([
        Of::value("name", "", "effect", |row| row.name.into()).words(COLUMNS[0], |row| row.name.to_owned()),
        Of::value("formula", "", "formula of the correction", |row| row.formula.into())
            .words(COLUMNS[4], |row| row.formula.to_owned()),
        Of::nullable(
            "correction",
            "1",
            "fractional correction of gravity that was applied, or null",
            |row| match row.correction {
                Correction::Applied(part) => Some(part),
                _ => None,
            },
        )
        .numeral(COLUMNS[1], |row| correction(row.correction)),
        Of::nullable(
            "usual_size",
            "1",
            "typical size of the correction, where it was not applied, or null",
            |row| match row.correction {
                Correction::Typical(part) => Some(part),
                _ => None,
            },
        ),
        Of::nullable(
            "uncertainty_m_per_s2",
            "m/s²",
            "standard uncertainty of gravity by this effect, or null",
            |row| row.uncertainty,
        )
        .rounded(COLUMNS[2], 2)
        .or("–"),
        Of::value("type", "", combined::KINDS, |row| row.evaluation.letter().to_string().into())
            .words(COLUMNS[3], |row| row.evaluation.letter().to_string()),
        Of::value("with", "", "values that the correction was computed with", |row| row.note.as_str().into())
            .words(COLUMNS[5], |row| match row.correction {
                Correction::Typical(_) => format!("not corrected; {}", row.note),
                _ => row.note.clone(),
            }),
    ])
}

const COLUMNS: [&str; 6] = ["effect", "correction of g", "u(g) / m/s²", "type", "formula", "with"];

/// The columns of [`rows`].
pub(crate) fn columns() -> Vec<Column> {
    of_effect().for_table(&COLUMNS).columns()
}

/// The cells of all rows, and of their total.
pub(crate) fn rows(effects: &[BudgetRow], uncertainty: &CombinedUncertainty) -> Vec<Vec<String>> {
    let fields = of_effect().for_table(&COLUMNS);
    let total = number::rounded(uncertainty.standard, 2);
    let total = ["combined", "", &total, "", "", ""].map(str::to_owned).to_vec();
    effects.iter().map(|row| fields.cells(row)).chain([total]).collect()
}

/// Formats a correction as text; one that is not applied is in brackets.
fn correction(correction: Correction) -> String {
    let percent =
        |part: f64| format!("{}{} %", if part < 0.0 { "" } else { "+" }, number::rounded(100.0 * part, 2));
    match correction {
        Correction::Applied(part) => percent(part),
        Correction::Typical(part) => format!("(about {})", percent(part)),
        Correction::Unknown => "(not known)".to_owned(),
        Correction::Input => String::new(),
    }
}
