//! `libration fields`: meanings of the fields of results.

use super::all_fields;
use crate::output::description::{Answers, Description, DescriptionRow, descriptions};
use crate::output::field::{Field, Fields};
use crate::output::json::{self, Record};
use crate::output::table::Table;
use crate::output::{Form, FormOptions, csv};
use crate::query_error::{QueryError, argument};
use std::io::{self, Write};

/// The fields of JSON and CSV results: names, units, meanings
///
/// In names, [] stands for each entry of a list, and capitals for a name that depends on the command line: KEY is the key of a
/// formula, NAME the name of a parameter, a coordinate or a velocity, K the number of a harmonic. Nested fields are preceded by their path. The unit is empty where there is none, or where it depends on the command line.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration fields period
  libration fields fit trace
  libration fields --json > fields.json   # of all commands
  libration fields expand --csv")
)]
pub(crate) struct FieldsQuestion {
    /// The command, such as period or fit trace [default: all commands]
    #[arg(value_name = "COMMAND")]
    command: Vec<String>,
    #[command(flatten)]
    form: FormOptions,
}

/// The fields that the JSON of every command has.
const FIRST: &[DescriptionRow] = &[("schema", "1", "version of the names of the fields")];
const LAST: &[DescriptionRow] = &[(
    "note",
    "",
    "reason why numbers of the same object are null; left out where there is none. In CSV the cell of a number that is not known or not finite is empty",
)];

/// The fields of `libration fields` itself.
pub(crate) fn answers() -> Vec<Answers> {
    let json = [
        descriptions("commands[].", &[COMMAND, OPTION]),
        of_description().described("commands[].json[]."),
        of_description().described("commands[].csv[]."),
    ];
    const FORM: DescriptionRow = ("form", "", "json or csv");
    let csv = [descriptions("", &[COMMAND, OPTION, FORM]), of_description().described_in_csv()];
    vec![Answers { command: "fields", option: "", json: json.concat(), csv: csv.concat() }]
}

const COMMAND: DescriptionRow = ("command", "", "command with this output");
const OPTION: DescriptionRow =
    ("option", "", "option or oscillator that selects this kind of output, empty for the usual one");

fn of_description() -> Fields<Description> {
    type Of = Field<Description>;
    Fields::from([
        Of::value("name", "", "name of the field", |description| description.name.as_str().into())
            .words("name", |description| description.name.clone()),
        Of::value("unit", "", "its unit, 1 for counts and ratios", |description| description.unit.into())
            .words("unit", |description| description.unit.to_owned()),
        Of::value("meaning", "", "meaning", |description| description.meaning.into())
            .words("meaning", |description| description.meaning.to_owned()),
    ])
}

impl FieldsQuestion {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let chosen = self.chosen()?;
        match self.form.form() {
            Form::Json => {
                json::document_with_list(out, Record::new(), "commands", chosen.iter().map(record))?;
            }
            Form::Csv => write_csv(out, &chosen)?,
            Form::Table => write_tables(out, &chosen)?,
        }
        Ok(())
    }

    /// The results requested; `fit` means all fits.
    fn chosen(&self) -> Result<Vec<Answers>, QueryError> {
        let asked: Vec<&str> = self.command.iter().flat_map(|words| words.split_whitespace()).collect();
        let is_asked = |answers: &Answers| {
            let words: Vec<&str> = answers.command.split(' ').collect();
            words.starts_with(&asked)
        };
        let mut chosen = all_fields();
        chosen.retain(is_asked);
        if chosen.is_empty() {
            let mut names: Vec<&str> = all_fields().iter().map(|field| field.command).collect();
            names.dedup();
            let reason = format!(
                "`{}` has no result with fields; the commands that have are {}",
                asked.join(" "),
                names.join(", ")
            );
            return Err(QueryError::usage(argument("COMMAND"), reason));
        }
        for answers in &mut chosen {
            answers.json =
                [descriptions("", FIRST), std::mem::take(&mut answers.json), descriptions("", LAST)].concat();
        }
        Ok(chosen)
    }
}

fn record(answers: &Answers) -> Record {
    let of_description = of_description();
    Record::new()
        .with(COMMAND.0, answers.command)
        .with(OPTION.0, answers.option)
        .with("json", of_description.records(&answers.json))
        .with("csv", of_description.records(&answers.csv))
}

/// The two forms that have fields, by name.
fn forms(answers: &Answers) -> [(&'static str, &[Description]); 2] {
    [("json", &answers.json), ("csv", &answers.csv)]
}

fn write_csv(out: &mut dyn Write, chosen: &[Answers]) -> io::Result<()> {
    let fields = of_description();
    let names = [COMMAND.0, OPTION.0, "form"].map(str::to_owned).to_vec();
    csv::line(out, &[names, fields.csv_names()].concat())?;
    for answers in chosen {
        for (form, list) in forms(answers) {
            for description in list {
                let context = [answers.command, answers.option, form].map(str::to_owned).to_vec();
                csv::line(out, &[context, fields.csv_cells(description)].concat())?;
            }
        }
    }
    Ok(())
}

fn write_tables(out: &mut dyn Write, chosen: &[Answers]) -> io::Result<()> {
    let fields = of_description();
    for (index, answers) in chosen.iter().enumerate() {
        for (form, list) in forms(answers) {
            if index > 0 || form == "csv" {
                writeln!(out)?;
            }
            let option =
                if answers.option.is_empty() { String::new() } else { format!(" {}", answers.option) };
            writeln!(out, "libration {}{option} --{form}", answers.command)?;
            writeln!(out)?;
            let mut table = Table::new(fields.columns());
            list.iter().try_for_each(|description| table.row(out, fields.cells(description)))?;
            table.finish(out)?;
        }
    }
    Ok(())
}
