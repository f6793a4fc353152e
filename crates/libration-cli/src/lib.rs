//! The command `libration`, for programs that ask its questions themselves: arguments in, answers out.
//!
//! [`ask`] answers in the process that calls it and leaves its streams, signals and environment alone; [`program`] is the command.

mod arguments;
mod call;
mod command;
mod document;
mod failure;
mod figure;
mod host;
mod interrupt;
mod output;
mod parallel;
#[cfg(not(target_family = "wasm"))]
mod program;
mod questions;
mod sweep;

pub use failure::Failure;
pub use host::{Host, InputFile};
#[cfg(not(target_family = "wasm"))]
pub use program::program;
pub use questions::{Parameter, ParameterKind, Question, questions};
pub use sweep::{AxisValues, SweepChunk, SweepPlan};

use call::Call;
use libration::systems::Model;
use libration::taylor::Ensemble;
use std::ffi::OsString;
use std::io::Write;
use std::sync::Arc;

/// Answers the question of a command line, which begins behind the name of the program, as the program does: the same bytes.
///
/// Questions may be asked on several threads at once.
///
/// # Errors
/// What the program says behind `error:`, with its exit status. Of an answer that fails on its way, or is ended early, the host has got
/// what was written until then.
///
/// # Examples
/// See [`Host`].
pub fn ask(arguments: impl IntoIterator<Item = OsString>, host: Arc<dyn Host>) -> Result<(), Failure> {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let call = Call::new(arguments.clone(), Arc::clone(&host));
    call::within(&call, || match command::question(arguments) {
        Ok(question) => answer(&question),
        Err(help) if !help.use_stderr() => Ok(host.write(help.render().to_string().as_bytes())?),
        Err(error) => Err(Failure::refused(&error)),
    })
}

/// The motions that `simulate … --each FILE` asks for, at their start, with their system: to be asked for their states at one time after the
/// other, as long as one likes. The question's own times are not looked at.
///
/// # Errors
/// As [`ask`]; another question, motions with different parameters, and events.
///
/// # Examples
/// ```
/// use libration_cli::{Host, InputFile};
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
/// let (model, mut ensemble) = libration_cli::ensemble(words.split(' ').map(Into::into), Arc::new(Starts))?;
/// assert_eq!((model.state_names()[1].as_str(), ensemble.len()), ("theta2", 2));
/// let states = ensemble.states_at(0.5);
/// assert!((states[1] - states[5]).abs() < 1e-3);
/// # Ok::<(), libration_cli::Failure>(())
/// ```
pub fn ensemble(
    arguments: impl IntoIterator<Item = OsString>,
    host: Arc<dyn Host>,
) -> Result<(Model, Ensemble), Failure> {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let call = Call::new(arguments.clone(), host);
    call::within(&call, || command::question(arguments).map_err(|error| Failure::refused(&error))?.ensemble())
}

/// Writes the answer to the host of the call.
fn answer(question: &command::Libration) -> Result<(), Failure> {
    let mut out = output::standard::StandardOutput::new();
    question.answer(&mut out)?;
    Ok(out.flush()?)
}
