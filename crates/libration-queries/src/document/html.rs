//! A document as one self-contained HTML file, with its pictures inside.

use super::{Block, Document, DocumentFigure, DocumentTable, Section, latex};
use crate::output::table::Column;
use libration_report::svg;

/// Style for telephones and paper. Tables fit the width: their cells are broken, and on the screen of a telephone each row of
/// a wide table becomes a list.
pub const STYLE: &str = "\
:root{color-scheme:light}
body{font:17px/1.5 system-ui,'DejaVu Sans',Arial,sans-serif;color:#1a1a1a;background:#fff;max-width:56rem;margin:0 auto;\
padding:1rem}
h1{font-size:1.7rem;line-height:1.2;overflow-wrap:anywhere}
h2{font-size:1.25rem;margin-top:2.2rem;border-bottom:1px solid #bbb;padding-bottom:.2rem}
p,li{max-width:44rem;overflow-wrap:anywhere}
figure{margin:1.4rem 0}
.wide{overflow-x:auto}
figure svg{display:block;width:100%;height:auto}
.wide svg{min-width:26rem}
.headline{font-size:1.35rem;font-weight:600}
figcaption{font-size:.9rem;color:#444;max-width:44rem}
.aside{border-left:.3rem solid #b35c00;background:#fff6e8;padding:.3rem 1rem;margin:1rem 0}
.aside h3{font-size:1rem;margin:.3rem 0}
.aside ul{margin:.3rem 0;padding-left:1.2rem}
table{border-collapse:collapse;font-size:.95rem;font-variant-numeric:tabular-nums}
caption{text-align:left;font-size:.9rem;color:#444;padding-bottom:.3rem}
th,td{padding:.25rem .8rem;text-align:left;vertical-align:top;border-bottom:1px solid #ddd}
tbody th{font-weight:600}
.short,.number{white-space:nowrap}
.many .short{white-space:normal}
td:last-child{overflow-wrap:anywhere}
.number{text-align:right}
thead th{border-bottom:2px solid #888;white-space:normal}
.copy{margin:.3rem 0 1rem}
.copy button{font:inherit;font-size:.8rem;margin-right:.5rem}
@media (max-width:60rem){table{font-size:.82rem}th,td{padding:.2rem .35rem}\
.short,.number{white-space:normal}}
@media (max-width:40rem){.many thead{display:none}.many,.many caption,.many tbody,.many tr,.many th,.many td{display:block}\
.many tr{border-bottom:2px solid #888;padding:.3rem 0}.many th,.many td{border:0;text-align:left;padding:.1rem 0}\
.many td::before{content:attr(data-head) ': ';color:#555}.many td:empty{display:none}}
@media print{body{font-size:10.5pt;max-width:none;padding:0}figure,tr,li,.aside{break-inside:avoid}h2{break-after:avoid}\
.wide{overflow:visible}table{font-size:9pt}th,td{padding:.15rem .4rem}.short,.number{white-space:normal}\
.wide svg{min-width:0;max-height:20cm}.copy{display:none}}
@media screen and (prefers-color-scheme:dark){:root{color-scheme:dark}body{color:#ededed;background:#121417}\
figcaption,caption{color:#bbb}.aside{background:#2a2114}th,td,h2{border-color:#444}.many td::before{color:#aaa}}
";

/// Script of the buttons below tables, which copy them as a table for word processors, or as LaTeX. Without scripts there are no buttons.
pub const SCRIPT: &str = "\
for (const bar of document.querySelectorAll('.copy')) {
  const table = bar.parentNode.querySelector('table');
  const text = Array.from(table.rows, row => Array.from(row.cells, cell => cell.textContent).join('\\t')).join('\\n');
  bar.hidden = false;
  for (const button of bar.children) button.onclick = () => {
    const fill = event => {
      event.preventDefault();
      const latex = button.className === 'latex';
      event.clipboardData.setData('text/plain', latex ? table.dataset.latex : text);
      if (!latex) event.clipboardData.setData('text/html', '<table>' + table.innerHTML + '</table>');
    };
    document.addEventListener('copy', fill);
    const done = document.execCommand('copy');
    document.removeEventListener('copy', fill);
    button.title = done ? 'copied' : 'the browser did not allow it';
    button.style.outline = done ? '2px solid #2a7' : '2px solid #b35c00';
  };
}
";

/// The content security policy of the page, which loads nothing: its style, its script and its icon are inside.
const POLICY: &str =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:";

/// Number of columns above which the rows of a table become lists on the screen of a telephone.
const MANY: usize = 4;

/// Letters of a cell that is kept on one line.
const SHORT: usize = 32;

/// The whole page.
pub fn page(document: &Document) -> String {
    let title = escaped(&document.title);
    let sections: String = document.sections.iter().map(section).collect();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <link rel=\"icon\" href=\"data:,\">\n<title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n\
         <body>\n<main>\n<h1>{title}</h1>\n{sections}</main>\n<script>\n{SCRIPT}</script>\n</body>\n</html>\n"
    )
}

fn section(section: &Section) -> String {
    let blocks: String = section.blocks.iter().map(block).collect();
    format!("<section>\n<h2>{}</h2>\n{blocks}</section>\n", escaped(section.title))
}

fn block(block: &Block) -> String {
    match block {
        Block::Headline(text) => format!("<p class=\"headline\">{}</p>\n", escaped(text)),
        Block::Paragraph(text) => format!("<p>{}</p>\n", escaped(text)),
        Block::List(items) => list(items),
        Block::Aside(title, items) => {
            format!("<div class=\"aside\">\n<h3>{}</h3>\n{}</div>\n", escaped(title), list(items))
        }
        Block::Table(table) => self::table(table),
        Block::Figure(figure) => self::figure(figure),
    }
}

fn list(items: &[String]) -> String {
    let items: String = items.iter().map(|item| format!("<li>{}</li>\n", escaped(item))).collect();
    format!("<ul>\n{items}</ul>\n")
}

/// The table, which becomes a list of lists on small screens if it has many columns of words, with its buttons.
pub fn table(table: &DocumentTable) -> String {
    let words = table.columns.iter().filter(|column| !column.is_of_numbers()).count();
    let many = if table.columns.len() >= MANY && words > 1 { " class=\"many\"" } else { "" };
    let head = |column: &Column| {
        format!("<th scope=\"col\"{}>{}</th>", class(column, false), escaped(&column.title))
    };
    let heads: String = table.columns.iter().map(head).collect();
    let rows: String = table.rows.iter().map(|cells| row(&table.columns, cells)).collect();
    format!(
        "<div><div class=\"wide\"><table{many} data-latex=\"{}\">\n<caption>{}</caption>\n<thead><tr>{heads}</tr></thead>\n\
         <tbody>\n{rows}</tbody>\n</table></div>\n<p class=\"copy\" hidden><button class=\"word\">Copy for Word</button>\
         <button class=\"latex\">Copy for LaTeX</button></p></div>\n",
        escaped(&latex::tabular(table)),
        escaped(&table.caption)
    )
}

/// The first cell names the row.
fn row(columns: &[Column], cells: &[String]) -> String {
    let cell = |(index, (column, cell)): (usize, (&Column, &String))| {
        let class = class(column, cell.chars().count() <= SHORT);
        let (tag, scope) = if index == 0 { ("th", " scope=\"row\"") } else { ("td", "") };
        let head =
            if index == 0 { String::new() } else { format!(" data-head=\"{}\"", escaped(&column.title)) };
        format!("<{tag}{scope}{class}{head}>{}</{tag}>", escaped(cell))
    };
    let cells: String = columns.iter().zip(cells).enumerate().map(cell).collect();
    format!("<tr>{cells}</tr>\n")
}

/// The class of a column: numbers are aligned to the right, and short text is not broken.
fn class(column: &Column, is_short: bool) -> &'static str {
    match (column.is_of_numbers(), is_short) {
        (true, _) => " class=\"number\"",
        (false, true) => " class=\"short\"",
        (false, false) => "",
    }
}

fn figure(figure: &DocumentFigure) -> String {
    let caption = escaped(&figure.caption);
    let svg = svg::inline(&figure.scene());
    format!("<figure>\n<div class=\"wide\">{svg}</div>\n<figcaption>{caption}</figcaption>\n</figure>\n")
}

pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
