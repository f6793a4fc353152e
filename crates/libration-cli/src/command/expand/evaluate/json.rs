//! The series in numbers, as JSON and CSV.

use super::{NOT_REACHED, Numbers, Quotient, certainty};
use crate::output::json::{self, Record};
use crate::output::series::coefficient;
use crate::output::{csv, number};
use libration::comparison::{Method, Radius};
use libration::perturbation::PartialSum;
use serde_json::{Map, Value};
use std::io::{self, Write};

pub(super) fn write(out: &mut dyn Write, numbers: &Numbers<'_>) -> io::Result<()> {
    let answer = numbers.answer;
    let variable = &answer.expansion.variable;
    let amplitude_is = if variable.is_strength() { variable.name() } else { "x_max" };
    let steps: Vec<Value> = numbers.evaluation.steps().iter().map(|step| record(numbers, step)).collect();
    let smallest = numbers.evaluation.smallest_term().map(|step| step.power);
    let record = Record::new()
        .with("oscillator", answer.key)
        .with("equation", answer.equation.clone())
        .with("order", answer.expansion.order)
        .with("quantity", numbers.relation.quantity().to_string())
        .with("amplitude_is", amplitude_is)
        .number("amplitude", numbers.amplitude);
    let record = with_radius(with_exact(record, numbers), numbers);
    let record = record.with("smallest_term_power", smallest).with("steps", steps);
    let record = with_pade(record, numbers).with("terms_needed", terms_needed(numbers));
    json::document(out, if numbers.missing().is_some() { record.with("interrupted", true) } else { record })
}

fn with_pade(record: Record, numbers: &Numbers<'_>) -> Record {
    match &numbers.pade {
        Some(pade) => record
            .with("pade", Value::from_iter(pade.iter().map(|quotient| quotient_record(numbers, quotient)))),
        None => record.number_or("pade", None, NOT_REACHED),
    }
}

fn with_exact(record: Record, numbers: &Numbers<'_>) -> Record {
    match &numbers.exact {
        Some(Ok(exact)) => {
            let road = match exact.method {
                Method::Elliptic => "elliptic integrals",
                Method::Integration => "integration of the equation of motion",
            };
            let record = record
                .number("exact", exact.value)
                .number("exact_uncertainty", exact.uncertainty)
                .with("exact_by", road)
                .with("encloses", exact.encloses.map(json::number));
            match numbers.other_family() {
                Some(told) => record.note(&told),
                None => record,
            }
        }
        Some(Err(reason)) => record.number_or("exact", None, &reason.to_string()),
        None => record.number_or("exact", None, NOT_REACHED),
    }
}

fn with_radius(record: Record, numbers: &Numbers<'_>) -> Record {
    let (value, certainty) = match &numbers.radius {
        Some(Some(Radius::Known(value))) => (Some(*value), Some("proven")),
        Some(Some(Radius::Estimated(found))) => (Some(found.radius), Some("estimated")),
        Some(None) | None => (None, None),
    };
    let why_none = if numbers.radius.is_none() { NOT_REACHED } else { "there are too few coefficients" };
    record.number_or("radius", value, why_none).with("radius_is", certainty)
}

fn record(numbers: &Numbers<'_>, step: &PartialSum) -> Value {
    let exact = &numbers.relation.series()[step.power];
    Record::new()
        .with("power", step.power)
        .with("coefficient", coefficient(exact, numbers.answer.expansion.precision))
        .number("term", step.term)
        .number("sum", step.sum)
        .with("error", numbers.error(step.sum).map(json::number))
        .number("bound", step.remainder.size)
        .with("bound_is", certainty(step.remainder.certainty))
        .into()
}

fn quotient_record(numbers: &Numbers<'_>, quotient: &Quotient) -> Value {
    Record::new()
        .with("degrees", vec![quotient.degree; 2])
        .number("value", quotient.value)
        .with("error", numbers.error(quotient.value).map(json::number))
        .with("pole_before", quotient.pole_before)
        .into()
}

fn terms_needed(numbers: &Numbers<'_>) -> Value {
    let fields = numbers.needed().map(|(tolerance, count)| (format!("{tolerance:e}"), count.into()));
    Value::Object(fields.collect::<Map<_, _>>())
}

/// One term a line.
pub(super) fn write_csv(out: &mut dyn Write, numbers: &Numbers<'_>) -> io::Result<()> {
    csv::line(out, &["power", "coefficient", "term", "sum", "error", "bound", "bound_is"])?;
    for step in numbers.evaluation.steps() {
        let exact = &numbers.relation.series()[step.power];
        let fields = [
            step.power.to_string(),
            coefficient(exact, numbers.answer.expansion.precision),
            number::exact(step.term),
            number::exact(step.sum),
            numbers.error(step.sum).map(number::exact).unwrap_or_default(),
            number::exact(step.remainder.size),
            certainty(step.remainder.certainty).to_owned(),
        ];
        csv::line(out, &fields)?;
    }
    Ok(())
}
