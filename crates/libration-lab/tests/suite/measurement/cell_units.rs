//! Cells with units, and headers that are units, read from files.

use libration_lab::measurement::{
    Choices, Column, MeasurementError, ReadOptions, Recording, Role, Table, Unit, WrittenUnit,
};

fn table(text: &str) -> Result<Table, MeasurementError> {
    Table::read(text.as_bytes(), &ReadOptions::default())
}

fn numbers(table: &Table) -> Vec<Vec<f64>> {
    table.select(&[Column::Number(1), Column::Number(2)]).unwrap().columns
}

#[test]
fn cells_with_units_are_read() {
    for text in
        ["L,T\n10cm,0.635s\n20cm,0.897s\n40cm,1.269s\n", "L;T\n10 cm;0,635 s\n20 cm;0,897 s\n40 cm;1,269 s\n"]
    {
        let table = table(text).unwrap();
        assert_eq!(numbers(&table), [vec![10.0, 20.0, 40.0], vec![0.635, 0.897, 1.269]]);
        assert_eq!(
            table.unit(&Column::Number(1), Role::Lengths).unwrap(),
            WrittenUnit::Known(Unit::Centimetre)
        );
        assert_eq!(table.unit(&Column::Number(2), Role::Times).unwrap(), WrittenUnit::Known(Unit::Second));
    }
}

/// A unit of the same quantity is converted to that of the header or of the first cell.
#[test]
fn units_of_one_quantity_are_brought_to_one() {
    let mixed = table("L,T (s)\n10cm,635ms\n0.2m,0.897s\n400mm,1.269s\n").unwrap();
    let computed = numbers(&mixed).concat();
    let truth = [10.0, 20.0, 40.0, 0.635, 0.897, 1.269];
    assert!(computed.iter().zip(truth).all(|(a, b)| (a / b - 1.0).abs() < 1e-15), "{computed:?}");
}

#[test]
fn units_may_have_a_column_of_their_own() {
    let read =
        |text: &str| table(text).unwrap().select(&[Column::Number(1), Column::Number(3)]).unwrap().columns;
    let truth = [10.0, 20.0, 40.0, 0.635, 0.897, 1.269];
    for text in [
        "length,unit,T,unit\n10,cm,635,ms\n20,cm,897,ms\n40,cm,1.269,s\n",
        "L;Einheit;T;Einheit\n10;cm;0,635;s\n0,2;m;0,897;s\n400;mm;1,269;s\n",
        "length\tUnits\tT\tUnits\n10\tcm\t0.635\ts\n20\t\t0.897\t\n40\t\t1.269\t\n",
    ] {
        let table = table(text).unwrap();
        assert_eq!(
            table.unit(&Column::Number(1), Role::Lengths).unwrap(),
            WrittenUnit::Known(Unit::Centimetre)
        );
        let computed = read(text).concat();
        let factor = if text.contains("635,ms") { 1e3 } else { 1.0 };
        let scaled = truth.iter().enumerate().map(|(row, x)| if row < 3 { *x } else { factor * x });
        assert!(
            computed.iter().zip(scaled).all(|(a, b)| (a / b - 1.0).abs() < 1e-15),
            "{text}: {computed:?}"
        );
    }
    // They are those of uncertainties and of repeated readings too, and not those of numbers of rows.
    let several =
        table("no.,L,u L,unit,T1,T2,T 3,unit\n1,20,1,cm,897,898,899,ms\n2,0.4,0.01,m,1.2,1.3,1.4,s\n")
            .unwrap();
    let columns: Vec<Column> = [1, 2, 3, 5, 6, 7].map(Column::Number).to_vec();
    let values = several.select(&columns).unwrap().columns;
    let expected = [[1.0, 2.0], [20.0, 40.0], [1.0, 1.0], [897.0, 1200.0], [898.0, 1300.0], [899.0, 1400.0]];
    for (values, expected) in values.iter().flatten().zip(expected.iter().flatten()) {
        assert!((values / expected - 1.0).abs() < 1e-15, "{values} {expected}");
    }
    assert_eq!(
        several.unit(&Column::Number(2), Role::Lengths).unwrap(),
        WrittenUnit::Known(Unit::Centimetre)
    );
    // Of other quantities, and without one in some rows.
    for text in ["L,unit,T (s)\n10,cm,0.6\n20,s,0.9\n", "L,unit,T (s)\n10,cm,0.6\n20,,0.9\n0.4,m,1.2\n"] {
        assert!(matches!(table(text), Err(MeasurementError::MixedUnits { .. })), "{text}");
    }
    let stated = table("L (m),unit,T (s)\n10,cm,0.6\n20,cm,0.9\n").unwrap();
    assert_eq!(stated.select(&[Column::Number(1)]).unwrap().columns[0], [0.1, 0.2]);
    assert_eq!(stated.unit(&Column::Number(1), Role::Lengths).unwrap(), WrittenUnit::Known(Unit::Metre));
    // Groups that are no units.
    let groups = table("L,unit,T (s)\n10,A,0.6\n20,m,0.9\n").unwrap();
    assert_eq!(groups.unit(&Column::Number(1), Role::Lengths).unwrap(), WrittenUnit::Nothing);
}

#[test]
fn units_that_do_not_go_together_are_refused() {
    for text in ["L,T\n10cm,0.6s\n20cm,0.9s\n0.4,1.2s\n", "L,T\n10cm,0.6s\n20cm,0.9s\n3s,1.2s\n"] {
        assert!(matches!(table(text), Err(MeasurementError::MixedUnits { .. })), "{text}");
    }
}

/// Names that are lengths, above plain numbers.
#[test]
fn lengths_as_names_are_no_cells() {
    let named = table("t (s),10 cm,20 cm\n0,0.1,0.2\n1,0.2,0.3\n2,0.3,0.5\n").unwrap();
    assert_eq!(named.names()[1], "10 cm");
}

#[test]
fn a_unit_of_angles_alone_is_the_name_of_an_angle_and_what_is_constant_is_none() {
    let text = |header: &str| {
        let rows = (0..200).map(|row| {
            let time = 0.02 * f64::from(row);
            format!("{time},{},0.7\n", 0.3 * libm::cos(3.0 * time))
        });
        format!("{header}\n{}", rows.collect::<String>())
    };
    for header in ["t (s),rad,x", "t (s),theta (rad),angle (rad)"] {
        let recording = Recording::read(text(header).as_bytes(), &ReadOptions::default()).unwrap();
        let trace = recording.traces(&Choices::default()).unwrap().traces.remove(0);
        assert!((trace.values()[0] - 0.3).abs() < 1e-12, "{header}");
    }
}
