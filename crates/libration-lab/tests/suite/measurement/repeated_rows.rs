//! Copies of rows: a table that was pasted twice, and readings that coincide.

use libration_lab::measurement::{Column, ReadOptions, Readings, RepeatedRows, Table};

fn readings(rows: &[&str]) -> Readings {
    let text = format!("L (m),T (s)\n{}\n", rows.join("\n"));
    let columns = [1, 2].map(|number| vec![Column::Number(number)]);
    Table::read(text.as_bytes(), &ReadOptions::default()).unwrap().readings(&columns).unwrap()
}

/// The lines that are left, and the copies.
fn once(rows: &[&str]) -> (Vec<u64>, Vec<RepeatedRows>) {
    let (left, repeated) = readings(rows).once(None);
    (left.lines, repeated)
}

const ROWS: [&str; 4] = ["0.2,0.90", "0.3,1.10", "0.4,1.27", "0.5,1.42"];

#[test]
fn copies_of_a_passage_count_once() {
    let passage = |lines: [u64; 2], of: [u64; 2]| RepeatedRows::Passage { lines, of };
    let twice = [ROWS, ROWS].concat();
    assert_eq!(once(&twice), (vec![2, 3, 4, 5], vec![passage([6, 9], [2, 5])]));
    let thrice = [ROWS, ROWS, ROWS].concat();
    let copies = vec![passage([6, 9], [2, 5]), passage([10, 13], [2, 5])];
    assert_eq!(once(&thrice), (vec![2, 3, 4, 5], copies));
    // A part of the table, next to rows of its own.
    let part = [&ROWS[..], &["0.6,1.55"], &ROWS[1..], &["0.7,1.68"]].concat();
    assert_eq!(once(&part), (vec![2, 3, 4, 5, 6, 10], vec![passage([7, 9], [3, 5])]));
    // Two readings of each length, all pasted again.
    let two = ["0.2,0.90", "0.2,0.91", "0.3,1.10", "0.3,1.10", "0.4,1.27", "0.4,1.28"];
    assert_eq!(once(&[two, two].concat()).1, [passage([8, 13], [2, 7])]);
    let each: Vec<&str> = ROWS.iter().flat_map(|row| [*row, *row]).collect();
    assert_eq!(once(&each), (vec![2, 4, 6, 8], vec![RepeatedRows::Each(2)]));
}

#[test]
fn readings_that_coincide_are_no_copies() {
    for rows in [
        // Repeated readings of one or two lengths.
        &["0.2,0.90", "0.2,0.91", "0.2,0.90", "0.2,0.91", "0.2,0.90", "0.2,0.91"][..],
        &["0.2,0.90", "0.2,0.90", "0.3,1.10", "0.3,1.10"],
        &["0.2,0.90", "0.2,0.90", "0.3,1.10", "0.3,1.10", "0.4,1.27", "0.4,1.28"],
        // A second series, in which one period differs; the other way round.
        &["0.2,0.90", "0.3,1.10", "0.4,1.27", "0.2,0.90", "0.3,1.11", "0.4,1.27"],
        &["0.2,0.90", "0.3,1.10", "0.4,1.27", "0.4,1.27", "0.3,1.10", "0.2,0.90"],
    ] {
        let (left, repeated) = once(rows);
        assert_eq!((left.len(), repeated.len()), (rows.len(), 0), "{rows:?}");
    }
}

#[test]
fn rows_of_different_groups_are_different() {
    let twice = [ROWS, ROWS].concat();
    let labels: Vec<String> = ["A", "B"].iter().flat_map(|name| [*name; 4]).map(str::to_owned).collect();
    let (left, repeated) = readings(&twice).once(Some(&labels));
    assert_eq!((left.lines.len(), repeated.len()), (8, 0));
}
