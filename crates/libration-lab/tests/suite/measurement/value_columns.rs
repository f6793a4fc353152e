//! The columns of a table that hold values, each with that of its uncertainties.

use libration_lab::measurement::{Column, ReadOptions, Table, ValueColumn};
use libration_testing::zip_archive::{Packed, archive};

fn found(header: &str) -> Vec<(usize, Option<usize>)> {
    let row = vec!["1.5"; header.split(',').count()].join(",");
    let table = Table::read(format!("{header}\n{row}\n{row}\n").as_bytes(), &ReadOptions::default()).unwrap();
    let number = |column: &Column| match column {
        Column::Number(number) => *number,
        Column::Name(_) => 0,
    };
    let pair = |it: &ValueColumn| (number(&it.values), it.uncertainties.as_ref().map(number));
    table.value_columns().iter().map(pair).collect()
}

#[test]
fn uncertainties_go_with_the_values_that_their_headings_name() {
    for (header, expected) in [
        ("A,±,T,±", vec![(1, Some(2)), (3, Some(4))]),
        ("A (deg),T (s),error (s)", vec![(1, None), (2, Some(3))]),
        ("A,T,u(A),u(T)", vec![(1, Some(3)), (2, Some(4))]),
        ("L,T,σ_T", vec![(1, None), (2, Some(3))]),
        ("L,10T,u(10T)", vec![(1, None), (2, Some(3))]),
        ("T (s),dT (s),L (m)", vec![(1, Some(2)), (3, None)]),
        ("L (m),T (s),ΔT", vec![(1, None), (2, Some(3))]),
        ("L (m),uL (mm),T (s),u_T (ms)", vec![(1, Some(2)), (3, Some(4))]),
        ("x,y,xerr,yerr", vec![(1, Some(3)), (2, Some(4))]),
        ("x,dx,y,dy", vec![(1, Some(2)), (3, Some(4))]),
        ("L,T,SD", vec![(1, None), (2, Some(3))]),
        ("L,T,u (s)", vec![(1, None), (2, Some(3))]),
        ("angle,time,sigma_angle,error", vec![(1, Some(3)), (2, Some(4))]),
        ("T,u(T),σ_T", vec![(1, Some(2))]),
        // Another unit, another letter, or words that begin with d.
        ("T (s),dT (m)", vec![(1, None), (2, None)]),
        ("d (m),T (s)", vec![(1, None), (2, None)]),
        ("T (s),distance (m),diameter (m)", vec![(1, None), (2, None), (3, None)]),
        ("istance (m),distance (m)", vec![(1, Some(2))]),
        ("U (V),T (s)", vec![(1, None), (2, None)]),
        ("length (m),run A,run B,run C", vec![(1, None), (2, None), (3, None), (4, None)]),
        ("x,y1,y2,y3", vec![(1, None), (2, None), (3, None), (4, None)]),
        ("A,T", vec![(1, None), (2, None)]),
        ("±,A,T", vec![(2, None), (3, None)]),
    ] {
        assert_eq!(found(header), expected, "{header}");
    }
}

#[test]
fn a_column_of_names_holds_no_values() {
    let text = "student,L (m),T (s)\nAnn,0.25,1.0\nBob,0.5,1.42\n";
    let table = Table::read(text.as_bytes(), &ReadOptions::default()).unwrap();
    let values: Vec<Column> = table.value_columns().into_iter().map(|it| it.values).collect();
    assert_eq!(values, [Column::Number(2), Column::Number(3)]);
}

#[test]
fn a_table_is_the_first_sheet_with_two_columns_of_numbers() {
    let notes = Packed::stored("notes.csv", b"remark,number\nstring,1\nbob,2\n");
    let data = Packed::stored("data.csv", b"L (m),T (s)\n0.25,1.0\n0.5,1.42\n");
    let table = Table::read(&archive(&[notes, data]), &ReadOptions::default()).unwrap();
    assert_eq!(table.names(), ["L (m)", "T (s)"]);
    assert!(table.chosen_sheet().unwrap().contains("data"), "{:?}", table.chosen_sheet());
}

/// Headers that have more numbers as cells between blanks than between tabs.
#[test]
fn names_with_numbers_do_not_make_blanks_the_delimiter() {
    for names in ["t (s)\tangle 1 (rad)", "Length 1 (m)\tT (s)", "angle 1 (deg)\tangle 2 (deg)"] {
        let text = format!("{names}\n0.0\t0.1\n0.1\t0.2\n0.2\t0.25\n");
        let table = Table::read(text.as_bytes(), &ReadOptions::default()).unwrap();
        assert_eq!(table.names(), names.split('\t').collect::<Vec<_>>());
    }
}

#[test]
fn names_have_no_characters_that_turn_a_terminal() {
    let text = "\u{202e}angle\u{2066} (rad),T (s)\n0.1,2\n0.2,2.1\n";
    let table = Table::read(text.as_bytes(), &ReadOptions::default()).unwrap();
    assert_eq!(table.names(), ["angle (rad)", "T (s)"]);
}
