//! The records of a workbook: kind, length, data, and the data that continue them.

use libration_lab::internals::measurement::container::xls::records::{Record, Records, small_number};

#[test]
fn small_numbers_are_whole_or_halves_of_doubles_or_hundredths_of_these() {
    let whole = |number: i32| (number << 2 | 2).cast_unsigned();
    let numbers = [0x3ff0_0000, 0x3ff0_0001, whole(-12345), whole(12345) | 1].map(small_number);
    assert_eq!(numbers.map(f64::to_bits), [1.0, 0.01, -12345.0, 123.45].map(f64::to_bits));
}

#[test]
fn a_record_that_is_cut_off_is_the_last() {
    let mut records = Records::new(&[0x0a, 0, 0, 0, 0x03, 0x02, 9, 0, 1]);
    assert_eq!(records.next().flatten().map(|record| record.kind), Some(Record::END));
    assert!(matches!(records.next(), Some(None)) && records.next().is_none());
}
