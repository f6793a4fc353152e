//! The program `libration`.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(libration_cli::program(std::env::args_os().skip(1)))
}
