//! Results that remain when long work is cancelled.

use crate::command::{directory, message};
use crate::fields::assert_described;
use serde_json::Value;
use std::io::Read;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

/// Sends Ctrl-C when the first bytes of the output have arrived.
#[cfg(unix)]
#[test]
fn ctrl_c_ends_a_long_list_with_a_whole_answer() {
    let questions = ["motion 60deg --times 0:9e5:0.1 --json", "period 0deg:179deg:0.0001deg --json"];
    for question in questions {
        let mut running = Command::new(env!("CARGO_BIN_EXE_libration"))
            .args(question.split(' '))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut answer = vec![0];
        let mut out = running.stdout.take().unwrap();
        out.read_exact(&mut answer).unwrap();
        assert!(Command::new("kill").args(["-INT", &running.id().to_string()]).status().unwrap().success());
        out.read_to_end(&mut answer).unwrap();
        let output = running.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(130), "{question}: {}", message(&output));
        assert!(message(&output).contains("up to then are written"), "{}", message(&output));
        let read: Value = serde_json::from_slice(&answer).unwrap();
        let list = if question.starts_with("motion") { &read["samples"] } else { &read["results"] };
        assert!(!list.as_array().unwrap().is_empty());
    }
}

/// Waits until the command handles Ctrl-C: until its mask of caught signals contains SIGINT, the second bit.
#[cfg(target_os = "linux")]
fn wait_until_it_listens(process: u32) {
    let listens = || {
        let status = std::fs::read_to_string(format!("/proc/{process}/status")).unwrap();
        let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:")).unwrap();
        u64::from_str_radix(caught.trim(), 16).unwrap() & 2 != 0
    };
    while !listens() {
        std::thread::sleep(Duration::from_millis(10));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_keeps_the_points_of_a_backbone_that_are_done() {
    let question = "backbone pendulum --amplitudes 1deg:179deg:0.002deg --csv";
    let output = interrupted(&question.split(' ').collect::<Vec<_>>(), Duration::ZERO);
    assert_eq!(output.status.code(), Some(130), "{}", message(&output));
    let answer = String::from_utf8(output.stdout.clone()).unwrap();
    let rows = answer.lines().skip(1);
    let amplitudes: Vec<f64> = rows.map(|line| line.split(',').next().unwrap().parse().unwrap()).collect();
    if amplitudes.is_empty() {
        assert!(message(&output).contains("nothing is written"), "{}", message(&output));
    } else {
        let told = format!("the points up to then are written, {} of 89001", amplitudes.len());
        assert!(message(&output).contains(&told), "{}", message(&output));
    }
    assert!(amplitudes.len() < 89_001 && amplitudes.is_sorted());
}

/// Without a check at each step of the quadratures this would take minutes.
#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_ends_a_search_for_thresholds() {
    let equation = "x'' + sin(x) = -0.1*x'*abs(x') + A*cos(t)/(2 + cos(t))";
    let began = std::time::Instant::now();
    let output = interrupted(&["melnikov", equation, "--over", "A=0:1"], Duration::from_millis(300));
    assert_eq!(output.status.code(), Some(130), "{}", message(&output));
    assert!(message(&output).contains("interrupted before the thresholds"), "{}", message(&output));
    assert!(began.elapsed() < Duration::from_secs(10), "{:?}", began.elapsed());
}

/// The output of a command that receives Ctrl-C this time after it began to handle it.
#[cfg(target_os = "linux")]
fn interrupted(arguments: &[&str], after: Duration) -> Output {
    let running = Command::new(env!("CARGO_BIN_EXE_libration"))
        .args(arguments)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    wait_until_it_listens(running.id());
    std::thread::sleep(after);
    assert!(Command::new("kill").args(["-INT", &running.id().to_string()]).status().unwrap().success());
    let output = running.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{arguments:?}: {}", message(&output));
    output
}

/// An equation whose orbits take more than ten seconds each, while its series takes no noticeable time.
#[cfg(target_os = "linux")]
const SLOW: &str = "x''=-x*exp(-x^2)+x^101*exp(-x^4)/2^400";

/// Time that suffices for the series on any computer, but not for an orbit.
#[cfg(target_os = "linux")]
const BETWEEN: Duration = Duration::from_secs(2);

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_keeps_a_series_whose_exact_value_takes_long() {
    let arguments = ["expand", SLOW, "--order", "5", "--evaluate", "20"];
    let output = interrupted(&[&arguments[..], &["--json"]].concat(), BETWEEN);
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(answer["interrupted"] == true && answer["order"] == 5, "{answer:#}");
    assert_described("expand --evaluate", &answer);
    for field in ["exact", "radius", "pade"] {
        assert!(answer[field].is_null(), "{field}: {answer:#}");
        let note = answer["note"].as_str().unwrap();
        assert!(note.contains(&format!("{field} is null: not computed: interrupted")), "{note}");
    }
    assert_eq!(answer["steps"][1]["coefficient"], "3/8");
    let missing = "the exact value, the radius of convergence, the Padé approximants";
    let told = format!("interrupted: the series is written, without {missing}");
    assert!(message(&output).contains(&told), "{}", message(&output));
    let table = String::from_utf8(interrupted(&arguments, BETWEEN).stdout).unwrap();
    assert_eq!(table.matches("not computed: interrupted").count(), 2, "{table}");
}

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_does_not_wait_for_the_orbits_under_way() {
    let arguments = ["backbone", SLOW, "--amplitudes", "0.1,0.2,0.3,0.4,20,21,22,23,24,25", "--json"];
    let output = interrupted(&arguments, BETWEEN);
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    let points = answer["points"].as_array().unwrap();
    assert!(answer["interrupted"] == true && (1..10).contains(&points.len()), "{answer:#}");
    assert_eq!(points[0]["amplitude"], 0.1);
    assert_described("backbone", &answer);
    let early = interrupted(&["backbone", "--order", "999", "--amplitudes", "1"], BETWEEN);
    assert!(early.stdout.is_empty());
    assert!(
        message(&early).contains("before the frequency at any amplitude was known"),
        "{}",
        message(&early)
    );
}

/// One of several motions begins at a singularity and ends at once; the others never end.
#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_keeps_what_of_many_motions_is_known() {
    let table = directory("interrupted-each").join("starts.csv");
    std::fs::write(&table, "x,k\n0,1\n1,0\n1,0\n").unwrap();
    let table = table.display().to_string();
    let question = ["simulate", "x''=-x-k/x^2", "--each", &table, "--times", "0:1e9:1e3", "--json"];
    let output = interrupted(&question, BETWEEN);
    assert!(message(&output).contains("interrupted: 1 of 3 motions are done"), "{}", message(&output));
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_described("simulate --each", &answer);
    let motions = answer["motions"].as_array().unwrap();
    assert!(
        motions[0]["stopped"].is_string() && motions[0]["interrupted"].is_null(),
        "{:#}",
        motions[0]["stopped"]
    );
    let long = motions.iter().filter(|motion| motion["interrupted"] == true);
    assert!(long.clone().count() >= 1 && long.clone().all(|motion| motion["steps"].as_u64().unwrap() > 0));
}

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_keeps_what_of_a_picture_is_known() {
    let picture = directory("interrupted-series").join("series.svg");
    let output = picture.display().to_string();
    let arguments = ["figure", "series", SLOW, "--order", "9", "--amplitudes", "0.1,0.2,20", "-o", &output];
    assert!(message(&interrupted(&arguments, BETWEEN)).contains("the curves up to then are written"));
    let drawn = std::fs::read_to_string(picture).unwrap();
    assert!(drawn.contains("A = 0.2") && !drawn.contains("A = 20"));
    let early = interrupted(&["figure", "series", "--order", "999", "-o", &output], BETWEEN);
    assert!(message(&early).contains("nothing is drawn"), "{}", message(&early));
}

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_keeps_the_steps_of_a_derivation() {
    let arguments = ["derive", "--method", "perturbation", SLOW, "--order", "3", "--amplitude", "20"];
    let output = interrupted(&arguments, 3 * BETWEEN);
    assert!(message(&output).contains("the steps up to then are written"), "{}", message(&output));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.starts_with("# Perturbation theory") && !text.contains("Accuracy"), "{text}");
    assert!(text.contains("This derivation was interrupted"), "{text}");
}

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_keeps_the_orders_with_letters() {
    let mixed = "x'' + w^2*x + a*x^2 + b*x^3 = 0";
    let output = interrupted(&["expand", mixed, "--order", "999", "--json"], Duration::from_secs(1));
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(answer["interrupted"] == true && answer["order"].as_u64().unwrap() < 999);
    assert_eq!((&answer["certificate"], &answer["certified"]), (&"none".into(), &false.into()));
    assert_eq!(answer["frequency_ratio"][2], "3*b/(8*w^2) - 5*a^2/(12*w^4)");
    assert!(
        message(&output).contains("of 999, which is not checked by a second method"),
        "{}",
        message(&output)
    );
    assert_described("expand", &answer);
}

#[test]
fn ctrl_c_keeps_the_orders_that_are_certain() {
    // Time that suffices for the first primes on any computer, but not for a thousand orders.
    let output = interrupted(&["expand", "pendulum", "--order", "999", "--json"], Duration::from_secs(1));
    assert!(message(&output).starts_with("error: interrupted"), "{}", message(&output));
    if message(&output).contains("is certain") {
        let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert!(answer["interrupted"] == true && answer["order"].as_u64().unwrap() < 999);
        assert_eq!(answer["of_amplitude"]["period_ratio"][2], "1/16");
        assert_described("expand", &answer);
    } else {
        assert!(message(&output).contains("before any order was confirmed"), "{}", message(&output));
    }
}
