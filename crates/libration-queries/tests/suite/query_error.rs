//! Errors as data: their parameters, and messages without the words of the command.

use libration_queries::{Host, Kind, QueryError, QueryParameter, Words, ask, questions};
use std::ffi::OsString;
use std::io;
use std::sync::Arc;

struct Nowhere;

impl Host for Nowhere {
    fn write(&self, _: &[u8]) -> io::Result<()> {
        Ok(())
    }
}

/// A front end that names nothing as the command does.
pub(crate) struct OtherWords;

impl Words for OtherWords {
    fn parameter(&self, parameter: &QueryParameter) -> String {
        format!("[{}]", parameter.name())
    }

    fn query(&self, words: &str) -> String {
        format!("[{}]", words.replace(' ', "_"))
    }
}

fn error(words: &[&str]) -> QueryError {
    match ask(words.iter().map(OsString::from), Arc::new(Nowhere)) {
        Err(error) => error,
        Ok(()) => panic!("{words:?} has a result"),
    }
}

/// Queries with an error, its parameters, and whether it has a hint.
const REFUSED: &[(&[&str], &[&str], bool)] = &[
    (&["period", "200deg"], &["amplitudes"], false),
    (&["period", "60degg"], &["amplitudes"], false),
    (&["period", "60deg", "--length", "-1m"], &["length"], false),
    (&["motion", "60deg", "--times", "1:0:1"], &["times"], false),
    (&["expand", "x'' + 2*x + abs(x) = 0"], &[], true),
    (&["expand", "x'' + x + c*x*sign(x') = 0"], &[], true),
    (&["expand", "x''+0.1*x'+x=0"], &[], true),
    (&["expand", "x''+x=cos(t)"], &[], true),
    (&["expand", "x''+y=0;y''+x=0"], &[], true),
    (&["expand", "pendulum", "--about", "3"], &[], false),
    (&["expand", "x'' + exp(x) = 0"], &[], false),
    (&["expand", "duffing", "--letters", "q"], &["letters"], false),
    (&["expand", "duffing", "--letters", "alpha", "--evaluate", "1"], &["letters"], false),
    (&["expand", "pendulum", "--set", "q=1"], &["set"], false),
    (&["expand", "x'' + a*x = 0", "--evaluate", "1"], &[], false),
    (&["expand", "pendulum", "--evaluate", "-1"], &["evaluate"], false),
    (&["expand", "x'' + c*x' + d*x'^3 + x = 0", "--damping-order", "2"], &["small"], false),
    (&["expand", "x'' + c*x' + x = t", "--damping-order", "2"], &[], true),
    (&["backbone", "x''+y=0;y''+x=0", "--amplitudes", "1"], &[], true),
    (&["backbone", "pendulum", "--amplitudes", "a"], &["amplitudes"], false),
    (&["derive", "--method", "perturbation", "--small", "c"], &["small"], false),
    (&["derive", "--method", "perturbation", "--order", "15"], &["order"], false),
    (&["derive", "--method", "averaging", "x'' + c*x' + d*x'^3 + x = 0"], &["small"], false),
    (&["derive", "--method", "perturbation", "x''+x+0.1*x'=0"], &[], true),
    (&["derive", "--method", "elliptic", "--length", "1m"], &[], false),
    (&["derive", "--method", "elliptic", "--amplitude", "179.99deg"], &["amplitude"], true),
    (&["derive", "--method", "limit-cycle", "x''+x=0"], &[], false),
    (&["decay", "60deg"], &[], false),
    (&["simulate", "pendulum", "--times", "0:1:0.1"], &["initial"], false),
    (&["simulate", "x''+a*x=0", "--initial", "x=1", "--times", "0:1:0.1"], &["set"], false),
    (&["simulate", "pendulum", "--initial", "theta=1", "--times", "1,-1,2"], &["times"], false),
    (
        &["simulate", "pendulum", "--initial", "theta=1", "--times=-1:1:1", "--until", "theta"],
        &["until"],
        false,
    ),
    (&["simulate", "pendulum", "--initial", "theta=1", "--until", "theta-9", "--times", "0:1:1"], &[], false),
    (
        &["simulate", "van_der_pol", "--length", "1m", "--initial", "x=1", "--times", "0:1:1"],
        &["length"],
        false,
    ),
    (
        &["simulate", "pendulum", "--initial", "theta=1", "--times", "0:1:1", "--events", "q"],
        &["events"],
        false,
    ),
    (&["simulate", "pendulum", "--each", "a.csv", "--times", "0:1:1", "--resume", "b"], &["resume"], false),
    (
        &[
            "simulate",
            "pendulum",
            "--initial",
            "theta=1",
            "--times",
            "0:1:1",
            "--axes",
            "q,r",
            "--figure",
            "-",
        ],
        &["axes"],
        false,
    ),
    (&["orbit", "x''+x^3+0.1*x'=0", "--initial", "x=1", "--hold", "q"], &["period"], false),
    (&["orbit", "x''=-x+t", "--initial", "x=1"], &["period"], false),
    (&["response", "x''+0.1*x'+x=cos(w*t)", "--over", "q=1:2"], &["over"], false),
    (&["response", "pendulum", "--over", "omega0=1:2"], &["system"], false),
    (&["section", "driven_pendulum", "--initial", "theta=0.2", "--period", "0"], &["period"], false),
    (&["section", "pendulum", "--initial", "theta=0.2"], &["period"], false),
    (&["bifurcation", "driven_pendulum", "--over", "q=1:2:0.1", "--initial", "theta=0"], &["over"], false),
    (&["lyapunov", "pendulum", "--set", "q=1", "--initial", "theta=1"], &["set"], false),
    (&["melnikov", "pendulum", "--over", "q=0:1"], &["over"], false),
    (&["modes", "double_pendulum", "--follow", "7"], &["amplitudes"], false),
    (&["resonance", "spring_pendulum", "--figure", "-"], &["initial"], false),
    (&["stability", "driven_pendulum", "--map", "q=0:1,r=0:1"], &["map"], false),
    (&["paper", "--label", "nothing"], &[], false),
    (&["figure", "errors", "--from", "90deg", "--to", "10deg", "--output", "-"], &["from", "to"], false),
    (&["figure", "errors", "--lowest", "20", "--output", "-"], &["lowest", "highest"], false),
    (&["figure", "errors", "--width", "10mm", "--output", "-"], &["width"], false),
    (&["figure", "series", "x''+x=0", "--output", "-"], &["quantity"], false),
    (&["fit", "trace", "missing.csv"], &[], false),
    (&["plan", "--g-to", "0", "--length", "1m", "--angle-noise", "1deg"], &["rate"], false),
];

