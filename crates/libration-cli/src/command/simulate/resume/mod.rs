//! An earlier answer that is to be gone on from.

use super::events::Happening;
use crate::arguments::{self, Initial};
use crate::failure::Failure;
use libration::systems::Model;
use libration::taylor::Moment;
use serde_json::Value;
use std::path::Path;

/// The most bytes of an earlier answer: memory ends before.
const LARGEST: usize = 1 << 30;

/// What an earlier answer holds.
#[derive(Clone, Debug)]
pub(super) struct Earlier {
    /// At least one.
    pub(super) samples: Vec<Moment>,
    pub(super) events: Vec<Happening>,
    /// Zero where the answer does not tell.
    pub(super) steps: usize,
}

impl Earlier {
    /// Reads a JSON or CSV answer of `libration simulate` about the same system.
    pub(super) fn read(path: &Path, model: &Model) -> Result<Self, Failure> {
        let bytes = arguments::read_at_most(path, LARGEST)?;
        let text = String::from_utf8_lossy(&bytes);
        let earlier = match text.trim_start().starts_with('{') {
            true => from_json(&text, model),
            false => from_csv(&text, model),
        };
        let earlier = earlier.and_then(|earlier| match earlier.samples.is_empty() {
            true => Err("it holds no sample to go on from: leave --resume out".to_owned()),
            false => Ok(earlier),
        });
        earlier.map_err(|reason| Failure::no_answer(&format!("--resume {}", path.display()), reason))
    }

    fn of_rows(rows: Vec<Happening>, steps: usize) -> Self {
        let (samples, events): (Vec<_>, Vec<_>) = rows.into_iter().partition(|row| row.kind.is_empty());
        let samples: Vec<Moment> =
            samples.into_iter().map(|row| Moment { time: row.time, state: row.state }).collect();
        // Those behind the last sample will be found again.
        let last = samples.last().map_or(0.0, |moment| moment.time.abs());
        let events = events.into_iter().filter(|event| event.time.abs() <= last).collect();
        Self { samples, events, steps }
    }

    /// The first sample, which stands for the start.
    pub(super) fn initial(&self) -> Initial {
        let state = self.samples.first().map(|moment| moment.state.clone()).unwrap_or_default();
        Initial { state, assumed: vec![] }
    }

    /// The start that was asked for, if the earlier answer began there.
    pub(super) fn begun_from(&self, asked: Initial) -> Result<Initial, Failure> {
        let start = self.samples.first().filter(|moment| moment.time.abs() == 0.0);
        if start.is_some_and(|start| start.state == asked.state) {
            return Ok(asked);
        }
        let reason = "the file given to --resume does not begin there: leave --initial out to go on from the file, or \
                      --resume to begin anew";
        Err(Failure::usage("--initial", reason))
    }
}

const WHAT_WOULD_DO: &str = "give a file that `libration simulate` wrote by --json or --csv";

fn from_json(text: &str, model: &Model) -> Result<Earlier, String> {
    let document: Value =
        serde_json::from_str(text).map_err(|error| format!("no JSON ({error}): {WHAT_WOULD_DO}"))?;
    let names: Option<Vec<String>> = serde_json::from_value(document["state"].clone()).ok();
    check_names(&names.ok_or_else(|| missing("state"))?, model)?;
    let equations = document["equations"].as_str();
    if let Some(equations) = equations.filter(|equations| *equations != model.equation().to_string()) {
        return Err(format!(
            "its equations are {equations}: give the system and the values it was begun with"
        ));
    }
    let list = |name: &str| document[name].as_array().ok_or_else(|| missing(name));
    let read = |(number, value): (usize, &Value)| {
        let state: Option<Vec<f64>> =
            value["state"].as_array().and_then(|state| state.iter().map(Value::as_f64).collect());
        let kind = value["kind"].as_str().unwrap_or_default();
        row(value["time"].as_f64(), kind, state, model)
            .ok_or_else(|| unreadable(&format!("item {}", number + 1)))
    };
    let rows = list("samples")?.iter().enumerate().chain(list("events")?.iter().enumerate());
    let rows = rows.map(read).collect::<Result<_, _>>()?;
    let steps = document["steps"].as_u64().and_then(|steps| usize::try_from(steps).ok()).unwrap_or(0);
    Ok(Earlier::of_rows(rows, steps))
}

fn from_csv(text: &str, model: &Model) -> Result<Earlier, String> {
    let mut lines = text.lines();
    let header: Vec<String> = lines.next().unwrap_or_default().split(',').map(str::to_owned).collect();
    match header.as_slice() {
        [time, names @ .., event] if time == "time" && event == "event" => check_names(names, model)?,
        [time, names @ ..] if time == "time" => check_names(names, model)?,
        _ => return Err(format!("the first line does not begin with `time`: {WHAT_WOULD_DO}")),
    }
    let numbers = 1 + model.state_names().len();
    let read = |(number, line): (usize, &str)| {
        // The kind of an event, the last cell, may hold commas.
        let cells: Vec<&str> = line.splitn(numbers + 1, ',').collect();
        let mut values = cells.iter().take(numbers).map(|cell| cell.parse::<f64>().ok());
        let kind = cells.get(numbers).map_or("", |kind| kind.trim_matches('"'));
        row(values.next().flatten(), kind, values.collect(), model)
            .ok_or_else(|| unreadable(&format!("line {}", number + 2)))
    };
    let rows = lines.enumerate().map(read).collect::<Result<_, _>>()?;
    Ok(Earlier::of_rows(rows, 0))
}

fn missing(field: &str) -> String {
    format!("`{field}` is missing: {WHAT_WOULD_DO}")
}

fn unreadable(place: &str) -> String {
    format!("{place} is no state of the system: {WHAT_WOULD_DO}")
}

fn check_names(names: &[String], model: &Model) -> Result<(), String> {
    let wanted = model.state_names();
    if names == wanted {
        return Ok(());
    }
    Err(format!("its states are of {}, those of this system of {}", names.join(", "), wanted.join(", ")))
}

/// A sample, or an event if it has a kind.
fn row(time: Option<f64>, kind: &str, state: Option<Vec<f64>>, model: &Model) -> Option<Happening> {
    let (time, state) = (time?, state?);
    let fits = state.len() == 2 * model.coordinates().len() && state.iter().all(|value| value.is_finite());
    fits.then(|| Happening { time, kind: kind.to_owned(), state })
}
