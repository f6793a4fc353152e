//! The short forms of numbers and lines in SVG.

use libration_report::internals::svg::{dots, escaped, rounded};

#[test]
fn numbers_are_as_short_as_they_can_be() {
    assert_eq!([1.0, -0.001, 2.5, 100.0].map(rounded), ["1", "0", "2.5", "100"]);
}

#[test]
fn dots_lead_from_one_to_the_next() {
    assert_eq!(dots(&[(1.0, 2.0), (1.5, 1.0)]), "m1 2h0m0.5 -1h0");
}

#[test]
fn what_is_written_is_never_taken_for_tags() {
    assert_eq!(escaped("a<b & \"c\"\u{1}"), "a&lt;b &amp; &quot;c&quot; ");
}
