//! Sentences of results, which name options and queries by marks, so that each front end can say them in its own words.

use crate::query_error::OtherWords;
use libration_queries::internals::query_error::CommandWords;
use libration_queries::{Host, MarkedWords, Words, ask};
use serde_json::Value;
use std::ffi::OsString;
use std::io;
use std::sync::{Arc, Mutex};

/// A front end with words of its own, a table as its standard input, and its output in memory.
struct Front {
    words: &'static (dyn Words + Sync),
    input: String,
    output: Mutex<Vec<u8>>,
    notes: Mutex<Vec<String>>,
}

impl Host for Front {
    fn write(&self, bytes: &[u8]) -> io::Result<()> {
        self.output.lock().unwrap().extend_from_slice(bytes);
        Ok(())
    }

    fn read(&self) -> Box<dyn io::Read + '_> {
        Box::new(self.input.as_bytes())
    }

    fn note(&self, sentence: &str) {
        self.notes.lock().unwrap().push(sentence.to_owned());
    }

    fn words(&self) -> &dyn Words {
        self.words
    }
}

/// The result of a query, and its notes.
fn result(query: &str, input: &str, words: &'static (dyn Words + Sync)) -> (String, Vec<String>) {
    let (output, notes) = Default::default();
    let front = Arc::new(Front { words, input: input.to_owned(), output, notes });
    ask(query.split(' ').map(OsString::from), front.clone()).unwrap();
    let output = String::from_utf8(front.output.lock().unwrap().clone()).unwrap();
    let notes = front.notes.lock().unwrap().clone();
    (output, notes)
}

/// All texts of a result and of its notes.
fn texts(query: &str, input: &str) -> Vec<String> {
    let (output, mut texts) = result(&format!("{query} --json"), input, &OtherWords);
    collect(&serde_json::from_str(&output).unwrap(), "", &mut texts);
    texts
}

fn collect(value: &Value, key: &str, texts: &mut Vec<String>) {
    match value {
        // These are options by themselves.
        _ if key == "option" || key == "options" => {}
        Value::String(text) => texts.push(text.clone()),
        Value::Array(items) => items.iter().for_each(|item| collect(item, key, texts)),
        Value::Object(fields) => fields.iter().for_each(|(key, value)| collect(value, key, texts)),
        _ => {}
    }
}

/// `head`, then lines of numbers.
fn table(head: &str, line: impl Fn(f64) -> String) -> String {
    let lines = (1..80).map(|n| line(f64::from(n)));
    format!("{head}\n{}", lines.collect::<Vec<_>>().join("\n"))
}

#[test]
fn sentences_of_results_name_parameters_in_the_words_of_the_front_end() {
    let swing = |n: f64, degrees: f64| {
        format!("{},{:.5}", n / 20.0, degrees * (-n / 4000.0).exp() * (3.1 * n / 20.0).cos())
    };
    let lengths = |period: f64| move |n: f64| format!("{},{:.4}", n / 80.0, period * (n / 80.0).sqrt());
    let cases = [
        ("fit trace -", table("t (s),angle (deg)", |n| swing(n, 30.0)), "[length]"),
        ("fit trace - --length 1m", table("t (s),angle (deg)", |n| swing(n, 0.5)), "[angle-unit]"),
        ("fit lengths -", table("L (m),T (s)", lengths(1.003)), "[half-periods]"),
        ("fit lengths -", table("L (m),T (s)", lengths(20.06)), "[swings-per-reading] 10"),
        (
            "fit periods -",
            table("amplitude (deg),T (s)", |n| format!("{n},{:.4}", 2.006 * (1.0 + n * n / 52_525.0))),
            "[length]",
        ),
        (
            "fit amplitudes -",
            table("n,amplitude (cm)", |n| format!("{n},{:.3}", 10.0 * (-n / 40.0).exp())),
            "[period]",
        ),
        (
            "inspect -",
            table("t;phase", |n| swing(n, 1.0).replace(',', ";")),
            "give [angle-unit] rad, deg, rad/s or deg/s or [counts-per-turn] 4000",
        ),
        ("orbit pendulum --initial theta=1", String::new(), ""),
    ];
    for (words, input, expected) in cases {
        let texts = texts(words, &input);
        let named: Vec<_> =
            texts.iter().filter(|text| text.contains("--") || text.contains("<libration")).collect();
        assert!(named.is_empty(), "{words}: {named:#?}");
        assert!(texts.iter().any(|text| text.contains(expected)), "{words}: {expected}: {texts:#?}");
        // Without its marks a table is that of the command, with the same line breaks.
        let (marked, _) = result(words, &input, &MarkedWords);
        let unmarked: String =
            marked.chars().filter(|character| !('\u{e000}'..='\u{e002}').contains(character)).collect();
        assert_eq!(unmarked, result(words, &input, &CommandWords).0, "{words}");
    }
}
