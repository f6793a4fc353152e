//! Dates and words as they are told.

use libration_queries::internals::provenance::{date, quoted};

/// Dates by `date -u -d @SECONDS`.
#[test]
fn dates_are_those_of_the_calendar() {
    for (seconds, expected) in [
        (0, "1970-01-01 00:00 UTC"),
        (951_782_400, "2000-02-29 00:00 UTC"),
        (951_868_799, "2000-02-29 23:59 UTC"),
        (951_868_800, "2000-03-01 00:00 UTC"),
        (1_000_000_000, "2001-09-09 01:46 UTC"),
        (1_709_164_800, "2024-02-29 00:00 UTC"),
        (1_735_689_599, "2024-12-31 23:59 UTC"),
        (4_107_542_400, "2100-03-01 00:00 UTC"),
    ] {
        assert_eq!(date(seconds), expected);
    }
}

#[test]
fn words_are_quoted_for_a_shell() {
    assert_eq!(quoted("--length"), "--length");
    assert_eq!(quoted("0.57m±0.004m"), "0.57m±0.004m");
    assert_eq!(quoted("my swing.csv"), "'my swing.csv'");
    assert_eq!(quoted("it's"), r"'it'\''s'");
    assert_eq!(quoted(""), "''");
}
