//! Numbers of two units in cells and in neighbouring columns.

use libration_lab::measurement::{Column, MeasurementError, ReadOptions, Table, says_number_of_half_swings};

/// The second column of a table with lengths in the first.
fn second(heading: &str, cells: &[&str]) -> Result<Vec<f64>, MeasurementError> {
    let rows: String = cells.iter().map(|cell| format!("1;{cell}\n")).collect();
    let table = Table::read(format!("L (m);{heading}\n{rows}").as_bytes(), &ReadOptions::default())?;
    Ok(table.select(&[Column::Number(2)])?.columns.concat())
}

#[test]
fn minutes_and_seconds_are_seconds() {
    let expected = [62.0, 65.5];
    for (heading, cells) in [
        ("t", ["1'02''", "1'05.5''"]),
        ("t", ["1′2″", "1′5″5"]),
        ("t", ["1 min 2 s", "1 min 5.5 s"]),
        ("t", ["1 mn 02", "1 mn 05,5"]),
        ("t", ["1:02.0", "1:05.5"]),
        ("t (min:s)", ["1:02", "1:05.5"]),
    ] {
        assert_eq!(second(heading, &cells).ok().as_deref(), Some(&expected[..]), "{heading} {cells:?}");
    }
    // Plain numbers have the unit of the heading, if it has one.
    let mixed = ["58.5", "1:02.0", "1:05.5"];
    assert_eq!(second("t (s)", &mixed), Ok(vec![58.5, 62.0, 65.5]));
    assert!(second("t", &mixed).is_err());
    for cells in [["1:02", "1:05"], ["1'62''", "1'65''"], ["1 h 2 s", "1 h 5 s"], ["1'02", "1'05"]] {
        assert!(second("t", &cells).is_err(), "{cells:?}");
    }
}

#[test]
fn times_of_day_are_seconds() {
    for (cells, expected) in [
        (["10:05:07", "10:05:08"], [36307.0, 36308.0]),
        (["10:05:07.25", "10:05:07.5"], [36307.25, 36307.5]),
        (["10:05:07,25", "10:05:07,5"], [36307.25, 36307.5]),
        (["9:59:59:750", "10:00:00:250"], [35999.75, 36000.25]),
    ] {
        assert_eq!(second("t", &cells).ok().as_deref(), Some(&expected[..]), "{cells:?}");
    }
    // Differences of dates, over the end of a leap February and of a year.
    for (cells, difference) in [
        (["2024-02-28 23:59:59.5", "2024-03-01 00:00:00.5"], 86401.0),
        (["2025-12-31T23:59:59Z", "2026-01-01T00:00:01Z"], 2.0),
        (["2025-03-30 10:00:00", "2025-03-31 10:00:00"], 86400.0),
    ] {
        let seconds = second("t", &cells).unwrap();
        assert_eq!(seconds[1] - seconds[0], difference, "{cells:?}");
    }
    for cells in
        [["24:00:00", "24:00:01"], ["10:60:00", "10:61:00"], ["2025-13-01 10:00:00", "2025-13-01 10:00:01"]]
    {
        assert!(second("t", &cells).is_err(), "{cells:?}");
    }
}

#[test]
fn feet_and_inches_are_inches_below_a_heading_of_lengths() {
    for (heading, cells, expected) in [
        ("length", ["3' 3 3/8\"", "2'"], [39.375, 24.0]),
        ("length", ["3 ft 3.5 in", "2 feet"], [39.5, 24.0]),
        ("length (in)", ["39 3/8", "24 1/2"], [39.375, 24.5]),
        ("length (in)", ["39", "24 1/2"], [39.0, 24.5]),
        ("length (mm)", ["1'005", "1'250"], [1005.0, 1250.0]),
        ("time", ["3'3\"", "2'0\""], [183.0, 120.0]),
    ] {
        // Feet alone are brought to the unit of the first cell.
        assert_eq!(second(heading, &cells).ok().as_deref(), Some(&expected[..]), "{heading} {cells:?}");
    }
    // `1 m 20` is a length.
    for cells in [["1 m 20", "1 m 25"], ["3' 13\"", "3' 14\""], ["39 3/7", "39 5/7"], ["39 9/8", "39 11/8"]] {
        assert!(second("length", &cells).is_err(), "{cells:?}");
    }
}

#[test]
fn half_swings_are_told_from_half_periods() {
    for heading in
        ["Halbschwingungen", "half swings", "number of half-periods", "n half swings", "Halbschwingung Nr."]
    {
        assert!(says_number_of_half_swings(heading), "{heading}");
    }
    for heading in
        ["half period", "half period (s)", "T/2", "swings", "Halbschwingungsdauer", "half", "10 half swings"]
    {
        assert!(!says_number_of_half_swings(heading), "{heading}");
    }
}
