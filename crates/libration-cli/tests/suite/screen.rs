//! Terminal output of commands that write files.

use crate::command::{directory, json, text};
use std::fs;

#[test]
fn with_a_picture_the_points_are_not_listed_and_a_line_says_what_was_written() {
    let folder = directory("announced");
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
        let picture = folder.join(format!("{number}.svg"));
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
    let folder = directory("announced-files");
    let page = folder.join("period.html");
    assert_eq!(
        text(&format!("derive --method formulas --format html --output {}", page.display())).lines().count(),
        1
    );
    let samples = folder.join("long.csv");
    let answer =
        text(&format!("simulate pendulum --initial theta=1 --times 0:9:1 --output {}", samples.display()));
    assert!(answer.starts_with(&format!("{} written: ", samples.display())), "{answer}");
    assert_eq!(fs::read_to_string(samples).unwrap().lines().count(), 11);
}
