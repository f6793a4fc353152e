//! The roles of columns by their headings, units, values and neighbours.

use libration_lab::measurement::{
    Column, ColumnRole, GivenRoles, MeasurementError, ReadOptions, Role, Table, TableQuantity, TableRoles,
    UncertaintyKind,
};
use libration_testing::zip_archive::{Packed, archive};

const AMPLITUDE: TableQuantity = TableQuantity { name: "amplitude", role: Role::Angles, only_named: None };
const LENGTH: TableQuantity = TableQuantity { name: "length", role: Role::Lengths, only_named: None };
const PERIOD: TableQuantity = TableQuantity { name: "period", role: Role::Times, only_named: None };

fn read(text: &str) -> Table {
    Table::read(text.as_bytes(), &ReadOptions::default()).unwrap()
}

/// A table whose rows make columns of the same stem repeat each other.
fn of_header(header: &str) -> Table {
    let row = vec!["1.5"; header.split(',').count()].join(",");
    let other = vec!["2.25"; header.split(',').count()].join(",");
    read(&format!("{header}\n{row}\n{other}\n"))
}

fn number(column: &Column) -> usize {
    match column {
        Column::Number(number) => *number,
        Column::Name(_) => 0,
    }
}

fn roles(table: &Table, needed: &[TableQuantity]) -> Result<TableRoles, MeasurementError> {
    table.roles(needed, &GivenRoles::default())
}

/// Columns of readings of both quantities, and columns of their uncertainties.
fn columns(table: &Table, needed: &[TableQuantity]) -> [(Vec<usize>, Option<usize>); 2] {
    let roles = roles(table, needed).unwrap();
    [0, 1].map(|quantity| {
        let of = &roles.quantities[quantity];
        (
            of.readings.iter().map(number).collect(),
            of.uncertainties.as_ref().map(|(column, _)| number(column)),
        )
    })
}

#[test]
fn uncertainties_go_with_the_values_that_their_headings_name() {
    for (header, expected) in [
        ("L,±,T,±", [(1, Some(2)), (3, Some(4))]),
        ("L (m),T (s),error (s)", [(1, None), (2, Some(3))]),
        ("L,T,u(L),u(T)", [(1, Some(3)), (2, Some(4))]),
        ("L,T,σ_T", [(1, None), (2, Some(3))]),
        ("L,10T,u(10T)", [(1, None), (2, Some(3))]),
        ("T (s),dT (s),L (m)", [(3, None), (1, Some(2))]),
        ("L (m),T (s),ΔT", [(1, None), (2, Some(3))]),
        ("L (m),uL (mm),T (s),u_T (ms)", [(1, Some(2)), (3, Some(4))]),
        ("x,y,xerr,yerr", [(1, Some(3)), (2, Some(4))]),
        ("x,dx,y,dy", [(1, Some(2)), (3, Some(4))]),
        ("L,T,SD", [(1, None), (2, Some(3))]),
        // Units distinguish those without a name.
        ("L,sigma (s),T (s)", [(1, None), (3, Some(2))]),
        ("T (s),± (mm),L (cm)", [(3, Some(2)), (1, None)]),
        ("L (m),T (s),± (s),± (cm)", [(1, Some(4)), (2, Some(3))]),
        ("L (m),T,± (s)", [(1, None), (2, Some(3))]),
        ("L (m),± (s),T", [(1, None), (3, None)]),
        ("L,T,u (s)", [(1, None), (2, Some(3))]),
        ("L (m),mean T (s),standard deviation (s)", [(1, None), (2, Some(3))]),
        ("L (m),T mean (s),s.e.m. (s)", [(1, None), (2, Some(3))]),
        ("L (m),T (s),écart-type (s)", [(1, None), (2, Some(3))]),
        ("length,time,sigma_length,error", [(1, Some(3)), (2, Some(4))]),
        ("T,u(T),σ_T,L", [(4, None), (1, Some(2))]),
        ("d (m),T (s)", [(1, None), (2, None)]),
        ("T (s),distance (m),diameter (m)", [(2, None), (1, None)]),
        ("U (V),T (s)", [(1, None), (2, None)]),
        ("±,L,T", [(2, None), (3, None)]),
        // By symbol or initial.
        ("Length (m),Period (s),L uncertainty,P uncertainty", [(1, Some(3)), (2, Some(4))]),
        ("Length (m),Period (s),L error,T error", [(1, Some(3)), (2, Some(4))]),
    ] {
        let expected = expected.map(|(value, of)| (vec![value], of));
        assert_eq!(columns(&of_header(header), &[LENGTH, PERIOD]), expected, "{header}");
    }
}

