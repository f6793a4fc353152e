//! The oscillators that are known by name, and `libration oscillators`, the former name of `libration list oscillators`.

use crate::arguments::KeyOptions;
use crate::output::description::{Answers, Description};
use crate::output::field::{Field, Fields};
use crate::output::json::{self, Record};
use crate::output::table::{sheet, write_text};
use crate::output::{Form, FormOptions};
use crate::query_error::QueryError;
use libration::catalogue::NamedParameter;
use libration::oscillator::{NamedOscillator, catalogue};
use std::io::{self, Write};

/// The built-in oscillators: equations, parameters, domains of oscillation, and sources
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration oscillators
  libration oscillators duffing morse
  libration oscillators --json

`libration expand` and `libration backbone` take these keys; --set NAME=VALUE
sets a parameter. Any other oscillator is given by its equation.")
)]
pub(crate) struct Oscillators {
    #[command(flatten)]
    keys: KeyOptions,
    #[command(flatten)]
    form: FormOptions,
}

impl Oscillators {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let chosen = self.keys.chosen(catalogue(), NamedOscillator::by_key)?;
        match self.form.form() {
            Form::Json => {
                json::begin_document(out, Record::new())?;
                write_list(out, &chosen)?;
                json::end_document(out, Record::new())?;
            }
            Form::Csv => of_oscillator().write_csv(out, chosen)?,
            Form::Table => write_sheets(out, &chosen)?,
        }
        Ok(())
    }
}

fn of_oscillator() -> Fields<NamedOscillator> {
    type Of = Field<NamedOscillator>;
    Fields::from([
        Of::value("key", "", "short name that commands accept", |oscillator| oscillator.key.into()),
        Of::value("also[]", "", "other names that they accept", |oscillator| {
            json::list(oscillator.also.to_vec())
        }),
        Of::value("title", "", "usual name", |oscillator| oscillator.title.into()),
        Of::value("equation", "", "equation of motion", |oscillator| oscillator.equation.into()),
        Of::nested("parameters[].", &of_parameter(), |oscillator| {
            of_parameter().records(oscillator.parameters)
        }),
        Of::value("parameters", "", "parameters with their default values", |oscillator| {
            defaults(oscillator).into()
        })
        .only_csv(),
        Of::value(
            "expansion_parameter",
            "",
            "parameter that series are in powers of; null where they are in the amplitude",
            |oscillator| oscillator.expansion_parameter.into(),
        )
        .only_json(),
        Of::value("description", "", "system that the equation describes", |oscillator| {
            oscillator.description.into()
        })
        .only_json(),
        Of::value("domain", "", "domain in which it oscillates", |oscillator| oscillator.domain.into()),
        Of::value("source", "", "source of the equation", |oscillator| oscillator.source.into()),
    ])
}

fn of_parameter() -> Fields<NamedParameter> {
    type Of = Field<NamedParameter>;
    Fields::from([
        Of::value("name", "", "name of the parameter", |parameter| parameter.name.into()),
        Of::value("default", "", "default value", |parameter| parameter.default.into()),
        Of::value("meaning", "", "meaning of the parameter", |parameter| parameter.meaning.into()),
    ])
}

pub(super) fn defaults(named: &NamedOscillator) -> String {
    let values = named.parameters.iter().map(|parameter| format!("{}={}", parameter.name, parameter.default));
    values.collect::<Vec<_>>().join(",")
}

pub(crate) fn answers() -> Vec<Answers> {
    vec![Answers {
        command: "oscillators",
        option: "",
        json: described(),
        csv: of_oscillator().described_in_csv(),
    }]
}

/// The fields of the list in JSON.
pub(super) fn described() -> Vec<Description> {
    of_oscillator().described("oscillators[].")
}

/// Writes the list in an answer in JSON.
pub(super) fn write_list(out: &mut dyn Write, chosen: &[&NamedOscillator]) -> io::Result<()> {
    let (fields, mut list) = (of_oscillator(), json::ListWriter::default());
    list.begin(out, "oscillators")?;
    chosen.iter().try_for_each(|named| list.item(out, fields.record(*named)))?;
    list.end(out)
}

pub(super) fn write_sheets(out: &mut dyn Write, chosen: &[&NamedOscillator]) -> io::Result<()> {
    for (index, named) in chosen.iter().enumerate() {
        if index > 0 {
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
