//! `libration sweep join`: the chunks of all shards as one table.

use super::chunk;
use super::plan::Plan;
use super::progress::SweepProgress;
use super::store::Store;
use crate::output::description::{Answers, DescriptionRow, descriptions};
use crate::output::file::NewFile;
use crate::output::json::{self, ListWriter, Record};
use crate::output::{Form, FormOptions, csv};
use crate::query_error::QueryError;
use std::io::Write;
use std::path::PathBuf;

/// Put the shards of a sweep together as one file of CSV or JSON
///
/// The file is the same, byte for byte, however many shards, threads and interruptions there were.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration sweep lyapunov driven_pendulum --over A=1:1.4:0.1 \\
    --set c=1/2 --initial theta=0.2 --intervals 10 --shard 1/2 --output a
  libration sweep lyapunov driven_pendulum --over A=1:1.4:0.1 \\
    --set c=1/2 --initial theta=0.2 --intervals 10 --shard 2/2 --output b
  libration sweep join a b --output exponents.csv")
)]
pub(crate) struct Join {
    /// The directories of the shards; a single one if all have written to it
    #[arg(value_name = "DIR", required = true)]
    directories: Vec<PathBuf>,
    /// The file, whose extension chooses its format: .csv or .json [default: CSV on the standard output]
    #[arg(long, short, value_name = "FILE", value_parser = table)]
    output: Option<PathBuf>,
    #[command(flatten)]
    form: FormOptions,
}

impl Join {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let stores = opened(&self.directories)?;
        let progress = SweepProgress::of(&stores)?;
        if let Some(missing) = progress.missing() {
            return Err(QueryError::failed(format!("the sweep is not complete: {missing}")));
        }
        let form = self.form.form_of_file(self.output.as_deref());
        let Some(path) = &self.output else { return write(out, form, &stores) };
        let mut file = NewFile::create(path)?;
        write(&mut file, form, &stores)?;
        file.finish()?;
        Ok(writeln!(out, "wrote {} ({} points)", path.display(), progress.points)?)
    }
}

/// The stores of one sweep.
pub(crate) fn opened(directories: &[PathBuf]) -> Result<Vec<Store>, QueryError> {
    let stores: Vec<Store> =
        directories.iter().map(|directory| Store::open(directory)).collect::<Result<_, _>>()?;
    let first = stores.first().ok_or_else(|| QueryError::misuse("DIR: give the directory of a sweep"))?;
    for other in &stores[1..] {
        if let Some(difference) = first.difference(other) {
            return Err(QueryError::failed(format!(
                "{} holds another sweep than {}: {difference}",
                other.directory.display(),
                first.directory.display()
            )));
        }
    }
    Ok(stores)
}

fn table(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
    let is_known = text == "-" || ending.is_some_and(|ending| ending == "csv" || ending == "json");
    if is_known {
        Ok(path)
    } else {
        Err("give a file that ends in .csv or .json, or - for the output".to_owned())
    }
}

fn write(out: &mut dyn Write, form: Form, stores: &[Store]) -> Result<(), QueryError> {
    match form {
        Form::Json => write_json(out, stores),
        Form::Csv | Form::Table => write_csv(out, stores),
    }
}

fn write_csv(out: &mut dyn Write, stores: &[Store]) -> Result<(), QueryError> {
    out.write_all(&chunk::header(&stores[0].plan)?)?;
    each_chunk(stores, |_, rows| Ok(out.write_all(rows.as_bytes())?))
}

fn write_json(out: &mut dyn Write, stores: &[Store]) -> Result<(), QueryError> {
    let plan = &stores[0].plan;
    json::begin_document(out, plan.to_json())?;
    let mut list = ListWriter::default();
    list.begin(out, "points")?;
    each_chunk(stores, |chunk, rows| {
        for (point, row) in plan.grid.points_of(chunk).zip(rows.lines()) {
            list.item(out, record(plan, point, row))?;
        }
        Ok(())
    })?;
    list.end(out)?;
    Ok(json::end_document(out, Record::new())?)
}

/// Hands the rows of each chunk on, from whichever store has them.
fn each_chunk(
    stores: &[Store],
    mut hand_on: impl FnMut(usize, &str) -> Result<(), QueryError>,
) -> Result<(), QueryError> {
    for chunk in 0..stores[0].plan.grid.chunks() {
        let mut rows = None;
        for store in stores {
            rows = match rows {
                None => store.rows(chunk)?,
                present => present,
            };
        }
        let gone = || QueryError::failed(format!("chunk {chunk} has been removed meanwhile: join again"));
        hand_on(chunk, &rows.ok_or_else(gone)?)?;
    }
    Ok(())
}

fn record(plan: &Plan, point: usize, row: &str) -> Record {
    let number = |text: &str| text.parse::<f64>().map_or(serde_json::Value::Null, json::number);
    let indices = plan.grid.indices_of(point);
    let at = plan.axes.iter().zip(indices).map(|(axis, index)| {
        let value = match &axis.numbers {
            Some(numbers) => json::number(numbers[index]),
            None => axis.values[index].as_str().into(),
        };
        (axis.name.clone(), value)
    });
    let cells = csv::cells(row);
    let numbers = cells.iter().skip(plan.axes.len()).map(|cell| number(cell));
    let values = plan.columns().into_iter().zip(numbers);
    let [.., status, message] = &cells[..] else { return Record::new() };
    let record = Record::new().with("at", json::object(at)).with("values", json::object(values));
    let record = record.with("status", status.parse::<u64>().unwrap_or_default());
    record.with("message", Some(message.as_str()).filter(|text| !text.is_empty()))
}

/// The fields of a plan.
pub(crate) const PLAN: &[DescriptionRow] = &[
    ("format", "1", "version of the format of sweeps"),
    ("version", "", "version of the program"),
    ("question[]", "", "words of the command, where {NAME} stands for the value of an axis"),
    ("axes[].name", "", "name of an axis"),
    ("axes[].unit", "", "unit of its values, empty where there is none"),
    ("axes[].values[]", "", "its values as given to the command"),
    (
        "axes[].numbers[]",
        "",
        "its values as numbers in that unit; null in place of the list where they are words",
    ),
    ("fields[].name", "", "name of the number kept of each result"),
    ("fields[].path", "", "path to it in the JSON of the result"),
    ("fields[].length", "1", "number of its elements where it is a list, or null"),
    ("fields[].unit", "", "its unit"),
    ("fields[].meaning", "", "meaning"),
    ("shape[]", "1", "number of values along each axis"),
    ("chunk_shape[]", "1", "number of values along each axis in a chunk"),
];

const POINTS: &[DescriptionRow] = &[
    ("points[].at.NAME", "", "value of the axis of this name"),
    ("points[].values.NAME", "", "number kept of the result, null where there is none"),
    (
        "points[].status",
        "1",
        "0 with a result, or the exit status of the command without: 1 no result, 2 usage error",
    ),
    ("points[].message", "", "reason why there is no result, or null"),
];

const COLUMNS: &[DescriptionRow] = &[
    ("NAME", "", "value of an axis, or number kept of the result, by name"),
    ("status", "1", "0 with a result, or the exit status of the command without: 1 no result, 2 usage error"),
    ("message", "", "reason why there is no result"),
];

pub(crate) fn answers() -> Vec<Answers> {
    let json = [descriptions("", PLAN), descriptions("", POINTS)].concat();
    vec![Answers { command: "sweep join", option: "", json, csv: descriptions("", COLUMNS) }]
}
