//! The number of periods that each time of a column lasts, by its heading: `10T`, `half period (s)`, `time of 20 oscillations`.

use libration_lab::internals::measurement::counted_periods::{counted, counted_in};
use libration_lab::measurement::{Column, CountedPeriods, ReadOptions, Table};

#[test]
fn headings_say_how_many_periods_a_time_lasts() {
    for (heading, count) in [
        ("half period (s)", 0.5),
        ("Half-period / s", 0.5),
        ("T/2", 0.5),
        ("T/2 (s)", 0.5),
        ("½ T", 0.5),
        ("0.5T", 0.5),
        ("mean half period (s)", 0.5),
        ("demi-période (s)", 0.5),
        ("halbe Schwingungsdauer", 0.5),
        ("time of 10 periods (s)", 10.0),
        ("time for 20 oscillations / s", 20.0),
        ("10T", 10.0),
        ("20 T (s)", 20.0),
        ("5×T", 5.0),
        ("time for 10 swings", 10.0),
        ("10 swings (s)", 10.0),
        ("10 Schwingungen in s", 10.0),
        ("T", 1.0),
        ("T (s)", 1.0),
        ("T/s", 1.0),
        ("mean period (s)", 1.0),
        ("T_1", 1.0),
    ] {
        assert_eq!(counted(heading), CountedPeriods::Said(count), "{heading}");
    }
}

#[test]
fn what_may_be_a_number_of_periods_is_not_guessed() {
    for heading in ["T10 (s)", "swing 10", "t_{20}", "half", "mean of 10 periods (s)", "10T/10", "T/10"] {
        assert_eq!(counted(heading), CountedPeriods::Unclear(heading.into()));
    }
    for heading in ["", "swing (s)", "time (s)", "trial 3", "u(x)"] {
        assert_eq!(counted(heading), CountedPeriods::Nothing, "{heading}");
    }
}

#[test]
fn numbers_of_half_periods_and_numbers_in_words_are_read() {
    for (heading, count) in [
        ("Time (s) for 10 complete oscillations", 10.0),
        ("Zeit (s) für 10 Perioden", 10.0),
        ("t (s) 10 swings", 10.0),
        ("time for 20 full small swings / s", 20.0),
        ("ten swings (s)", 10.0),
        ("zehn Perioden", 10.0),
        ("Zeit für zwanzig volle Schwingungen", 20.0),
        ("zehnfache Schwingungsdauer", 10.0),
        ("tempo per 10 oscillazioni (s)", 10.0),
        ("10 half swings (s)", 5.0),
        ("10 Halbschwingungen (s)", 5.0),
        ("twenty half-periods (s)", 10.0),
        ("2.5 T", 2.5),
        ("T at 20 cm (s)", 1.0),
        ("T (s) 10°", 1.0),
        ("time for one swing", 1.0),
    ] {
        assert_eq!(counted(heading), CountedPeriods::Said(count), "{heading}");
    }
    for heading in [
        "ten (s)",
        "time for 5 beats",
        "5 beats (s)",
        "N periods (s)",
        "half swings (s), 10",
        "time of several periods",
    ] {
        assert_eq!(counted(heading), CountedPeriods::Unclear(heading.into()));
    }
}

/// Words after the unit name a run unless they count periods; so does a title above the columns.
#[test]
fn a_run_may_be_a_number_of_periods() {
    for (heading, count) in [
        ("t (s) 10 swings", CountedPeriods::Said(10.0)),
        ("Time (s) for 10 complete oscillations", CountedPeriods::Said(10.0)),
        ("t (s) 10 half swings", CountedPeriods::Said(5.0)),
        ("t (s) x10", CountedPeriods::Unclear("t (s) x10".into())),
        ("T (s) Run 12", CountedPeriods::Said(1.0)),
        ("T (ms) ± 20", CountedPeriods::Said(1.0)),
        // A small t is any time.
        ("t (s) morning", CountedPeriods::Nothing),
        ("T (s) morning", CountedPeriods::Said(1.0)),
    ] {
        let text = format!("A (deg),{heading}\n10,20.0\n20,20.1\n30,20.3\n");
        let table = Table::read(text.as_bytes(), &ReadOptions::default()).unwrap();
        assert_eq!(table.counted_periods(&Column::Number(2)), Ok(count), "{text}");
    }
    assert_eq!(counted_in("T (s)", "10 swings"), CountedPeriods::Said(10.0));
    assert_eq!(counted_in("T (s)", "Group 12"), CountedPeriods::Said(1.0));
}

/// Headers of a table, with the number of swings in the times of a column.
#[test]
fn a_number_after_the_symbol_is_that_of_swings_or_of_a_reading() {
    let single = CountedPeriods::Said(1.0);
    for (header, column, counted) in [
        ("L (m),T5 (s)", 2, CountedPeriods::Numbered(5.0)),
        ("L (m),t20 / s", 2, CountedPeriods::Numbered(20.0)),
        ("L (m),T_{10}", 2, CountedPeriods::Numbered(10.0)),
        ("L (m),Time 3 (s)", 2, CountedPeriods::Numbered(3.0)),
        ("L (m),T10_1 (s),T10_2 (s)", 3, CountedPeriods::Numbered(10.0)),
        ("L (m),T5 (s),T10 (s)", 2, CountedPeriods::Numbered(5.0)),
        ("L (m),T1 (s)", 2, single.clone()),
        ("L (m),T0 (s)", 2, single.clone()),
        ("L (m),T1 (s),T2 (s),T3 (s)", 4, single.clone()),
        ("L (m),T9 (s),T10 (s)", 3, single.clone()),
        ("L (m),t9 (s),t10 (s)", 3, CountedPeriods::Nothing),
        ("L (m),T 20 cm (s)", 2, single),
        ("L (m),5T (s)", 2, CountedPeriods::Said(5.0)),
    ] {
        let numbers = ["0.25"; 4][..=header.matches(',').count()].join(",");
        let text = format!("{header}\n{numbers}\n{numbers}\n");
        let table = Table::read(text.as_bytes(), &ReadOptions::default()).unwrap();
        assert_eq!(table.counted_periods(&Column::Number(column)), Ok(counted), "{header}");
    }
}