#[test]
fn messages_name_parameters_by_data_alone() {
    let queries = questions();
    let names: Vec<String> = queries
        .iter()
        .flat_map(|query| &query.parameters)
        .map(|parameter| format!("--{}", parameter.name))
        .collect();
    let mut wrong = vec![];
    for (words, parameters, has_hint) in REFUSED {
        let Err(error) = ask(words.iter().map(OsString::from), Arc::new(Nowhere)) else {
            wrong.push(format!("{words:?} has a result"));
            continue;
        };
        let of_error: Vec<String> = error.parameters().iter().map(QueryParameter::name).collect();
        let written = error.in_words(&OtherWords);
        let is_word = |name: &String| {
            written
                .split(|letter: char| !letter.is_ascii_lowercase() && letter != '-')
                .any(|word| word == name)
        };
        let query = queries
            .iter()
            .filter(|query| words.join(" ").starts_with(&query.words))
            .max_by_key(|query| query.words.len())
            .unwrap();
        let is_known = |name: &String| query.parameters.iter().any(|parameter| parameter.name == *name);
        let holds = of_error == *parameters
            && error.hint(&OtherWords).is_some() == *has_hint
            && !names.iter().any(is_word)
            && !written.contains("libration ")
            && !written.contains("<--")
            && !written.contains("<libration")
            && of_error.iter().all(is_known);
        if !holds {
            wrong.push(format!("{words:?}: {of_error:?}: {written}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn settings_groups_and_choices_are_in_the_words_of_each_front_end() {
    let chain = ["simulate", "double_pendulum", "--times", "1"];
    for (words, command, other) in [
        (&["decay", "60deg"] as &[&str], "such as --linear 0.1;", "such as [linear] 0.1;"),
        (&chain, "such as --initial theta1=60deg,theta2=60deg;", "such as [initial] theta1=60deg"),
        (&["simulate", "x''=-k*x", "--initial", "x=1", "--times", "1"], "--set k=0.1", "[set] k=0.1"),
        (
            &["period"],
            "AMPLITUDE, --from-file, --period, --ratio and --excess: one of them is required",
            "[amplitudes], [from-file], [period], [ratio] and [excess]: one of them is required",
        ),
        (&["motion"], "ANGLE: required, and not given", "[angle]: required, and not given"),
        (
            &["section", "lorenz", "--direction", "up"],
            "--direction: unknown value `up`: give rising, falling or any",
            "[direction]: unknown value `up`: give rising, falling or any",
        ),
    ] {
        let error = error(words);
        let (one, two) = (error.to_string(), error.in_words(&OtherWords));
        assert!(one.contains(command), "{one}");
        assert!(two.contains(other), "{two}");
    }
}

#[test]
fn errors_have_a_kind_a_suggestion_and_the_item_that_is_wrong() {
    let error_of = |words: &[&str]| error(words);
    let usage = error_of(&["period", "60degg"]);
    assert!(matches!(usage.kind(), Kind::Usage) && usage.status() == 2);
    assert!(matches!(error_of(&["fit", "trace", "missing.csv"]).kind(), Kind::MissingFile | Kind::NoResult));
    let small = error_of(&["figure", "errors", "--width", "10mm", "--output", "-"]);
    let least = small.suggestion().unwrap();
    assert!(least.ends_with("mm"), "{least}");
    ask(["figure", "errors", "--width", least, "--output", "-"].map(OsString::from), Arc::new(Nowhere))
        .unwrap();
    for (value, item) in [("c=1,A=b(", "A"), ("c=k", "c"), ("q=1", "q")] {
        let error = error_of(&[
            "simulate",
            "driven_pendulum",
            "--set",
            value,
            "--initial",
            "theta=0",
            "--times",
            "0:1:1",
        ]);
        assert_eq!(error.item(), Some(item), "{error}");
    }
}

#[test]
fn pages_get_an_error_as_json() {
    let json = error(&["expand", "x''+0.1*x'+x=0"]).to_json();
    let read: serde_json::Value = serde_json::from_str(&json).unwrap();
    let hint = read["hint"].as_array().unwrap();
    assert!(hint.contains(&serde_json::json!({ "query": "simulate" })), "{json}");
    assert!(hint.contains(&serde_json::json!({ "parameter": "--damping-order", "values": ["2"] })), "{json}");
    assert_eq!(
        (&read["subject"], &read["text"].as_str().unwrap()[..12]),
        (&"oscillator".into(), "oscillator: ")
    );
    assert_eq!(read["suggestion"], "");
}

#[test]
fn a_first_word_that_is_no_command_gets_the_one_that_is_meant() {
    for (word, hint) in [
        ("60deg", Some("[period] 60deg")),
        ("1deg:9deg:1deg", Some("[period] 1deg:9deg:1deg")),
        ("pi-1e-6", Some("[period] pi-1e-6")),
        ("swing.csv", Some("[inspect] swing.csv")),
        ("data/Swing.XLSX", Some("[inspect] data/Swing.XLSX")),
        ("periode", None),
        ("", None),
    ] {
        assert_eq!(error(&[word]).hint(&OtherWords).as_deref(), hint, "{word}");
    }
}
