//! `libration section`, `libration bifurcation` and `libration lyapunov`.

use crate::command::{directory, json, message, run, unfolded};
use serde_json::Value;
use std::process::{Command, Stdio};
use std::time::Duration;

const DRIVEN: [&str; 6] = ["driven_pendulum", "--set", "A=1.5,c=1/2", "--initial", "theta=0.2", "--json"];

fn answered(arguments: &[&str]) -> Vec<u8> {
    let output = run(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", message(&output));
    output.stdout
}

fn ask(arguments: &[&str]) -> Value {
    serde_json::from_slice(&answered(arguments)).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

#[test]
fn a_section_has_the_period_of_the_drive() {
    let answer = ask(&[&["section", "--points", "50", "--skip", "10", "--fold"][..], &DRIVEN].concat());
    let points = answer["points"].as_array().unwrap();
    assert_eq!((points.len(), &answer["complete"]), (50, &true.into()));
    assert_eq!(answer["state"], serde_json::json!(["theta", "theta'"]));
    for (n, point) in (10..).zip(points) {
        let period = 3.0 * std::f64::consts::PI;
        assert!((point["time_s"].as_f64().unwrap() - f64::from(n) * period).abs() < 1e-9);
        assert!(numbers(&point["state"])[0].abs() <= std::f64::consts::PI);
    }
}

/// A triple zero of the formula is known to a third of the digits, a chaotic motion for some hundred seconds.
#[test]
fn points_of_a_section_have_errors() {
    let arguments = ["section", "x'' = -x", "--initial", "x=1", "--at", "x^3", "--points", "4"];
    let answer = ask(&[&arguments[..], &["--json"]].concat());
    assert_eq!(answer["determined_until_s"], serde_json::json!([null]));
    let points = answer["points"].as_array().unwrap();
    for (n, point) in (0..).zip(points) {
        let error = numbers(&point["error"]);
        assert!(numbers(&point["state"])[0].abs() <= error[0], "{point}");
        let exact = (1.5 + 2.0 * f64::from(n)) * std::f64::consts::PI;
        let distance = (point["time_s"].as_f64().unwrap() - exact).abs();
        assert!(distance <= point["time_error_s"].as_f64().unwrap(), "{point}");
    }
    let table = String::from_utf8(answered(&arguments)).unwrap();
    assert!(table.contains("4.712388979  -2e-9  1.000000000"), "{table}");
    let without = ask(&[&arguments[..], &["--json", "--no-errors"]].concat());
    assert_eq!(
        (&without["points"][3]["error"], &without["points"][3]["state"]),
        (&Value::Null, &points[3]["state"])
    );

    let chaotic = ["section", "--points", "60", "--skip", "0"];
    let answer = ask(&[&chaotic[..], &DRIVEN].concat());
    let until = answer["determined_until_s"][0].as_f64().unwrap();
    for point in answer["points"].as_array().unwrap() {
        let is_determined = point["time_s"].as_f64().unwrap() <= until;
        assert_eq!(point["error"][0].is_f64(), is_determined, "{until}: {point}");
    }
    let table = String::from_utf8(answered(&[&chaotic[..], &DRIVEN[..5]].concat())).unwrap();
    assert!(
        unfolded(&table).contains("later points, with three digits, are those of a nearby motion"),
        "{table}"
    );
}

/// The motions for A = 1 and 1.1 are periodic, that for 1.2 is chaotic and not determined after some thirty periods.
#[test]
fn points_of_a_diagram_have_errors() {
    let arguments = ["bifurcation", "driven_pendulum", "--set", "c=1/2", "--initial", "theta=0.2"];
    let arguments = [&arguments[..], &["--over", "A=1:1.2:0.1", "--points", "2", "--skip", "60"]].concat();
    let answer = ask(&[&arguments[..], &["--json"]].concat());
    let points = answer["points"].as_array().unwrap();
    for point in points {
        let errors = [&point["time_error_s"], &point["error"][0], &point["error"][1]];
        let is_periodic = point["value"].as_f64().unwrap() < 1.15;
        assert!(errors.iter().all(|error| error.is_f64() == is_periodic), "{point}");
        assert!(!is_periodic || numbers(&point["error"]).iter().all(|error| *error < 1e-9), "{point}");
    }
    let table = String::from_utf8(answered(&arguments)).unwrap();
    assert!(unfolded(&table).contains("1 of 3 motions are not determined in double precision"), "{table}");
    let last = table.lines().last().unwrap();
    let digits = |cell: &str| {
        cell.chars().filter(char::is_ascii_digit).collect::<String>().trim_start_matches('0').len()
    };
    assert!(last.split_whitespace().skip(4).all(|cell| digits(cell) <= 3), "{last}");
    let csv = String::from_utf8(answered(&[&arguments[..], &["--csv"]].concat())).unwrap();
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], "sweep,A,time_s,theta,theta',time_error_s,theta_error,theta'_error");
    assert!(lines[6].ends_with(",,,"), "{}", lines[6]);
    let without = ask(&[&arguments[..], &["--json", "--no-errors"]].concat());
    assert_eq!(
        (&without["points"][5]["error"], &without["points"][5]["state"]),
        (&Value::Null, &points[5]["state"])
    );
}

