//! Lines of CSV.

use libration_queries::internals::csv::{cells, line};

#[test]
fn fields_are_read_as_they_are_written() {
    let fields = ["a,b", "say \"a\"", "", "\"", "1.5", ""];
    let mut text = vec![];
    line(&mut text, &fields).unwrap();
    assert_eq!(cells(String::from_utf8(text).unwrap().trim_end_matches('\n')), fields);
}

#[test]
fn commas_and_quotes_are_quoted() {
    let mut text = vec![];
    line(&mut text, &["a,b", "say \"a\"", "plain"]).unwrap();
    assert_eq!(String::from_utf8(text).unwrap(), "\"a,b\",\"say \"\"a\"\"\",plain\n");
}
