//! The expansion as JSON and CSV: every coefficient as text.

use super::Answer;
use crate::output::series::coefficient;
use crate::output::{csv, json, json::Record};
use libration::algebra::Rational;
use libration::perturbation::{AmplitudeSeries, Certificate, ExpansionVariable, Precision};
use serde_json::{Map, Value};
use std::io::{self, Write};

pub(super) fn write(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    let expansion = &answer.expansion;
    let list = |series: &[Rational]| list(series, expansion.precision);
    let harmonics = expansion.harmonics.iter().map(|harmonic| {
        (
            harmonic.k.to_string(),
            Record::new().with("cos", list(&harmonic.cos)).with("sin", list(&harmonic.sin)),
        )
    });
    let gauge = match &expansion.variable {
        ExpansionVariable::Epsilon(gauge) => gauge.to_string().into(),
        ExpansionVariable::Parameter(_) => Value::Null,
    };
    let of = |of: &Option<AmplitudeSeries>| {
        of.as_ref().map_or(Value::Null, |of| of_amplitude(of, expansion.precision))
    };
    let record = Record::new()
        .with("oscillator", answer.key)
        .with("equation", answer.equation.clone())
        .with("parameters", parameters(answer))
        .with("order", expansion.order)
        .with("gauge", gauge)
        .with("variable", expansion.variable.name())
        .with("precision", precision(expansion.precision))
        .with("equilibrium", coefficient(&expansion.equilibrium, expansion.precision))
        .with("omega0_squared", coefficient(&expansion.omega0_squared, expansion.precision))
        .with("frequency_ratio", list(&expansion.frequency_ratio))
        .with("harmonics", object(harmonics))
        .with("unit_squared", coefficient(&expansion.unit_squared, expansion.precision))
        .with("x_max", list(&expansion.x_max))
        .with("x_min", list(&expansion.x_min))
        .with("of_amplitude", of(&expansion.of_amplitude))
        .with("of_half_swing", of(&expansion.of_half_swing))
        .with("certified", expansion.certificate.is_proof())
        .with("certificate", certificate(expansion.certificate));
    json::document(out, if answer.interrupted.is_some() { record.with("interrupted", true) } else { record })
}

fn parameters(answer: &Answer) -> Value {
    let values = answer.values.iter().map(|(name, value)| (name.clone(), value.clone().into()));
    Value::Object(values.collect::<Map<_, _>>())
}

fn object(fields: impl Iterator<Item = (String, Record)>) -> Value {
    Value::Object(fields.map(|(name, record)| (name, Value::from(record))).collect::<Map<_, _>>())
}

fn list(series: &[Rational], precision: Precision) -> Value {
    series.iter().map(|value| Value::from(coefficient(value, precision))).collect::<Vec<_>>().into()
}

fn of_amplitude(of: &AmplitudeSeries, precision: Precision) -> Value {
    let harmonics = of.harmonics.iter().map(|(k, series)| {
        let nothing = vec![Rational::from(0); series.len()];
        let record =
            Record::new().with("cos", list(series, precision)).with("sin", list(&nothing, precision));
        (k.to_string(), record)
    });
    let record = Record::new()
        .with("frequency_ratio", list(&of.frequency_ratio, precision))
        .with("period_ratio", list(&of.period_ratio, precision))
        .with("epsilon", list(&of.epsilon, precision))
        .with("harmonics", object(harmonics));
    record.into()
}

fn precision(precision: Precision) -> String {
    match precision {
        Precision::Exact => "exact".to_owned(),
        Precision::Digits(digits) => format!("{digits} digits"),
    }
}

fn certificate(certificate: Certificate) -> &'static str {
    match certificate {
        Certificate::PlainRationals => "plain rationals",
        Certificate::Potential => "potential",
        Certificate::FirstIntegral => "first integral",
        Certificate::FreshPrimes => "fresh primes",
        Certificate::TwoPrecisions => "two precisions",
    }
}

/// One coefficient a line.
pub(super) fn write_csv(out: &mut dyn Write, answer: &Answer) -> io::Result<()> {
    let expansion = &answer.expansion;
    csv::line(out, &["quantity", "variable", "power", "coefficient"])?;
    let mut series = |name: &str, variable: &str, series: &[Rational]| -> io::Result<()> {
        for (power, value) in series.iter().enumerate() {
            let value = coefficient(value, expansion.precision);
            csv::line(out, &[name, variable, &power.to_string(), &value])?;
        }
        Ok(())
    };
    let variable = expansion.variable.name();
    series("frequency_ratio", variable, &expansion.frequency_ratio)?;
    for harmonic in &expansion.harmonics {
        series(&format!("cos_{}", harmonic.k), variable, &harmonic.cos)?;
        series(&format!("sin_{}", harmonic.k), variable, &harmonic.sin)?;
    }
    series("x_max", variable, &expansion.x_max)?;
    series("x_min", variable, &expansion.x_min)?;
    let amplitudes = [("x_max", &expansion.of_amplitude), ("half_swing", &expansion.of_half_swing)];
    for (amplitude, of) in amplitudes.into_iter().filter_map(|(name, of)| Some((name, of.as_ref()?))) {
        series("frequency_ratio", amplitude, &of.frequency_ratio)?;
        series("period_ratio", amplitude, &of.period_ratio)?;
        series("epsilon", amplitude, &of.epsilon)?;
        for (k, list) in &of.harmonics {
            series(&format!("cos_{k}"), amplitude, list)?;
        }
    }
    Ok(())
}
