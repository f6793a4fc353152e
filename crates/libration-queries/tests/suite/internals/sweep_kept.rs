//! The ways into an answer.

use libration_queries::internals::sweep_kept::{Kept, scalars};
use serde_json::json;

#[test]
fn ways_lead_to_numbers() {
    let answer = json!({"a": {"b": 2}, "yes": true, "none": null, "word": "x",
        "rows": [{"state": [1, 2]}, {"state": [3, 4]}]});
    let numbers = |text: &str| Kept::read(text).unwrap().numbers(&answer);
    assert_eq!(numbers("a.b"), [2.0]);
    assert_eq!(numbers("yes"), [1.0]);
    assert_eq!(numbers("rows[-1].state[0]"), [3.0]);
    assert_eq!(numbers("rows[0:2].state[1]"), [2.0, 4.0]);
    for text in ["none", "word", "a", "c", "rows", "rows[2].state[0]", "rows[-3].state[0]", "a[0]"] {
        assert!(numbers(text).iter().all(|number| number.is_nan()), "{text}");
    }
    let beyond = numbers("rows[1:4].state[1]");
    assert_eq!(beyond.iter().map(|number| number.is_nan()).collect::<Vec<_>>(), [false, true, true]);
}

#[test]
fn ways_that_no_answer_has_are_known() {
    let answer = json!({"a": {"b": 2}, "word": "x", "none": null, "rows": [{"state": [1, 2]}]});
    let is_in = |text: &str| Kept::read(text).unwrap().is_in(&answer);
    for text in
        ["a.b", "none", "rows[0].state[1]", "rows[5].state[1]", "rows[0:9].state[1]", "rows[-1].state[7]"]
    {
        assert!(is_in(text), "{text}");
    }
    for text in ["a", "a.c", "word", "rows", "rows[0].speed", "a[0]", "none.b"] {
        assert!(!is_in(text), "{text}");
    }
}

#[test]
fn names_are_given_or_the_last_key() {
    let columns = |text: &str| Kept::read(text).unwrap().columns();
    assert_eq!(columns("a.b"), ["b"]);
    assert_eq!(columns("rows[-1].state[0]"), ["state[0]"]);
    assert_eq!(columns("x=rows[0:2].state[1]"), ["x[0]", "x[1]"]);
    assert_eq!(columns("rows[0:2]"), ["rows[0]", "rows[1]"]);
    assert_eq!(Kept::read("x=rows[0:2].state[1]").unwrap().described_as(), "rows[].state[]");
}

#[test]
fn what_is_no_way_is_refused() {
    for text in ["", "a..b", "a[", "a[x]", "a[2:1]", "a[0:2].b[0:2]", "a[1]b", "=a", "[0]", "a[0:99999999]"] {
        assert!(Kept::read(text).is_err(), "{text}");
    }
}

#[test]
fn numbers_that_stand_alone_are_found() {
    let answer = json!({"schema": 1, "resume": {"steps": 2}, "a": {"b": 2, "c": "x"}, "one": [{"d": 1, "e": [1, 2]}], "two": [1, 2]});
    assert_eq!(scalars(&answer), ["a.b", "one[0].d"]);
}
