//! `libration fit lengths` and `libration fit gates`.

use crate::command::{directory, json, libration, message, text};
use std::path::PathBuf;

fn example(name: &str) -> String {
    format!("{}/../../examples/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn file(name: &str, text: &str) -> String {
    let path: PathBuf = directory(name).join("file.csv");
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

/// How many of its uncertainties a value is from the truth.
fn pull(answer: &serde_json::Value, name: &str, uncertainty: &str, truth: f64) -> f64 {
    (answer[name].as_f64().unwrap() - truth).abs() / answer[uncertainty].as_f64().unwrap()
}

#[test]
fn the_example_of_lengths_gives_its_truth_back() {
    let lengths = example("lengths_synthetic.csv");
    let answer = json(&format!("fit lengths {lengths} --amplitude 10deg --bob-radius 25mm"));
    assert_eq!(answer["rows"], 12);
    assert!(pull(&answer, "gravity_m_per_s2", "gravity_uncertainty_m_per_s2", 9.81) < 3.0);
    assert!(pull(&answer, "offset_m", "offset_uncertainty_m", 0.025) < 3.0);
    assert!(answer["warnings"][0].as_str().unwrap().contains("offset is needed"));
    let sheet = text(&format!("fit lengths {lengths}"));
    assert!(sheet.contains("offset+gyration") && sheet.contains("gravity"));
}

/// T² = 4π²(L + 0.01)/9.81, to twelve digits.
const EXACT: &str = "L,half\n25,0.511448657526\n50,0.716309081159\n75,0.874424193522\n100,1.008036031441\n";

#[test]
fn half_periods_and_centimetres_are_taken_as_said() {
    let table = file("lengths-half", EXACT);
    let answer = json(&format!("fit lengths {table} --length-unit cm --half-periods"));
    assert!((answer["gravity_m_per_s2"].as_f64().unwrap() - 9.81).abs() < 1e-9, "{answer}");
    assert!((answer["offset_m"].as_f64().unwrap() - 0.01).abs() < 1e-9);
    let csv = text(&format!("fit lengths {table} --length-unit cm --half-periods --csv"));
    assert!(csv.starts_with("law,g_m_per_s2,") && csv.lines().count() == 4, "{csv}");
}

#[test]
fn the_line_is_drawn() {
    let picture = directory("lengths-drawn").join("lengths.svg");
    text(&format!("fit lengths {} --figure {}", example("lengths_synthetic.csv"), picture.display()));
    let svg = std::fs::read_to_string(picture).unwrap();
    assert!(svg.contains("length L / m") && svg.contains("residual / s"));
}

#[test]
fn the_example_of_a_gate_gives_its_truth_back() {
    let gate = example("gate_synthetic.csv");
    // One shell word each: the tests split at blanks.
    let answer = json(&format!("fit gates {gate} --length 0.958m±0.001m --diameter 25.0(1)mm"));
    assert_eq!((&answer["missed_passages"], &answer["unpaired_edges"]), (&1.into(), &1.into()));
    assert!(pull(&answer, "t0_s", "t0_uncertainty_s", std::f64::consts::TAU / 3.2) < 3.0, "{answer}");
    assert!(pull(&answer, "beta", "beta_uncertainty", 1.0) < 3.0);
    // The pendulum has neither air nor a rod.
    assert!(pull(&answer, "gravity_m_per_s2", "gravity_uncertainty_m_per_s2", 9.81) < 3.0);
    assert!(answer["budget"].as_array().unwrap().len() >= 9);
    assert_eq!(answer["t0_by"], "the speeds at the gate");
    let csv = text(&format!("fit gates {gate} --csv"));
    assert!(csv.starts_with("time_s,period_s,side,amplitude_rad\n"));
}

#[test]
fn passages_without_an_amplitude_give_the_period_alone() {
    let times: String = (0..12).map(|k| format!("{}\n", f64::from(k) + 0.1 * f64::from(k % 2))).collect();
    let times = file("gate-bare", &format!("Time (s)\n{times}"));
    let answer = json(&format!("fit gates {times}"));
    assert!((answer["mean_period_s"].as_f64().unwrap() - 2.0).abs() < 1e-12);
    assert!(answer["t0_s"].is_null() && answer["note"].as_str().unwrap().contains("amplitude"));
    let sheet = text(&format!("fit gates {times} --amplitude 20deg --length 1m"));
    assert!(
        sheet.contains("by the amplitude of the release") && sheet.contains("finite amplitude"),
        "{sheet}"
    );
}

#[test]
fn the_periods_are_drawn() {
    let picture = directory("gates-drawn").join("gates.svg");
    let gate = example("gate_synthetic.csv");
    text(&format!("fit gates {gate} --length 0.958m --diameter 25mm --figure {}", picture.display()));
    let svg = std::fs::read_to_string(picture).unwrap();
    assert!(svg.contains("the other side") && svg.contains("exact law"));
}

#[test]
fn what_tells_nothing_is_refused_with_a_reason() {
    let few = file("gate-few", "0.1\n1.1\n2.1\n");
    assert!(message(&libration(&format!("fit gates {few}"))).contains("too few"));
    let equal = file("lengths-equal", "1,2.0\n1,2.01\n1,2.02\n");
    assert!(message(&libration(&format!("fit lengths {equal}"))).contains("all the same"));
    let both = file("lengths-amplitudes", "1,2.0,0.1\n0.5,1.4,0.1\n0.25,1.0,0.1\n");
    let both = libration(&format!("fit lengths {both} --columns 1,2,-,-,3 --amplitude 10deg"));
    assert!(message(&both).contains("--amplitude"));
    let rod = libration(&format!("fit gates {few} --length 1m --rod-mass 5g"));
    assert!(message(&rod).contains("--bob-mass"));
}
