//! Continued runs of `libration simulate` equal uninterrupted ones, to the last byte.

use crate::command::{directory, libration, message, text};
use crate::fields::assert_described;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

/// A system with its start and its events.
const QUESTIONS: [(&str, &str); 4] = [
    ("driven_pendulum --set A=0.5,c=1/2 --tolerance 1e-15", "theta=0.2"),
    ("driven_pendulum --set A=1.2,c=1/2 --events turning,crossing,theta-0.5", "theta=0.2"),
    ("damped_pendulum --set c=0.1,c0=0.2 --events turning", "theta=2"),
    ("double_pendulum --tolerance 1e-9", "theta1=2,theta2=1"),
];

fn state_of(file: &Path) -> PathBuf {
    PathBuf::from(format!("{}.state", file.display()))
}

fn state(file: &Path) -> Value {
    serde_json::from_slice(&fs::read(state_of(file)).unwrap()).unwrap()
}

#[test]
fn an_answer_is_gone_on_from_as_if_it_had_never_ended() {
    let directory = directory("resume");
    for (number, (question, start)) in QUESTIONS.iter().enumerate() {
        for ending in ["csv", "json"] {
            let [whole, part] =
                ["whole", "part"].map(|name| directory.join(format!("{name}{number}.{ending}")));
            let begin = |end: &str, file: &Path| {
                text(&format!(
                    "simulate {question} --initial {start} --times 0:{end}:0.125 --output {}",
                    file.display()
                ))
            };
            begin("20", &whole);
            for end in ["0", "0.125", "7", "9.875"] {
                begin(end, &part);
                for farther in ["15.5", "20"] {
                    let file = part.display();
                    text(&format!(
                        "simulate {question} --times 0:{farther}:0.125 --resume {file} --output {file}"
                    ));
                }
                assert!(
                    fs::read(&part).unwrap() == fs::read(&whole).unwrap(),
                    "{question} {ending} from {end}"
                );
            }
            if ending == "csv" {
                assert_eq!(state(&part), state(&whole));
            }
        }
    }
}

#[test]
fn a_file_that_is_cut_short_anywhere_comes_out_whole() {
    let directory = directory("resume_cut");
    let (question, start) = QUESTIONS[1];
    let [whole, part, cut] = ["whole.csv", "part.csv", "cut.csv"].map(|name| directory.join(name));
    let begin = |end: &str, file: &Path| {
        let file = file.display();
        text(&format!("simulate {question} --initial {start} --times 0:{end}:0.05 --output {file}"))
    };
    begin("30", &whole);
    begin("20", &part);
    let bytes = fs::read(&part).unwrap();
    let saved = usize::try_from(state(&part)["known"]["bytes"].as_u64().unwrap()).unwrap();
    assert!(saved < bytes.len() && saved > bytes.len() / 2, "{saved} of {}", bytes.len());
    // Cut at the end of a line, one byte next to it, within a number, and before the first complete line.
    for length in
        [bytes.len(), bytes.len() - 1, bytes.len() - 7, saved + 20, saved + 1, saved, saved - 1, saved / 2]
    {
        fs::write(&cut, &bytes[..length]).unwrap();
        fs::copy(state_of(&part), state_of(&cut)).unwrap();
        let file = cut.display();
        let output =
            libration(&format!("simulate {question} --times 0:30:0.05 --resume {file} --output {file}"));
        if length >= saved {
            assert!(output.status.success(), "{length}: {}", message(&output));
            assert!(fs::read(&cut).unwrap() == fs::read(&whole).unwrap(), "{length}");
        } else {
            assert_eq!(output.status.code(), Some(1), "{length}");
            assert!(message(&output).contains("recorded in its .state"), "{}", message(&output));
            assert_eq!(fs::read(&cut).unwrap().len(), length);
        }
    }
    let mut changed = bytes.clone();
    // A changed digit in a number, which only the checksum can detect.
    let digit = (saved / 2..).find(|&index| changed[index].is_ascii_digit()).unwrap();
    changed[digit] = if changed[digit] == b'1' { b'2' } else { b'1' };
    fs::write(&cut, &changed).unwrap();
    fs::copy(state_of(&part), state_of(&cut)).unwrap();
    let output = libration(&format!("simulate {question} --times 0:30:0.05 --resume {}", cut.display()));
    assert_eq!(output.status.code(), Some(1));
    assert!(
        ["do not match its .state", "has a sample at"].iter().any(|reason| message(&output).contains(reason)),
        "{}",
        message(&output)
    );
}

