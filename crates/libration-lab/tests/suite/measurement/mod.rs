//! Tables as instruments and people write them.

mod cell_units;
mod compound;
mod container;
mod counted_periods;
mod faults;
mod fitted_pivot;
mod heading;
mod number;
mod repeated_rows;
mod roles;
mod signal;
mod traces;

use libration_lab::measurement::{
    Column, CountedPeriods, Delimiter, Header, MeasurementError, ReadOptions, Role, Selection, Table, Unit,
    WrittenUnit,
};

fn read(text: &str) -> Result<Table, MeasurementError> {
    Table::read(text.as_bytes(), &ReadOptions::default())
}

fn first_two(text: &str) -> Result<Selection, MeasurementError> {
    read(text)?.select(&[Column::Number(1), Column::Number(2)])
}

#[test]
fn one_table_in_many_dialects_has_the_same_numbers() {
    for text in [
        "0.5,2.01\n1.0,2.13\n",
        "0.5, 2.01\r\n1.0, 2.13",
        "0.5;2.01\n1.0;2.13\n",
        "0,5;2,01\n1,0;2,13\n",
        "0.5\t2.01\n1.0\t2.13\n",
        "0,5\t2,01\n1,0\t2,13\n",
        "0.5 2.01\n1.0 2.13\n",
        "  0.5   2.01 \n\n1.0 \t 2.13",
        "0,5 2,01\n1,0 2,13\n",
        "0.5 2.01\r1.0 2.13\r",
        "\u{feff}amplitude,period\n0.5,2.01\n1.0,2.13\n",
        "# made up\n\n\"angle, rad\",\"period (s)\"\n# more\n0.5,2.01\n1.0,2.13\n",
        "theta T\n0.5 2.01\n1.0 2.13\n",
        "0.5,2.01,\n1.0,2.13,\n",
        "a,b,,\n0.5,2.01,,\n1.0,2.13\n",
        "a;b;remark\n0,5;2,01;calm\n1,0;2,13;\"windy; door open\"\n",
        " # said\n0.5,2.01\n1.0,2.13\n  \n",
    ] {
        let selection = first_two(text).unwrap_or_else(|error| panic!("{text:?}: {error}"));
        assert_eq!(selection.columns, [[0.5, 1.0], [2.01, 2.13]], "{text:?}");
        assert_eq!(selection.dropped, 0);
    }
}

#[test]
fn columns_are_found_by_number_or_by_name_without_case() {
    let table = read("X,Y,X',Y'\n1,2,3,4\n").unwrap();
    let chosen = table.select(&[" y' ".parse().unwrap(), "1".parse().unwrap()]).unwrap();
    assert_eq!(chosen.columns, [[4.0], [1.0]]);
    let message = table.select(&[Column::Name("period".into())]).unwrap_err().to_string();
    assert_eq!(
        message,
        "there is no column `period`: the table has columns 1 to 4, named `X`, `Y`, `X'`, `Y'`"
    );
    assert!(table.select(&[Column::Number(0)]).is_err() && table.select(&[Column::Number(5)]).is_err());
    let twice = read("t,T\n1,2\n").unwrap().select(&[Column::Name("t".into())]);
    assert_eq!(twice, Err(MeasurementError::AmbiguousColumn("t".into())));
}

#[test]
fn rows_without_a_number_are_dropped_and_counted() {
    let selection = first_two("A,T\n0.5,2.01\n,2.0\n0.7,NaN\n1.0,2.13\n").unwrap();
    assert_eq!((selection.columns, selection.dropped), (vec![vec![0.5, 1.0], vec![2.01, 2.13]], 2));
    assert_eq!(selection.lines, [2, 5]);
    assert_eq!(first_two("1,\n2,\n3,nan\n"), Err(MeasurementError::NothingComplete(3)));
}

#[test]
fn complaints_name_the_line() {
    let ragged = MeasurementError::Ragged { line: 5, cells: 3, expected: 2 };
    assert_eq!(read("# c\nA,T\n1,2\n\n3,4,5\n").unwrap_err(), ragged);
    assert_eq!(
        read("A,T\n1,2\n3\n").unwrap_err(),
        MeasurementError::Ragged { line: 3, cells: 1, expected: 2 }
    );
    let text = MeasurementError::NotANumber { line: 3, column: 2, cell: "two".into() };
    assert_eq!(first_two("A,T\n1,2\n3,two\n"), Err(text));
    let infinite = MeasurementError::NotANumber { line: 1, column: 2, cell: "inf".into() };
    assert_eq!(first_two("1,inf\n"), Err(infinite));
}

