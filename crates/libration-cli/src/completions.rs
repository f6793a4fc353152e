//! `libration completions`: the script that completes the command in a shell.

use clap::Command;
use clap_complete::Shell;
use libration_queries::QueryError;
use std::io::Write;

/// Write the completion script for a shell
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  source <(libration completions bash)        # in bash, for this session
  libration completions zsh > _libration      # into a directory of $fpath")]
pub(crate) struct Completions {
    /// The shell
    shell: Shell,
}

impl Completions {
    pub(crate) fn write(&self, program: &mut Command, out: &mut dyn Write) -> Result<(), QueryError> {
        // Written to memory first, because the generator panics if its writer is closed.
        let mut script = vec![];
        clap_complete::generate(self.shell, program, "libration", &mut script);
        Ok(out.write_all(&script)?)
    }
}
