//! How an integration ended, and what is left to be said of that.

use crate::failure::Failure;
use std::path::Path;

/// How an integration ended.
#[derive(Clone, Debug)]
pub(super) enum Ending {
    Complete,
    /// Ctrl-C was pressed.
    Interrupted(f64),
    /// The motion ends or cannot be followed: why.
    Stopped(String),
}

impl Ending {
    /// What is left to be said when the answer is written.
    pub(super) fn into_result(self, output: Option<&Path>) -> Result<(), Failure> {
        match self {
            Self::Complete => Ok(()),
            Self::Interrupted(time) => {
                let how = output.map_or_else(
                    || "only a run written by --output as JSON or CSV can be continued".to_owned(),
                    |file| format!("continue with --resume {}", file.display()),
                );
                Err(Failure::Interrupted(format!(
                    "interrupted at t = {time:?} s: what was computed is written; {how}"
                )))
            }
            Self::Stopped(reason) => Err(Failure::NoAnswer(reason)),
        }
    }
}
