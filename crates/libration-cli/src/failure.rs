//! Why a question was not answered, and the exit status that says so.

mod echo;

pub(crate) use echo::excerpt;
use std::io::{Error, ErrorKind, Write, stderr};
use std::process::ExitCode;

/// Why the command ends without its answer.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    /// The question cannot be understood: exit status 2.
    #[error("{0}")]
    Usage(String),
    /// The question is understood and has no answer: exit status 1.
    #[error("{0}")]
    NoAnswer(String),
    /// Somebody has ended the work early: exit status 130.
    #[error("{0}")]
    Interrupted(String),
    /// The answer cannot be written: exit status 1, or 0 when the reader has gone.
    #[error("cannot write the answer: {0}")]
    Output(#[from] Error),
}

/// Ends a command whose arguments are not understood, or whose help is asked for, as clap has it; what is repeated of long
/// arguments is shortened.
pub(crate) fn refuse(error: &clap::Error) -> ExitCode {
    let message = error.render().to_string();
    let shown = echo::shortened(&echo::unprotected(&message));
    if shown == message {
        error.exit();
    }
    let _ = write!(stderr(), "{shown}");
    ExitCode::from(2)
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

    /// Writes the message to the error stream and gives the exit status.
    pub(crate) fn report(self) -> ExitCode {
        if self.is_closed_pipe() {
            return ExitCode::SUCCESS;
        }
        // Nothing is left to be done when even the error stream is closed.
        let _ = writeln!(stderr(), "error: {}", echo::shortened(&self.to_string()));
        match self {
            Self::Usage(_) => ExitCode::from(2),
            Self::Interrupted(_) => ExitCode::from(Self::INTERRUPTED),
            Self::NoAnswer(_) | Self::Output(_) => ExitCode::from(1),
        }
    }

    fn is_closed_pipe(&self) -> bool {
        matches!(self, Self::Output(error) if error.kind() == ErrorKind::BrokenPipe)
    }
}
