//! An earlier result to be continued.
//!
//! Of what was written only that counts which the end of a step covers that does not depend on the last of the times; what is behind it,
//! whole or cut short, is computed again, so that the result is that of one run to its last byte.

pub(crate) mod checksum;
mod mark;
mod question;
mod rows;
mod state;

use super::events::Happening;
use crate::arguments::{self, Initial, Times};
use crate::call;
use crate::output::destination::{self, Destination};
use crate::output::leftover::{self, Leftover};
use crate::query_error::{QueryError, option};
use serde_json::Value;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

pub(super) use checksum::Checksum;
pub(super) use mark::Mark;
pub(super) use question::{Difference, RunParameters};
use state::check_schema;
pub(super) use state::{Keeper, State};

use rows::Rows;

/// The most bytes of an earlier JSON result: memory ends before. CSV files are read line by line.
const LARGEST: usize = 1 << 30;

/// The content of an earlier result.
#[derive(Debug)]
pub(super) struct Earlier {
    question: RunParameters,
    /// The part of it that is kept; `None` if the earlier run did not complete its first step.
    kept: Option<(Mark, Rows)>,
    /// The unfinished file of a killed run, if the result is continued from that.
    _leftover: Option<Leftover>,
}

/// The reason why a result cannot be continued.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(super) enum ResumeError {
    #[error("{} is missing, which records the system and the state of the integration: give a file that <libration simulate> with <--output> wrote, with its .state file next to it", .0.display())]
    NoState(PathBuf),
    #[error("{} is not a record of an integration: give a file that <libration simulate> with <--output> wrote", .0.display())]
    NotAState(PathBuf),
    #[error(
        "the field `resume` is missing or damaged: give a file that this version of <libration simulate> wrote with <--json> or <--csv>"
    )]
    NotInAnswer,
    #[error("not valid JSON ({0}): give a file that <libration simulate> wrote")]
    NotJson(String),
    #[error(
        "its fields have the names of schema {schema}, and those of this version are schema {expected}: run it again from the start"
    )]
    Schema { schema: u64, expected: u64 },
    #[error(transparent)]
    Difference(#[from] Difference),
    #[error(
        "it is shorter than the {bytes} bytes recorded in its .state: the two files are from different runs"
    )]
    Shorter { bytes: u64 },
    #[error(
        "its first {bytes} bytes do not match its .state: it was changed, or the two files are from different runs"
    )]
    Changed { bytes: u64 },
    #[error("line {0} is not a state of the system")]
    Unreadable(usize),
    #[error(
        "it has a sample at t = {earlier:?} s where <--times> has {asked:?} s: give <--times> that begin with those of the file"
    )]
    Times { earlier: f64, asked: f64 },
    #[error(
        "it already reaches t = {earlier:?} s, and <--times> ends earlier: give later times, or leave out <--resume>"
    )]
    NotFarther { earlier: f64 },
}

impl Earlier {
    /// Finds an earlier result of this query: the file, or the one left by a killed run next to it, whichever extends farther.
    pub(super) fn find(path: &Path, question: &RunParameters, times: &Times) -> Result<Self, QueryError> {
        let target = match destination::resolved(path) {
            Ok(Destination::File(target)) => target,
            _ => path.to_owned(),
        };
        let resumed = Self::read(&target, question, times);
        let reached = |earlier: &Self| earlier.mark().map_or(0.0, |mark| mark.checkpoint.time.abs());
        let mut best = resumed;
        for leftover in leftover::beside(&target) {
            let Ok(other) = Self::of_csv(&leftover.path, question, times) else { continue };
            if best.as_ref().map_or(true, |best| reached(best) < reached(&other)) {
                let (name, time) = (leftover.path.display(), reached(&other));
                let said = format!("continuing from {name}, which a killed run left at t = {time:?} s");
                call::current().note(&said);
                best = Ok(Self { _leftover: Some(leftover), ..other });
            }
        }
        best.map_err(|reason| match reason {
            Unusable::Failed(failure) => failure,
            Unusable::Refused(reason) => {
                QueryError::no_result(&format!("--resume {}", path.display()), reason)
            }
        })
    }

