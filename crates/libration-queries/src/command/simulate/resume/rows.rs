//! The samples and events of an earlier result, one after the other.

use super::{Checksum, Mark, ResumeError, RunParameters};
use crate::command::simulate::events::Happening;
use crate::output::csv;
use libration::internals::InOrder;
use libration::taylor::MomentErrors;
use serde_json::Value;
use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

/// The storage of the rows.
#[derive(Clone, Debug)]
pub(crate) enum Rows {
    /// Rows in memory, in the order of time.
    List(Vec<Happening>),
    /// Rows in the first lines of a CSV file, the first of which contains the names.
    Csv { path: PathBuf, bytes: u64, contents: Contents },
}

/// The contents of a CSV file besides the formulas.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Contents {
    /// The numbers of a state.
    numbers: usize,
    with_errors: bool,
    with_events: bool,
}

/// The cells of a line.
#[derive(Clone, Copy, Debug)]
struct Cells {
    contents: Contents,
    /// Number of columns of formulas after the state; their values are computed again.
    columns: usize,
}

impl Rows {
    /// The rows of a CSV file that a mark counts.
    pub(super) fn of_csv(path: &Path, mark: &Mark, question: &RunParameters) -> Self {
        let contents = Contents {
            numbers: mark.checkpoint.state.len(),
            with_errors: question.errors,
            with_events: !question.events.is_empty(),
        };
        Self::Csv { path: path.to_owned(), bytes: mark.bytes, contents }
    }

    /// The rows of a JSON result that a mark counts.
    pub(super) fn of_json(document: &Value, mark: &Mark) -> Option<Self> {
        let list = |name: &str, most: usize| -> Option<Vec<Happening>> {
            let all = document[name].as_array().filter(|all| all.len() >= most)?;
            all.iter().take(most).map(of_record).collect()
        };
        let mut rows = list("samples", mark.samples)?;
        rows.extend(list("events", mark.events)?);
        // Samples stay before the events at their time.
        rows.put_in_order(|a, b| a.time.abs().total_cmp(&b.time.abs()));
        Some(Self::List(rows))
    }

    /// Passes on one row after the other.
    pub(super) fn each<E: From<ResumeError>>(
        &self,
        mut take: impl FnMut(&Happening) -> Result<(), E>,
    ) -> Result<Checksum, E> {
        match self {
            Self::List(rows) => rows.iter().try_for_each(take).map(|()| Checksum::NONE),
            Self::Csv { path, bytes, contents } => {
                let shorter = || ResumeError::Shorter { bytes: *bytes };
                let unreadable = |_| shorter();
                let file = File::open(path).map_err(unreadable)?;
                if file.metadata().map_err(unreadable)?.len() < *bytes {
                    return Err(shorter().into());
                }
                let mut lines = BufReader::with_capacity(1 << 16, file).take(*bytes);
                let (mut checksum, mut line, mut number) = (Checksum::NONE, vec![], 0);
                let mut cells: Option<Cells> = None;
                while lines.read_until(b'\n', &mut line).map_err(unreadable)? > 0 {
                    checksum.include(&line);
                    number += 1;
                    cells = Some(match cells {
                        None => Cells::below(&line, *contents).ok_or(ResumeError::Unreadable(1))?,
                        Some(cells) => {
                            take(&cells.of_line(&line).ok_or(ResumeError::Unreadable(number))?)?;
                            cells
                        }
                    });
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
    let number = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
    let numbers = |all: &Vec<Value>| all.iter().map(number).collect();
    let errors = value["error"].as_array().map(|error| MomentErrors {
        time: number(&value["time_error_s"]),
        state: numbers(error),
        formulas: value["columns_error"].as_array().map_or(vec![], numbers),
    });
    Some(Happening { time: value["time_s"].as_f64()?, kind, state, columns: None, errors })
}

impl Cells {
    /// The cells below these names; `None` if the columns of errors do not match the others.
    fn below(names: &[u8], contents: Contents) -> Option<Self> {
        let Contents { numbers, with_errors, with_events } = contents;
        let names = csv::cells(std::str::from_utf8(names).ok()?.strip_suffix('\n')?);
        let with_time_errors = usize::from(with_events && with_errors);
        let rest = names.len().checked_sub(1 + numbers + usize::from(with_events) + with_time_errors)?;
        if !with_errors {
            return Some(Self { contents, columns: rest });
        }
        let columns = rest.checked_sub(numbers)? / 2;
        let (values, behind) = names.get(1..)?.split_at_checked(numbers + columns)?;
        let errors = behind.get(with_time_errors..)?;
        let fits = errors.iter().zip(values).filter(|(error, name)| **error == csv::error_of(name)).count();
        (fits == values.len()).then_some(Self { contents, columns })
    }

    /// A sample, or an event if it has a kind, the last cell, which may hold commas.
    fn of_line(self, line: &[u8]) -> Option<Happening> {
        let Self { contents: Contents { numbers, with_errors, with_events }, columns } = self;
        let line = std::str::from_utf8(line).ok()?.strip_suffix('\n')?;
        let errors = if with_errors { numbers + columns + usize::from(with_events) } else { 0 };
        let mut cells = line.splitn(numbers + columns + errors + 2, ',');
        let time = cells.next()?.parse().ok()?;
        let state: Vec<f64> =
            cells.by_ref().take(numbers).map(|cell| cell.parse().ok()).collect::<Option<_>>()?;
        let mut behind = cells.skip(columns);
        // What is not determined has no error.
        let mut error = || match behind.next()? {
            "" => Some(f64::NAN),
            error => error.parse().ok(),
        };
        let mut list = |count: usize| (0..count).map(|_| error()).collect::<Option<Vec<f64>>>();
        let errors = match with_errors {
            true => {
                let time = if with_events { list(1)?[0] } else { f64::NAN };
                Some(MomentErrors { time, state: list(numbers)?, formulas: list(columns)? })
            }
            false => None,
        };
        let kind = behind.next().unwrap_or_default().trim_matches('"').to_owned();
        (state.len() == numbers).then_some(Happening { time, kind, state, columns: None, errors })
    }
}
