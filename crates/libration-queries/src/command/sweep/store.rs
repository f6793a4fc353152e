//! The directory of a sweep: its plan, its shards, and a file for each chunk, written completely or not at all.

use super::chunk::{self, PointOutcome};
use super::plan::Plan;
use super::shard::Shard;
use crate::output::json::SCHEMA;
use crate::output::{file, json};
use crate::query_error::QueryError;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

const MANIFEST: &str = "sweep.json";

/// A directory with its plan.
#[derive(Debug)]
pub(crate) struct Store {
    pub(crate) directory: PathBuf,
    pub(crate) plan: Plan,
    /// The program that has begun it.
    version: String,
}

impl Store {
    /// The directory of a plan, which is created if it does not exist; that of another sweep is refused.
    pub(crate) fn create(directory: &Path, plan: Plan) -> Result<Self, QueryError> {
        fs::create_dir_all(directory).map_err(|error| cannot(directory, "make", &error))?;
        let version = env!("CARGO_PKG_VERSION").to_owned();
        let store = Self { directory: directory.to_owned(), plan, version };
        if directory.join(MANIFEST).exists() {
            let existing = Self::open(directory)?;
            return match store.difference(&existing) {
                None => Ok(store),
                Some(difference) => Err(QueryError::failed(format!(
                    "{} holds another sweep: {difference}; give another directory",
                    directory.display()
                ))),
            };
        }
        let names = names(directory)?;
        if let Some(name) = names.iter().find(|name| !name.starts_with('.')) {
            return Err(QueryError::failed(format!(
                "{} contains `{name}` and no sweep: give an empty directory, or a new one",
                directory.display()
            )));
        }
        let mut text = vec![];
        json::document(&mut text, store.plan.to_json())?;
        file::write(&directory.join(MANIFEST), &text)?;
        Ok(store)
    }

    /// The sweep in a directory.
    pub(crate) fn open(directory: &Path) -> Result<Self, QueryError> {
        let path = directory.join(MANIFEST);
        let no_sweep = |reason: String| QueryError::failed(format!("{}: {reason}", path.display()));
        let text = fs::read(&path).map_err(|error| match error.kind() {
            ErrorKind::NotFound => QueryError::failed(format!(
                "{} holds no sweep: it has no file {MANIFEST}",
                directory.display()
            )),
            _ => no_sweep(error.to_string()),
        })?;
        let json: Value = serde_json::from_slice(&text).map_err(|error| no_sweep(error.to_string()))?;
        if let Some(schema) = json["schema"].as_u64().filter(|schema| *schema != SCHEMA) {
            let reason = format!(
                "its fields have the names of schema {schema}, and those of this version are schema {SCHEMA}: sweep again into a new directory"
            );
            return Err(no_sweep(reason));
        }
        let plan = Plan::read(&json).map_err(no_sweep)?;
        let version = json["version"].as_str().unwrap_or_default().to_owned();
        Ok(Self { directory: directory.to_owned(), plan, version })
    }

    /// The difference from another store, in words.
    pub(crate) fn difference(&self, other: &Self) -> Option<String> {
        if self.version != other.version {
            return Some(format!(
                "it was begun by libration {}, and this is {}",
                other.version, self.version
            ));
        }
        other.plan.difference(&self.plan)
    }

    /// Notes that the chunks of a shard are written here.
    pub(crate) fn note(&self, shard: Shard) -> Result<(), QueryError> {
        let path = self.directory.join(shard.note());
        if path.exists() { Ok(()) } else { file::write(&path, b"") }
    }

    /// The shards that are written here.
    pub(crate) fn shards(&self) -> Result<BTreeSet<Shard>, QueryError> {
        Ok(names(&self.directory)?.iter().filter_map(|name| Shard::of_note(name)).collect())
    }

    /// Returns `true` if the file of a chunk is there, and whole.
    pub(crate) fn has(&self, chunk: usize) -> Result<bool, QueryError> {
        Ok(self.rows(chunk)?.is_some())
    }

    /// The lines of a chunk; `None` if it does not exist or is damaged.
    pub(crate) fn rows(&self, chunk: usize) -> Result<Option<String>, QueryError> {
        let path = self.path(chunk);
        let bytes = match fs::read(&path) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(cannot(&path, "read", &error)),
        };
        let header = chunk::header(&self.plan)?;
        let whole = String::from_utf8(bytes).ok().filter(|text| {
            let lines = text.bytes().filter(|byte| *byte == b'\n').count();
            text.as_bytes().starts_with(&header)
                && text.ends_with('\n')
                && lines == 1 + self.plan.grid.points_of(chunk).len()
        });
        Ok(whole.map(|text| text[header.len()..].to_owned()))
    }

    /// Writes a chunk, which is on the disk when this returns.
    pub(crate) fn write(&self, chunk: usize, outcomes: &[PointOutcome]) -> Result<(), QueryError> {
        file::write(&self.path(chunk), &chunk::csv(&self.plan, chunk, outcomes)?)
    }

    fn path(&self, chunk: usize) -> PathBuf {
        self.directory.join(format!("chunk-{chunk:06}.csv"))
    }
}

fn names(directory: &Path) -> Result<BTreeSet<String>, QueryError> {
    let fails = |error: io::Error| cannot(directory, "read", &error);
    let entries = fs::read_dir(directory).map_err(fails)?;
    entries.map(|entry| Ok(entry.map_err(fails)?.file_name().to_string_lossy().into_owned())).collect()
}

fn cannot(path: &Path, what: &str, error: &io::Error) -> QueryError {
    QueryError::failed(format!("cannot {what} {}: {error}", path.display()))
}