    fn read(path: &Path, question: &RunParameters, times: &Times) -> Result<Self, Unusable> {
        let mut first = [0; 1];
        let read = File::open(path).and_then(|mut file| file.read(&mut first));
        match read {
            Ok(_) if first[0] == b'{' => Ok(Self::of_json(path, question, times)?),
            Ok(_) => Ok(Self::of_csv(path, question, times)?),
            // With the message that all files get which cannot be read.
            Err(_) => Err(arguments::read_at_most(path, LARGEST).err().map_or_else(
                || Unusable::Refused(ResumeError::NotAState(path.to_owned())),
                Unusable::Failed,
            )),
        }
    }

    fn of_csv(path: &Path, question: &RunParameters, times: &Times) -> Result<Self, ResumeError> {
        let state = State::read(&leftover::state_of(path))?;
        question.check(&state.question)?;
        let kept = state.mark.map(|mark| (mark.clone(), Rows::of_csv(path, &mark, question)));
        if let Some((mark, rows)) = &kept {
            let checksum = check_times(rows, mark, times)?;
            if checksum.value() != mark.checksum {
                return Err(ResumeError::Changed { bytes: mark.bytes });
            }
        }
        Ok(Self { question: state.question, kept, _leftover: None })
    }

    fn of_json(path: &Path, question: &RunParameters, times: &Times) -> Result<Self, Unusable> {
        let bytes = arguments::read_at_most(path, LARGEST).map_err(Unusable::Failed)?;
        let document: Value =
            serde_json::from_slice(&bytes).map_err(|error| ResumeError::NotJson(error.to_string()))?;
        check_schema(&document)?;
        let state = State::from_json(&document["resume"]).ok_or(ResumeError::NotInAnswer)?;
        question.check(&state.question).map_err(ResumeError::from)?;
        let kept = match state.mark {
            None => None,
            Some(mark) => {
                let rows = Rows::of_json(&document, &mark).ok_or(ResumeError::NotInAnswer)?;
                check_times(&rows, &mark, times)?;
                Some((mark, rows))
            }
        };
        Ok(Self { question: state.question, kept, _leftover: None })
    }

    /// The initial state, unless a different one is requested.
    pub(super) fn initial(&self, asked: Option<Initial>) -> Result<Initial, QueryError> {
        match asked {
            Some(asked) if asked.state != self.question.initial => {
                let reason = "the run given to <--resume> started from another state: leave out <--initial> to continue that run, or <--resume> to start a new one";
                Err(QueryError::usage(option("initial"), reason))
            }
            Some(asked) => Ok(asked),
            None => Ok(Initial { state: self.question.initial.clone(), assumed: vec![] }),
        }
    }

    /// The mark at which the continuation begins.
    pub(super) fn mark(&self) -> Option<&Mark> {
        self.kept.as_ref().map(|(mark, _)| mark)
    }

    /// Passes on the kept rows one after the other.
    pub(super) fn each(
        &self,
        take: impl FnMut(&Happening) -> Result<(), QueryError>,
    ) -> Result<(), QueryError> {
        self.kept.as_ref().map_or(Ok(()), |(_, rows)| rows.each(take).map(|_| ()))
    }
}

/// The checksum of rows whose samples are at the first of the times.
fn check_times(rows: &Rows, mark: &Mark, times: &Times) -> Result<Checksum, ResumeError> {
    if times.last().abs() < mark.checkpoint.time.abs() {
        return Err(ResumeError::NotFarther { earlier: mark.checkpoint.time });
    }
    let mut asked = times.iter();
    rows.each(|row| {
        let asked = if row.kind.is_empty() { asked.next() } else { Some(row.time) };
        match asked {
            Some(asked) if asked.to_bits() == row.time.to_bits() || asked.abs() + row.time.abs() == 0.0 => {
                Ok(())
            }
            asked => Err(ResumeError::Times { earlier: row.time, asked: asked.unwrap_or(f64::NAN) }),
        }
    })
}

/// The reason why a file cannot be continued.
#[derive(Debug)]
enum Unusable {
    /// The file cannot be read.
    Failed(QueryError),
    Refused(ResumeError),
}

impl From<ResumeError> for Unusable {
    fn from(error: ResumeError) -> Self {
        Self::Refused(error)
    }
}

impl From<ResumeError> for QueryError {
    fn from(error: ResumeError) -> Self {
        Self::no_result(option("resume"), error)
    }
}
