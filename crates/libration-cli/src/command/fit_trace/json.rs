//! The answer as JSON.

use super::answer::Answer;
use crate::output;
use crate::output::json::{self, Record};
use libration_lab::fit::DampingTerm;
use libration_lab::fit::cycles::Cycle;
use libration_lab::fit::swings::{Advice, FittedPendulum, Warning};
use libration_lab::fit::trace::{Averaged, Comparison, Parameter};
use libration_lab::measurement::Seen;
use serde_json::Value;
use std::io::{self, Write};

/// Writes the whole answer.
pub(super) fn write(out: &mut dyn Write, answer: &Answer<'_>) -> io::Result<()> {
    let record = of_fit(answer);
    let record = of_cycles(record, answer);
    let record = of_pendulum(record, answer);
    let record = record
        .with("warnings", answer.warnings())
        .with("warning_kinds", kinds(&answer.swings.warnings, Warning::name))
        .with("advice", answer.advice())
        .with("advice_kinds", kinds(&answer.swings.advice, Advice::name))
        .with("traces", traces(answer))
        .with("findings", findings(answer))
        .with("comparison", answer.swings.comparison.as_ref().map_or(Value::Null, comparison))
        .with("averaged", answer.swings.comparison.as_ref().map_or(Value::Null, averaged))
        .with("correlations", correlations(answer))
        .with("autocorrelation", autocorrelation(answer));
    json::document(out, record)
}

