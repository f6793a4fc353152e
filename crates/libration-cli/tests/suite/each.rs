//! Many motions in one run, from a table.

use crate::command::{directory, message, run, unfolded};
use serde_json::Value;
use std::path::PathBuf;
use std::process::Output;

/// A file with this text.
fn table(name: &str, text: &str) -> PathBuf {
    let file = directory(&format!("each-{name}")).join("motions.csv");
    std::fs::write(&file, text).unwrap();
    file
}

fn asked(name: &str, text: &str, question: &[&str]) -> Output {
    let file = table(name, text).display().to_string();
    run(&[&["simulate"], question, &["--each", &file]].concat())
}

fn out(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{}", message(output)))
}

/// Asserts that the motions of a table equal those of single runs; a row has the values of `--set` and `--initial`.
fn are_those_of_single_runs(name: &str, question: &[&str], names: &str, rows: &[[&str; 2]]) {
    let names: Vec<&str> = names.split(',').collect();
    let (mut text, mut expected) = (names.join(",") + "\n", vec![]);
    for (number, [set, initial]) in (1..).zip(rows) {
        let values: Vec<&str> = [*set, *initial]
            .into_iter()
            .filter(|list| !list.is_empty())
            .flat_map(|list| list.split(','))
            .collect();
        text += &(values.iter().map(|value| value.split_once('=').unwrap().1).collect::<Vec<_>>().join(",")
            + "\n");
        let set = if set.is_empty() { vec![] } else { vec!["--set", *set] };
        let single =
            run(&[&["simulate"], question, &set, &["--initial", initial, "--csv", "--no-errors"]].concat());
        let single = out(&single);
        expected.extend(single.lines().skip(1).map(|line| format!("{number},{line}")));
    }
    let many = out(&asked(name, &text, &[question, &["--csv"]].concat()));
    assert_eq!(many.lines().count(), expected.len() + 1, "{question:?}");
    for (line, expected) in many.lines().skip(1).zip(&expected) {
        assert_eq!(line, expected, "{question:?}");
    }
    assert!(expected.len() > rows.len(), "{question:?}");
}

fn question_of_derivatives(times: &str) -> [&str; 6] {
    ["x'' = -k*x", times, "--columns", "e=k*x^2+x'^2", "--sensitivity", "x',k"]
}

/// The energy is that of the motion alone; a picture, which could not show the sensitivities, is rejected.
#[test]
fn derivatives_by_parameters_and_starts_are_columns_of_each_motion() {
    let question = question_of_derivatives("--times=0:50:10");
    let answer = json(&asked("derivatives-json", "k,x\n4,1\n9,2\n", &[&question[..], &["--json"]].concat()));
    crate::fields::assert_described("simulate --each", &answer);
    assert_eq!(answer["columns"], serde_json::json!(["e", "dx/dx'(0)", "dx'/dx'(0)", "dx/dk", "dx'/dk"]));
    for (motion, (frequency, start)) in
        answer["motions"].as_array().unwrap().iter().zip([(2.0, 1.0), (3.0, 2.0)])
    {
        assert!(motion["energy_drift"].as_f64().unwrap() < 1e-13, "{motion}");
        let last = motion["samples"].as_array().unwrap().last().unwrap();
        assert_eq!(last["state"].as_array().unwrap().len(), 2);
        let by_k = -50.0 * start * f64::sin(50.0 * frequency) / (2.0 * frequency);
        assert!((last["columns"][3].as_f64().unwrap() - by_k).abs() < 1e-9, "{last}, {by_k}");
    }
    let drawn = asked("derivatives-svg", "k,x\n4,1\n", &[&question[..], &["--figure", "a.svg"]].concat());
    assert!(message(&drawn).contains("--figure: it does not draw the derivatives"), "{}", message(&drawn));
}

