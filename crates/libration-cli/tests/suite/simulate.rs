//! Motions in time by the command.

use crate::command::{close, directory, json, libration, message, run, text, unfolded};
use serde_json::Value;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6};
use std::fs;
use std::path::Path;

fn sample(answer: &Value, place: usize) -> Vec<f64> {
    let state = answer["samples"][place]["state"].as_array().unwrap();
    state.iter().map(|value| value.as_f64().unwrap()).collect()
}

#[test]
fn a_damped_pendulum_is_that_of_the_reference() {
    let answer = json(
        "simulate damped_pendulum --set c=0.1,n=2 --initial theta=1,theta'=0 --times 0.5,30 --tolerance 1e-15",
    );
    let fields: Vec<&str> = answer.as_object().unwrap().keys().map(String::as_str).collect();
    let expected =
        ["schema", "system", "equations", "state", "samples", "events", "energy_drift", "steps", "note"];
    assert_eq!(fields, expected);
    assert_eq!(
        (&answer["system"], &answer["state"]),
        (&"damped_pendulum".into(), &serde_json::json!(["theta", "theta'"]))
    );
    close(&answer["samples"][0]["time"], 0.5, 0.0);
    // damped.csv of the library.
    close(&answer["samples"][0]["state"][0], 0.896390819265663239817, 1e-15);
    close(&answer["samples"][1]["state"][0], -0.28686664229216129236, 1e-14);
    assert_eq!(answer["energy_drift"], Value::Null);
    assert!(answer["note"].as_str().unwrap().contains("not conserved"), "{}", answer["note"]);
}

#[test]
fn a_conservative_motion_reports_how_well_it_keeps_its_energy() {
    for system in [
        "pendulum --initial theta=60deg",
        "double_pendulum --initial theta1=1,theta2=-0.5",
        "morse --initial x=0.5",
    ] {
        let answer = json(&format!("simulate {system} --times 0:20:5"));
        let drift = answer["energy_drift"].as_f64().unwrap();
        assert!(drift < 1e-11, "{system}: {drift}");
        assert!(answer["note"].is_null() && answer["steps"].as_u64().unwrap() > 10, "{answer}");
    }
    let answer =
        run(&["simulate", "x'' = y - x; y'' = x - y", "--initial", "x=1", "--times", "0,1", "--json"]);
    let answer: Value = serde_json::from_slice(&answer.stdout).unwrap();
    assert_eq!(answer["system"], "x'' = y - x; y'' = x - y");
    assert!(answer["energy_drift"].as_f64().unwrap() < 1e-12);
    let (half, frequency) = (0.5, 2_f64.sqrt());
    assert!((sample(&answer, 1)[0] - half * (1.0 + frequency.cos())).abs() < 1e-12);
}

#[test]
fn every_form_has_the_same_numbers() {
    let question = "simulate spring_pendulum --initial theta=0.5 --times 0:2:0.25";
    let answer = json(question);
    let table = text(&format!("{question} --csv"));
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("time,r,theta,r',theta'"));
    for (place, line) in lines.enumerate() {
        let numbers: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        assert_eq!(numbers[1..], sample(&answer, place));
    }
    // r is not given and begins where the spring carries the weight.
    assert_eq!(sample(&answer, 0), [1.1, 0.5, 0.0, 0.0]);
    let sheet = text(question);
    let said = unfolded(&sheet);
    assert!(
        said.contains("(r, r', theta' not given and taken at rest)") && said.contains("r' / (m/s)"),
        "{sheet}"
    );
}

#[test]
fn initial_values_have_units_and_names_as_physicists_write_them() {
    let start = |initial: &str, system: &str| {
        let arguments = ["simulate", system, "--initial", initial, "--times", "0", "--json"];
        let output = run(&arguments);
        assert!(output.status.success(), "{initial}: {}", message(&output));
        sample(&serde_json::from_slice(&output.stdout).unwrap(), 0)
    };
    assert_eq!(start("theta=90deg,theta'=30deg/s", "pendulum"), [FRAC_PI_2, FRAC_PI_6]);
    assert_eq!(start("θ = pi/2, θ̇ = 1", "pendulum"), [FRAC_PI_2, 1.0]);
    assert_eq!(start("x=sqrt(2)", "x'' = -x"), [2f64.sqrt(), 0.0]);
    assert_eq!(start("r=120cm,r'=-5cm/s", "spring_pendulum"), [1.2, 0.0, -0.05, 0.0]);
    assert_eq!(start("x'=0.1", "double_well"), [1.0, 0.1]);
}

