//! `libration page`: the page for browsers, where this command was built with it.

use crate::output::file;
use crate::query_error::QueryError;
use std::io::Write;
use std::path::{Path, PathBuf};

/// The file, if there was one when the command was built.
const PAGE: Option<&[u8]> = include!(concat!(env!("OUT_DIR"), "/page.rs"));

/// Write the page for browsers: one file, to open without a network
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "\
The page holds the moving pendulum, all formulas, series, derivations, fits of
measured swings, order and chaos. A command contains it if built with it:
  web/build
  LIBRATION_PAGE=web/dist/libration.html \\
    cargo install --path crates/libration-cli

Examples:
  libration page                            # writes libration.html
  libration page --output lesson.html")
)]
pub(crate) struct Page {
    /// The file to write; - for standard output
    #[arg(long, short, value_name = "FILE", default_value = "libration.html")]
    output: PathBuf,
}

impl Page {
    pub(crate) fn answer(&self, _: &mut dyn Write) -> Result<(), QueryError> {
        write(PAGE, &self.output)
    }
}

/// Writes the page to a file, if the command contains one.
pub fn write(page: Option<&[u8]>, path: &Path) -> Result<(), QueryError> {
    let page = page.ok_or_else(|| {
        QueryError::failed(
            "this command was built without the page: in the sources run web/build, which makes web/dist/libration.html; \
             LIBRATION_PAGE=web/dist/libration.html cargo install --path crates/libration-cli puts it into the command"
                .to_owned(),
        )
    })?;
    file::write(path, page)
}
