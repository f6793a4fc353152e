//! A run of a query: its words, its host, its result.

use crate::call::{self, Call};
use crate::command;
use crate::host::Host;
use crate::output::file::NewFile;
use crate::output::standard::StandardOutput;
use crate::query_error::QueryError;
use crate::questions;
use clap::{ArgMatches, Command};
use libration::systems::Model;
use libration::taylor::Ensemble;
use std::ffi::OsString;
use std::io::Write;
use std::path::Path;
use std::sync::Arc;

/// A run of a query, for front ends that add commands of their own.
#[derive(Debug)]
pub struct Run(Arc<Call>);

impl Run {
    /// A run with the words of a command line after the name of the program, for a host.
    pub fn new(arguments: impl IntoIterator<Item = OsString>, host: Arc<dyn Host>) -> Self {
        Self(Call::new(arguments.into_iter().collect(), host))
    }

    /// The words as matched by `command`; the host receives notes on inferred settings.
    ///
    /// # Errors
    /// The help, or the refusal by clap.
    pub fn matches(&self, command: &mut Command) -> Result<ArgMatches, clap::Error> {
        call::within(&self.0, || command::matches(command, self.0.arguments().to_vec()))
    }

    /// Writes the result of the query to a file, which takes its place only when it is complete, or to the host where no file is named.
    ///
    /// # Errors
    /// The reason why there is no result or not all of it; the host keeps the part written until then, a file does not.
    pub fn write(&self, matches: &ArgMatches, file: Option<&Path>) -> Result<(), QueryError> {
        self.write_by(file, |out| command::write(matches, out))
    }

    /// Writes the output of a front end's own command in the same way.
    ///
    /// # Errors
    /// Those of the command, and files that cannot be written.
    pub fn write_by(
        &self,
        file: Option<&Path>,
        command: impl FnOnce(&mut dyn Write) -> Result<(), QueryError>,
    ) -> Result<(), QueryError> {
        let written = call::within(&self.0, || match file {
            Some(path) => {
                let mut file = NewFile::create(path)?;
                command(&mut file)?;
                file.finish()
            }
            None => {
                let mut out = StandardOutput::new();
                command(&mut out)?;
                Ok(out.flush()?)
            }
        });
        written.map_err(|error| self.named(error))
    }

    /// The error with the name of the argument that the help calls by its value.
    fn named(&self, error: QueryError) -> QueryError {
        error.named(&|value| questions::argument_name(self.0.arguments(), value))
    }
}

/// Runs the query of a command line, whose words begin after the name of the program, with the same bytes as the program.
///
/// Several threads may run queries at once.
///
/// # Errors
/// The message of the program after `error:`, with its exit status. Of a result that fails while it is written, or is cancelled, the host has the
/// part that was written until then.
///
/// # Examples
/// See [`Host`].
pub fn ask(arguments: impl IntoIterator<Item = OsString>, host: Arc<dyn Host>) -> Result<(), QueryError> {
    let run = Run::new(arguments, Arc::clone(&host));
    match command::with_command(|command| run.matches(command)) {
        Ok(matches) => run.write(&matches, None),
        Err(help) if !help.use_stderr() => Ok(host.write(help.render().to_string().as_bytes())?),
        Err(error) => Err(run.named(QueryError::refused(&error))),
    }
}

/// The motions of `simulate … --each FILE` at their start, with their system; they give their states at one time after the other, as long as
/// requested. The times of the query are not used.
///
/// # Errors
/// As [`ask`]; another question, motions with different parameters, and events.
///
/// # Examples
/// ```
/// use libration::progress::Quiet;
/// use libration_queries::{Host, InputFile};
/// use std::path::Path;
/// use std::sync::Arc;
///
/// struct Starts;
///
/// impl Host for Starts {
///     fn write(&self, _: &[u8]) -> std::io::Result<()> {
///         Ok(())
///     }
///
///     fn open(&self, _: &Path) -> std::io::Result<InputFile<'_>> {
///         let bytes = b"theta1,theta2\n120deg,120deg\n120deg,120.001deg\n";
///         Ok(InputFile { size: bytes.len() as u64, bytes: Box::new(&bytes[..]) })
///     }
/// }
///
/// let words = "simulate double_pendulum --each starts.csv --times 0:10:1 --tolerance 1e-8";
/// let (model, mut ensemble) = libration_queries::ensemble(words.split(' ').map(Into::into), Arc::new(Starts))?;
/// assert_eq!((model.state_names()[1].as_str(), ensemble.len()), ("theta2", 2));
/// let states = ensemble.states_at(0.5, &Quiet)?;
/// assert!((states[1] - states[5]).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn ensemble(
    arguments: impl IntoIterator<Item = OsString>,
    host: Arc<dyn Host>,
) -> Result<(Model, Ensemble), QueryError> {
    let run = Run::new(arguments, host);
    call::within(&run.0, || command::ensemble(&command::matches_of_query(run.0.arguments().to_vec())?))
}
