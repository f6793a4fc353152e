//! Selected entries of a catalogue.

use crate::query_error::{QueryError, argument};
use std::fmt::Display;

/// The entries that are listed.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct KeyOptions {
    /// List only these
    #[arg(value_name = "KEY")]
    keys: Vec<String>,
}

impl KeyOptions {
    /// The entries with these keys; the whole catalogue if none is requested.
    pub(crate) fn chosen<T, E: Display>(
        &self,
        catalogue: impl IntoIterator<Item = T>,
        by_key: impl Fn(&str) -> Result<T, E>,
    ) -> Result<Vec<T>, QueryError> {
        if self.keys.is_empty() {
            return Ok(catalogue.into_iter().collect());
        }
        let entries = self.keys.iter().map(|key| by_key(key.trim()));
        entries.collect::<Result<_, _>>().map_err(|error| QueryError::usage(argument("KEY"), error))
    }
}
