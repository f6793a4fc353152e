//! `libration man`: manual pages.

use clap::Command;
use libration_queries::QueryError;
use std::io::Write;

/// Write the manual page of the program or of a command
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration man > libration.1              # for a directory man1 of $MANPATH
  libration man fit trace > fit-trace.1    # to be read by: man ./fit-trace.1")]
pub(crate) struct Manual {
    /// The words of the command, such as fit trace; without them the program
    #[arg(value_name = "COMMAND")]
    words: Vec<String>,
}

impl Manual {
    pub(crate) fn write(&self, program: &mut Command, out: &mut dyn Write) -> Result<(), QueryError> {
        program.build();
        let described = self.words.iter().try_fold(&*program, |outer, word| {
            outer.find_subcommand(word).ok_or_else(|| unknown(&self.words, outer))
        })?;
        let mut page = vec![];
        clap_mangen::Man::new(described.clone()).render(&mut page)?;
        Ok(out.write_all(&page)?)
    }
}

fn unknown(words: &[String], outer: &Command) -> QueryError {
    let names: Vec<_> =
        outer.get_subcommands().map(Command::get_name).filter(|name| *name != "help").collect();
    let available = if names.is_empty() { String::new() } else { format!(": {}", names.join(", ")) };
    QueryError::misuse(format!(
        "there is no command `{}`; {} has these{available}",
        words.join(" "),
        outer.get_name()
    ))
}