#[test]
fn files_that_are_no_tables_are_told_by_kind() {
    for (bytes, kind) in [
        (b"1,2\n\0\n".as_slice(), "NUL"),
        (b"PK\x03\x04rest", "ZIP archive"),
        (b"\xff\xfe1", "UTF-16"),
        (b"\xce\xb8 (\xb0)\n1\n", "broken UTF-8"),
    ] {
        let message = Table::read(bytes, &ReadOptions::default()).unwrap_err().to_string();
        assert!(message.contains(kind), "{message}");
    }
    for text in ["", "\n\n", "# only a comment\n", "A,T\n", "\u{feff}", ",,,\n"] {
        assert_eq!(read(text).unwrap_err(), MeasurementError::Empty, "{text:?}");
    }
    let small = ReadOptions { size_limit: 3, ..ReadOptions::default() };
    assert_eq!(Table::read(b"1,2\n", &small).unwrap_err(), MeasurementError::TooLarge { size: 4, limit: 3 });
}

#[test]
fn delimiter_and_header_may_be_said() {
    let options = ReadOptions {
        delimiter: Some(Delimiter::Whitespace),
        header: Header::Present,
        ..ReadOptions::default()
    };
    let table = Table::read(b"1 2\n0,5 2,01\n", &options).unwrap();
    assert_eq!(
        (table.names(), table.width(), table.delimiter()),
        (&["1".into(), "2".into()][..], 2, Delimiter::Whitespace)
    );
    assert_eq!(table.select(&[Column::Number(1)]).unwrap().columns, [[0.5]]);
    let absent = ReadOptions { header: Header::Absent, ..ReadOptions::default() };
    let table = Table::read(b"A,T\n1,2\n", &absent).unwrap();
    assert!(matches!(table.select(&[Column::Number(1)]), Err(MeasurementError::NotANumber { line: 1, .. })));
}

#[test]
fn an_unclosed_quote_or_a_megabyte_of_one_cell_is_an_error_not_a_stall() {
    let long = format!("A,T\n1,{}x\n", "1".repeat(1 << 20));
    assert!(first_two(&long).unwrap_err().to_string().len() < 200);
    assert!(first_two("A,T\n1,2\n\"3,4\n5,6\n").is_err());
}

#[test]
fn every_unit_is_turned_into_that_of_the_si() {
    use std::f64::consts::{PI, TAU};
    for (unit, expected) in [
        ("s", 3.0),
        ("ms", 3e-3),
        ("µs", 3e-6),
        ("ns", 3e-9),
        ("min", 180.0),
        ("rad", 3.0),
        ("mrad", 3e-3),
        ("°", PI / 60.0),
        ("turn", 3.0 * TAU),
        ("counts", 3.0),
        ("rad/s", 3.0),
        ("dps", PI / 60.0),
        ("m", 3.0),
        ("cm", 0.03),
        ("mm", 3e-3),
        ("in", 0.0762),
        ("px", 3.0),
    ] {
        let computed = unit.parse::<Unit>().unwrap().to_si(3.0);
        assert!((computed / expected - 1.0).abs() < 1e-15, "{unit}: {computed} {expected}");
    }
}

#[test]
fn columns_are_described_with_what_their_headings_say() {
    let table = read("L (cm),half period (s),u(L) (mm),σ_T\n25,0.5,2,0.01\n").unwrap();
    let column = Column::Number;
    assert_eq!(table.describe(&column(2)).unwrap(), "column 2 (`half period (s)`)");
    assert!(table.describe(&column(5)).is_err());
    assert_eq!(table.counted_periods(&column(2)), Ok(CountedPeriods::Said(0.5)));
    assert_eq!(table.counted_periods(&column(1)), Ok(CountedPeriods::Nothing));
    let of_lengths = table.unit_of_chosen(&column(3), Role::Lengths);
    assert_eq!(of_lengths, Ok(WrittenUnit::Known(Unit::Millimetre)));
    assert_eq!(table.unit_of_chosen(&column(4), Role::Times), Ok(WrittenUnit::Nothing));
    assert!(table.unit_of_chosen(&column(3), Role::Times).is_err());
    assert!(table.unit(&column(3), Role::Lengths).is_err(), "uncertainties are no lengths");
}