#[test]
fn motions_run_backward_too() {
    let there = json("simulate pendulum --initial theta=1,theta'=0.3 --times 0:-3:-1 --tolerance 1e-15");
    let [angle, velocity] = sample(&there, 3).try_into().unwrap();
    let back = json(&format!(
        "simulate pendulum --initial theta={angle:?},theta'={velocity:?} --times 3 --tolerance 1e-15"
    ));
    let [angle, velocity] = sample(&back, 0).try_into().unwrap();
    assert!((angle - 1.0).abs() < 1e-14 && (velocity - 0.3).abs() < 1e-14);
}

#[test]
fn a_singularity_ends_the_answer_and_says_so() {
    let output = run(&["simulate", "x'' = 2 x^3", "--initial", "x=1,x'=1", "--times", "0:2:0.4", "--json"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(message(&output).contains("singularity"), "{}", message(&output));
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(answer["samples"].as_array().unwrap().len(), 3);
    assert!(answer["stopped"].as_str().unwrap().contains("singularity"), "{answer}");
}

#[test]
fn an_answer_is_gone_on_from_where_it_ended() {
    let directory = directory("resume");
    let question = "simulate driven_pendulum --set A=0.5,c=1/2 --tolerance 1e-15";
    let whole = json(&format!("{question} --initial theta=0.2 --times 0:20:0.5"));
    for ending in ["json", "csv"] {
        let file = directory.join(format!("part.{ending}"));
        let file = file.display();
        text(&format!("{question} --initial theta=0.2 --times 0:10:0.5 --output {file}"));
        text(&format!("{question} --times 0:20:0.5 --resume {file} --output {file}"));
        let samples: Vec<Vec<f64>> = if ending == "json" {
            let answer: Value = serde_json::from_slice(&fs::read(file.to_string()).unwrap()).unwrap();
            (0..41).map(|place| sample(&answer, place)).collect()
        } else {
            let table = fs::read_to_string(file.to_string()).unwrap();
            let numbers = |line: &str| line.split(',').skip(1).map(|cell| cell.parse().unwrap()).collect();
            table.lines().skip(1).map(numbers).collect()
        };
        assert_eq!(samples.len(), 41);
        for (place, state) in samples.iter().enumerate() {
            let [wanted, got] = [sample(&whole, place)[0], state[0]];
            assert!((wanted - got).abs() < 1e-14, "{ending} {place}: {wanted} {got}");
        }
    }
    let other = directory.join("part.csv");
    let begun = directory.join("begun.json");
    let question =
        format!("simulate pendulum --initial theta=1 --times 0,1 --json --output {}", begun.display());
    assert!(libration(&question).status.success());
    let output =
        libration(&format!("simulate pendulum --set omega0=2 --times 0,2 --resume {}", begun.display()));
    assert!(message(&output).contains("its equations are"), "{}", message(&output));
    let further = format!("simulate pendulum --times 0,2 --resume {}", begun.display());
    assert!(libration(&format!("{further} --initial theta=1")).status.success());
    let output = libration(&format!("{further} --initial theta=1.1"));
    assert_eq!(output.status.code(), Some(2));
    assert!(message(&output).contains("does not begin there"), "{}", message(&output));
    let output = libration(&format!("simulate spring_pendulum --times 0,1 --resume {}", other.display()));
    assert_eq!(output.status.code(), Some(1));
    assert!(message(&output).contains("its states are of theta, theta'"), "{}", message(&output));
}

/// Times and kinds of the events of an answer.
fn events(answer: &Value) -> Vec<(f64, String)> {
    let event = |event: &Value| (event["time"].as_f64().unwrap(), event["kind"].as_str().unwrap().to_owned());
    answer["events"].as_array().unwrap().iter().map(event).collect()
}

#[test]
fn turning_points_passages_and_levels_are_found() {
    let question = "simulate damped_pendulum --set c=0.1 --initial theta=1 --times 0:10:5 --tolerance 1e-15";
    let turnings = events(&json(&format!("{question} --events turning")));
    // damped.csv of the library.
    let expected = [3.323972347874400124, 6.594035276141596549, 9.827704016085721970];
    assert_eq!(turnings[0], (0.0, "turning, at the start".to_owned()));
    assert_eq!(turnings.len(), 1 + expected.len());
    for ((time, kind), expected) in turnings[1..].iter().zip(expected) {
        assert!(kind == "turning" && (time - expected).abs() < 1e-14, "{time} {kind}");
    }
    let passages = events(&json(&format!("{question} --events crossing")));
    assert_eq!(passages.len(), 3);
    let levels = events(&json(&format!("{question} --events theta-0.5,c-0.2")));
    assert_eq!(levels.iter().map(|(_, kind)| kind.as_str()).collect::<Vec<_>>(), ["theta - 0.5"; 3]);
    let table = text(&format!("{question} --events turning --csv"));
    assert!(table.starts_with("time,theta,theta',event\n0.0,1.0,0.0,\n"), "{table}");
    assert_eq!(table.lines().filter(|line| line.ends_with(",turning")).count(), 3);
    let coupled = "simulate double_pendulum --initial theta1=1 --times 0,3 --events turning";
    assert!(events(&json(coupled)).iter().any(|(_, kind)| kind == "turning of theta2"));
    let sheet = text(&format!("{question} --events turning"));
    assert!(sheet.contains("3.32397234787") && sheet.contains("event"), "{sheet}");
}

#[test]
fn rotations_pass_the_lowest_point_in_every_turn() {
    let answer = json("simulate pendulum --initial theta'=3 --times 0,20 --events crossing,turning");
    let end = sample(&answer, 1)[0];
    // The start is one of them, and no rotation turns back.
    let turns = (1..100).take_while(|&turn| f64::from(turn) * std::f64::consts::TAU <= end).count();
    assert!(turns > 3);
    assert_eq!(events(&answer).len(), 1 + turns, "{end}");
}

#[test]
fn events_are_kept_when_an_answer_is_gone_on_from() {
    let directory = directory("resumed_events");
    let question = "simulate pendulum --events turning,crossing --tolerance 1e-15";
    let whole = events(&json(&format!("{question} --initial theta=2 --times 0:20:1")));
    for ending in ["json", "csv"] {
        let file = directory.join(format!("part.{ending}"));
        let file = file.display();
        text(&format!("{question} --initial theta=2 --times 0:10:1 --output {file}"));
        let answer = json(&format!("{question} --times 0:20:1 --resume {file}"));
        let found = events(&answer);
        assert_eq!(found.len(), whole.len(), "{ending}: {found:?}");
        for (found, whole) in found.iter().zip(&whole) {
            assert!(found.1 == whole.1 && (found.0 - whole.0).abs() < 1e-13, "{ending}: {found:?} {whole:?}");
        }
    }
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
    wait_for_samples(&file);
    let signal =
        std::process::Command::new("kill").args(["-INT", &running.id().to_string()]).status().unwrap();
    assert!(signal.success());
    let output = running.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{}", message(&output));
    assert!(message(&output).contains("--resume"), "{}", message(&output));
    let answer: Value = serde_json::from_slice(&fs::read(&file).unwrap()).unwrap();
    let count = answer["samples"].as_array().unwrap().len();
    assert!(answer["interrupted"] == true && (1..1_000_001).contains(&count), "{count}");
    let further = format!("{question} --times 0:{}:1 --resume {} --json", count + 10, file.display());
    let answer: Value = serde_json::from_str(&text(&further)).unwrap();
    assert_eq!(answer["samples"].as_array().unwrap().len(), count + 11);
    assert!(answer["interrupted"].is_null());
}

/// Until the unfinished file beside its place has grown.
#[cfg(unix)]
fn wait_for_samples(file: &Path) {
    let grown = || {
        let beside = fs::read_dir(file.parent()?).ok()?.find_map(Result::ok)?;
        (beside.metadata().ok()?.len() > 100_000).then_some(())
    };
    for _ in 0..600 {
        if grown().is_some() {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    panic!("nothing is written");
}

#[test]
fn pictures_have_an_axis_for_each_unit() {
    let picture = directory("simulation").join("spring.svg");
    text(&format!(
        "simulate spring_pendulum --initial theta=0.5,r=1 --times 0:20:1 --events turning --figure {}",
        picture.display()
    ));
    let drawn = fs::read_to_string(&picture).unwrap();
    for label in ["time t / s", "r / m", "θ / degrees", "Motion of the spring pendulum"] {
        assert!(drawn.contains(label), "{label}");
    }
}
