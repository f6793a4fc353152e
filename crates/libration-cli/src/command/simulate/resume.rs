//! An earlier answer that is to be gone on from.

use crate::arguments::{self, Initial};
use crate::failure::Failure;
use libration::systems::Model;
use libration::taylor::Moment;
use serde_json::Value;
use std::path::Path;

/// What an earlier answer holds.
#[derive(Clone, Debug)]
pub(super) struct Earlier {
    /// At least one.
    pub(super) samples: Vec<Moment>,
    /// Zero where the answer does not tell.
    pub(super) steps: usize,
}

impl Earlier {
    /// Reads a JSON or CSV answer of `libration simulate` about the same system.
    pub(super) fn read(path: &Path, model: &Model) -> Result<Self, Failure> {
        let bytes = arguments::read_bytes(path)?;
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

    /// The first sample, which stands for the start.
    pub(super) fn initial(&self) -> Initial {
        let state = self.samples.first().map(|moment| moment.state.clone()).unwrap_or_default();
        Initial { state, assumed: vec![] }
    }
}

const WHAT_WOULD_DO: &str = "give a file that `libration simulate` wrote by --json or --csv";

fn from_json(text: &str, model: &Model) -> Result<Earlier, String> {
    let document: Value =
        serde_json::from_str(text).map_err(|error| format!("no JSON ({error}): {WHAT_WOULD_DO}"))?;
    let names: Option<Vec<String>> = serde_json::from_value(document["state"].clone()).ok();
    check_names(&names.ok_or_else(|| format!("`state` is missing: {WHAT_WOULD_DO}"))?, model)?;
    let samples =
        document["samples"].as_array().ok_or_else(|| format!("`samples` is missing: {WHAT_WOULD_DO}"))?;
    let sample = |(number, value): (usize, &Value)| {
        let state: Option<Vec<f64>> =
            value["state"].as_array().and_then(|state| state.iter().map(Value::as_f64).collect());
        moment(value["time"].as_f64(), state, model)
            .ok_or_else(|| unreadable(&format!("sample {}", number + 1)))
    };
    let samples = samples.iter().enumerate().map(sample).collect::<Result<_, _>>()?;
    let steps = document["steps"].as_u64().and_then(|steps| usize::try_from(steps).ok()).unwrap_or(0);
    Ok(Earlier { samples, steps })
}

fn from_csv(text: &str, model: &Model) -> Result<Earlier, String> {
    let mut lines = text.lines();
    let header: Vec<String> = lines.next().unwrap_or_default().split(',').map(str::to_owned).collect();
    match header.as_slice() {
        [time, names @ ..] if time == "time" => check_names(names, model)?,
        _ => return Err(format!("the first line does not begin with `time`: {WHAT_WOULD_DO}")),
    }
    let sample = |(number, line): (usize, &str)| {
        let mut cells = line.split(',').map(|cell| cell.parse::<f64>().ok());
        let time = cells.next().flatten();
        moment(time, cells.collect(), model).ok_or_else(|| unreadable(&format!("line {}", number + 2)))
    };
    let samples = lines.enumerate().map(sample).collect::<Result<_, _>>()?;
    Ok(Earlier { samples, steps: 0 })
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

fn moment(time: Option<f64>, state: Option<Vec<f64>>, model: &Model) -> Option<Moment> {
    let state = state.filter(|state| state.len() == 2 * model.coordinates().len())?;
    Some(Moment { time: time?, state }).filter(|moment| moment.state.iter().all(|value| value.is_finite()))
}
