//! The file of a picture: its extension decides between SVG and PNG.

use super::chart::Picture;
use super::{Sizes, png};
use crate::output::{file, standard};
use crate::query_error::{QueryError, option};
use libration_report::svg;
use std::path::{Path, PathBuf};

/// Reads a file name that ends in `.svg` or `.png`.
pub(crate) fn drawable(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    if text == "-" {
        standard::keep_for_files();
        return Ok(path);
    }
    if is(&path, "svg") || is(&path, "png") {
        return Ok(path);
    }
    Err("pictures are written as SVG or PNG: give a file name ending in .svg or .png, or - for SVG on standard output"
        .to_owned())
}

/// Draws the picture in its size into its file, and announces it.
pub(crate) fn write(path: &Path, picture: &Picture, sizes: &Sizes) -> Result<String, QueryError> {
    if picture.animation.is_some() && is(path, "png") {
        let reason = format!("{} cannot be animated: give a file name ending in .svg", path.display());
        return Err(QueryError::usage(option("animate"), reason));
    }
    let scene = sizes.scene(picture)?;
    let bytes = if is(path, "svg") || path == Path::new("-") {
        svg::file(&scene).into_bytes()
    } else {
        png::file(&scene).map_err(|reason| QueryError::no_result("the picture", reason))?
    };
    file::write(path, &bytes)?;
    let points: usize =
        picture.panels.iter().flat_map(|panel| &panel.series).map(|series| series.points.len()).sum();
    Ok(format!("{} written: {}, {points} points", path.display(), picture.title))
}

fn is(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|found| found.eq_ignore_ascii_case(ending))
}
