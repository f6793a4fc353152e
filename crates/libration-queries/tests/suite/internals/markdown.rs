//! Documents as Markdown.

use libration_queries::internals::document::{Block, DocumentTable};
use libration_queries::internals::markdown::{block, table as written};
use libration_queries::internals::table::Column;

#[test]
fn what_must_not_be_missed_stands_out() {
    let aside = Block::Aside("Doubts", vec!["one_1".to_owned(), "two".to_owned()]);
    assert_eq!(block(&aside, &|_| String::new()), "> **Doubts**\n>\n> - one\\_1\n> - two");
}

#[test]
fn tables_have_a_rule_and_text_is_escaped() {
    let table = DocumentTable {
        caption: "What".to_owned(),
        columns: vec![Column::words("name"), Column::numbers("value")],
        rows: vec![vec!["a_b|c".to_owned(), "1".to_owned()]],
    };
    assert_eq!(written(&table), "What:\n\n| name | value |\n| --- | ---: |\n| a\\_b\\|c | 1 |");
}