#[test]
fn each_motion_is_bit_for_bit_that_of_its_own_run() {
    let starts: Vec<String> = (1..=19).map(|n| format!("theta1={}deg,theta2'=0.{n}", 9 * n)).collect();
    let starts: Vec<[&str; 2]> = starts.iter().map(|start| ["", start.as_str()]).collect();
    let question = ["double_pendulum", "--times", "0:7:0.5", "--events", "turning,crossing"];
    let question = [&question[..], &["--tolerance", "1e-13, theta2=1e-9"]].concat();
    are_those_of_single_runs("starts", &question, "theta1,theta2'", &starts);
    let rows = [
        ["c=0.1,n=2", "theta=60deg"],
        ["c=1/3,n=2", "theta=1"],
        ["c=0.1,n=2", "theta=179deg"],
        ["c=0,n=1", "theta=1e-3"],
        ["c=1/2,n=0", "theta=2"],
    ];
    let question = ["damped_pendulum", "--times", "0,1,3,20", "--columns", "e=theta'^2/2-cos(theta),c*t"];
    are_those_of_single_runs("parameters", &question, "c,n,theta", &rows);
    let rows = [["k=4", "x=1"], ["k=9", "x=sqrt(2)"], ["k=2", "x=-3"]];
    for times in ["--times=-1:-9:-1", "--times=0:-9:-1", "--times=-3:3:0.5"] {
        let question = ["x'' = -k*x - x^3", times, "--tolerance", "1e-15", "--events", "turning,x-0.1"];
        are_those_of_single_runs("times", &question, "k,x", &rows);
    }
    let question = [&question_of_derivatives("--times=0:5:1")[..], &["--events", "turning"]].concat();
    are_those_of_single_runs("derivatives", &question, "k,x", &rows);
    are_those_of_single_runs("both", &question_of_derivatives("--times=-3:3:1"), "k,x", &rows);
    let rows = [["", "x=1"], ["", "x=0.2"]];
    let question = ["x'' = -x", "--times", "0:9:1", "--until", "x = -0.1", "--direction", "falling"];
    are_those_of_single_runs("until", &question, "x", &rows);
}

#[test]
fn rows_tell_whose_they_are_and_energies_are_kept_for_each() {
    let text = "# three pendulums\n\nname;theta;omega0\n\"short; light\";60deg;3\n;1;2\n long ;0.5;1/2\n";
    let output = asked("names", text, &["pendulum", "--times", "0:20:10", "--json"]);
    let answer = json(&output);
    crate::fields::assert_described("simulate --each", &answer);
    let motions = answer["motions"].as_array().unwrap();
    let names: Vec<&Value> = motions.iter().map(|motion| &motion["name"]).collect();
    assert_eq!(names, [&Value::from("short; light"), &Value::Null, &Value::from("long")]);
    for (motion, (omega0, theta)) in
        motions.iter().zip([(3.0, std::f64::consts::FRAC_PI_3), (2.0, 1.0), (0.5, 0.5)])
    {
        assert_eq!(motion["parameters"]["omega0"], omega0);
        assert!((motion["initial"][0].as_f64().unwrap() - theta).abs() < 1e-15);
        let drift = motion["energy_drift"].as_f64().unwrap();
        assert!(drift < 1e-12 && motion["steps"].as_u64().unwrap() > 3, "{motion:#}");
        assert_eq!(motion["samples"].as_array().unwrap().len(), 3);
    }
    let csv = out(&asked("names", text, &["pendulum", "--times", "0:20:10", "--csv"]));
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], "motion,name,time_s,theta,theta'");
    assert!(
        lines[1].starts_with("1,short; light,0.0,1.047") && lines[9].starts_with("3,long,20.0,"),
        "{csv}"
    );
    let sheet = out(&asked("names", text, &["pendulum", "--times", "0:20:10"]));
    assert!(sheet.contains("theta'' + omega0^2*sin(theta) = 0") && sheet.contains("60deg"), "{sheet}");
}

#[test]
fn a_motion_that_ends_early_stops_no_other() {
    let text = "name,x,k\ninto,1,1\nout,1,-1\nfar,9,1\n";
    let question = ["x'' = -k/x^2", "--times", "0:2:1", "--json"];
    let output = asked("ends", text, &question);
    assert_eq!(output.status.code(), Some(1));
    let told = message(&output);
    assert!(
        told.contains("motion 1 (into): the steps become too short") && told.contains("t = 1.11"),
        "{told}"
    );
    assert!(!told.contains("motion 2") && !told.contains("motion 3"), "{told}");
    let answer = json(&output);
    let samples = |n: usize| answer["motions"][n]["samples"].as_array().unwrap().len();
    assert_eq!([samples(0), samples(1), samples(2)], [2, 3, 3]);
    assert!(answer["motions"][0]["stopped"].as_str().unwrap().contains("too short"));
    assert!(answer["motions"][1]["stopped"].is_null());
    let output = asked("ends", text, &[&question[..], &["--until", "x = 3/2", "--times", "0:9:9"]].concat());
    assert_eq!(output.status.code(), Some(2), "--times twice");
    let question = ["x'' = -k/x^2", "--times", "0:1:1", "--json", "--until", "x = 1.2"];
    let output = asked("ends", text, &question);
    let told = message(&output);
    assert!(told.contains("motion 1 (into): `x = 1.2` does not occur before t = 1.0 s"), "{told}");
    assert!(told.contains("motion 3 (far)") && !told.contains("motion 2"), "{told}");
    let until = &json(&output)["motions"][1]["until"];
    assert!((until["state"][0].as_f64().unwrap() - 1.2).abs() < 1e-12, "{until}");
}

#[test]
fn more_failures_than_are_read_are_counted() {
    let text = "x\n1\n1\n1\n1\n1\n-1\n";
    let output = asked("failures", text, &["x'' = -1/x^2", "--times", "0:2:1", "--csv"]);
    assert!(message(&output).contains("; and 2 more of 6 motions"), "{}", message(&output));
}

