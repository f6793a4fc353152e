//! The cells of a worksheet.

use libration_lab::internals::measurement::container::xlsx::worksheet::{
    MOST_COLUMNS, MOST_ROWS, position_of,
};

#[test]
fn addresses_are_held_to_what_a_worksheet_can_hold() {
    assert_eq!(position_of("A1"), Some((0, 0)));
    assert_eq!(position_of("ab10"), Some((9, 27)));
    assert_eq!(position_of("XFD1048576"), Some((MOST_ROWS - 1, MOST_COLUMNS - 1)));
    for bad in ["", "A", "1", "A0", "XFE1", "A1048577", "ZZZZZZZZZ1", "A99999999999", "A-1", "A1B", "µ1"] {
        assert_eq!(position_of(bad), None, "{bad}");
    }
}
