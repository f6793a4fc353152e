//! Documents of JSON.

use libration_queries::internals::json::{Record, document_with_list};
use serde_json::Value;

#[test]
fn numbers_that_are_not_finite_become_null_with_a_note() {
    let value = Value::from(Record::new().number("period_s", f64::INFINITY).number("x", 0.5));
    assert_eq!(value.to_string(), r#"{"period_s":null,"x":0.5,"note":"period_s is infinite"}"#);
}

#[test]
fn a_streamed_list_is_one_json_document() {
    let mut text = vec![];
    let items = (0..3).map(|n| Record::new().with("n", n));
    document_with_list(&mut text, Record::new().with("a", "b"), "items", items).unwrap();
    let read: Value = serde_json::from_slice(&text).unwrap();
    assert_eq!(read, serde_json::json!({"schema": 2, "a": "b", "items": [{"n": 0}, {"n": 1}, {"n": 2}]}));
}
