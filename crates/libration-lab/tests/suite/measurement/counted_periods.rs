//! The number of periods that each time of a column lasts, by its heading: `10T`, `half period (s)`, `time of 20 oscillations`.

use libration_lab::internals::measurement::counted_periods::counted;
use libration_lab::measurement::CountedPeriods;

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
