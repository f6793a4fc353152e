//! Queries that another program runs in its own process.

use crate::command::{message, run};
use libration::progress::Quiet;
use libration::systems::Model;
use libration::taylor::Ensemble;
use libration_queries::internals::query_error::CommandWords;
use libration_queries::{AxisValues, Host, QueryError, SweepPlan, ask};
use serde_json::Value;
use std::ffi::OsString;
use std::io::{self, Read};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

/// A host that stores the messages it receives.
#[derive(Default)]
struct Memory {
    answer: Mutex<Vec<u8>>,
    notes: Mutex<Vec<String>>,
    input: &'static [u8],
    /// Number of checks after which the host cancels once.
    patience: Option<usize>,
    looks: AtomicUsize,
    is_full: bool,
}

impl Host for Memory {
    fn write(&self, bytes: &[u8]) -> io::Result<()> {
        if self.is_full {
            return Err(io::Error::other("no room is left"));
        }
        self.answer.lock().unwrap().extend_from_slice(bytes);
        Ok(())
    }

    fn read(&self) -> Box<dyn Read + '_> {
        Box::new(self.input)
    }

    fn note(&self, sentence: &str) {
        self.notes.lock().unwrap().push(sentence.to_owned());
    }

    fn goes_on(&self) -> bool {
        Some(self.looks.fetch_add(1, Ordering::Relaxed)) != self.patience
    }
}

fn asked(arguments: &[&str], host: Memory) -> (Arc<Memory>, Result<(), QueryError>) {
    let host = Arc::new(host);
    let answered = ask(arguments.iter().map(OsString::from), host.clone());
    (host, answered)
}

fn answer(arguments: &[&str]) -> Vec<u8> {
    let (host, answered) = asked(arguments, Memory::default());
    answered.unwrap();
    host.answer.lock().unwrap().clone()
}

#[test]
fn answers_are_those_of_the_program_byte_for_byte() {
    for question in [
        "period 60deg 1.2 --json",
        "period -- -30deg",
        "period 0deg:170deg:0.01deg --csv",
        "motion 60deg --times 0:1:0.1",
        "motion 60deg --times 0:1:0.1 --figure -",
        "motion 60deg --times 0:1:0.1 --csv --figure -",
        "expand pendulum --order 7 --json",
        "expand pendulum --order 5 --evaluate 1",
        "decay 60deg --linear 0.1 --cycles 3 --json",
        "simulate pendulum --initial theta=1 --times 0:3:1 --output -",
        "section driven_pendulum --set A=1.5,c=1/2 --initial theta=0.2 --points 5 --skip 1 --csv",
        "paper",
        "fields fit trace",
        "--version",
    ] {
        let words: Vec<&str> = question.split(' ').collect();
        let program = run(&words);
        assert!(program.status.success(), "{question}: {}", message(&program));
        assert!(!program.stdout.is_empty(), "{question}");
        assert!(answer(&words) == program.stdout, "{question}");
    }
}

#[test]
fn failures_have_the_reason_and_the_status_of_the_program() {
    for (question, status) in [
        ("period 60degg", 2),
        ("period 200deg", 1),
        ("simulate pendulum --times 0:1:1 --initial nothing=1", 2),
        ("inspect /nowhere.csv", 1),
        ("expand x''+1=0", 1),
        ("nonsense", 2),
        ("period --nonsense", 2),
        ("", 2),
    ] {
        let words: Vec<&str> = question.split_whitespace().collect();
        let program = run(&words);
        let (host, answered) = asked(&words, Memory::default());
        let failure = answered.unwrap_err();
        assert_eq!(Some(i32::from(failure.status())), program.status.code(), "{question}");
        assert_eq!(program.status.code(), Some(status), "{question}");
        // clap puts its own sentences before the reason.
        let said = message(&program);
        assert!(said.contains(&failure.message(&CommandWords)), "{question}: {failure}");
        assert!(!failure.to_string().contains("--help"), "{question}: {failure}");
        assert_eq!(*host.answer.lock().unwrap(), program.stdout, "{question}");
    }
}

#[test]
fn the_input_is_that_of_the_host() {
    let table = b"amplitude (deg),period (s)\n10,2.01\n30,2.04\n50,2.1\n70,2.21\n";
    let words = ["fit", "periods", "-", "--json"];
    let (host, answered) = asked(&words, Memory { input: table, ..Memory::default() });
    answered.unwrap();
    let mut program = Command::new(env!("CARGO_BIN_EXE_libration"));
    let mut program = program.args(words).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    io::Write::write_all(&mut program.stdin.take().unwrap(), table).unwrap();
    assert_eq!(*host.answer.lock().unwrap(), program.wait_with_output().unwrap().stdout);
}

#[test]
fn notes_go_to_the_host_once_a_question() {
    for _ in 0..2 {
        let (host, answered) = asked(&["expand", "d^2x/dt^2 + sin x = 0", "--order", "3"], Memory::default());
        answered.unwrap();
        let notes = host.notes.lock().unwrap();
        assert!(notes.len() == 1 && notes[0].starts_with("the equation is read as"), "{notes:?}");
    }
}

