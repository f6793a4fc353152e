//! The `libration` command: it reads the question, calls the library, and writes the answer.

mod arguments;
mod command;
mod document;
mod failure;
mod figure;
mod interrupt;
mod output;
mod parallel;

use clap::Parser;
use output::progress::Heartbeat;
use std::io::Write;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = arguments::protect_negative_values(std::env::args_os());
    let question = match command::Libration::try_parse_from(arguments) {
        Ok(question) => question,
        Err(error) => return failure::refuse(&error),
    };
    let mut out = output::standard::StandardOutput::new();
    let heartbeat = Heartbeat::begin();
    let answered = question.answer(&mut out).and_then(|()| Ok(out.flush()?));
    heartbeat.end();
    answered.map_or_else(|failure| failure.report(), |()| ExitCode::SUCCESS)
}
