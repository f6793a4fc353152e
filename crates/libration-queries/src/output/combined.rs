//! The uncertainty of g input by input: values, sensitivity coefficients, shares, the expanded uncertainty.

use super::field::{Field, Fields};
use super::table::{Column, Table};
use super::{json, number};
use libration_lab::fit::{COVERAGE_PROBABILITY, CombinedUncertainty, Contribution, Correlation};
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
    let percent = number::short(100.0 * COVERAGE_PROBABILITY, 3);
    format!(
        "± {} m/s² with {percent} %  (U = k u, k = {}; effective degrees of freedom: {})",
        number::rounded(combined.expanded(), 2),
        number::rounded(combined.coverage_factor(), 3),
        degrees(combined.degrees_of_freedom)
    )
}

/// The columns of [`rows`].
pub(crate) fn columns() -> Vec<Column> {
    of_input().columns()
}

/// The cells of the inputs of g, and of their total.
pub(crate) fn rows(combined: &CombinedUncertainty) -> Vec<Vec<String>> {
    let fields = of_input();
    let effective = inputs(combined).into_iter().filter(|input| input.each.sensitivity != 0.0);
    let mut rows: Vec<Vec<String>> = effective.map(|input| fields.cells(&input)).collect();
    if !combined.correlations.is_empty() {
        rows.push(last_row("correlations", "", &percent(combined.share_of_correlations()), ""));
    }
    let total = number::rounded(combined.standard, 2);
    rows.push(last_row("combined", &total, "", &degrees(combined.degrees_of_freedom)));
    rows
}

fn last_row(name: &str, uncertainty: &str, share: &str, degrees: &str) -> Vec<String> {
    [name, "", "", "", uncertainty, share, "", degrees].map(str::to_owned).to_vec()
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

/// The two types of evaluation in the Guide to the Expression of Uncertainty in Measurement.
pub(super) const KINDS: &str =
    "A where it is evaluated from the scatter of measurements, B from other knowledge";

/// An input of an uncertainty.
struct InputRow<'a> {
    combined: &'a CombinedUncertainty,
    each: &'a Contribution,
}

fn inputs(combined: &CombinedUncertainty) -> Vec<InputRow<'_>> {
    combined.contributions.iter().map(|each| InputRow { combined, each }).collect()
}

/// The expanded uncertainty and its contributions.
pub(crate) fn of_uncertainty() -> Fields<CombinedUncertainty> {
    let correlations =
        |uncertainty: &CombinedUncertainty| of_correlation().records(&uncertainty.correlations);
    with_correlations(Field::nested("budget_correlations[].", &of_correlation(), correlations))
}

/// The same where inputs are independent.
pub(crate) fn of_independent() -> Fields<CombinedUncertainty> {
    let none = |_: &CombinedUncertainty| json::records([]);
    with_correlations(Field::value("budget_correlations[]", "", "empty, as the inputs are independent", none))
}

fn with_correlations(correlations: Field<CombinedUncertainty>) -> Fields<CombinedUncertainty> {
    type Of = Field<CombinedUncertainty>;
    Fields::from([
        Of::number(
            "gravity_expanded_uncertainty_m_per_s2",
            "m/s²",
            "expanded uncertainty of gravity",
            |uncertainty| uncertainty.expanded(),
        ),
        Of::number(
            "coverage_probability",
            "1",
            "probability that gravity is within the expanded uncertainty",
            |_| COVERAGE_PROBABILITY,
        ),
        Of::number("coverage_factor", "1", "expanded uncertainty over the standard one", |uncertainty| {
            uncertainty.coverage_factor()
        }),
        Of::value(
            "effective_degrees_of_freedom",
            "1",
            "degrees of freedom of the standard uncertainty, null where they are infinite",
            |uncertainty| json::number(uncertainty.degrees_of_freedom),
        ),
        Of::nested("budget_inputs[].", &of_input(), |uncertainty| of_input().records(&inputs(uncertainty))),
        correlations,
        Of::number(
            "share_of_correlations",
            "1",
            "share of the variance of gravity that correlations make",
            |uncertainty| uncertainty.share_of_correlations(),
        ),
    ])
}

fn of_correlation() -> Fields<Correlation> {
    type Of = Field<Correlation>;
    Fields::from([
        Of::value("between[]", "", "names of two inputs that are correlated", |correlation| {
            json::list(correlation.between.iter().map(|input| input.name()))
        }),
        Of::number("coefficient", "1", "their correlation coefficient", |correlation| {
            correlation.coefficient
        }),
    ])
}

fn of_input<'a>() -> Fields<InputRow<'a>> {
    type Of<'a> = Field<InputRow<'a>>;
    Fields::from([
        Of::value("input", "", "name of the input quantity x", |row| row.each.input.name().into())
            .words("input", |row| row.each.input.name().to_owned()),
        Of::number("value", "", "value of the input, in its unit", |row| row.each.value)
            .numeral("x", |row| with_unit(number::short(row.each.value, 7), row.each.input.unit())),
        Of::value("unit", "", "unit of the input", |row| row.each.input.unit().into()),
        Of::nullable("uncertainty", "", "standard uncertainty u(x), in the same unit, or null", |row| {
            row.each.uncertainty
        })
        .short("u(x)", 2)
        .or("–"),
        Of::number("sensitivity", "", "sensitivity coefficient ∂g/∂x", |row| row.each.sensitivity)
            .numeral("∂g/∂x", |row| {
                with_unit(number::short(row.each.sensitivity, 4), row.each.input.unit_of_sensitivity())
            }),
        Of::value("sensitivity_unit", "", "unit of the sensitivity coefficient", |row| {
            row.each.input.unit_of_sensitivity().into()
        }),
        Of::number(
            "contribution_m_per_s2",
            "m/s²",
            "change of gravity by one standard uncertainty of the input",
            |row| row.each.change(),
        )
        .numeral("|∂g/∂x| u(x) / m/s²", |row| row.if_known(number::rounded(row.each.change().abs(), 2))),
        Of::number("share", "1", "share of the variance of gravity that the input makes by itself", |row| {
            row.combined.share(row.each)
        })
        .numeral("share", |row| row.if_known(percent(row.combined.share(row.each)))),
        Of::value("type", "", KINDS, |row| row.each.evaluation.letter().to_string().into())
            .words("type", |row| row.each.evaluation.letter().to_string()),
        Of::value(
            "degrees_of_freedom",
            "1",
            "degrees of freedom of u(x), null where they are infinite",
            |row| json::number(row.each.degrees_of_freedom),
        )
        .numeral("ν", |row| degrees(row.each.degrees_of_freedom)),
    ])
}

impl InputRow<'_> {
    /// A dash where the uncertainty is not known.
    fn if_known(&self, text: String) -> String {
        if self.each.uncertainty.is_some() { text } else { "–".to_owned() }
    }
}

fn with_unit(value: String, unit: &str) -> String {
    match unit {
        "1" => value,
        unit => format!("{value} {}", unit.replace("^2", "²").replace("^3", "³").replace("^4", "⁴")),
    }
}
