//! `libration systems`: the systems that are known by name.

use crate::arguments::KeyOptions;
use crate::failure::Failure;
use crate::output::json::{self, Record};
use crate::output::table::{paragraph, write_text};
use crate::output::{Form, FormOptions, csv};
use libration::systems::{NamedCoordinate, NamedSystem, Parameter, catalogue};
use serde_json::Value;
use std::io::{self, Write};

/// The systems known by name: equations of motion, parameters with units, energies, and sources
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration systems
  libration systems damped_pendulum double_pendulum
  libration systems --json

Each can be given to `libration simulate` by its key, and its parameters by
--set NAME=VALUE. The default values leave out all damping and driving, and the
angular frequency of small swings is 1. The oscillators of
`libration oscillators` can be given there too, and so can any equations of
motion.")]
pub(crate) struct Systems {
    #[command(flatten)]
    keys: KeyOptions,
    #[command(flatten)]
    form: FormOptions,
}

impl Systems {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let chosen = self.keys.chosen(catalogue(), NamedSystem::by_key)?;
        match self.form.form() {
            Form::Json => {
                let records = chosen.into_iter().map(record);
                json::document_with_list(out, Record::new(), "systems", records)?;
            }
            Form::Csv => write_csv(out, &chosen)?,
            Form::Table => write_sheets(out, &chosen)?,
        }
        Ok(())
    }
}

fn record(named: &NamedSystem) -> Record {
    let parameters: Vec<Value> = named.parameters.iter().map(|it| parameter_record(it).into()).collect();
    let coordinates: Vec<Value> = named.coordinates.iter().map(|it| coordinate_record(it).into()).collect();
    Record::new()
        .with("key", named.key)
        .with("also", named.also.to_vec())
        .with("title", named.title)
        .with("equations", named.equations.split(';').map(str::trim).collect::<Vec<_>>())
        .with("coordinates", coordinates)
        .with("parameters", parameters)
        .with("energy", named.energy)
        .with("energy_unit", named.energy_unit)
        .with("power", named.power)
        .with("drive_frequency", named.drive_frequency)
        .with("description", named.description)
        .with("domain", named.domain)
        .with("source", named.source)
}

fn coordinate_record(coordinate: &NamedCoordinate) -> Record {
    Record::new().with("name", coordinate.name).with("unit", coordinate.unit).with("rest", coordinate.rest)
}

fn parameter_record(parameter: &Parameter) -> Record {
    Record::new()
        .with("name", parameter.name)
        .with("default", parameter.default)
        .with("unit", parameter.unit)
        .with("meaning", parameter.meaning)
}

fn write_csv(out: &mut dyn Write, chosen: &[&NamedSystem]) -> io::Result<()> {
    csv::line(out, &["key", "title", "equations", "parameters", "energy", "domain", "source"])?;
    for named in chosen {
        let values: Vec<String> =
            named.parameters.iter().map(|it| format!("{}={}", it.name, it.default)).collect();
        let values = values.join(",");
        let fields =
            [named.key, named.title, named.equations, &values, named.energy, named.domain, named.source];
        csv::line(out, &fields)?;
    }
    Ok(())
}

fn write_sheets(out: &mut dyn Write, chosen: &[&NamedSystem]) -> io::Result<()> {
    for (place, named) in chosen.iter().enumerate() {
        if place > 0 {
            writeln!(out)?;
        }
        let also =
            if named.also.is_empty() { String::new() } else { format!(" (also {})", named.also.join(", ")) };
        write_text(out, "", &format!("{}{also}: {}", named.key, named.title))?;
        for (name, text) in lines(named) {
            writeln!(out, "{}", paragraph(&format!("  {name:<11}"), &text, COLUMNS))?;
        }
    }
    Ok(())
}

/// Where the lines of a sheet are broken.
const COLUMNS: usize = 120;

fn lines(named: &NamedSystem) -> Vec<(&'static str, String)> {
    let mut lines: Vec<(&'static str, String)> =
        named.equations.split(';').map(|one| ("equation", one.trim().to_owned())).collect();
    for coordinate in named.coordinates {
        let text = format!("{} in {}, at rest {}", coordinate.name, coordinate.unit, coordinate.rest);
        lines.push(("coordinate", text));
    }
    for parameter in named.parameters {
        let unit = if parameter.unit == "1" { String::new() } else { format!(", in {}", parameter.unit) };
        lines.push((
            "parameter",
            format!("{} = {}{unit}: {}", parameter.name, parameter.default, parameter.meaning),
        ));
    }
    lines.push(("energy", format!("{} ({})", named.energy, named.energy_unit)));
    if named.power != "0" {
        lines.push(("its change", named.power.to_owned()));
    }
    lines.push(("describes", named.description.to_owned()));
    lines.push(("holds for", named.domain.to_owned()));
    lines.push(("source", named.source.to_owned()));
    lines
}