#[test]
fn several_motions_cross_a_plane() {
    let equations = "x'' = -x - 2 x y; y'' = -y - x^2 + y^2";
    let arguments = ["section", equations, "--at", "x", "--points", "20"];
    let starts = ["--initial", "y=0.1,x'=0.49", "--initial", "y=-0.25,x'=0.42"];
    let figure = directory("section").join("section.svg");
    let drawn = ["--figure", figure.to_str().unwrap(), "--csv"];
    let csv = String::from_utf8(answered(&[&arguments[..], &starts, &drawn].concat())).unwrap();
    let mut lines = csv.lines();
    let errors = "time_error_s,x_error,y_error,x'_error,y'_error";
    assert_eq!(lines.next(), Some(&*format!("motion,time_s,x,y,x',y',{errors}")));
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    assert_eq!(rows.iter().filter(|row| row[0] > 1.5).count(), 20);
    assert!(rows.iter().all(|row| row[2].abs() <= row[7] && row[4] > 0.0));
    assert!(rows.iter().all(|row| row[6..].iter().all(|error| *error < 1e-8)));
    let svg = std::fs::read_to_string(figure).unwrap();
    assert!(svg.contains("Poincaré section") && svg.contains(">y′<"), "axes y and y′");
}

#[test]
fn sweeps_show_hysteresis_and_single_values_are_the_same_bits() {
    let arguments = ["bifurcation", "x'' + 0.2 x' + x + x^3 = A cos(1.8 t)", "--initial", "x=0", "--json"];
    let both =
        ask(&[&arguments[..], &["--over", "A=0.5:1.5:0.5", "--points", "1", "--sweep", "both"]].concat());
    let points = both["points"].as_array().unwrap();
    let sweeps: Vec<(&str, f64)> = points
        .iter()
        .map(|point| (point["sweep"].as_str().unwrap(), point["value"].as_f64().unwrap()))
        .collect();
    let order = [("up", 0.5), ("up", 1.0), ("up", 1.5), ("down", 1.5), ("down", 1.0), ("down", 0.5)];
    assert_eq!(sweeps, order);
    // More values than one work item has.
    let all = ask(&[&arguments[..], &["--over", "A=0.5:1.5:0.025", "--points", "3", "--skip", "9"]].concat());
    let all = all["points"].as_array().unwrap();
    for value in ["0.5", "1.3", "1.5"] {
        let over = format!("A={value}");
        let one = ask(&[&arguments[..], &["--over", &over, "--points", "3", "--skip", "9"]].concat());
        let same: Vec<&Value> =
            all.iter().filter(|point| point["value"] == one["points"][0]["value"]).collect();
        assert_eq!(same, one["points"].as_array().unwrap().iter().collect::<Vec<_>>(), "{value}");
    }
}

#[test]
fn the_verdicts_are_said() {
    let answer = ask(&[&["lyapunov", "--intervals", "500"][..], &DRIVEN].concat());
    assert_eq!(answer["verdict"], "chaotic");
    assert!((answer["exponent_per_s"].as_f64().unwrap() - 0.11).abs() < 0.02, "{}", answer["exponent_per_s"]);
    let last = answer["convergence"].as_array().unwrap().last().unwrap();
    assert_eq!(last["exponent_per_s"], answer["exponent_per_s"]);
    let pendulum = json("lyapunov pendulum --initial theta=179.999deg --intervals 50");
    assert_eq!(pendulum["verdict"], "regular");
    assert!(pendulum["reason"].as_str().unwrap().contains("Bendixson"), "{}", pendulum["reason"]);
    let short = ask(&[&["lyapunov", "--intervals", "30"][..], &DRIVEN].concat());
    assert_eq!(short["verdict"], "undecided");
}

#[test]
fn what_cannot_be_is_refused_with_what_would_do() {
    let cases: [(&[&str], i32, &[&str]); 12] = [
        (&["section", "pendulum", "--initial", "theta=1"], 2, &["--period", "surface"]),
        (&["section", "driven_pendulum"], 2, &["--initial", "theta=60deg"]),
        (&["section", "pendulum", "--initial", "theta=1", "--at", "z"], 2, &["--at", "z"]),
        // `foo` is not a parameter either, so that `--set` is not suggested.
        (
            &["section", "x''=-x", "--initial", "x=1", "--at", "x-foo"],
            2,
            &["--at: the system has no state variable `foo`: it has x, x', and the time t"],
        ),
        (
            &["bifurcation", "x''=-k*x", "--initial", "x=1", "--over", "k=1:2:1", "--at", "1/foo"],
            2,
            &["--at: the system has no state variable `foo`: it has x, x', and the time t"],
        ),
        (
            &["section", "x''=-x", "--initial", "x=1", "--at", "x = 1 +"],
            2,
            &["--at", "at character", "\n   1 +\n"],
        ),
        (
            &["section", "x''=-x", "--initial", "x=1", "--at", "x-5"],
            1,
            &["the motion does not cross the surface", "no point is written"],
        ),
        (
            &["section", "pendulum", "--initial", "theta=1", "--period", "1", "--phase", "2"],
            2,
            &["--phase", "0 to 1"],
        ),
        (
            &["bifurcation", "driven_pendulum", "--initial", "theta=1", "--over", "B=1:2:1"],
            2,
            &["B", "omega0"],
        ),
        (
            &["bifurcation", "driven_pendulum", "--initial", "theta=1", "--over", "A=1:2:-1"],
            2,
            &["--over", "step"],
        ),
        (&["lyapunov", "x'' = -k x", "--initial", "x=1"], 2, &["k", "--set k="]),
        (&["lyapunov", "x'' = x^2", "--initial", "x=1"], 1, &["singularity"]),
    ];
    for (arguments, status, parts) in cases {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {}", message(&output));
        for part in parts {
            assert!(message(&output).contains(part), "{arguments:?}: {}", message(&output));
        }
    }
}

