//! The samples and events of an earlier answer, one after the other.

use super::{Checksum, Mark, ResumeError};
use crate::command::simulate::events::Happening;
use serde_json::Value;
use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

/// Where they are.
#[derive(Clone, Debug)]
pub(crate) enum Rows {
    /// In memory, in the order of time.
    List(Vec<Happening>),
    /// In the first lines of a CSV file, the first of which are names.
    Csv {
        path: PathBuf,
        bytes: u64,
        numbers: usize,
        /// How many columns of formulas stand behind the state; they are computed again.
        columns: usize,
    },
}

impl Rows {
    /// The rows of a CSV file that a mark counts.
    pub(super) fn of_csv(path: &Path, mark: &Mark, columns: usize) -> Self {
        let numbers = 1 + mark.checkpoint.state.len();
        Self::Csv { path: path.to_owned(), bytes: mark.bytes, numbers, columns }
    }

    /// Those of a JSON answer that a mark counts.
    pub(super) fn of_json(document: &Value, mark: &Mark) -> Option<Self> {
        let list = |name: &str, most: usize| -> Option<Vec<Happening>> {
            let all = document[name].as_array().filter(|all| all.len() >= most)?;
            all.iter().take(most).map(of_record).collect()
        };
        let mut rows = list("samples", mark.samples)?;
        rows.extend(list("events", mark.events)?);
        // Samples stay before the events at their time.
        rows.sort_by(|a, b| a.time.abs().total_cmp(&b.time.abs()));
        Some(Self::List(rows))
    }

    /// Shows one row after the other.
    pub(super) fn each<E: From<ResumeError>>(
        &self,
        mut take: impl FnMut(&Happening) -> Result<(), E>,
    ) -> Result<Checksum, E> {
        match self {
            Self::List(rows) => rows.iter().try_for_each(take).map(|()| Checksum::NONE),
            Self::Csv { path, bytes, numbers, columns } => {
                let shorter = || ResumeError::Shorter { bytes: *bytes };
                let unreadable = |_| shorter();
                let file = File::open(path).map_err(unreadable)?;
                if file.metadata().map_err(unreadable)?.len() < *bytes {
                    return Err(shorter().into());
                }
                let mut lines = BufReader::with_capacity(1 << 16, file).take(*bytes);
                let (mut checksum, mut line, mut number) = (Checksum::NONE, vec![], 0);
                while lines.read_until(b'\n', &mut line).map_err(unreadable)? > 0 {
                    checksum.include(&line);
                    number += 1;
                    if number > 1 {
                        take(&of_line(&line, *numbers, *columns).ok_or(ResumeError::Unreadable(number))?)?;
                    }
                    line.clear();
                }
                Ok(checksum)
            }
        }
    }
}

fn of_record(value: &Value) -> Option<Happening> {
    let state = value["state"].as_array()?.iter().map(Value::as_f64).collect::<Option<_>>()?;
    let kind = value["kind"].as_str().unwrap_or_default().to_owned();
    Some(Happening { time: value["time"].as_f64()?, kind, state, columns: None })
}

/// A sample, or an event if it has a kind, the last cell, which may hold commas.
fn of_line(line: &[u8], numbers: usize, columns: usize) -> Option<Happening> {
    let line = std::str::from_utf8(line).ok()?.strip_suffix('\n')?;
    let mut cells = line.splitn(numbers + columns + 1, ',');
    let time = cells.next()?.parse().ok()?;
    let state =
        cells.by_ref().take(numbers - 1).map(|cell| cell.parse().ok()).collect::<Option<Vec<f64>>>()?;
    let kind = cells.nth(columns).unwrap_or_default().trim_matches('"').to_owned();
    (state.len() == numbers - 1).then_some(Happening { time, kind, state, columns: None })
}