#[test]
fn numbers_of_swings_may_be_halves_and_a_zero_among_them_is_no_reason_to_ignore_them() {
    for numbers in [["10", "5.5"], ["10", "0"], ["10", "20"]] {
        let [first, second] = numbers;
        let table = read(&format!("L (m),t (s),swings\n1,20.1,{first}\n0.5,7.8,{second}\n"));
        assert_eq!(roles(&table, &[LENGTH, PERIOD]).unwrap().swings, Some(Column::Number(3)), "{numbers:?}");
    }
    let table = read("L (m),t (s),n\n1,20.1,1.3\n0.5,7.8,5.5\n");
    assert_eq!(roles(&table, &[LENGTH, PERIOD]).unwrap().swings, None);
}

/// T is the initial of Theta and the symbol of the period: only both columns together decide.
#[test]
fn uncertainties_that_only_an_initial_names_are_given_where_one_assignment_is_left() {
    let both = of_header("Theta (rad),Period (s),T uncertainty,P uncertainty");
    assert_eq!(columns(&both, &[AMPLITUDE, PERIOD]), [(vec![1], Some(3)), (vec![2], Some(4))]);
    let refused =
        roles(&of_header("Theta (rad),Period (s),T uncertainty"), &[AMPLITUDE, PERIOD]).unwrap_err();
    let text = refused.to_string();
    assert!(text.ends_with("give role=3=amplitude-uncertainty or 3=period-uncertainty"), "{text}");
}

#[test]
fn columns_of_one_name_and_different_numbers_are_repeated_readings() {
    for header in [
        "L (m),t1 (s),t2 (s),t3 (s)",
        "L (m),Trial 1 (s),Trial 2 (s),Trial 3 (s)",
        "L (m),T (s),T (s),T (s)",
        "L (m),1st reading (s),2nd reading (s),3rd reading (s)",
        "length (m),run A,run B,run C",
        "L (m),T_1 / s,T_2 / s,T_3 / s",
        "x,y1,y2,y3",
    ] {
        assert_eq!(columns(&of_header(header), &[LENGTH, PERIOD])[1].0, [2, 3, 4], "{header}");
    }
    // Values that differ by more than half are other quantities.
    let unlike = read("L (m),t1 (s),t2 (s)\n0.25,1.0,10.1\n0.5,1.4,14.2\n");
    assert_eq!(columns(&unlike, &[LENGTH, PERIOD])[1].0, [2]);
}

#[test]
fn functions_of_the_readings_are_not_used() {
    let table = read(
        "L (cm),t1 (s),t2 (s),mean t (s),T (s),T^2 (s^2),SD (s)\n25,10.0,10.1,10.05,1.005,1.010,0.07\n50,14.2,14.2,14.2,1.42,2.016,0.0\n",
    );
    let roles = roles(&table, &[LENGTH, PERIOD]).unwrap();
    assert_eq!(roles.quantities[1].readings, [Column::Number(2), Column::Number(3)]);
    assert_eq!(roles.quantities[1].swings, Some(10.0), "T is a tenth of the mean");
    assert_eq!(roles.quantities[1].uncertainties, None);
    assert_eq!(roles.unused, [4, 5, 6, 7].map(Column::Number));
    let scattered = read("L (cm),t1 (s),t2 (s),± (s)\n25,10.0,10.1,0.1\n50,14.2,14.2,0.1\n");
    let roles = scattered.roles(&[LENGTH, PERIOD], &GivenRoles::default()).unwrap();
    assert!(roles.notes[0].contains("4=period-uncertainty"), "{:?}", roles.notes);
}

#[test]
fn squares_are_read_where_there_are_no_periods() {
    let squares = roles(&read("L (m),T^2 (s^2)\n0.25,1.0\n0.5,2.0\n"), &[LENGTH, PERIOD]).unwrap();
    assert!(squares.quantities[1].are_squares);
    let both =
        roles(&read("L (m),T^2 (s^2),T (s)\n0.25,1.0,1.0\n0.5,2.0,1.41\n"), &[LENGTH, PERIOD]).unwrap();
    assert_eq!(
        (both.quantities[1].readings.clone(), both.quantities[1].are_squares),
        (vec![Column::Number(3)], false)
    );
}