#[test]
fn a_host_that_takes_no_more_ends_the_answer() {
    for question in ["period 60deg", "motion 60deg --times 0:1:0.1 --figure -", "--help"] {
        let words: Vec<&str> = question.split(' ').collect();
        let (_, answered) = asked(&words, Memory { is_full: true, ..Memory::default() });
        let failure = answered.unwrap_err();
        assert_eq!(failure.status(), 1, "{question}");
        assert!(failure.to_string().contains("no room is left"), "{question}: {failure}");
    }
}

#[test]
fn an_answer_that_is_ended_early_keeps_what_is_done_and_ends_no_other() {
    let long = ["motion", "60deg", "--times", "0:100:0.1", "--json"];
    let of = |patience| Memory { patience: Some(patience), ..Memory::default() };
    let (host, answered) = asked(&long, of(500));
    assert!(matches!(&answered, Err(error) if error.is_cancelled()), "{answered:?}");
    let done: Value = serde_json::from_slice(&host.answer.lock().unwrap()).unwrap();
    assert!((1..=500).contains(&done["samples"].as_array().unwrap().len()));
    let section =
        "section driven_pendulum --set A=1.5,c=1/2 --initial theta=0.2 --points 3000 --skip 1 --json";
    let (host, answered) = asked(&section.split(' ').collect::<Vec<_>>(), of(100));
    assert!(matches!(&answered, Err(error) if error.is_cancelled()), "{answered:?}");
    let done: Value = serde_json::from_slice(&host.answer.lock().unwrap()).unwrap();
    assert!(done["points"].as_array().unwrap().len() < 3000);
    assert_eq!(answer(&long), run(&long).stdout);
}

#[test]
fn answers_side_by_side_do_not_mix() {
    let questions: Vec<Vec<String>> = (0..8)
        .map(|n| {
            let picture = if n % 2 == 0 { "--figure=-" } else { "--json" };
            let question =
                ["section", "driven_pendulum", "--set=A=1.5,c=1/2", "--points=20", "--skip=1", picture];
            question.into_iter().map(str::to_owned).chain([format!("--initial=theta=0.{}", n + 1)]).collect()
        })
        .collect();
    let words = |n: usize| questions[n].iter().map(String::as_str).collect::<Vec<_>>();
    let alone: Vec<Vec<u8>> = (0..8).map(|n| answer(&words(n))).collect();
    let words = &words;
    std::thread::scope(|scope| {
        let asking: Vec<_> = (0..8).map(|n| scope.spawn(move || answer(&words(n)))).collect();
        for (together, alone) in asking.into_iter().zip(&alone) {
            assert!(together.join().unwrap() == *alone);
        }
    });
}

#[test]
fn the_question_of_a_thread_ends_with_it_even_by_a_panic() {
    struct Panics;
    impl Host for Panics {
        fn write(&self, _: &[u8]) -> io::Result<()> {
            panic!("the host fails")
        }
    }
    let asks = || ask(["period", "1"].map(OsString::from), Arc::new(Panics));
    assert!(std::panic::catch_unwind(asks).is_err());
    assert_eq!(answer(&["period", "1"]), run(&["period", "1"]).stdout);
}

fn planned() -> SweepPlan {
    let question =
        ["section", "driven_pendulum", "--set", "c=1/2", "--points", "2", "--skip", "9"].map(str::to_owned);
    let axes = [
        ("A".to_owned(), AxisValues::Text("1:1.2:0.1".to_owned())),
        ("theta".to_owned(), AxisValues::List(vec!["0.1".to_owned(), "x".to_owned()])),
    ];
    let keep = ["omega=points[0:2].state[1]".to_owned()];
    SweepPlan::new(&question, &axes, &keep, Some(2), Arc::new(Memory::default())).unwrap()
}

#[test]
fn a_plan_and_its_text_answer_chunks_alike() {
    let plan = planned();
    let read = SweepPlan::from_json(&plan.to_json()).unwrap();
    assert_eq!((&read, read.to_json()), (&plan, plan.to_json()));
    for chunk in 0..3 {
        let [one, other] =
            [&plan, &read].map(|sweep| sweep.answers(chunk, Arc::new(Memory::default())).unwrap());
        // Text is compared, because NaN differs from itself.
        assert_eq!(format!("{one:?}"), format!("{other:?}"));
        assert_eq!(one.status, [0, 2], "an initial angle x is not understood");
        assert!(
            one.numbers[..2].iter().all(|number| number.is_finite())
                && one.numbers[2..].iter().all(|number| number.is_nan())
        );
        assert!(one.messages[0].is_empty() && one.messages[1].contains("--initial"), "{:?}", one.messages);
    }
}

