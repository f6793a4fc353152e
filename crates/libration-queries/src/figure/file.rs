//! The file of a picture: its extension decides between SVG, PDF and PNG.

use super::chart::Picture;
use super::{Layout, pdf, png};
use crate::output::{file, standard};
use crate::query_error::{QueryError, option};
use libration_report::svg;
use std::path::{Path, PathBuf};

/// Reads a file name that ends in `.svg`, `.pdf` or `.png`.
pub(crate) fn drawable(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    if text == "-" {
        standard::keep_for_files();
        return Ok(path);
    }
    if ["svg", "pdf", "png"].iter().any(|ending| is(&path, ending)) {
        return Ok(path);
    }
    Err("pictures are written as SVG, PDF or PNG: give a file name ending in .svg, .pdf or .png, or - for SVG on standard output"
        .to_owned())
}

/// Draws the picture in its size into its file, and announces it.
pub(crate) fn write(path: &Path, picture: &Picture, layout: &Layout) -> Result<String, QueryError> {
    let is_svg = is(path, "svg") || path == Path::new("-");
    if picture.animation.is_some() && !is_svg {
        let reason = format!("{} cannot be animated: give a file name ending in .svg", path.display());
        return Err(QueryError::usage(option("animate"), reason));
    }
    let scene = layout.scene(picture)?;
    let bytes = match is_svg {
        true => Ok(svg::file(&scene).into_bytes()),
        false if is(path, "pdf") => pdf::file(&scene),
        false => png::file(&scene),
    };
    file::write(path, &bytes.map_err(|reason| QueryError::no_result("the picture", reason))?)?;
    let points: usize =
        picture.panels.iter().flat_map(|panel| &panel.series).map(|series| series.points.len()).sum();
    Ok(format!("{} written: {}, {points} points{}", path.display(), picture.title, layout.remark(picture)))
}

fn is(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|found| found.eq_ignore_ascii_case(ending))
}
