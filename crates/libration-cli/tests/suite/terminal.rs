//! The terminal's commands and options, and the help.

use crate::command::{directory, libration, message, refusal, text};
use libration_queries::{ParameterKind, questions};

#[test]
fn a_first_word_that_is_an_angle_gets_a_hint() {
    let refused = refusal("60deg");
    assert!(refused.contains("hint: libration period 60deg"), "{refused}");
}

#[test]
fn every_command_stands_in_one_group_of_the_help() {
    let help = text("--help");
    for query in questions() {
        let name = query.words.split(' ').next().unwrap();
        let lines = help.lines().filter(|line| {
            line.strip_prefix("  ").is_some_and(|words| words.split(' ').next() == Some(name))
        });
        assert_eq!(lines.count(), 1, "{name}");
    }
    assert!(help.lines().count() <= 66 && help.lines().all(|line| line.chars().count() <= 80), "{help}");
}

#[test]
fn quiet_runs_write_results_and_errors_only() {
    let noted = "period 1 --length 1m±0.1m";
    let quiet = [format!("-q {noted}"), format!("{noted} --quiet"), format!("{noted} -q --color never")];
    let expected = libration(noted);
    assert!(message(&expected).starts_with("note: "));
    for arguments in quiet {
        let output = libration(&arguments);
        assert_eq!((message(&output).as_str(), &output.stdout), ("", &expected.stdout), "{arguments}");
    }
    let sweep = libration("sweep period --over amplitude=1,2 -q --csv");
    assert!(!message(&sweep).contains("unexpected argument"), "{}", message(&sweep));
    assert!(message(&libration("-q period 4rad")).starts_with("error: "));
    // After -- come values, not options.
    assert!(refusal("period -- -q").contains("cannot read `-q` as an angle"));
}

#[test]
fn colours_are_those_of_the_option() {
    let is_coloured = |arguments: &str| message(&libration(arguments)).contains("\x1b[");
    assert!(is_coloured("period up --color always") && is_coloured("--color=always period up"));
    assert!(!is_coloured("period up --color never") && !is_coloured("period up"));
    let refused = refusal("period 1 --color green");
    assert!(refused.contains("[possible values: auto, always, never]"), "{refused}");
}

#[test]
fn manual_pages_name_every_option_and_example() {
    let page = text("man fit trace");
    let escaped = |option: &str| option.replace('-', "\\-");
    let query = questions().into_iter().find(|question| question.words == "fit trace").unwrap();
    for parameter in query.parameters.iter().filter(|parameter| parameter.kind != ParameterKind::Argument) {
        assert!(page.contains(&escaped(&parameter.name)), "{}", parameter.name);
    }
    assert!(page.contains("libration fit trace examples/swing_synthetic.csv"));
    assert!(text("man").contains("libration\\-period"));
    let refused = refusal("man fit swing");
    assert!(refused.contains("no command `fit swing`") && refused.contains("periods, lengths"), "{refused}");
}

/// A file has the bytes of the standard output, and its extension chooses the format where none is stated.
#[test]
fn every_command_writes_to_a_file() {
    let folder = directory("output");
    let file = |name: &str| folder.join(name).display().to_string();
    let noted = "--length 1m±0.1m";
    for (name, command, options, format) in [
        ("period.json", "period 1", noted, "--json"),
        ("rows.csv", "-q period 1 2", "", "--csv"),
        // A note on how a word was read.
        ("motion.csv", "motion 45", "--times 0,1", "--csv"),
        ("stated.json", "period 1 2", "", "--csv"),
        ("none.json", "completions bash", "", ""),
        ("page.1", "man period", "", ""),
        ("list.txt", "list oscillators", "", ""),
        ("fit.json", "fit trace ../../examples/swing_synthetic.csv", "", "--json"),
    ] {
        let stated = if name == "stated.json" { format } else { "" };
        let path = file(name);
        let written = libration(&format!("{command} {options} {stated} --output {path}"));
        let shown = libration(&format!("{command} {options} {format}"));
        assert!(written.status.success() && written.stdout.is_empty(), "{name}: {}", message(&written));
        assert_eq!(std::fs::read(&path).unwrap(), shown.stdout, "{name}");
        // A note is written once, though the words are read twice.
        assert_eq!(message(&written), message(&shown), "{name}");
    }
    assert_eq!(text(&format!("period 1 -o {}", "-")), text("period 1"));
}

#[test]
fn a_result_that_fails_leaves_the_file_as_it_was() {
    let path = directory("output").join("kept.json");
    std::fs::write(&path, "before").unwrap();
    // The second amplitude has no period.
    let failed = libration(&format!("period 1 4 -o {}", path.display()));
    assert!(!failed.status.success() && message(&failed).contains("not below pi"), "{}", message(&failed));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "before");
    let failed = libration("period 1 -o no/such/folder/x.json");
    assert!(message(&failed).contains("cannot write no/such/folder/x.json"), "{}", message(&failed));
}
