//! Text in the columns of a terminal.

use libration_queries::internals::screen_text::{columns_of, folded, padded};

#[test]
fn letters_take_the_columns_that_terminals_give_them() {
    assert_eq!([columns_of("θ₀ / °"), columns_of("时间"), columns_of("e\u{301}")], [6, 4, 1]);
    assert_eq!(padded("时", 4), "时  ");
}

#[test]
fn text_is_folded_at_blanks_and_loses_no_word() {
    assert_eq!(folded("one two three", 7), ["one two", "three"]);
    assert_eq!(folded("a-very-long-word and more", 6), ["a-very-long-word", "and", "more"]);
    assert_eq!(folded("two  blanks", 11), ["two  blanks"]);
}
