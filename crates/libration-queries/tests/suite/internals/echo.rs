//! Long messages are shortened.

use libration_queries::internals::echo::{LONGEST_LINE, excerpt, shortened};

#[test]
fn what_is_short_stays_as_it_is() {
    let message = "--about: `foo` is not a place: give a number,\nsuch as 0.5";
    assert_eq!(shortened(message), message);
    // The note on what is left out would be as long as that.
    for letters in [60, 61, 80] {
        assert_eq!(excerpt(&"x".repeat(letters)), "x".repeat(letters));
    }
    assert!(excerpt(&"x".repeat(81)).contains("(21 characters)"));
}

#[test]
fn long_words_quotations_and_lines_are_cut_in_the_middle() {
    let long = "é".repeat(10_000);
    for message in [format!("`{long}` is not a place"), format!("{long} is not a place"), "x + ".repeat(3000)]
    {
        let shown = shortened(&message);
        assert!(shown.chars().count() < LONGEST_LINE + 40 && shown.contains("characters)…"), "{shown}");
    }
    assert!(shortened(&format!("`{}` is not a place", "x + ".repeat(3000))).ends_with("` is not a place"));
    assert_eq!(excerpt(&long).chars().count(), 60 + "…(9940 characters)…".chars().count());
}
