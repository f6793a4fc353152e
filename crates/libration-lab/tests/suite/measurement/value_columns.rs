//! The columns of a table that hold values, each with that of its uncertainties.

use libration_lab::measurement::{Column, ReadOptions, Table, ValueColumn};

fn found(header: &str) -> Option<Vec<(usize, Option<usize>)>> {
    let row = vec!["1.5"; header.split(',').count()].join(",");
    let table = Table::read(format!("{header}\n{row}\n{row}\n").as_bytes(), &ReadOptions::default()).unwrap();
    let number = |column: &Column| match column {
        Column::Number(number) => *number,
        Column::Name(_) => 0,
    };
    let pair = |it: &ValueColumn| (number(&it.values), it.uncertainties.as_ref().map(number));
    Some(table.value_columns()?.iter().map(pair).collect())
}

#[test]
fn uncertainties_go_with_the_values_that_their_headings_name() {
    for (header, expected) in [
        ("A,±,T,±", vec![(1, Some(2)), (3, Some(4))]),
        ("A (deg),T (s),error (s)", vec![(1, None), (2, Some(3))]),
        ("A,T,u(A),u(T)", vec![(1, Some(3)), (2, Some(4))]),
        ("L,T,σ_T", vec![(1, None), (2, Some(3))]),
        ("L,10T,u(10T)", vec![(1, None), (2, Some(3))]),
    ] {
        assert_eq!(found(header), Some(expected), "{header}");
    }
    assert_eq!(found("A,T"), None);
    assert_eq!(found("±,A,T"), None);
    assert_eq!(found("T,u(T),σ_T"), None);
}
