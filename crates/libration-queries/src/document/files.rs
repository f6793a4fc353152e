//! The files of a document: all of them are written, or none.

use super::{Document, DocumentFigure, html, markdown};
use crate::output::file::NewFile;
use crate::query_error::QueryError;
use libration_report::svg;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Reads the name of a document, which ends in `.html`, `.htm` or `.md`.
pub(crate) fn name(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    if is(&path, "html") || is(&path, "htm") || is(&path, "md") {
        return Ok(path);
    }
    Err("reports are written as HTML or Markdown: give a file name ending in .html or .md".to_owned())
}

/// Writes the document; with Markdown each picture becomes an SVG file next to it.
pub(crate) fn write(path: &Path, document: &Document) -> Result<(), QueryError> {
    let mut files = vec![];
    if is(path, "md") {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        for figure in document.figures() {
            let beside = path.with_file_name(file_name(&stem, figure));
            files.push((beside, svg::file(&figure.scene())));
        }
        files.push((path.to_owned(), markdown::page(document, |figure| file_name(&stem, figure))));
    } else {
        files.push((path.to_owned(), html::page(document)));
    }
    place(&files)
}

fn file_name(stem: &str, figure: &DocumentFigure) -> String {
    format!("{stem}-{}.svg", figure.name)
}

/// Writes all files next to their places before the first one is put into its own.
fn place(files: &[(PathBuf, String)]) -> Result<(), QueryError> {
    let mut written = vec![];
    for (path, text) in files {
        let mut file = NewFile::create(path)?;
        file.write_all(text.as_bytes())?;
        file.flush()?;
        written.push(file);
    }
    written.into_iter().try_for_each(NewFile::finish)
}

fn is(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|found| found.eq_ignore_ascii_case(ending))
}
