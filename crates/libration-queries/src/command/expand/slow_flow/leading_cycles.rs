//! Limit cycles over the exact orbits, to leading order in the small parameter.

use super::SlowFlowResult;
use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::number::short;
use crate::output::table::write_text;
use libration::comparison::{LeadingLimitCycle, LeadingLimitCycles};
use libration::quantity::with_uncertainty;
use serde_json::Value;
use std::io::{self, Write};

pub(super) fn of_answer() -> Fields<SlowFlowResult> {
    type Of = Field<SlowFlowResult>;
    Fields::from([
        Of::nested("leading_limit_cycles[].", &of_cycle(), |result| {
            of_cycle().records(result.leading.as_ref().map_or(&[][..], |leading| &leading.cycles))
        }),
        Of::value(
            "leading_amplitudes_searched[]",
            "",
            "least and greatest amplitude whose exact orbit was examined; null where no orbits are known",
            |result| {
                result
                    .leading
                    .as_ref()
                    .map_or(Value::Null, |leading| json::list(leading.searched.map(json::number)))
            },
        ),
        Of::value(
            "leading_work_signs[]",
            "1",
            "sign of the work of the small terms over these two orbits, for a positive parameter",
            |result| {
                result
                    .leading
                    .as_ref()
                    .map_or(Value::Null, |leading| json::list(leading.signs.map(json::number)))
            },
        ),
        Of::value(
            "leading_orbits_end",
            "",
            "true if the orbits about the equilibrium end at the greatest amplitude",
            |result| result.leading.as_ref().map_or(Value::Null, |leading| leading.family_ends.into()),
        ),
        Of::value(
            "leading_reason",
            "",
            "reason why no exact orbits were examined; null where they were",
            |result| result.leading.as_ref().err().map_or(Value::Null, |error| error.to_string().into()),
        ),
    ])
}

fn of_cycle() -> Fields<LeadingLimitCycle> {
    type Of = Field<LeadingLimitCycle>;
    Fields::from([
        Of::number(
            "amplitude",
            "",
            "largest displacement of a limit cycle for a small parameter, over the exact orbits",
            |cycle| cycle.amplitude,
        ),
        Of::number("amplitude_uncertainty", "", "uncertainty of the amplitude", |cycle| {
            cycle.amplitude_uncertainty
        }),
        Of::number("other_side", "", "displacement at the other turning point", |cycle| cycle.other_side),
        Of::number("period_s", "s", "its period, that of the exact orbit", |cycle| cycle.period),
        Of::number("period_uncertainty_s", "s", "uncertainty of the period", |cycle| {
            cycle.period_uncertainty
        }),
        Of::number(
            "exponent_per_s",
            "1/s",
            "rate at which distances from it grow, over the small parameter",
            |cycle| cycle.exponent,
        ),
        Of::number("exponent_uncertainty_per_s", "1/s", "uncertainty of the exponent", |cycle| {
            cycle.exponent_uncertainty
        }),
    ])
}

/// Writes the limit cycles at which the small terms take and give the same energy over exact orbits.
pub(super) fn write(out: &mut dyn Write, answer: &SlowFlowResult) -> io::Result<()> {
    writeln!(out)?;
    match &answer.leading {
        Ok(leading) if leading.cycles.is_empty() => write_text(out, "", &without_cycle(leading)),
        Ok(leading) => {
            leading.cycles.iter().try_for_each(|cycle| write_cycle(out, cycle, &leading.parameter))
        }
        Err(error) => write_text(out, "", &format!("no limit cycles over exact orbits: {error}")),
    }
}

fn without_cycle(leading: &LeadingLimitCycles) -> String {
    let (parameter, largest) = (&leading.parameter, short(leading.searched[1], 6));
    let end = if leading.family_ends { ", where the orbits end" } else { "" };
    let amplitudes = format!("amplitudes up to {largest}{end}");
    match leading.signs[1] {
        _ if leading.is_without_work() => format!(
            "to first order in {parameter} the small terms take as much as they give over every exact orbit: {amplitudes} were examined"
        ),
        sign => {
            let does = if sign < 0.0 { "take" } else { "give" };
            format!(
                "no limit cycle to leading order: for {parameter} > 0 the small terms {does} energy over every exact orbit, of {amplitudes}"
            )
        }
    }
}

fn write_cycle(out: &mut dyn Write, cycle: &LeadingLimitCycle, parameter: &str) -> io::Result<()> {
    let side = if cycle.exponent < 0.0 { ">" } else { "<" };
    let with = |value: f64, uncertainty: f64| with_uncertainty(value, uncertainty, "");
    let amplitude = with(cycle.amplitude, cycle.amplitude_uncertainty);
    let other = short(cycle.other_side, 10);
    let period = with(cycle.period, cycle.period_uncertainty);
    let exponent = with(cycle.exponent, cycle.exponent_uncertainty);
    write_text(
        out,
        "",
        &format!(
            "limit cycle over the exact orbits, to leading order in {parameter}, attracting for {parameter} {side} 0: from {other} to \
             A = {amplitude}, with the period {period} and the exponent {exponent} times {parameter}"
        ),
    )
}
