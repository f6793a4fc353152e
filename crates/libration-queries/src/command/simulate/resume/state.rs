//! Data that a result must contain to be continued: in a JSON result a field, next to a CSV file a file `NAME.csv.state`.

use super::{Mark, ResumeError, RunParameters};
use crate::output::field::{Field, Fields};
use crate::output::{file, json};
use crate::query_error::QueryError;
use crate::{arguments, call};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The query, and the time up to which the result is final; `None` before the first step whose length does not depend on the end.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct State {
    pub(crate) question: RunParameters,
    pub(crate) mark: Option<Mark>,
}

impl State {
    pub(crate) fn fields() -> Fields<Self> {
        type Of = Field<State>;
        let (question, mark) = (RunParameters::fields(), Mark::fields());
        Fields::from([
            Of::nested("question.", &question, |state| {
                RunParameters::fields().record(&state.question).into()
            }),
            Of::nested("known.", &mark, |state| {
                state.mark.as_ref().map(|mark| Mark::fields().record(mark)).into()
            }),
        ])
    }

    pub(crate) fn from_json(value: &Value) -> Option<Self> {
        let mark = match value.get("known")? {
            Value::Null => None,
            mark => Some(Mark::from_json(mark)?),
        };
        Some(Self { question: RunParameters::from_json(&value["question"])?, mark })
    }

    /// Reads the record next to a file of samples.
    pub(super) fn read(path: &Path) -> Result<Self, ResumeError> {
        /// A state has a hundred bytes for each of its numbers.
        const LARGEST: usize = 1 << 20;
        if !path.exists() {
            return Err(ResumeError::NoState(path.to_owned()));
        }
        let bytes = arguments::read_at_most(path, LARGEST).ok();
        let value: Option<Value> = bytes.and_then(|bytes| serde_json::from_slice(&bytes).ok());
        value.as_ref().map_or(Ok(()), check_schema)?;
        let state = value.as_ref().and_then(Self::from_json);
        state.ok_or_else(|| ResumeError::NotAState(path.to_owned()))
    }

    pub(crate) fn write(&self, path: &Path) -> Result<(), QueryError> {
        let mut text = vec![];
        json::document(&mut text, Self::fields().record(self))?;
        file::write(path, &text)
    }
}

/// Checks that a document has the names of fields of this version.
pub(super) fn check_schema(document: &Value) -> Result<(), ResumeError> {
    match document["schema"].as_u64() {
        Some(schema) if schema != json::SCHEMA => Err(ResumeError::Schema { schema, expected: json::SCHEMA }),
        _ => Ok(()),
    }
}

/// Records regularly up to where an unfinished file is final, in case the run is killed.
#[derive(Debug)]
pub(crate) struct Keeper {
    path: PathBuf,
    due: Duration,
}

impl Keeper {
    /// Longest work that may be lost when the run is killed.
    const PAUSE: Duration = Duration::from_secs(1);

    /// Creates the keeper of the state file next to an unfinished file.
    pub(crate) fn new(path: PathBuf) -> Self {
        Self { path, due: now() + Self::PAUSE }
    }

    pub(crate) fn is_due(&self) -> bool {
        now() >= self.due
    }

    /// Keeps the state, when all that it counts is on its way to the disk.
    pub(crate) fn keep(&mut self, state: &State) -> Result<(), QueryError> {
        state.write(&self.path)?;
        self.due = now() + Self::PAUSE;
        Ok(())
    }
}

fn now() -> Duration {
    call::current().host().now()
}

impl Drop for Keeper {
    fn drop(&mut self) {
        // The unfinished file is in its place now, or removed; there may never have been a state.
        let _ = fs::remove_file(&self.path);
    }
}
