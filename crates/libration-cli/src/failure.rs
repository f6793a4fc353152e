//! Why a question was not answered, and the exit status that says so.

pub(crate) mod echo;

pub(crate) use echo::excerpt;
use libration::quantity::printable;
use std::io::{Error, ErrorKind};

/// Why a question is left without its answer.
///
/// As text each is the reason, of which what is very long in it is shortened.
#[derive(Debug)]
pub enum Failure {
    /// The question cannot be understood: exit status 2.
    Usage(String),
    /// The question is understood and has no answer: exit status 1.
    NoAnswer(String),
    /// A file is not there: exit status 1.
    MissingFile(String),
    /// Somebody has ended the work early, and what is done was written: exit status 130.
    Interrupted(String),
    /// The answer cannot be written: exit status 1, or 0 when the reader has gone.
    Output(Error),
}

impl Failure {
    /// The exit status of a command that was interrupted, as shells have it.
    pub(crate) const INTERRUPTED: u8 = 130;

    /// A failure to understand `argument`, with the library's reason.
    pub(crate) fn usage(argument: &str, reason: impl std::fmt::Display) -> Self {
        Self::Usage(format!("{argument}: {reason}"))
    }

    /// A question about `argument` without an answer, with the library's reason.
    pub(crate) fn no_answer(argument: &str, reason: impl std::fmt::Display) -> Self {
        Self::NoAnswer(format!("{argument}: {reason}"))
    }

    /// Arguments that are not understood, without the advice to ask for help.
    pub(crate) fn refused(error: &clap::Error) -> Self {
        let message = refusal(error);
        let reason = message.strip_prefix("error: ").unwrap_or(&message);
        let end =
            ["\n\nUsage:", "\n\nFor more information"].iter().filter_map(|advice| reason.find(advice)).min();
        Self::Usage(reason[..end.unwrap_or(reason.len())].trim_end().to_owned())
    }

    /// The exit status of the command.
    #[must_use]
    pub fn status(&self) -> u8 {
        match self {
            _ if self.is_closed_pipe() => 0,
            Self::Usage(_) => 2,
            Self::Interrupted(_) => Self::INTERRUPTED,
            Self::NoAnswer(_) | Self::MissingFile(_) | Self::Output(_) => 1,
        }
    }

    /// Whether nobody reads the answer any more.
    pub(crate) fn is_closed_pipe(&self) -> bool {
        matches!(self, Self::Output(error) if error.kind() == ErrorKind::BrokenPipe)
    }
}

/// What clap says of arguments; what is repeated of long ones is shortened.
pub(crate) fn refusal(error: &clap::Error) -> String {
    echo::shortened(&echo::unprotected(&error.render().to_string()))
}

impl std::fmt::Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Usage(reason)
            | Self::NoAnswer(reason)
            | Self::MissingFile(reason)
            | Self::Interrupted(reason) => f.write_str(&without_controls(&echo::shortened(reason))),
            Self::Output(error) => write!(f, "cannot write the answer: {error}"),
        }
    }
}

/// Without characters that move the cursor of a terminal or turn the direction of its text; lines stay.
fn without_controls(text: &str) -> String {
    text.split('\n').map(printable).collect::<Vec<_>>().join("\n")
}

impl std::error::Error for Failure {}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::Output(error)
    }
}