#[test]
fn chunks_that_cannot_be_are_refused_and_others_end_early() {
    let plan = planned();
    let refused = plan.answers(3, Arc::new(Memory::default())).unwrap_err();
    assert!(refused.to_string().contains("no chunk 3: the sweep has 3"), "{refused}");
    let impatient = Memory { patience: Some(1), ..Memory::default() };
    assert!(matches!(plan.answers(0, Arc::new(impatient)), Err(error) if error.is_cancelled()));
    let text = plan.to_json();
    for (from, to) in
        [("\"format\":1", "\"format\":2"), ("[3,2]", "[3,3]"), ("[1,2]", "[0,2]"), ("path", "way"), ("{", "")]
    {
        assert!(text.contains(from), "{from} in {text}");
        assert!(SweepPlan::from_json(&text.replace(from, to)).is_err(), "{from}");
    }
}

#[test]
fn a_host_may_ask_while_it_is_told_how_an_argument_was_read() {
    #[derive(Default)]
    struct Asks(Memory);
    impl Host for Asks {
        fn write(&self, bytes: &[u8]) -> io::Result<()> {
            self.0.write(bytes)
        }

        fn note(&self, sentence: &str) {
            self.0.note(&format!("{sentence}: {}", String::from_utf8(answer(&["--version"])).unwrap()));
        }
    }
    let host = Arc::new(Asks::default());
    ask(["motion", "5", "--times", "0,1", "--json"].map(OsString::from), host.clone()).unwrap();
    assert!(host.0.notes.lock().unwrap()[0].contains("libration 0."));
    assert_eq!(*host.0.answer.lock().unwrap(), run(&["motion", "5", "--times", "0,1", "--json"]).stdout);
}

fn ensemble(arguments: &[&str], starts: &'static [u8]) -> Result<(Model, Ensemble), QueryError> {
    let host = Memory { input: starts, ..Memory::default() };
    libration_queries::ensemble(arguments.iter().map(OsString::from), Arc::new(host))
}

#[test]
fn motions_that_go_on_together_are_those_of_the_program() {
    let starts = b"theta1,theta2\n120deg,120deg\n120deg,121deg\n2,-1\n";
    let words = ["simulate", "double_pendulum", "--each", "-", "--times", "1.5,9", "--tolerance", "1e-8"];
    let (model, mut followed) = ensemble(&words, starts).unwrap();
    assert_eq!((model.key(), followed.len()), (Some("double_pendulum"), 3));
    let (host, answered) =
        asked(&[&words[..], &["--json"]].concat(), Memory { input: starts, ..Memory::default() });
    answered.unwrap();
    let answer: Value = serde_json::from_slice(&host.answer.lock().unwrap()).unwrap();
    let numbers = |motion: &Value| -> Vec<f64> {
        motion["samples"][0]["state"]
            .as_array()
            .unwrap()
            .iter()
            .map(|component| component.as_f64().unwrap())
            .collect()
    };
    let expected: Vec<f64> = answer["motions"].as_array().unwrap().iter().flat_map(numbers).collect();
    assert_eq!(followed.states_at(1.5, &Quiet).unwrap(), expected);
}

#[test]
fn what_cannot_go_on_together_is_refused() {
    let of = |more: &[&str], starts| {
        let words = [&["simulate", "driven_pendulum", "--times", "0,1"], more].concat();
        ensemble(&words, starts).map(|_| ()).unwrap_err().to_string()
    };
    let each = ["--each", "-"];
    assert_eq!(of(&[], b""), "--each: give a file with the initial states");
    assert_eq!(
        of(&each, b"theta,c\n1,0.1\n1,0.2\n"),
        "--each: the motions of an ensemble have the same parameters: give one value for each"
    );
    assert_eq!(
        of(&["--each", "-", "--events", "turning"], b"theta\n1\n"),
        "--events: events are not located in an ensemble"
    );
    assert!(of(&each, b"phi\n1\n").contains("phi"));
    assert!(of(&["--each", "-", "--tolerance", "0"], b"theta\n1\n").contains("1e-18"));
    let other = ensemble(&["period", "60deg"], b"").map(|_| ()).unwrap_err();
    assert_eq!(other.to_string(), "only libration simulate with --each has an ensemble");
}

/// The relaxation oscillation takes a minute; the run is cancelled when the second progress message has more steps than the first.
#[test]
fn a_long_search_for_an_orbit_tells_its_steps_and_can_be_ended() {
    #[derive(Default)]
    struct Watcher(Mutex<Vec<usize>>);
    impl Host for Watcher {
        fn write(&self, _: &[u8]) -> io::Result<()> {
            Ok(())
        }
        fn progress(&self, how_far: Option<&str>) {
            let steps: Option<usize> =
                how_far.and_then(|line| line.strip_prefix("the orbit: ")?.split(' ').next()?.parse().ok());
            self.0.lock().unwrap().extend(steps);
        }
        fn goes_on(&self) -> bool {
            self.0.lock().unwrap().len() < 2
        }
    }
    let host = Arc::new(Watcher::default());
    let question =
        ["orbit", "van_der_pol", "--set", "mu=1000", "--initial", "x=0.5", "--json"].map(OsString::from);
    let ended = ask(question, host.clone()).unwrap_err();
    assert!(ended.is_cancelled(), "{ended}");
    let steps = host.0.lock().unwrap();
    assert!(steps[0] > 0 && steps[1] > steps[0], "{steps:?}");
}
