//! Documents to read and to print: sections with text, tables and pictures, as one HTML file, or as Markdown or
//! LaTeX with the pictures in separate files.

mod files;
pub(crate) mod html;
pub(crate) mod latex;
pub(crate) mod markdown;
pub(crate) mod provenance;

pub(crate) use files::{name, write};
pub(crate) use provenance::provenance;

use crate::figure::chart::Picture;
use crate::output::table::Column;
use libration_report::draw;
use libration_report::format::{PictureFormat, TooSmall};
use libration_report::scene::Scene;

/// A document.
#[derive(Clone, Debug)]
pub struct Document {
    /// The title.
    pub title: String,
    /// The sections.
    pub sections: Vec<Section>,
}

/// A part of a document with a title.
#[derive(Clone, Debug)]
pub struct Section {
    /// The title.
    pub title: &'static str,
    /// The blocks of the section.
    pub blocks: Vec<Block>,
}

/// A part of a section.
#[derive(Clone, Debug)]
pub enum Block {
    /// The result in one line.
    Headline(String),
    /// A paragraph.
    Paragraph(String),
    /// A list of sentences.
    List(Vec<String>),
    /// A list that must not be missed, under a title.
    Aside(&'static str, Vec<String>),
    /// A table.
    Table(DocumentTable),
    /// A picture.
    Figure(DocumentFigure),
}

/// A table with a caption above it; the first column names the row.
#[derive(Clone, Debug)]
pub struct DocumentTable {
    /// The line above.
    pub caption: String,
    /// The columns.
    pub columns: Vec<Column>,
    /// The cells of each row.
    pub rows: Vec<Vec<String>>,
}

/// A picture with its caption.
#[derive(Clone, Debug)]
pub struct DocumentFigure {
    /// Part of the name of its file, if it has a separate one.
    pub name: String,
    /// Caption, which describes the figure also for readers who cannot see it.
    pub caption: String,
    /// The picture.
    pub picture: Picture,
}

impl DocumentFigure {
    /// The picture as wide as the text of a page, or as wide as it must be.
    fn scene(&self) -> Scene {
        let usual = PictureFormat::PAGE;
        let fitting = draw(&self.picture, &usual).or_else(|error| match error {
            TooSmall::Width(width) => draw(&self.picture, &PictureFormat { width, ..usual }),
            TooSmall::Height(_) => Err(error),
        });
        fitting.expect("the width is enough, and the height follows from it")
    }
}

impl Section {
    /// The section of these blocks; `None` if there are none.
    pub(crate) fn new(title: &'static str, blocks: Vec<Block>) -> Option<Self> {
        (!blocks.is_empty()).then_some(Self { title, blocks })
    }
}

impl Block {
    /// A paragraph of these words.
    pub fn words(text: impl Into<String>) -> Self {
        Self::Paragraph(text.into())
    }
}

impl Document {
    fn figures(&self) -> impl Iterator<Item = &DocumentFigure> {
        let blocks = self.sections.iter().flat_map(|section| &section.blocks);
        blocks.filter_map(|block| if let Block::Figure(figure) = block { Some(figure) } else { None })
    }
}