#[test]
fn another_question_is_refused_with_what_differs() {
    let directory = directory("resume_other");
    for ending in ["csv", "json"] {
        let file = directory.join(format!("begun.{ending}"));
        let begun = "simulate pendulum --initial theta=1 --times 0:5:0.5";
        text(&format!("{begun} --events turning --output {}", file.display()));
        let cases = [
            ("pendulum --events turning --set omega0=2 --times 0:9:0.5", 1, "its equations are"),
            ("spring_pendulum --events turning --times 0:9:0.5", 1, "its equations are"),
            ("pendulum --events turning --tolerance 1e-9 --times 0:9:0.5", 1, "--tolerance 1e-12"),
            ("pendulum --times 0:9:0.5", 1, "its events are turning, not none"),
            ("pendulum --events crossing --times 0:9:0.5", 1, "its events are turning, not crossing"),
            ("pendulum --events turning --times 0:9:0.25", 1, "has a sample at t = 0.5 s"),
            ("pendulum --events turning --times 0:2:0.5", 1, "--times ends earlier"),
            (
                "pendulum --events turning --times 0:9:0.5 --initial theta=1.1",
                2,
                "started from another state",
            ),
        ];
        for (question, status, expected) in cases {
            let output = libration(&format!("simulate {question} --resume {}", file.display()));
            assert_eq!(output.status.code(), Some(status), "{ending} {question}: {}", message(&output));
            assert!(message(&output).contains(expected), "{ending} {question}: {}", message(&output));
            assert!(output.stdout.is_empty(), "{ending} {question}");
        }
        let same = "simulate pendulum --events turning --times 0:9:0.5 --initial theta=1";
        text(&format!("{same} --resume {}", file.display()));
    }
}

#[test]
fn a_file_that_does_not_say_how_it_goes_on_is_refused() {
    let directory = directory("resume_without");
    let file = directory.join("begun.csv");
    let question = "simulate pendulum --times 0:5:0.5";
    let attempt = || libration(&format!("{question} --resume {}", file.display()));
    text(&format!("{question} --initial theta=1 --output {}", file.display()));
    let state = fs::read_to_string(state_of(&file)).unwrap();
    // The state file is not read to its end, whatever its size.
    fs::write(state_of(&file), state + &" ".repeat(1 << 20)).unwrap();
    assert!(message(&attempt()).contains("not a record of an integration"), "{}", message(&attempt()));
    fs::write(state_of(&file), "{}").unwrap();
    assert!(message(&attempt()).contains("not a record of an integration"), "{}", message(&attempt()));
    fs::remove_file(state_of(&file)).unwrap();
    assert!(message(&attempt()).contains("begun.csv.state is missing"), "{}", message(&attempt()));
    assert_eq!(attempt().status.code(), Some(1));
    fs::remove_file(&file).unwrap();
    assert!(message(&attempt()).contains("begun.csv"), "{}", message(&attempt()));
    let json = directory.join("old.json");
    fs::write(
        &json,
        r#"{"schema":2,"state":["theta","theta'"],"samples":[{"time_s":0.0,"state":[1.0,0.0]}],"events":[]}"#,
    )
    .unwrap();
    let output = libration(&format!("{question} --resume {}", json.display()));
    assert!(message(&output).contains("`resume` is missing or damaged"), "{}", message(&output));
}