#[test]
fn the_answer_goes_to_a_file_without_a_state() {
    let folder = directory("each-output");
    let answer = folder.join("answer.json").display().to_string();
    let question = ["pendulum", "--times", "0:2:1", "--output", &answer];
    let output = asked("output", "theta\n1\n2\n", &question);
    let told = unfolded(&out(&output));
    assert!(told.contains("answer.json written: 2 motions of the simple pendulum"), "{told}");
    let written: Value = serde_json::from_slice(&std::fs::read(&answer).unwrap()).unwrap();
    assert_eq!(written["motions"][1]["initial"][0], 2.0);
    assert!(!folder.join("answer.json.state").exists());
}

#[test]
fn tables_that_cannot_be_are_refused_for_the_true_reason() {
    let pendulum = |text: &str, options: &[&str]| {
        let output = asked("refused", text, &[&["pendulum", "--times", "0,1"], options].concat());
        (output.status.code().unwrap(), message(&output))
    };
    for (text, reason) in [
        ("", "the file has no motions"),
        ("theta,omega0\n", "the file has no motions"),
        ("theta,\n1,2\n", "line 1: column 2 has no name"),
        ("theta,θ\n1,2\n", "line 1: there are two columns `θ`"),
        (
            "theta,thta\n1,2\n",
            "line 1: `thta` is neither a parameter (omega0) nor an initial value (theta, theta')",
        ),
        ("# 1\ntheta,omega0\n\n1\n", "line 4: 1 cell below 2 names"),
        ("theta,omega0\n1,2,3\n", "line 2: 3 cells below 2 names"),
        ("theta,omega0\n1,2\n1,\n", "line 3: omega0 has no value"),
        ("theta,omega0\n1,1/0\n", "line 2: omega0 has no value: `1/0`"),
        ("theta,omega0\n1,2*\n", "line 2: omega0: "),
        ("theta,omega0\n1,k\n", "line 2: the value of omega0 contains k"),
        ("theta,omega0\n1kg,2\n", "line 2: theta: cannot read `1kg` as an angle"),
        ("x[i]\n1\n", "line 2: the system has no state variables x[i]"),
        ("name\na\n", "line 1: it names neither a parameter nor an initial value"),
        ("theta\n\0\n", "not a text file"),
    ] {
        let (status, told) = pendulum(text, &[]);
        assert!(status == 1 && told.contains(reason), "{text:?}: {told}");
    }
    for (text, options, reason) in [
        (
            "omega0\n1\n",
            &["--initial", "theta=1", "--set", "omega0=2"][..],
            "has a value by an option already",
        ),
        ("omega0\n1\n", &["--initial", "theta=1", "--length", "1m"], "has a value by an option already"),
        ("theta\n1\n", &["--initial", "theta=1"], "line 2: theta is given twice"),
        ("omega0\n1\n", &[], "--initial: the initial state is missing"),
        ("theta\n1\n", &["--initial", "q=1"], "--initial: the system has no state variable `q`"),
        ("theta\n1\n", &["--resume", "a.json"], "--resume: it continues one motion"),
        ("theta\n1\n", &["--animate", "--figure", "a.svg"], "--animate: it shows the bodies of one motion"),
    ] {
        let (_, told) = pendulum(text, options);
        assert!(told.contains(reason), "{options:?}: {told}");
    }
    let many: String = (0..13).fold("theta\n".to_owned(), |text, n| format!("{text}0.{n}\n"));
    assert!(pendulum(&many, &["--figure", "a.svg"]).1.contains("at most 12 motions, and there are 13"));
    let long = asked("long", &many, &["pendulum", "--times", "0:1e6:0.5"]);
    assert!(
        message(&long).contains("13 motions at 2000001 times are 78000039 numbers"),
        "{}",
        message(&long)
    );
    let chain = asked("chain", "n,x1\n3,1\n", &["fermi_pasta_ulam", "--times", "0,1"]);
    assert!(
        message(&chain).contains("`n` sets the number of coordinates of all motions"),
        "{}",
        message(&chain)
    );
    let endless = run(&["simulate", "pendulum", "--each", "/dev/zero", "--times", "0,1"]);
    assert!(cfg!(not(unix)) || message(&endless).contains("at most 67108864 bytes are read"));
}

#[test]
fn the_first_angle_that_may_be_meant_in_degrees_is_doubted_once() {
    let output = asked("bare", "theta\n1\n60\n70\n", &["pendulum", "--times", "0,1", "--csv"]);
    assert_eq!(message(&output).matches("note:").count(), 1, "{}", message(&output));
    assert!(message(&output).contains("taken as 60 rad"), "{}", message(&output));
}
