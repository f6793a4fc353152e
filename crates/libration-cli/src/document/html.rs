//! A document as one HTML file that needs nothing else: its pictures are inside.

use super::{Block, Document, Figure, Section, Table};
use crate::figure::draw;
use crate::output::table::Column;

/// Readable on a telephone, where wide tables and pictures are moved by the finger, and on paper.
const STYLE: &str = "\
:root{color-scheme:light}
body{font:17px/1.5 system-ui,'DejaVu Sans',Arial,sans-serif;color:#1a1a1a;background:#fff;max-width:56rem;margin:0 auto;\
padding:1rem}
h1{font-size:1.7rem;line-height:1.2;overflow-wrap:anywhere}
h2{font-size:1.25rem;margin-top:2.2rem;border-bottom:1px solid #bbb;padding-bottom:.2rem}
p,li{max-width:44rem}
figure{margin:1.4rem 0}
.wide{overflow-x:auto}
figure svg{display:block;width:100%;min-width:34rem;height:auto}
figcaption{font-size:.9rem;color:#444;max-width:44rem}
table{border-collapse:collapse;font-size:.95rem;font-variant-numeric:tabular-nums}
caption{text-align:left;font-size:.9rem;color:#444;padding-bottom:.3rem}
th,td{padding:.25rem .8rem;text-align:left;vertical-align:top;border-bottom:1px solid #ddd}
tbody th{font-weight:600}
.short,.number{white-space:nowrap}
.number{text-align:right}
thead th{border-bottom:2px solid #888}
@media (max-width:40rem){.short{white-space:normal}th,td{padding:.25rem .4rem}}
@media print{body{font-size:10.5pt;max-width:none;padding:0}figure,tr,li{break-inside:avoid}h2{break-after:avoid}\
.wide{overflow:visible}table{font-size:9pt}th,td{padding:.15rem .4rem}.short{white-space:normal}\
figure svg{min-width:0;max-height:20cm}}
";

/// Letters of a cell that is kept on one line.
const SHORT: usize = 32;

/// The whole page.
pub(super) fn page(document: &Document) -> String {
    let title = escaped(&document.title);
    let mut pictures = 0;
    let sections: String = document.sections.iter().map(|each| section(each, &mut pictures)).collect();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <link rel=\"icon\" href=\"data:,\">\n<title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n\
         <body>\n<main>\n<h1>{title}</h1>\n{sections}</main>\n</body>\n</html>\n"
    )
}

fn section(section: &Section, pictures: &mut usize) -> String {
    let blocks: String = section.blocks.iter().map(|each| block(each, pictures)).collect();
    format!("<section>\n<h2>{}</h2>\n{blocks}</section>\n", escaped(section.title))
}

fn block(block: &Block, pictures: &mut usize) -> String {
    match block {
        Block::Paragraph(text) => format!("<p>{}</p>\n", escaped(text)),
        Block::List(items) => {
            let items: String = items.iter().map(|item| format!("<li>{}</li>\n", escaped(item))).collect();
            format!("<ul>\n{items}</ul>\n")
        }
        Block::Table(table) => self::table(table),
        Block::Figure(figure) => {
            *pictures += 1;
            self::figure(figure, *pictures)
        }
    }
}

fn table(table: &Table) -> String {
    let head = |column: &Column| {
        format!("<th scope=\"col\"{}>{}</th>", class(column, false), escaped(&column.title))
    };
    let heads: String = table.columns.iter().map(head).collect();
    let rows: String = table.rows.iter().map(|cells| row(&table.columns, cells)).collect();
    format!(
        "<div class=\"wide\"><table>\n<caption>{}</caption>\n<thead><tr>{heads}</tr></thead>\n<tbody>\n{rows}</tbody>\n\
         </table></div>\n",
        escaped(&table.caption)
    )
}

/// The first cell names the row.
fn row(columns: &[Column], cells: &[String]) -> String {
    let cell = |(place, (column, cell)): (usize, (&Column, &String))| {
        let class = class(column, cell.chars().count() <= SHORT);
        let (tag, scope) = if place == 0 { ("th", " scope=\"row\"") } else { ("td", "") };
        format!("<{tag}{scope}{class}>{}</{tag}>", escaped(cell))
    };
    let cells: String = columns.iter().zip(cells).enumerate().map(cell).collect();
    format!("<tr>{cells}</tr>\n")
}

/// Numbers stand on the right, and short text is not broken.
fn class(column: &Column, is_short: bool) -> &'static str {
    match (column.is_of_numbers(), is_short) {
        (true, _) => " class=\"number\"",
        (false, true) => " class=\"short\"",
        (false, false) => "",
    }
}

/// A picture with names of its own for its parts, since all pictures share the names of the page.
fn figure(figure: &Figure, number: usize) -> String {
    let caption = escaped(&figure.caption);
    let svg = draw::to_svg(&figure.picture)
        .replace("id=\"", &format!("id=\"picture{number}-"))
        .replace("url(#", &format!("url(#picture{number}-"));
    format!(
        "<figure>\n<div class=\"wide\">{}</div>\n<figcaption>{caption}</figcaption>\n</figure>\n",
        scalable(&svg, &caption)
    )
}

/// The picture as wide as its place, its size given as a view box, and named for those who cannot see it.
fn scalable(svg: &str, caption: &str) -> String {
    let size = |name: &str| {
        let (_, rest) = svg.split_once(&format!(" {name}=\""))?;
        rest.split_once('"').map(|(size, _)| size)
    };
    let Some(((width, height), begin)) = size("width").zip(size("height")).zip(svg.find("<svg ")) else {
        return svg.to_owned();
    };
    let sized = svg[begin..].replacen(&format!(" width=\"{width}\""), "", 1).replacen(
        &format!(" height=\"{height}\""),
        "",
        1,
    );
    let begin = format!("<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{caption}\" ");
    sized.replacen("<svg ", &begin, 1)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::chart::Picture;

    #[test]
    fn what_is_written_is_never_taken_for_tags() {
        let text = "<script>alert(1)</script> & \"more\"";
        let figure =
            Figure { name: "a".to_owned(), caption: text.to_owned(), picture: Picture::new(text, vec![]) };
        let table = Table {
            caption: text.to_owned(),
            columns: vec![Column::words("x")],
            rows: vec![vec![text.to_owned()]],
        };
        let blocks = vec![Block::words(text), Block::List(vec![text.to_owned()]), Block::Table(table)];
        let sections =
            vec![Section { title: "what", blocks: [blocks, vec![Block::Figure(figure)]].concat() }];
        let page = page(&Document { title: text.to_owned(), sections });
        assert!(!page.contains("<script"), "{page}");
        assert!(page.contains("viewBox=\"0 0 ") && page.contains("role=\"img\""), "{page}");
    }
}