#[cfg(unix)]
#[test]
fn a_run_that_is_ended_by_force_is_gone_on_from_and_nothing_is_left() {
    let directory = directory("resume_killed");
    let [file, whole] = ["long.csv", "whole.csv"].map(|name| directory.join(name));
    let question = "simulate driven_pendulum --set A=1.2,c=1/2 --events turning";
    let begin = || {
        let arguments =
            format!("{question} --initial theta=0.1 --times 0:1e6:0.5 --output {}", file.display());
        let mut running = std::process::Command::new(env!("CARGO_BIN_EXE_libration"))
            .args(arguments.split_whitespace())
            .stderr(std::process::Stdio::null())
            .spawn()
            .unwrap();
        wait_for(&file, |entry| entry.file_name().to_string_lossy().ends_with(".part.state"));
        running.kill().unwrap();
        running.wait().unwrap();
    };
    begin();
    let left = fs::read_dir(&directory).unwrap().find_map(|entry| {
        let path = entry.unwrap().path();
        path.to_string_lossy().ends_with(".part").then_some(path)
    });
    let left = left.unwrap();
    let saved = &state(&left)["known"];
    // As many samples again.
    let end = 2 * saved["samples"].as_u64().unwrap() / 2;
    text(&format!("{question} --initial theta=0.1 --times 0:{end}:0.5 --output {}", whole.display()));
    let output = libration(&format!(
        "{question} --times 0:{end}:0.5 --resume {} --output {}",
        file.display(),
        file.display()
    ));
    assert!(output.status.success(), "{}", message(&output));
    assert!(message(&output).contains("continuing from"), "{}", message(&output));
    assert!(fs::read(&file).unwrap() == fs::read(&whole).unwrap());
    let names = || {
        let names = fs::read_dir(&directory).unwrap();
        let mut names: Vec<_> =
            names.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    };
    assert_eq!(names(), ["long.csv", "long.csv.state", "whole.csv", "whole.csv.state"]);
    begin();
    assert_eq!(names().len(), 6);
    let output =
        libration(&format!("{question} --initial theta=1 --times 0:5:1 --output {}", file.display()));
    assert!(message(&output).contains("left by a killed run"), "{}", message(&output));
    assert_eq!(names(), ["long.csv", "long.csv.state", "whole.csv", "whole.csv.state"]);
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_a_complete_file_to_go_on_from() {
    let file = directory("interrupt").join("long.json");
    let question = "simulate driven_pendulum --set A=1.2,c=1/2 --initial theta=0.1";
    let arguments = format!("{question} --times 0:1e6:1 --output {}", file.display());
    let running = std::process::Command::new(env!("CARGO_BIN_EXE_libration"))
        .args(arguments.split_whitespace())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    wait_for(&file, |entry| entry.metadata().is_ok_and(|metadata| metadata.len() > 100_000));
    let signal =
        std::process::Command::new("kill").args(["-INT", &running.id().to_string()]).status().unwrap();
    assert!(signal.success());
    let output = running.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{}", message(&output));
    assert!(message(&output).contains("--resume"), "{}", message(&output));
    let answer: Value = serde_json::from_slice(&fs::read(&file).unwrap()).unwrap();
    let count = answer["samples"].as_array().unwrap().len();
    assert!(answer["interrupted"] == true && (1..1_000_001).contains(&count), "{count}");
    assert_described("simulate", &answer);
    let further = format!("{question} --times 0:{}:1 --resume {} --json", count + 10, file.display());
    let answer: Value = serde_json::from_str(&text(&further)).unwrap();
    assert_eq!(answer["samples"].as_array().unwrap().len(), count + 11);
    assert!(answer["interrupted"].is_null());
}

/// Waits until the directory of a file contains an entry that `seen` accepts.
#[cfg(unix)]
fn wait_for(file: &Path, seen: impl Fn(&fs::DirEntry) -> bool) {
    for _ in 0..600 {
        if fs::read_dir(file.parent().unwrap()).unwrap().filter_map(Result::ok).any(|entry| seen(&entry)) {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    panic!("nothing is written");
}
