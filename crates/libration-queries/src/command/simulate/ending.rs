//! Ending of an integration, and the error that follows from it.

use crate::query_error::QueryError;
use libration::taylor::Moment;
use std::path::Path;

/// The state at which an event ended the motion.
#[derive(Clone, Debug)]
pub(super) struct EventEnding {
    pub(super) name: String,
    pub(super) end: Moment,
    /// Error of each number.
    pub(super) error: Moment,
}

/// The ending of an integration.
#[derive(Clone, Debug)]
pub(super) enum Ending {
    Complete,
    /// A terminal event, at this index and with these errors.
    Event(EventEnding),
    /// The event that should end it did not happen.
    NotReached(String),
    /// Ctrl-C was pressed.
    Interrupted(f64),
    /// The reason why the motion ends or cannot be followed.
    Stopped(String),
}

impl Ending {
    /// The error after the result is written.
    pub(super) fn into_result(self, output: Option<&Path>) -> Result<(), QueryError> {
        match self {
            Self::Complete | Self::Event(_) => Ok(()),
            Self::Interrupted(time) => {
                let how = output.map_or_else(
                    || "only a run written by <--output> as JSON or CSV can be continued".to_owned(),
                    |file| format!("continue with <--resume> {}", file.display()),
                );
                Err(QueryError::cancelled(format!(
                    "interrupted at t = {time:?} s: what was computed is written; {how}"
                )))
            }
            Self::NotReached(reason) | Self::Stopped(reason) => Err(QueryError::failed(reason)),
        }
    }
}
