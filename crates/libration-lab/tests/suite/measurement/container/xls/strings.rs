//! Strings in a workbook: one or two bytes for each letter, and a table of shared ones that extends over several records.

use libration_lab::internals::measurement::container::xls::records::Record;
use libration_lab::internals::measurement::container::xls::strings::{long, short, table};

#[test]
fn strings_run_on_into_the_next_record_with_letters_of_another_width() {
    let first = [1, 0, 0, 0, 1, 0, 0, 0, 4, 0, 0, b'a', b'b'];
    let second = [1, 0xb8, 3, b'!', 0, 1, 0, 0, b'z'];
    let record = Record { kind: Record::STRINGS, data: &first, continued: vec![&second] };
    assert_eq!(table(&record), ["abθ!", "z"]);
}

#[test]
fn a_string_that_is_cut_off_is_none() {
    assert_eq!(short(&[3, 0, b'a', b'b']), None);
    assert_eq!(long(&[1, 0, 1, 0xb8, 3]), Some("θ".into()));
}
