//! What goes to the screen beside files, and what is left when long work is ended early.

use crate::command::{directory, json, message, text};
use std::fs;
use std::io::Read;
use std::process::{Command, Stdio};

#[test]
fn with_a_picture_the_points_are_not_listed_and_a_line_says_what_was_written() {
    let place = directory("announced");
    let questions = [
        "motion 60deg --times 0:100:0.01",
        "decay 60deg --linear 0.01 --cycles 200",
        "backbone duffing --amplitudes 0.01:3:0.01",
        "section driven_pendulum --set A=1.5,c=1/2 --initial theta=0.2 --points 100 --skip 1",
        "bifurcation driven_pendulum --set c=1/2 --over A=1:1.2:0.1 --initial theta=0.2 --points 40 --skip 1",
        "simulate pendulum --initial theta=1 --times 0:100:0.1",
        "lyapunov driven_pendulum --set A=1.5,c=1/2 --initial theta=0.2 --intervals 100 --transient 1",
    ];
    for (number, question) in questions.iter().enumerate() {
        let picture = place.join(format!("{number}.svg"));
        let answer = text(&format!("{question} --figure {}", picture.display()));
        assert!(answer.lines().count() < 25, "{question}:\n{answer}");
        let said = answer.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(said.contains(&format!("{} written: ", picture.display())), "{question}:\n{answer}");
        assert!(fs::read_to_string(picture).unwrap().starts_with("<svg"));
    }
}

#[test]
fn numbers_that_are_asked_for_are_written_beside_a_picture() {
    let picture = directory("beside-numbers").join("motion.svg").display().to_string();
    let answer = json(&format!("motion 60deg --times 0:1:0.1 --figure {picture}"));
    assert_eq!(answer["samples"].as_array().unwrap().len(), 11);
    let table = text(&format!("motion 60deg --times 0:1:0.1 --csv --figure {picture}"));
    assert_eq!(table.lines().count(), 12);
}

#[test]
fn files_are_announced() {
    let place = directory("announced-files");
    let page = place.join("period.html");
    assert_eq!(
        text(&format!("derive --road formulas --format html --output {}", page.display())).lines().count(),
        1
    );
    let samples = place.join("long.csv");
    let answer =
        text(&format!("simulate pendulum --initial theta=1 --times 0:9:1 --output {}", samples.display()));
    assert!(answer.starts_with(&format!("{} written: ", samples.display())), "{answer}");
    assert_eq!(fs::read_to_string(samples).unwrap().lines().count(), 11);
}

/// Sends Ctrl-C when the first bytes of an answer have come.
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
        assert!(message(&output).contains("until then are written"), "{}", message(&output));
        let read: serde_json::Value = serde_json::from_slice(&answer).unwrap();
        let list = if question.starts_with("motion") { &read["samples"] } else { &read["results"] };
        assert!(!list.as_array().unwrap().is_empty());
    }
}

/// Waits until the command listens for Ctrl-C: until its mask of caught signals has SIGINT, the second bit.
#[cfg(target_os = "linux")]
fn wait_until_it_listens(process: u32) {
    let listens = || {
        let status = fs::read_to_string(format!("/proc/{process}/status")).unwrap();
        let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:")).unwrap();
        u64::from_str_radix(caught.trim(), 16).unwrap() & 2 != 0
    };
    while !listens() {
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_keeps_the_points_of_a_backbone_that_are_done() {
    let question = "backbone pendulum --amplitudes 1deg:179deg:0.002deg --csv";
    let running = Command::new(env!("CARGO_BIN_EXE_libration"))
        .args(question.split(' '))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    wait_until_it_listens(running.id());
    assert!(Command::new("kill").args(["-INT", &running.id().to_string()]).status().unwrap().success());
    let output = running.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{}", message(&output));
    assert!(message(&output).contains("the points until then are written"), "{}", message(&output));
    let answer = String::from_utf8(output.stdout).unwrap();
    let rows = answer.lines().skip(1);
    let amplitudes: Vec<f64> = rows.map(|line| line.split(',').next().unwrap().parse().unwrap()).collect();
    assert!(amplitudes.len() < 89_001, "{}", amplitudes.len());
    for (place, amplitude) in (0_u32..).zip(amplitudes) {
        assert!((amplitude.to_degrees() - 1.0 - 0.002 * f64::from(place)).abs() < 1e-9);
    }
}
