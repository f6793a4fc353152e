//! A document as Markdown (the tables are GitHub's).

use super::{Block, Document, DocumentFigure, DocumentTable};
use std::borrow::Cow;

/// The whole page; `file_of` gives the file of a picture.
pub(super) fn page(document: &Document, file_of: &dyn Fn(&DocumentFigure) -> String) -> String {
    let mut page = format!("# {}\n", escaped(&document.title));
    for section in &document.sections {
        page += &format!("\n## {}\n", escaped(section.title));
        for each in &section.blocks {
            page += &format!("\n{}\n", block(each, file_of));
        }
    }
    page
}

/// A block, with the files of its pictures.
pub fn block(block: &Block, file_of: &dyn Fn(&DocumentFigure) -> String) -> String {
    match block {
        Block::Headline(text) => format!("**{}**", escaped(text)),
        Block::Paragraph(text) => escaped(text).into_owned(),
        Block::List(items) => {
            items.iter().map(|item| format!("- {}", escaped(item))).collect::<Vec<_>>().join("\n")
        }
        Block::Aside(title, items) => {
            let items: Vec<String> = items.iter().map(|item| format!("> - {}", escaped(item))).collect();
            format!("> **{}**\n>\n{}", escaped(title), items.join("\n"))
        }
        Block::Table(table) => self::table(table),
        Block::Figure(figure) => {
            let caption = escaped(&figure.caption);
            format!("![{caption}](<{}>)\n\n*{caption}*", file_of(figure))
        }
    }
}

/// A table below its caption.
pub fn table(table: &DocumentTable) -> String {
    let line = |cells: &mut dyn Iterator<Item = Cow<'_, str>>| {
        format!("| {} |", cells.map(|cell| cell.replace('|', "\\|")).collect::<Vec<_>>().join(" | "))
    };
    let rule = table.columns.iter().map(|column| if column.is_of_numbers() { "---:" } else { "---" }.into());
    let mut lines = vec![
        format!("{}:\n", escaped(&table.caption)),
        line(&mut table.columns.iter().map(|column| escaped(&column.title))),
        line(&mut { rule }),
    ];
    lines.extend(table.rows.iter().map(|row| line(&mut row.iter().map(|cell| escaped(cell)))));
    lines.join("\n")
}

/// The text with special characters of Markdown escaped.
fn escaped(text: &str) -> Cow<'_, str> {
    const OWN: [char; 9] = ['\\', '`', '*', '_', '[', ']', '<', '>', '#'];
    if !text.contains(OWN) {
        return text.into();
    }
    let letters = text.chars().flat_map(|letter| {
        let backslash = OWN.contains(&letter).then_some('\\');
        backslash.into_iter().chain([letter])
    });
    letters.collect::<String>().into()
}