#[test]
fn words_numbers_of_rows_groups_and_swings_are_told_apart() {
    let table = read(
        "No.,group,N,L (m),t (s)\n1,A,10,0.25,10.0\n2,A,20,0.5,28.4\n3,B,10,0.25,10.1\n4,B,20,0.5,28.2\n",
    );
    let roles = roles(&table, &[LENGTH, PERIOD]).unwrap();
    assert_eq!(roles.group, Some(Column::Number(2)));
    assert_eq!(roles.swings, Some(Column::Number(3)));
    assert_eq!(roles.unused, [Column::Number(1)]);
    let names = read("student,L (m),T (s)\nAnn,0.25,1.0\nBob,0.5,1.42\n");
    assert_eq!(columns(&names, &[LENGTH, PERIOD]), [(vec![2], None), (vec![3], None)]);
}

#[test]
fn given_roles_stay() {
    let table = of_header("L (m),a (s),b (s),c (s)");
    let words = [(3, "period"), (4, "period-half-width"), (2, "ignore")];
    let given = words
        .map(|(column, word)| (Column::Number(column), ColumnRole::parse(word, &[LENGTH, PERIOD]).unwrap()));
    let given = GivenRoles { roles: given.to_vec(), are_all: false };
    let roles = table.roles(&[LENGTH, PERIOD], &given).unwrap();
    assert_eq!(roles.quantities[1].readings, [Column::Number(3)]);
    assert_eq!(roles.quantities[1].uncertainties, Some((Column::Number(4), UncertaintyKind::HalfWidth)));
    let unknown = ColumnRole::parse("mass", &[LENGTH, PERIOD]).unwrap_err().to_string();
    assert!(unknown.contains("length-resolution"), "{unknown}");
}

#[test]
fn two_tables_side_by_side_are_refused_with_both_choices() {
    let table = read("L (m),T (s),,L (m),T (s)\n0.25,1.0,,0.3,1.1\n0.5,1.42,,0.6,1.55\n");
    let text = roles(&table, &[LENGTH, PERIOD]).unwrap_err().to_string();
    assert!(text.ends_with("give columns=1,2 or 4,5"), "{text}");
}

#[test]
fn a_table_with_one_column_of_numbers_is_refused() {
    let text = roles(&read("name,T (s)\na,1\nb,2\n"), &[LENGTH, PERIOD]).unwrap_err().to_string();
    assert_eq!(text, "length and period are needed, and the table has 1 column of numbers");
}

#[test]
fn rows_of_means_are_left_out_and_named() {
    let table = read("name,L (m),T (s)\nAnn,0.25,1.0\nBob,0.5,1.42\nmean,0.375,1.21\n");
    assert_eq!(table.summaries(), [(4, "mean")]);
    let read = table.readings(&[vec![Column::Number(2)], vec![Column::Number(3)]]).unwrap();
    assert_eq!((read.lines, read.dropped), (vec![2, 3], 0));
}

#[test]
fn a_row_needs_one_reading_of_each_quantity() {
    let table = read("L (m),t1 (s),t2 (s)\n0.25,1.0,\n0.5,1.4,1.5\n,1,2\n0.75,,\n");
    let columns = [vec![Column::Number(1)], vec![Column::Number(2), Column::Number(3)]];
    let read = table.readings(&columns).unwrap();
    assert_eq!(read.quantities[1], [vec![1.0], vec![1.4, 1.5]]);
    assert_eq!((read.lines, read.dropped), (vec![2, 3], 2));
}

