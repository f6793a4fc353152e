//! The option that draws a result, with its layout, for commands without more to say about their picture.

use super::chart::Picture;
use crate::query_error::QueryError;

/// The file of the picture and its layout.
#[cfg(not(target_family = "wasm"))]
#[derive(Debug, clap::Args)]
pub(crate) struct PictureOptions {
    /// Draw the result to FILE.svg, .pdf, .png or .json
    #[arg(long, value_name = "FILE", value_parser = super::file::drawable)]
    figure: Option<std::path::PathBuf>,
    #[command(flatten)]
    layout: super::Layout,
}

/// The page has no picture of these results: its rooms draw them.
#[cfg(target_family = "wasm")]
#[derive(Debug, clap::Args)]
pub(crate) struct PictureOptions {}

impl PictureOptions {
    /// Draws the picture where it is requested; the sentence about its file.
    #[cfg(not(target_family = "wasm"))]
    pub(crate) fn drawn(
        &self,
        picture: impl Fn() -> Picture + Send + Sync + 'static,
    ) -> Result<Vec<String>, QueryError> {
        super::file::drawn_later(self.figure.as_deref(), &self.layout, picture)
    }

    #[cfg(target_family = "wasm")]
    pub(crate) fn drawn(&self, _: impl Fn() -> Picture) -> Result<Vec<String>, QueryError> {
        Ok(vec![])
    }
}