fn kinds<T>(all: &[T], name: fn(&T) -> &'static str) -> Vec<&'static str> {
    all.iter().map(name).collect()
}

fn of_fit(answer: &Answer<'_>) -> Record {
    let fit = &answer.swings.fit;
    let files: Vec<&str> = answer.measured.files.iter().map(|file| file.name.as_str()).collect();
    let parameters: Vec<Value> = fit.parameters.iter().map(|each| parameter(each).into()).collect();
    let period = answer.swings.small_angle_period();
    let rms = match answer.measured.traces[0].seen() {
        Seen::Angle => "rms_residual_rad",
        Seen::AngularVelocity => "rms_residual_rad_per_s",
    };
    Record::new()
        .with("files", files)
        .with("model", fit.damping.to_string())
        .with("parameters", parameters)
        .number_or("chi2_per_dof", fit.chi2_per_dof, "the rows have no uncertainties")
        .number(rms, fit.rms)
        .with("rows", fit.rows())
        .with("converged", fit.converged)
        .number("small_angle_period_s", period.value)
        .number("small_angle_period_uncertainty_s", period.uncertainty)
}

fn parameter(parameter: &Parameter) -> Record {
    let record = Record::new()
        .with("name", parameter.name)
        .number("value", parameter.value)
        .number("uncertainty", parameter.uncertainty)
        .with("unit", parameter.unit)
        .number("formal_uncertainty", parameter.formal_uncertainty)
        .number("degrees_of_freedom", parameter.degrees_of_freedom)
        .with("interval_68", pair(parameter.intervals[0]))
        .with("interval_95", pair(parameter.intervals[1]));
    match parameter.trace {
        Some(trace) => record.with("trace", trace),
        None => record,
    }
}

fn pair(ends: [f64; 2]) -> Value {
    ends.map(json::number).to_vec().into()
}

fn of_cycles(record: Record, answer: &Answer<'_>) -> Record {
    let several = answer.measured.traces.len() > 1;
    let cycles: Vec<Value> = answer
        .swings
        .all_cycles()
        .map(|(trace, each)| cycle(each, several.then_some(trace)).into())
        .collect();
    let beta = answer.swings.beta.as_ref();
    let why_none = beta.err().map(ToString::to_string).unwrap_or_default();
    let beta = beta.ok();
    record.with("cycles", cycles).number_or("beta", beta.map(|beta| beta.factor.value), &why_none).number_or(
        "beta_uncertainty",
        beta.map(|beta| beta.factor.uncertainty),
        &why_none,
    )
}

fn cycle(cycle: &Cycle, trace: Option<usize>) -> Record {
    let record = Record::new()
        .number("time_s", cycle.time)
        .number("period_s", cycle.period)
        .number("amplitude_rad", cycle.amplitude)
        .number("period_uncertainty_s", cycle.period_uncertainty)
        .number("amplitude_uncertainty_rad", cycle.amplitude_uncertainty)
        .with("outlier", cycle.outlier);
    match trace {
        Some(trace) => record.with("trace", trace),
        None => record,
    }
}

fn of_pendulum(record: Record, answer: &Answer<'_>) -> Record {
    match &answer.swings.pendulum {
        FittedPendulum::Gravity { budget, length } => output::budget::fields(record, budget)
            .number("length_m", length.value)
            .number_or("length_uncertainty_m", length.uncertainty, "the length was given without one")
            .number("gravity_m_per_s2", budget.g)
            .number("gravity_uncertainty_m_per_s2", budget.uncertainty),
        FittedPendulum::Length(length) => record
            .number("length_in_standard_gravity_m", length.value)
            .number("length_in_standard_gravity_uncertainty_m", length.uncertainty)
            .note("give --length to have gravity"),
    }
}

fn traces(answer: &Answer<'_>) -> Vec<Value> {
    (0..answer.measured.traces.len()).map(|number| trace(answer, number).into()).collect()
}

fn trace(answer: &Answer<'_>, number: usize) -> Record {
    let (trace, fitted) = (&answer.measured.traces[number], &answer.swings.fit.traces[number]);
    let cycles = answer.swings.cycles[number].as_ref();
    let beta = cycles.ok().and_then(|cycles| cycles.beta.as_ref().ok());
    let no_cycles = cycles.err().map_or(String::new(), ToString::to_string);
    const OPEN: &str = "its cycles leave beta open";
    Record::new()
        .with("name", trace.name())
        .with("rows", trace.len())
        .number("first_s", trace.times()[0])
        .number("last_s", trace.times()[trace.len() - 1])
        .number("rms_residual", fitted.rms())
        .with("outlier_rows", fitted.outliers.clone())
        .number_or("t0_by_cycles_s", cycles.ok().map(|cycles| cycles.t0), &no_cycles)
        .number_or("t0_by_cycles_uncertainty_s", cycles.ok().map(|cycles| cycles.t0_uncertainty), &no_cycles)
        .number_or("beta", beta.map(|beta| beta.factor.value), OPEN)
        .number_or("beta_uncertainty", beta.map(|beta| beta.factor.uncertainty), OPEN)
}

fn findings(answer: &Answer<'_>) -> Vec<Value> {
    let file = |file: &super::input::File| {
        Record::new().with("file", file.name.as_str()).with("findings", file.findings.clone()).into()
    };
    answer.measured.files.iter().map(file).collect()
}

fn comparison(comparison: &Comparison) -> Value {
    let weights = comparison.weights();
    (0..comparison.fits.len())
        .map(|place| model(comparison, place, weights[place]))
        .collect::<Vec<_>>()
        .into()
}

fn model(comparison: &Comparison, place: usize, weight: f64) -> Value {
    let fit = &comparison.fits[place];
    let period = fit.small_angle_period();
    let negative: Vec<&str> = fit.negative_terms().into_iter().map(DampingTerm::name).collect();
    let coefficients = fit.damping.iter().filter_map(|term| fit.parameter(term.name()));
    Record::new()
        .with("model", fit.damping.to_string())
        .with("standing", comparison.standing(place).name())
        .number("rms_residual", fit.rms)
        .number("excess_aicc", comparison.excess_information[place])
        .number("weight", weight)
        .number("independent_rows", comparison.independent_rows)
        .number("small_angle_period_s", period.value)
        .number("small_angle_period_uncertainty_s", period.uncertainty)
        .with("takes_energy", fit.takes_energy())
        .with("negative_terms", negative)
        .with("coefficients", coefficients.map(|each| parameter(each).into()).collect::<Vec<Value>>())
        .into()
}

/// Over the models that the data leave.
fn averaged(comparison: &Comparison) -> Value {
    let number = |record: Record, name: &str, value: Averaged| {
        record
            .number(name, value.value)
            .number(&format!("{name}_uncertainty"), value.uncertainty)
            .number(&format!("{name}_spread"), value.spread)
    };
    let record = number(Record::new(), "small_angle_period_s", comparison.small_angle_period());
    let terms = DampingTerm::ALL.map(DampingTerm::name);
    let known =
        ["omega0"].into_iter().chain(terms).filter_map(|name| Some((name, comparison.parameter(name)?)));
    known.fold(record, |record, (name, value)| number(record, name, value)).into()
}

fn correlations(answer: &Answer<'_>) -> Vec<Value> {
    let row = |row: &Vec<f64>| row.iter().map(|&value| json::number(value)).collect::<Vec<_>>().into();
    answer.swings.fit.correlations.iter().map(row).collect()
}

fn autocorrelation(answer: &Answer<'_>) -> Record {
    let found = &answer.swings.fit.autocorrelation;
    Record::new()
        .with("is_noise", found.is_noise())
        .number("correlation_time_rows", found.time)
        .number("excess", found.excess)
        .with("bootstrap_block_rows", answer.swings.fit.bootstrap_block.map_or(Value::Null, Value::from))
}
