//! `libration oscillators`: the oscillators that are known by name.

use crate::arguments::KeyOptions;
use crate::failure::Failure;
use crate::output::json::{self, Record};
use crate::output::table::{sheet, write_text};
use crate::output::{Form, FormOptions, csv};
use libration::oscillator::{NamedOscillator, Parameter, catalogue};
use serde_json::Value;
use std::io::{self, Write};

/// The oscillators known by name: equations, parameters, where they oscillate, and sources
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration oscillators
  libration oscillators duffing morse
  libration oscillators --json

Each can be given to `libration expand` by its key, and its parameters by
--set NAME=VALUE. Any other oscillator can be given there by its equation.")]
pub(crate) struct Oscillators {
    #[command(flatten)]
    keys: KeyOptions,
    #[command(flatten)]
    form: FormOptions,
}

impl Oscillators {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let chosen = self.keys.chosen(catalogue(), NamedOscillator::by_key)?;
        match self.form.form() {
            Form::Json => {
                let records = chosen.into_iter().map(record);
                json::document_with_list(out, Record::new(), "oscillators", records)?;
            }
            Form::Csv => write_csv(out, &chosen)?,
            Form::Table => write_sheets(out, &chosen)?,
        }
        Ok(())
    }
}

fn record(named: &NamedOscillator) -> Record {
    let parameters: Vec<Value> = named.parameters.iter().map(|it| parameter_record(it).into()).collect();
    Record::new()
        .with("key", named.key)
        .with("also", named.also.to_vec())
        .with("title", named.title)
        .with("equation", named.equation)
        .with("parameters", parameters)
        .with("expansion_parameter", named.expansion_parameter)
        .with("description", named.description)
        .with("domain", named.domain)
        .with("source", named.source)
}

fn parameter_record(parameter: &Parameter) -> Record {
    Record::new()
        .with("name", parameter.name)
        .with("default", parameter.default)
        .with("meaning", parameter.meaning)
}

fn write_csv(out: &mut dyn Write, chosen: &[&NamedOscillator]) -> io::Result<()> {
    csv::line(out, &["key", "title", "equation", "parameters", "domain", "source"])?;
    for named in chosen {
        let values: Vec<String> =
            named.parameters.iter().map(|it| format!("{}={}", it.name, it.default)).collect();
        let values = values.join(",");
        csv::line(out, &[named.key, named.title, named.equation, &values, named.domain, named.source])?;
    }
    Ok(())
}

fn write_sheets(out: &mut dyn Write, chosen: &[&NamedOscillator]) -> io::Result<()> {
    for (place, named) in chosen.iter().enumerate() {
        if place > 0 {
            writeln!(out)?;
        }
        let also =
            if named.also.is_empty() { String::new() } else { format!(" (also {})", named.also.join(", ")) };
        write_text(out, "", &format!("{}{also}: {}", named.key, named.title))?;
        sheet(out, &lines(named))?;
    }
    Ok(())
}

fn lines(named: &NamedOscillator) -> Vec<(&'static str, String)> {
    let mut lines = vec![("  equation", named.equation.to_owned())];
    for parameter in named.parameters {
        let value = if named.expansion_parameter == Some(parameter.name) {
            format!("{}: {}", parameter.name, parameter.meaning)
        } else {
            format!("{} = {}: {}", parameter.name, parameter.default, parameter.meaning)
        };
        lines.push(("  parameter", value));
    }
    lines.push(("  describes", named.description.to_owned()));
    lines.push(("  oscillates", named.domain.to_owned()));
    lines.push(("  source", named.source.to_owned()));
    lines
}
