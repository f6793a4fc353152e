//! `libration list`: the oscillators and systems that are known by name.

use super::{oscillators, systems};
use crate::output::description::Answers;
use crate::output::field::{Field, Fields};
use crate::output::json::{self, Record};
use crate::output::table::{Column, Table};
use crate::output::{Form, FormOptions};
use crate::query_error::{QueryError, argument};
use libration::catalogue::UnknownKey;
use libration::oscillator::{self, NamedOscillator};
use libration::systems::{self as models, NamedSystem};
use serde_json::Value;
use std::io::{self, Write};

/// The built-in oscillators and systems: equations of motion, parameters, sources
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration list                          # keys and titles
  libration list systems
  libration list duffing double_pendulum  # equations, parameters, sources
  libration list --json

`libration expand` and `libration backbone` take the keys of oscillators,
`simulate`, `modes`, `section`, `bifurcation` and `lyapunov` the keys of systems
and of oscillators; --set NAME=VALUE sets a parameter. By default the systems
have no damping and no driving, and the angular frequency of small swings is 1.
Any other oscillator or system is given by its equations.")
)]
pub(crate) struct List {
    /// The catalogues `oscillators` and `systems`, or keys of their entries [default: both catalogues]
    #[arg(value_name = "CATALOGUE|KEY")]
    entries: Vec<String>,
    #[command(flatten)]
    form: FormOptions,
}

/// Entries of both catalogues.
#[derive(Default)]
struct ChosenEntries {
    oscillators: Vec<&'static NamedOscillator>,
    systems: Vec<&'static NamedSystem>,
}

const OSCILLATORS: &str = "oscillators";
const SYSTEMS: &str = "systems";

impl List {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let chosen = self.chosen()?;
        match self.form.form() {
            Form::Json => write_json(out, &chosen)?,
            Form::Csv => of_entry().write_csv(out, &chosen.entries())?,
            Form::Table if self.has_keys() => write_sheets(out, &chosen)?,
            Form::Table => write_tables(out, &chosen)?,
        }
        Ok(())
    }

    fn has_keys(&self) -> bool {
        self.entries.iter().any(|word| ![OSCILLATORS, SYSTEMS].contains(&word.trim()))
    }

    /// The entries for each word, without repetition.
    fn chosen(&self) -> Result<ChosenEntries, QueryError> {
        let mut chosen = ChosenEntries::default();
        if self.entries.is_empty() {
            chosen.add(OSCILLATORS)?;
            chosen.add(SYSTEMS)?;
        }
        self.entries.iter().try_for_each(|word| chosen.add(word.trim()))?;
        Ok(chosen)
    }
}

impl ChosenEntries {
    fn add(&mut self, word: &str) -> Result<(), QueryError> {
        match word {
            OSCILLATORS => oscillator::catalogue().iter().for_each(|named| self.add_oscillator(named)),
            SYSTEMS => models::catalogue().for_each(|named| self.add_system(named)),
            key => match (NamedOscillator::by_key(key), NamedSystem::by_key(key)) {
                (Err(oscillator), Err(system)) => return Err(unknown(&oscillator, &system)),
                (oscillator, system) => {
                    oscillator.into_iter().for_each(|named| self.add_oscillator(named));
                    system.into_iter().for_each(|named| self.add_system(named));
                }
            },
        }
        Ok(())
    }

    fn add_oscillator(&mut self, named: &'static NamedOscillator) {
        if self.oscillators.iter().all(|oscillator| oscillator.key != named.key) {
            self.oscillators.push(named);
        }
    }

    fn add_system(&mut self, named: &'static NamedSystem) {
        if self.systems.iter().all(|system| system.key != named.key) {
            self.systems.push(named);
        }
    }

    fn entries(&self) -> Vec<CatalogueEntry> {
        let oscillators = self.oscillators.iter().map(|oscillator| CatalogueEntry::Oscillator(oscillator));
        oscillators.chain(self.systems.iter().map(|system| CatalogueEntry::System(system))).collect()
    }
}

