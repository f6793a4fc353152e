//! Tables and paragraphs.

use libration_queries::internals::table::{Column, HELD_BACK, Table, paragraph};

fn in_columns(room: usize, columns: Vec<Column>, rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut out = vec![];
    let mut table = Table::new(columns);
    table.room = room;
    for row in rows {
        table.row(&mut out, row).unwrap();
    }
    table.finish(&mut out).unwrap();
    String::from_utf8(out).unwrap()
}

fn written(rows: usize) -> String {
    let columns = vec![Column::words("name"), Column::numbers("x / m")];
    in_columns(80, columns, (0..rows).map(|row| vec!["θ".to_owned(), row.to_string()]))
}

fn cells(texts: &[&str]) -> Vec<String> {
    texts.iter().map(|text| (*text).to_owned()).collect()
}

#[test]
fn columns_are_aligned_by_letters_and_not_by_bytes() {
    assert_eq!(written(2), "name  x / m\nθ         0\nθ         1\n");
}

#[test]
fn paragraphs_are_broken_before_the_column() {
    assert_eq!(paragraph("θ: ", "one two three", 10), "θ: one two\n   three");
    assert_eq!(paragraph("θ: ", "a-very-long-word", 10), "θ: a-very-long-word");
}

#[test]
fn long_tables_lose_no_row() {
    assert_eq!(written(2 * HELD_BACK + 1).lines().count(), 2 * HELD_BACK + 2);
}

#[test]
fn titles_are_folded_before_anything_else() {
    let columns = ["n", "time of the cycle / s", "amplitude / °"].map(Column::numbers).to_vec();
    let table = in_columns(24, columns, [cells(&["1", "2.0064", "60.000000"])]);
    assert_eq!(
        table,
        "n     time of  amplitude\n    the cycle        / °\n          / s\n1      2.0064  60.000000\n"
    );
}

#[test]
fn words_are_folded_where_there_is_no_room() {
    let columns = vec![Column::numbers("n"), Column::words("what")];
    let table = in_columns(40, columns, [cells(&["1", "a text that is much longer than the line, by far"])]);
    assert_eq!(table, "n  what\n1  a text that is much longer than the\n   line, by far\n");
}

#[test]
fn columns_without_room_stand_in_a_block_below() {
    let columns = ["t", "one", "two", "three"].map(Column::numbers).to_vec();
    let rows = [cells(&["0", "1.00000000", "2.00000000", "3.00000000"])];
    let table = in_columns(26, columns, rows);
    assert_eq!(
        table,
        "t         one         two\n0  1.00000000  2.00000000\n\nt       three\n0  3.00000000\n"
    );
}

/// A column of remarks takes no room, and no block of its own, as long as there are none.
#[test]
fn what_has_neither_title_nor_words_is_left_out() {
    let columns = [Column::numbers("n"), Column::numbers("x"), Column::words("")];
    let rows = |remark| [cells(&["1", "2.00000", ""]), cells(&["2", "3.00000", remark])];
    assert_eq!(in_columns(10, columns.to_vec(), rows("")), "n        x\n1  2.00000\n2  3.00000\n");
    assert!(in_columns(30, columns.to_vec(), rows("← least")).ends_with("2  3.00000  ← least\n"));
    let late = (0..=HELD_BACK).map(|row| cells(&["1", "2", if row < HELD_BACK { "" } else { "← last" }]));
    assert!(in_columns(80, columns.to_vec(), late).ends_with("1  2  ← last\n"));
}

#[test]
fn a_row_that_is_wider_than_those_before_begins_a_new_head() {
    let rows = (0..=HELD_BACK).map(|row| vec![if row < HELD_BACK { "1" } else { "1000" }.to_owned()]);
    let table = in_columns(80, vec![Column::numbers("n")], rows);
    assert!(table.ends_with("1\n\n   n\n1000\n"), "{}", &table[table.len() - 20..]);
    assert_eq!(table.matches('n').count(), 2);
}