#[test]
fn the_formula_of_a_surface_may_name_parameters() {
    let points = |at: &str| {
        let arguments =
            ["section", "pendulum", "--initial", "theta=1", "--set", "omega0=2", "--at", at, "--points", "2"];
        ask(&[&arguments[..], &["--json"]].concat())["points"].clone()
    };
    assert_eq!(points("theta - omega0/4"), points("theta - 1/2"));
    assert_eq!(points("theta = omega0/4"), points("theta - 1/2"));
}

#[test]
fn the_surface_of_a_diagram_may_name_parameters_and_the_varied_one() {
    let diagram = |over: &str, at: &str| {
        let rest = ["--initial", "theta=1", "--set", "omega0=2", "--skip", "0", "--points", "2", "--json"];
        ask(&[&["bifurcation", "damped_pendulum", "--over", over, "--at", at][..], &rest].concat())["points"]
            .clone()
    };
    assert_eq!(diagram("c1=0.01:0.02:0.01", "theta - omega0/4"), diagram("c1=0.01:0.02:0.01", "theta - 1/2"));
    let varied = diagram("c1=0.0625:0.125:0.0625", "theta - 4*c1");
    for (value, surface) in [("0.0625", "theta - 1/4"), ("0.125", "theta - 1/2")] {
        let one = diagram(&format!("c1={value}"), surface);
        let is_at = |point: &&Value| point["value"] == one[0]["value"];
        let same: Vec<Value> = varied.as_array().unwrap().iter().filter(is_at).cloned().collect();
        assert_eq!(Value::from(same), one, "{value}");
        assert_eq!(one.as_array().unwrap().len(), 2);
    }
}

/// What the surface fixes would be one line of points.
#[test]
fn pictures_show_what_the_surface_leaves_free() {
    let driven =
        ["bifurcation", "driven_pendulum", "--set", "c=1/2", "--initial", "theta=0.2", "--over", "A=1"];
    let double = ["section", "double_pendulum", "--initial", "theta1=2,theta2=2"];
    let lorenz = ["section", "lorenz", "--initial", "x=1,y=1,z=1"];
    let figure = directory("free").join("free.json");
    let figure = figure.to_str().unwrap();
    let cases: [(&[&str], &str, [&str; 2]); 8] = [
        (&driven, "theta", ["A", "θ′ / (rad/s)"]),
        (&driven, "theta' - c", ["A", "θ / rad"]),
        (&driven, "theta' = A/4", ["A", "θ / rad"]),
        (&driven, "theta' - t/100", ["A", "θ′ / (rad/s)"]),
        (&double, "sin(theta1)", ["θ₂ / rad", "θ₂′ / (rad/s)"]),
        (&double, "theta1' = 0", ["θ₁ / rad", "θ₂ / rad"]),
        (&double, "theta1 - theta2", ["θ₁ / rad", "θ₁′ / (rad/s)"]),
        (&lorenz, "x = 1", ["y", "z"]),
    ];
    for (arguments, at, axes) in cases {
        let rest = ["--at", at, "--points", "2", "--skip", "0", "--direction", "any", "--figure", figure];
        answered(&[arguments, &rest].concat());
        let chart: Value = serde_json::from_slice(&std::fs::read(figure).unwrap()).unwrap();
        let panel = &chart["panels"][0];
        assert_eq!([&panel["x"]["label"], &panel["y"]["label"]], axes, "{arguments:?} at {at}");
    }
}

#[cfg(unix)]
#[test]
fn ctrl_c_keeps_a_complete_answer() {
    let endless: [&[&str]; 3] = [
        &["section", "--points", "10000000"],
        &["bifurcation", "--points", "1000", "--over", "omega=0.5:0.7:1e-5", "--skip", "0"],
        &["lyapunov", "--intervals", "100000000"],
    ];
    for arguments in endless {
        let child = Command::new(env!("CARGO_BIN_EXE_libration"))
            .args([arguments, &DRIVEN].concat())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(1500));
        assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(130), "{arguments:?}: {}", message(&output));
        let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert!(answer["complete"] == false || answer["reason"].as_str().unwrap().contains("interrupted"));
    }
}
