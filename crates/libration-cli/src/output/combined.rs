//! The uncertainty of g input by input: values, sensitivity coefficients, shares, the expanded uncertainty.

use super::json::{self, Record};
use super::number;
use super::table::{Column, Table};
use libration_lab::fit::{COVERAGE, CombinedUncertainty, Contribution};
use serde_json::Value;
use std::io::{self, Write};

/// One line for each input that matters.
pub(crate) fn write_table(out: &mut dyn Write, combined: &CombinedUncertainty) -> io::Result<()> {
    let mut table = Table::new(columns());
    for row in rows(combined) {
        table.row(out, row)?;
    }
    table.finish(out)
}

/// `± 0.069 m/s² with 95 % (k = 1.96; degrees of freedom: 1800)`.
pub(crate) fn expanded(combined: &CombinedUncertainty) -> String {
    let percent = number::short(100.0 * COVERAGE, 3);
    format!(
        "± {} m/s² with {percent} %  (U = k u, k = {}; effective degrees of freedom: {})",
        number::rounded(combined.expanded(), 2),
        number::rounded(combined.coverage_factor(), 3),
        degrees(combined.degrees_of_freedom)
    )
}

/// The columns of [`rows`].
pub(crate) fn columns() -> Vec<Column> {
    let numbers = ["x", "u(x)", "∂g/∂x", "|∂g/∂x| u(x) / m/s²", "share"].map(Column::numbers);
    let last = [Column::words("type"), Column::numbers("ν")];
    [vec![Column::words("input")], numbers.to_vec(), last.to_vec()].concat()
}

/// The cells of the inputs that g depends on, and of what they are together.
pub(crate) fn rows(combined: &CombinedUncertainty) -> Vec<Vec<String>> {
    let known = combined.contributions.iter().filter(|each| each.sensitivity != 0.0);
    let mut rows: Vec<Vec<String>> = known.map(|each| cells(combined, each)).collect();
    if !combined.correlations.is_empty() {
        rows.push(of_all("correlations", "", &percent(combined.share_of_correlations()), ""));
    }
    let total = number::rounded(combined.standard, 2);
    rows.push(of_all("together", &total, "", &degrees(combined.degrees_of_freedom)));
    rows
}

fn of_all(name: &str, uncertainty: &str, share: &str, degrees: &str) -> Vec<String> {
    [name, "", "", "", uncertainty, share, "", degrees].map(str::to_owned).to_vec()
}

fn cells(combined: &CombinedUncertainty, each: &Contribution) -> Vec<String> {
    let with_unit = |value: String, unit: &str| match unit {
        "1" => value,
        unit => format!("{value} {}", unit.replace("^2", "²").replace("^3", "³").replace("^4", "⁴")),
    };
    let of_known = |text: String| if each.uncertainty.is_some() { text } else { "–".to_owned() };
    vec![
        each.input.name().to_owned(),
        with_unit(number::short(each.value, 7), each.input.unit()),
        of_known(number::short(each.uncertainty.unwrap_or(0.0), 2)),
        with_unit(number::short(each.sensitivity, 4), each.input.unit_of_sensitivity()),
        of_known(number::rounded(each.change().abs(), 2)),
        of_known(percent(combined.share(each))),
        each.evaluation.letter().to_string(),
        degrees(each.degrees_of_freedom),
    ]
}

fn percent(part: f64) -> String {
    format!("{:.1} %", 100.0 * part + 0.0)
}

fn degrees(of_freedom: f64) -> String {
    match of_freedom {
        many if many >= 1e6 => "∞".to_owned(),
        many if many >= 1000.0 => number::rounded(many, 2),
        few => format!("{few:.0}"),
    }
}

/// The expanded uncertainty and what it comes from.
pub(crate) fn fields(record: Record, combined: &CombinedUncertainty) -> Record {
    let inputs: Vec<Value> = combined.contributions.iter().map(|each| input(combined, each).into()).collect();
    let correlations: Vec<Value> = combined
        .correlations
        .iter()
        .map(|both| {
            let between: Vec<&str> = both.between.iter().map(|input| input.name()).collect();
            Record::new().with("between", between).number("coefficient", both.coefficient).into()
        })
        .collect();
    record
        .number("gravity_expanded_uncertainty_m_per_s2", combined.expanded())
        .number("coverage_probability", COVERAGE)
        .number("coverage_factor", combined.coverage_factor())
        .with("effective_degrees_of_freedom", json::number(combined.degrees_of_freedom))
        .with("budget_inputs", inputs)
        .with("budget_correlations", correlations)
        .number("share_of_correlations", combined.share_of_correlations())
}

/// Degrees of freedom are null where they are infinite.
fn input(combined: &CombinedUncertainty, each: &Contribution) -> Record {
    Record::new()
        .with("input", each.input.name())
        .number("value", each.value)
        .with("unit", each.input.unit())
        .with("uncertainty", each.uncertainty.map_or(Value::Null, json::number))
        .number("sensitivity", each.sensitivity)
        .with("sensitivity_unit", each.input.unit_of_sensitivity())
        .number("contribution_m_per_s2", each.change())
        .number("share", combined.share(each))
        .with("type", each.evaluation.letter().to_string())
        .with("degrees_of_freedom", json::number(each.degrees_of_freedom))
}
