//! The files of a document: all of them are written, or none.

use super::{Document, DocumentFigure, html, latex, markdown};
use crate::figure::png;
use crate::output::file::NewFile;
use crate::query_error::QueryError;
use libration_report::svg;
use std::io::Write;
use std::path::{Path, PathBuf};

/// `true` if documents have no pictures in separate files, as in the page, which is smaller without the other formats.
const IS_ONE_FILE: bool = cfg!(target_family = "wasm");

/// Reads the name of a document, which ends in `.html`, `.htm`, `.md` or `.tex`.
pub(crate) fn name(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    let endings: &[&str] = if IS_ONE_FILE { &["html"] } else { &["html", "htm", "md", "tex"] };
    if endings.iter().any(|ending| is(&path, ending)) {
        return Ok(path);
    }
    if IS_ONE_FILE {
        return Err("the page writes reports as HTML: give a file name ending in .html".to_owned());
    }
    Err("reports are written as HTML, Markdown or LaTeX: give a file name ending in .html, .md or .tex"
        .to_owned())
}

/// Writes the document, and announces it; with Markdown each picture becomes an SVG file next to it, with LaTeX a PNG file.
pub(crate) fn write(path: &Path, document: &Document) -> Result<String, QueryError> {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let ending = if IS_ONE_FILE {
        ""
    } else if is(path, "md") {
        "svg"
    } else if is(path, "tex") {
        "png"
    } else {
        ""
    };
    let file_name = |figure: &DocumentFigure| format!("{stem}-{}.{ending}", figure.name);
    let mut files = vec![];
    for figure in document.figures().filter(|_| !ending.is_empty()) {
        files.push((path.with_file_name(file_name(figure)), picture(figure, ending)?));
    }
    let page = match ending {
        "svg" => markdown::page(document, &file_name),
        "png" => latex::page(document, &file_name),
        _ => html::page(document),
    };
    files.push((path.to_owned(), page.into_bytes()));
    write_all(&files)?;
    Ok(format!("{} written: report with pictures", path.display()))
}

fn picture(figure: &DocumentFigure, ending: &str) -> Result<Vec<u8>, QueryError> {
    match ending {
        "png" => png::file(&figure.scene()).map_err(|reason| QueryError::no_result("the picture", reason)),
        _ => Ok(svg::file(&figure.scene()).into_bytes()),
    }
}

/// Writes all files under temporary names before the first one is renamed.
fn write_all(files: &[(PathBuf, Vec<u8>)]) -> Result<(), QueryError> {
    let mut written = vec![];
    for (path, bytes) in files {
        let mut file = NewFile::create(path)?;
        file.write_all(bytes)?;
        file.flush()?;
        written.push(file);
    }
    written.into_iter().try_for_each(NewFile::finish)
}

fn is(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(ending))
}
