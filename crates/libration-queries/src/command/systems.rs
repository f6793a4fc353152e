//! The systems that are known by name, and `libration systems`, the former name of `libration list systems`.

use crate::arguments::KeyOptions;
use crate::output::description::{Answers, Description};
use crate::output::field::{Field, Fields};
use crate::output::json::{self, Record};
use crate::output::table::{paragraph, write_text};
use crate::output::{Form, FormOptions};
use crate::query_error::QueryError;
use libration::catalogue::NamedParameter;
use libration::systems::{NamedCoordinate, NamedSystem, catalogue};
use std::io::{self, Write};

/// The built-in systems: equations of motion, parameters with units, energies, and sources
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration systems
  libration systems damped_pendulum double_pendulum
  libration systems --json

`libration simulate`, `modes`, `section`, `bifurcation` and `lyapunov` take these
keys; --set NAME=VALUE sets a parameter. By default there is no damping and no
driving, and the angular frequency of small swings is 1. Those commands also
take the keys of `libration oscillators` and any equations of motion.")
)]
pub(crate) struct Systems {
    #[command(flatten)]
    keys: KeyOptions,
    #[command(flatten)]
    form: FormOptions,
}

impl Systems {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let chosen = self.keys.chosen(catalogue(), NamedSystem::by_key)?;
        match self.form.form() {
            Form::Json => {
                json::begin_document(out, Record::new())?;
                write_list(out, &chosen)?;
                json::end_document(out, Record::new())?;
            }
            Form::Csv => of_system().write_csv(out, chosen)?,
            Form::Table => write_sheets(out, &chosen)?,
        }
        Ok(())
    }
}

fn of_system() -> Fields<NamedSystem> {
    type Of = Field<NamedSystem>;
    Fields::from([
        Of::value("key", "", "short name that commands accept", |system| system.key.into()),
        Of::value("also[]", "", "other names that they accept", |system| json::list(system.also.to_vec())),
        Of::value("title", "", "usual name", |system| system.title.into()),
        Of::value("equations[]", "", "equations of motion", |system| {
            json::list(system.equations.split(';').map(str::trim))
        }),
        Of::value("equations", "", "equations of motion, with ; between them", |system| {
            system.equations.into()
        })
        .only_csv(),
        Of::nested("coordinates[].", &of_coordinate(), |system| of_coordinate().records(system.coordinates)),
        Of::nested("parameters[].", &of_parameter(), |system| of_parameter().records(system.parameters)),
        Of::value("parameters", "", "parameters with their default values", |system| defaults(system).into())
            .only_csv(),
        Of::value("energy", "", "formula of the energy, or null", |system| {
            unless_empty(system.energy).into()
        }),
        Of::value("energy_unit", "", "divisor of the energy, or its unit, or null", |system| {
            unless_empty(system.energy_unit).into()
        })
        .only_json(),
        Of::value("power", "", "formula of the power gained, or null", |system| {
            unless_empty(system.power).into()
        })
        .only_json(),
        Of::value(
            "drive_frequency",
            "",
            "parameter that is the angular frequency of the drive, or null",
            |system| system.drive_frequency.into(),
        )
        .only_json(),
        Of::value("count", "", "parameter that counts the bodies, or null", |system| system.count.into())
            .only_json(),
        Of::value("description", "", "system that the equation describes", |system| {
            system.description.into()
        })
        .only_json(),
        Of::value("domain", "", "domain of the equations", |system| system.domain.into()),
        Of::value("source", "", "source of the equations", |system| system.source.into()),
    ])
}

fn of_coordinate() -> Fields<NamedCoordinate> {
    type Of = Field<NamedCoordinate>;
    Fields::from([
        Of::value("name", "", "name of the coordinate", |coordinate| coordinate.name.into()),
        Of::value("unit", "", "its unit", |coordinate| coordinate.unit.into()),
        Of::value("rest", "", "its value at rest", |coordinate| coordinate.at_rest.into()),
    ])
}

fn of_parameter() -> Fields<NamedParameter> {
    type Of = Field<NamedParameter>;
    Fields::from([
        Of::value("name", "", "name of the parameter", |parameter| parameter.name.into()),
        Of::value("default", "", "default value", |parameter| parameter.default.into()),
        Of::value("unit", "", "its unit", |parameter| parameter.unit.into()),
        Of::value("meaning", "", "meaning of the parameter", |parameter| parameter.meaning.into()),
    ])
}

/// The text, unless it is empty.
fn unless_empty(text: &'static str) -> Option<&'static str> {
    Some(text).filter(|text| !text.is_empty())
}

pub(super) fn defaults(named: &NamedSystem) -> String {
    let values = named.parameters.iter().map(|parameter| format!("{}={}", parameter.name, parameter.default));
    values.collect::<Vec<_>>().join(",")
}

pub(crate) fn answers() -> Vec<Answers> {
    vec![Answers { command: "systems", option: "", json: described(), csv: of_system().described_in_csv() }]
}

/// The fields of the list in JSON.
pub(super) fn described() -> Vec<Description> {
    of_system().described("systems[].")
}

/// Writes the list in a JSON result.
pub(super) fn write_list(out: &mut dyn Write, chosen: &[&NamedSystem]) -> io::Result<()> {
    let (fields, mut list) = (of_system(), json::ListWriter::default());
    list.begin(out, "systems")?;
    chosen.iter().try_for_each(|named| list.item(out, fields.record(*named)))?;
    list.end(out)
}

pub(super) fn write_sheets(out: &mut dyn Write, chosen: &[&NamedSystem]) -> io::Result<()> {
    for (index, named) in chosen.iter().enumerate() {
        if index > 0 {
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

/// Width at which the lines of a sheet are broken, in columns.
const COLUMNS: usize = 120;

fn lines(named: &NamedSystem) -> Vec<(&'static str, String)> {
    let mut lines: Vec<(&'static str, String)> =
        named.equations.split(';').map(|one| ("equation", one.trim().to_owned())).collect();
    for coordinate in named.coordinates {
        let unit = unless_empty(coordinate.unit).map_or_else(String::new, |unit| format!(" in {unit}"));
        let text = format!("{}{unit}, at rest {}", coordinate.name, coordinate.at_rest);
        lines.push(("coordinate", text));
    }
    for parameter in named.parameters {
        let unit = if parameter.unit == "1" { String::new() } else { format!(", in {}", parameter.unit) };
        lines.push((
            "parameter",
            format!("{} = {}{unit}: {}", parameter.name, parameter.default, parameter.meaning),
        ));
    }
    if let Some(energy) = unless_empty(named.energy) {
        lines.push(("energy", format!("{energy} ({})", named.energy_unit)));
    }
    if !matches!(named.power, "" | "0") {
        lines.push(("its change", named.power.to_owned()));
    }
    lines.push(("describes", named.description.to_owned()));
    lines.push(("holds for", named.domain.to_owned()));
    lines.push(("source", named.source.to_owned()));
    lines
}
