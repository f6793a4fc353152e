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

/// Writes the answer to the host of the call.
fn answer(question: &command::Libration) -> Result<(), Failure> {
    let mut out = output::standard::StandardOutput::new();
    question.answer(&mut out)?;
    Ok(out.flush()?)
}
