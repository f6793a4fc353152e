//! A fitted parameter.

use super::super::answer::FitTraceResult;
use super::super::units::unit;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::number::{short, with_uncertainty};
use libration_lab::fit::trace::Parameter;

/// A parameter, with the name of its trace if there are several.
pub(in super::super) struct ParameterRow<'a> {
    pub(super) parameter: &'a Parameter,
    pub(super) trace: Option<&'a str>,
}

pub(in super::super) fn rows<'a>(answer: &'a FitTraceResult<'_>) -> Vec<ParameterRow<'a>> {
    let traces = &answer.measured.traces;
    let name = |trace: usize| (traces.len() > 1).then(|| traces[trace].name());
    let parameters = answer.swings.fit.parameters.iter();
    parameters.map(|parameter| ParameterRow { parameter, trace: parameter.trace.and_then(name) }).collect()
}

const COLUMNS: [&str; 6] = ["parameter", "value", "±", "68 %", "95 %", "unit"];

pub(in super::super) fn of_parameter<'a>() -> Fields<ParameterRow<'a>> {
    type Of<'a> = Field<ParameterRow<'a>>;
    Fields::from([
        Of::value("name", "", "name of the parameter", |row| row.parameter.kind.name().into()).words(
            COLUMNS[0],
            |row| {
                row.trace.map_or_else(
                    || row.parameter.kind.name().to_owned(),
                    |trace| format!("{}, {trace}", row.parameter.kind.name()),
                )
            },
        ),
        Of::number("value", "", "its value, in its unit", |row| row.parameter.estimate.value)
            .numeral(COLUMNS[1], |row| row.to_the_digit(row.parameter.estimate.value)),
        Of::number("uncertainty", "", "its standard uncertainty, in its unit", |row| {
            row.parameter.estimate.uncertainty
        })
        .rounded(COLUMNS[2], 2),
        Of::value("unit", "", "its unit", |row| row.parameter.unit.into())
            .words(COLUMNS[5], |row| unit(row.parameter.unit)),
        Of::number(
            "formal_uncertainty",
            "",
            "standard uncertainty as if residuals were independent, in its unit",
            |row| row.parameter.formal_uncertainty,
        ),
        Of::number("degrees_of_freedom", "1", "degrees of freedom of the uncertainty", |row| {
            row.parameter.degrees_of_freedom
        }),
        Of::value("interval_68[]", "", "ends of the interval of 68 % confidence", |row| {
            json::numbers(&row.parameter.intervals[0])
        })
        .numeral(COLUMNS[3], |row| row.interval(0)),
        Of::value("interval_95[]", "", "ends of the interval of 95 % confidence", |row| {
            json::numbers(&row.parameter.intervals[1])
        })
        .numeral(COLUMNS[4], |row| row.interval(1)),
    ])
}

/// The fields of the table of parameters.
pub(in super::super) fn shown<'a>() -> Fields<ParameterRow<'a>> {
    of_parameter().for_table(&COLUMNS)
}

/// The trace that the parameter belongs to.
pub(super) fn trace<'a>() -> Field<ParameterRow<'a>> {
    let meaning = "number of its trace, from 0, if it belongs to one";
    Field::present_value("trace", "1", meaning, |row: &ParameterRow<'a>| row.parameter.trace.map(Into::into))
}

impl ParameterRow<'_> {
    fn interval(&self, level: usize) -> String {
        let ends = self.parameter.intervals[level].map(|end| self.to_the_digit(end));
        format!("{} … {}", ends[0], ends[1])
    }

    /// A value to the last digit of the uncertainty.
    fn to_the_digit(&self, value: f64) -> String {
        let text = with_uncertainty(value, self.parameter.estimate.uncertainty, "");
        text.split_once(' ').map_or_else(|| short(value, 8), |(value, _)| value.to_owned())
    }
}