fn unknown(oscillator: &UnknownKey, system: &UnknownKey) -> QueryError {
    let reason = format!(
        "no oscillator and no system has the key `{}`; the nearest oscillators are {}, the nearest systems {}; <libration list> shows all keys",
        oscillator.key,
        oscillator.near.join(", "),
        system.near.join(", ")
    );
    QueryError::usage(argument("CATALOGUE|KEY"), reason)
}

/// An entry of either catalogue.
enum CatalogueEntry {
    Oscillator(&'static NamedOscillator),
    System(&'static NamedSystem),
}

impl CatalogueEntry {
    /// One of two texts.
    fn text(
        &self,
        of_oscillator: impl Fn(&NamedOscillator) -> String,
        of_system: impl Fn(&NamedSystem) -> String,
    ) -> Value {
        match self {
            Self::Oscillator(named) => of_oscillator(named).into(),
            Self::System(named) => of_system(named).into(),
        }
    }
}

/// The columns of CSV.
fn of_entry() -> Fields<CatalogueEntry> {
    type Of = Field<CatalogueEntry>;
    let fields = [
        Of::value("catalogue", "", "oscillators or systems", |entry| {
            entry.text(|_| OSCILLATORS.to_owned(), |_| SYSTEMS.to_owned())
        }),
        Of::value("key", "", "short name that commands take", |row| {
            row.text(|entry| entry.key.to_owned(), |entry| entry.key.to_owned())
        }),
        Of::value("title", "", "usual name", |row| {
            row.text(|entry| entry.title.to_owned(), |entry| entry.title.to_owned())
        }),
        Of::value("equations", "", "equations of motion, with ; between them", |row| {
            row.text(|entry| entry.equation.to_owned(), |entry| entry.equations.to_owned())
        }),
        Of::value("parameters", "", "parameters with their default values", |entry| {
            entry.text(oscillators::defaults, systems::defaults)
        }),
        Of::value("domain", "", "domain, for oscillators that in which they oscillate", |row| {
            row.text(|entry| entry.domain.to_owned(), |entry| entry.domain.to_owned())
        }),
        Of::value("source", "", "source of the equations", |row| {
            row.text(|entry| entry.source.to_owned(), |entry| entry.source.to_owned())
        }),
    ];
    Fields::from(fields.map(Of::only_csv))
}

pub(crate) fn answers() -> Vec<Answers> {
    let json = [oscillators::described(), systems::described()].concat();
    vec![Answers { command: "list", option: "", json, csv: of_entry().described_in_csv() }]
}

fn write_json(out: &mut dyn Write, chosen: &ChosenEntries) -> io::Result<()> {
    json::begin_document(out, Record::new())?;
    oscillators::write_list(out, &chosen.oscillators)?;
    systems::write_list(out, &chosen.systems)?;
    json::end_document(out, Record::new())
}

fn write_sheets(out: &mut dyn Write, chosen: &ChosenEntries) -> io::Result<()> {
    oscillators::write_sheets(out, &chosen.oscillators)?;
    if !chosen.oscillators.is_empty() && !chosen.systems.is_empty() {
        writeln!(out)?;
    }
    systems::write_sheets(out, &chosen.systems)
}

/// The keys and titles of each catalogue that is not empty.
fn write_tables(out: &mut dyn Write, chosen: &ChosenEntries) -> io::Result<()> {
    let oscillators =
        chosen.oscillators.iter().map(|oscillator| (oscillator.key, oscillator.title)).collect();
    let systems = chosen.systems.iter().map(|system| (system.key, system.title)).collect();
    let tables: [(&str, Vec<_>); 2] = [("oscillator", oscillators), ("system", systems)];
    for (index, (title, entries)) in tables.iter().filter(|table| !table.1.is_empty()).enumerate() {
        if index > 0 {
            writeln!(out)?;
        }
        let mut table = Table::new(vec![Column::words(*title), Column::words("title")]);
        entries.iter().try_for_each(|entry| table.row(out, vec![entry.0.to_owned(), entry.1.to_owned()]))?;
        table.finish(out)?;
    }
    Ok(())
}