#[test]
fn cells_may_have_uncertainties() {
    for text in [
        "L (m);T (s)\n0,25 ± 0,01;1,00 ± 0,02\n0,50 ± 0,01;1,42 ± 0,02\n",
        "L (m),T (s)\n0.25(1),1.00(2)\n0.50(1),1.42(2)\n",
        "L,T\n25 ± 1 cm,1.00(2) s\n50 cm ± 1 cm,(1.42 ± 0.02) s\n",
        "L T\n0.25 ± 0.01 1.00 +/- 0.02\n0.50 ± 0.01 1.42 +/- 0.02\n",
    ] {
        let table = read(text);
        let read = table.readings(&[vec![Column::Number(1)], vec![Column::Number(2)]]).unwrap();
        let per_metre = if text.contains("cm") { 100.0 } else { 1.0 };
        assert_eq!(read.quantities[0], [[0.25 * per_metre], [0.5 * per_metre]], "{text}");
        assert_eq!(read.quantities[1], [[1.0], [1.42]], "{text}");
        assert_eq!(read.uncertainties, [Some(vec![0.01 * per_metre; 2]), Some(vec![0.02; 2])], "{text}");
    }
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

#[test]
fn a_header_that_runs_into_the_first_row_is_cut_off() {
    for text in [
        "L (m),T (s)0.25,1.00\n0.50,1.42\n0.75,1.74\n",
        "L (m),T (s),0.25,1.00\n0.50,1.42\n0.75,1.74\n",
        "length;period0,25;1,00\n0,50;1,42\n0,75;1,74\n",
    ] {
        let table = read(text);
        let chosen = table.select(&[Column::Number(1), Column::Number(2)]).unwrap();
        assert_eq!(chosen.columns, [vec![0.25, 0.5, 0.75], vec![1.0, 1.42, 1.74]], "{text}");
        assert_eq!(chosen.lines, [1, 2, 3], "{text}");
        assert!(table.notes().iter().any(|note| note.contains("line 1")), "{text}");
    }
    // `T10` may be the name T1 and 0, or T and 10.
    assert!(Table::read(b"L,T10.25,1.00\n0.50,1.42\n0.75,1.74\n", &ReadOptions::default()).is_err());
}

#[test]
fn units_may_have_a_row_of_their_own() {
    let table = read("L,t1,t2\ncm,s,s\n25,1.0,1.01\n50,1.42,1.41\n");
    let roles = roles(&table, &[LENGTH, PERIOD]).unwrap();
    assert_eq!(roles.quantities[1].readings, [Column::Number(2), Column::Number(3)]);
}

/// Rows of sums and means in German, French and Spanish, and by signs.
/// Cells of a worksheet that were merged over two rows or several columns have their text in the first one.
#[test]
fn headings_below_titles_have_their_units() {
    let rows = "20,0.90,0.91,0.89\n40,1.27,1.28,1.26\n";
    for (header, expected) in [
        (
            "Length (cm),Period (s),,\n,Trial 1,Trial 2,Trial 3",
            ["Length (cm)", "Period Trial 1 (s)", "Period Trial 2 (s)", "Period Trial 3 (s)"],
        ),
        ("l [cm];10T / s;;\n;a;b;c", ["l [cm]", "10T a (s)", "10T b (s)", "10T c (s)"]),
        // A title over one column belongs to no other.
        ("Length (cm),,,\n,T1 (s),T2 (s),T3 (s)", ["Length (cm)", "T1 (s)", "T2 (s)", "T3 (s)"]),
        (
            "Length (cm),Period,,\n,a (s),b (s),c (s)",
            ["Length (cm)", "Period a (s)", "Period b (s)", "Period c (s)"],
        ),
        ("Anna,group 3,,\n,x,y,z", ["", "x", "y", "z"]),
    ] {
        let rows = if header.contains(';') { rows.replace(',', ";") } else { rows.into() };
        let table = read(&format!("{header}\n{rows}"));
        assert_eq!(table.names(), expected, "{header}");
    }
    let table = read(&format!("Length (cm),Period (s),,\n,Trial 1,Trial 2,Trial 3\n{rows}"));
    let [(length, _), (period, _)] = columns(&table, &[LENGTH, PERIOD]);
    assert_eq!((length, period), (vec![1], vec![2, 3, 4]));
}

#[test]
fn rows_of_sums_and_means_are_left_out_in_other_languages() {
    for word in ["Ø", "MW", "Σ", "Summe", "somme", "promedio", "x̄", "Durchschnitt:"] {
        let table = read(&format!("name,L (m),T (s)\nAnn,0.25,1.0\nBob,0.5,1.42\n{word},0.375,1.21\n"));
        assert_eq!(table.summaries().iter().map(|summary| summary.0).collect::<Vec<_>>(), [4], "{word}");
    }
}

#[test]
fn bounds_of_a_quantity_are_refused_with_both_choices() {
    for [high, low] in
        [["T max (s)", "T min (s)"], ["Tmax (s)", "Tmin (s)"], ["T_max", "T_min"], ["T max", "T min"]]
    {
        let table = read(&format!("L (m),{low},{high}\n0.25,0.99,1.01\n0.5,1.41,1.43\n"));
        let text = roles(&table, &[LENGTH, PERIOD]).unwrap_err().to_string();
        assert!(text.contains("half-widths") && text.ends_with("give role=3=period or 2=period"), "{text}");
        let given = (Column::Number(3), ColumnRole::parse("period", &[LENGTH, PERIOD]).unwrap());
        let given = GivenRoles { roles: vec![given], are_all: false };
        assert!(table.roles(&[LENGTH, PERIOD], &given).is_ok());
    }
    // One bound alone is a name like others.
    assert_eq!(
        columns(&of_header("theta_max (rad),T (s)"), &[AMPLITUDE, PERIOD]),
        [(vec![1], None), (vec![2], None)]
    );
}

#[test]
fn a_bare_count_next_to_periods_is_asked_about() {
    let refused = |text: &str| roles(&read(text), &[LENGTH, PERIOD]).unwrap_err().to_string();
    let text = refused("L (m),N,T (s)\n0.25,3,1.0\n0.5,3,1.42\n");
    assert!(text.ends_with("give role=2=swings or 2=ignore"), "{text}");
    let swings = |text: &str| roles(&read(text), &[LENGTH, PERIOD]).unwrap().swings;
    assert_eq!(swings("L (m),N,t (s)\n0.25,10,10.0\n0.5,10,14.2\n"), Some(Column::Number(2)));
    for name in ["N readings", "number of trials"] {
        assert_eq!(swings(&format!("L (m),{name},T (s)\n0.25,5,1.0\n0.5,5,1.42\n")), None);
    }
    // The measurements of each length are numbered.
    assert_eq!(swings("L (m),N,T (s)\n0.25,1,1.0\n0.25,2,1.01\n0.5,1,1.42\n0.5,2,1.41\n"), None);
}

#[test]
fn standard_deviations_next_to_a_number_of_readings_are_of_single_ones() {
    let kind = |header: &str, count: &str| {
        let row = |value: &str| format!("0.{value},1.{value},0.0{value},{count}");
        let table = read(&format!("{header}\n{}\n{}\n", row("25"), row("36")));
        let roles = roles(&table, &[LENGTH, PERIOD]).unwrap();
        (
            roles.quantities[1].uncertainties.as_ref().map(|uncertainty| uncertainty.1),
            roles.readings.as_ref().map(number),
        )
    };
    for (header, expected) in [
        ("L (m),T (s),sd (s),n", (UncertaintyKind::Deviation, Some(4))),
        ("L (m),T (s),SD,N", (UncertaintyKind::Deviation, Some(4))),
        ("L (m),T (s),σ_T (s),n", (UncertaintyKind::Deviation, Some(4))),
        ("L (m),10T (s),s.d.,n", (UncertaintyKind::Deviation, Some(4))),
        ("L (m),t (s),standard deviation (s),No. of trials", (UncertaintyKind::Deviation, Some(4))),
        ("L (m),T (s),Standardabweichung (s),Anzahl der Messungen", (UncertaintyKind::Deviation, Some(4))),
        // Those of a mean are not divided, nor what no column counts.
        ("L (m),T (s),SE (s),number of readings", (UncertaintyKind::Standard, None)),
        ("L (m),T (s),sem (s),number of readings", (UncertaintyKind::Standard, None)),
        ("L (m),T (s),u(T) (s),number of readings", (UncertaintyKind::Standard, None)),
        ("L (m),T (s),sd of mean (s),number of readings", (UncertaintyKind::Standard, None)),
        ("L (m),T (s),standard error (s),number of readings", (UncertaintyKind::Standard, None)),
        ("L (m),T (s),sd (s),mass", (UncertaintyKind::Standard, None)),
    ] {
        assert_eq!(kind(header, "5"), (Some(expected.0), expected.1), "{header}");
    }
    // n next to times may be the number of swings.
    let times = read("L (m),t (s),sd (s),n\n0.25,10.0,0.1,10\n0.36,12.0,0.1,10\n");
    let error = roles(&times, &[LENGTH, PERIOD]).unwrap_err().to_string();
    assert!(error.contains("4=swings") && error.contains("4=readings"), "{error}");
    let deviation = ColumnRole::parse("period-deviation", &[LENGTH, PERIOD]).unwrap();
    let given = GivenRoles { roles: vec![(Column::Number(3), deviation)], are_all: false };
    let alone = of_header("L (m),T (s),scatter").roles(&[LENGTH, PERIOD], &given).unwrap_err().to_string();
    assert!(alone.contains("COLUMN=readings"), "{alone}");
}
