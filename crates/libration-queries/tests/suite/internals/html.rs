//! Documents as a page.

use libration_queries::internals::document::{Block, Document, DocumentFigure, DocumentTable, Section};
use libration_queries::internals::html::{SCRIPT, STYLE, page, table};
use libration_queries::internals::table::Column;
use libration_report::chart::Picture;

#[test]
fn what_is_written_is_never_taken_for_tags() {
    let text = "<script>alert(1)</script> & \"more\"";
    let figure = DocumentFigure {
        name: "a".to_owned(),
        caption: text.to_owned(),
        picture: Picture::new(text, vec![]),
    };
    let table = DocumentTable {
        caption: text.to_owned(),
        columns: vec![Column::words(text), Column::numbers(text)],
        rows: vec![vec![text.to_owned(); 2]],
    };
    let list = vec![text.to_owned()];
    let blocks = vec![
        Block::words(text),
        Block::Aside("doubts", list.clone()),
        Block::List(list),
        Block::Table(table),
    ];
    let sections = vec![Section { title: "what", blocks: [blocks, vec![Block::Figure(figure)]].concat() }];
    let page = page(&Document { title: text.to_owned(), sections });
    // The one script is that of the page.
    assert!(page.matches("<script").count() == 1 && page.contains(&format!("<script>\n{SCRIPT}")), "{page}");
    assert!(!page.contains("\"more\""), "{page}");
    assert!(page.contains("viewBox=\"0 0 ") && page.contains("role=\"img\""), "{page}");
}

#[test]
fn tables_can_be_copied_and_fit_small_screens() {
    let written = |columns: Vec<Column>| {
        let row = vec!["a_b".to_owned(); columns.len()];
        table(&DocumentTable { caption: "What".to_owned(), columns, rows: vec![row] })
    };
    let words = written(["one", "two", "three", "four"].map(Column::words).to_vec());
    assert!(words.contains("class=\"many\"") && words.contains("data-head=\"four\""), "{words}");
    assert!(words.contains("data-latex=\"% What\n\\begin{tabular}{llll}"), "{words}");
    assert!(words.contains("a\\_b &amp; a\\_b") && words.contains("<p class=\"copy\" hidden>"), "{words}");
    let numbers = [vec![Column::words("one")], ["two", "three", "four"].map(Column::numbers).to_vec()];
    assert!(!written(numbers.concat()).contains("class=\"many\""));
    assert!(STYLE.contains("@media print") && STYLE.contains(".copy{display:none}"));
}

#[test]
fn the_page_may_load_nothing() {
    let page = page(&Document { title: "what".to_owned(), sections: vec![] });
    assert!(page.contains("default-src 'none'"), "{page}");
    let outside = ["http", "//", "@import", "url(", "fetch", "XMLHttp"].map(|word| page.contains(word));
    assert_eq!(outside, [true, false, false, false, false, false], "http-equiv alone");
    assert_eq!(page.matches("http").count(), 1);
}
