//! The file of a picture: its extension decides between SVG, PDF, PNG and JSON.

use super::chart::Picture;
use super::{Layout, data, pdf, png};
use crate::call;
use crate::output::{file, standard};
use crate::query_error::{QueryError, option};
use libration_report::svg;
use std::path::{Path, PathBuf};

/// Reads a file name that ends in `.svg`, `.pdf`, `.png` or `.json`.
pub(crate) fn drawable(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    if text == "-" {
        standard::keep_for_files();
        return Ok(path);
    }
    if ["svg", "pdf", "png", "json"].iter().any(|ending| is(&path, ending)) {
        return Ok(path);
    }
    Err("pictures are written as SVG, PDF, PNG or JSON: give a file name ending in .svg, .pdf, .png or .json, or - for SVG on standard output"
        .to_owned())
}

/// Returns `true` if there is a file for the picture, or if the host takes its chart.
pub(crate) fn is_drawn(path: Option<&Path>) -> bool {
    path.is_some() || call::current().host().takes_chart()
}

/// Draws the picture of a result into its file and passes its chart to the host, each where it is requested; the sentence about the file.
pub(crate) fn drawn(
    path: Option<&Path>,
    layout: &Layout,
    picture: impl FnOnce() -> Result<Picture, QueryError>,
) -> Result<Vec<String>, QueryError> {
    if !is_drawn(path) {
        return Ok(vec![]);
    }
    match (picture(), path) {
        (Ok(picture), _) => finished(path, layout, &picture),
        // A result that cannot be drawn has no chart; only a file that is named makes this an error.
        (Err(_), None) => Ok(vec![]),
        (Err(error), Some(_)) => Err(error),
    }
}

/// The same for a picture that takes time: for the host it is made when the chart is read.
pub(crate) fn drawn_later(
    path: Option<&Path>,
    layout: &Layout,
    picture: impl Fn() -> Picture + Send + Sync + 'static,
) -> Result<Vec<String>, QueryError> {
    if path.is_some() {
        return finished(path, layout, &picture());
    }
    data::pass(layout, picture);
    Ok(vec![])
}

/// Draws a picture into its file and passes it to the host in the same way.
pub(crate) fn finished(
    path: Option<&Path>,
    layout: &Layout,
    picture: &Picture,
) -> Result<Vec<String>, QueryError> {
    let sentence = path.map(|path| write(path, picture, layout)).transpose()?;
    if is_drawn(None) {
        let passed = picture.clone();
        data::pass(layout, move || passed.clone());
    }
    Ok(sentence.into_iter().collect())
}

/// Draws the picture in its size into its file, and announces it.
fn write(path: &Path, picture: &Picture, layout: &Layout) -> Result<String, QueryError> {
    let is_svg = is(path, "svg") || path == Path::new("-");
    if picture.animation.is_some() && !is_svg {
        let reason = format!("{} cannot be animated: give a file name ending in .svg", path.display());
        return Err(QueryError::usage(option("animate"), reason));
    }
    let is_data = is(path, "json");
    let bytes = if is_data {
        data::file(&layout.content(picture))
    } else {
        let scene = layout.scene(picture)?;
        match is_svg {
            true => Ok(svg::file(&scene).into_bytes()),
            false if is(path, "pdf") => pdf::file(&scene),
            false => png::file(&scene),
        }
    };
    file::write(path, &bytes.map_err(|reason| QueryError::no_result("the picture", reason))?)?;
    let points: usize =
        picture.panels.iter().flat_map(|panel| &panel.series).map(|series| series.points.len()).sum();
    let remarks = [layout.remark(picture), if is_data { layout.remark_on_data() } else { "" }].concat();
    Ok(format!("{} written: {}, {points} points{remarks}", path.display(), picture.title))
}

fn is(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(ending))
}
