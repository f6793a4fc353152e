//! The styles of cells that show numbers as dates or times of day.

use libration_lab::internals::measurement::container::date_formats::shows_date;

#[test]
fn formats_of_dates_are_known_by_their_letters() {
    for format in ["dd.mm.yyyy", "hh:mm:ss.000", "[h]:mm", "[$-407]d. mmm"] {
        assert!(shows_date(format), "{format}");
    }
    for format in ["0.000", "General", "0.00E+00", "[Red]0.0", "0.0\" s\"", "0.0\\s"] {
        assert!(!shows_date(format), "{format}");
    }
}
