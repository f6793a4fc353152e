//! The escaped letters in the words of a workbook.

use libration_lab::internals::measurement::container::xlsx::contents::unescaped;

#[test]
fn escaped_letters_are_read_and_what_only_looks_like_them_stays() {
    assert_eq!(unescaped("a_x000A_b_x0041_"), "a\nbA");
    for plain in ["_x", "max_x", "_x000_", "_xZZZZ_", "_x00µ_x", "_x000A"] {
        assert_eq!(unescaped(plain), plain);
    }
}
