//! Equations of first order, alone and together with second-order ones.

use crate::command::{message, run};
use serde_json::Value;

const LORENZ: &str = "x' = 10*(y - x); y' = x*(28 - z) - y; z' = x*y - 8/3*z";
const FROM: [&str; 2] = ["--initial", "x=1,y=1,z=1"];

fn json(arguments: &[&str]) -> Value {
    let output = run(&[arguments, &["--json"]].concat());
    assert!(output.status.success(), "{arguments:?}: {}", message(&output));
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn a_state_has_velocities_of_accelerated_coordinates_only() {
    let thermostat =
        json(&["simulate", "x'' = -x - z*x'; z' = x'^2 - 1", "--initial", "x=1", "--times", "5"]);
    assert_eq!(thermostat["state"], serde_json::json!(["x", "z", "x'"]));
    assert_eq!(thermostat["samples"][0]["state"].as_array().unwrap().len(), 3);
    let lorenz = json(&[&["simulate", LORENZ, "--times", "5", "--events", "turning"], &FROM[..]].concat());
    assert_eq!(lorenz["state"], serde_json::json!(["x", "y", "z"]));
    // From reference/first_order.py.
    let state: Vec<f64> =
        lorenz["samples"][0]["state"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    let exact = [-6.512113699419599, -6.974042788417076, 23.924129572103375];
    assert!(state.iter().zip(exact).all(|(got, truth)| (got - truth).abs() < 1e-9), "{state:?}");
    let events = lorenz["events"].as_array().unwrap();
    let turns = events.iter().filter(|event| event["kind"] == "turning of x");
    for event in turns {
        let [x, y] = [0, 1].map(|n| event["state"][n].as_f64().unwrap());
        assert!((x - y).abs() < 1e-12, "{event}");
    }
}

#[test]
fn freely_written_rates_are_read() {
    for text in ["dx/dt = -x", "\\dot{x} = -x", "x'(t) = -x(t)", "2x' + 2x = 0"] {
        let answer = json(&["simulate", text, "--initial", "x=1", "--times", "1"]);
        let end = answer["samples"][0]["state"][0].as_f64().unwrap();
        assert!((end - 0.36787944117144233).abs() < 1e-12, "{text}: {end}");
    }
}

#[test]
fn sections_diagrams_and_exponents_take_them() {
    let arguments = ["section", LORENZ, "--at", "z'", "--direction", "falling", "--points", "3"];
    let section = json(&[&arguments[..], &FROM].concat());
    let points = section["motions"][0]["points"].as_array().or_else(|| section["points"].as_array());
    assert_eq!(points.unwrap().len(), 3, "{section}");
    let family = "x' = 10*(y - x); y' = x*(r - z) - y; z' = x*y - 8/3*z";
    let diagram = |over| {
        [&["bifurcation", family, "--over", over, "--at", "z - 27", "--points", "2"], &FROM[..]].concat()
    };
    // At 20 the motion crosses the surface once before it comes to rest: not a point of the diagram.
    let points = json(&diagram("r=20:28:8"))["points"].clone();
    assert_eq!(points.as_array().unwrap().len(), 2, "{points}");
    assert!(points.as_array().unwrap().iter().all(|point| point["value"] == 28.0), "{points}");
    // Where there is nothing to draw no file is written.
    let picture = std::env::temp_dir().join(format!("libration-no-points-{}.svg", std::process::id()));
    let nothing = run(&[&diagram("r=20:22:1")[..], &["--figure", picture.to_str().unwrap()]].concat());
    assert!(!picture.exists() && nothing.stdout.is_empty());
    assert_eq!(nothing.status.code(), Some(1));
    assert!(
        String::from_utf8_lossy(&nothing.stderr).contains("no longer crosses the surface"),
        "{nothing:?}"
    );
    // The value is 0.9056 over long times; over 300 intervals of 0.4 s the exponents of different motions scatter by 0.03.
    let arguments = [&["lyapunov", LORENZ, "--intervals", "300"], &FROM[..]].concat();
    assert!((json(&arguments)["exponent_per_s"].as_f64().unwrap() - 0.9056).abs() < 0.2);
    let square =
        json(&["lyapunov", "x' = x - x*y; y' = x*y - y", "--initial", "x=2,y=1", "--intervals", "10"]);
    assert_eq!(square["verdict"], "regular", "{square}");
}

#[test]
fn what_needs_an_acceleration_refuses_them() {
    for arguments in [
        &["expand", "x' = -x"][..],
        &["backbone", "x' = -x", "--amplitudes", "1"],
        &["modes", "x'' = -x; q' = x"],
        &["derive", "--method", "averaging", "x' = -e*x"],
        &["derive", "--method", "limit-cycle", "x' = -e*x"],
        &["derive", "--method", "perturbation", "x' = -x^3"],
        &["figure", "series", "x' = -x"],
    ] {
        let output = run(arguments);
        assert!(matches!(output.status.code(), Some(1 | 2)), "{arguments:?}");
        let told = message(&output);
        assert!(
            told.contains("' is of the first order") || arguments[0] == "figure",
            "{arguments:?}: {told}"
        );
        assert!(!told.contains("panicked"), "{told}");
    }
}

#[test]
fn equations_that_do_not_fit_together_are_named() {
    for (text, part) in [
        ("x'' = -x; x' = y", "x has one for x'' already"),
        ("x' = y'; y' = x", "solve for each of them, as in x' = …; y' = …"),
        ("x' = 1; x' = 2", "two equations for x'"),
        ("x = 1", "has no derivative"),
    ] {
        let output = run(&["simulate", text, "--initial", "x=0", "--times", "1"]);
        assert_eq!(output.status.code(), Some(2));
        assert!(message(&output).contains(part), "{text}: {}", message(&output));
    }
}

#[test]
fn chains_are_written_with_an_index() {
    let plain = json(&[
        "simulate",
        "x1'' = x2 - 2*x1; x2'' = x3 - 2*x2 + x1; x3'' = -2*x3 + x2",
        "--initial",
        "x1=1,x2=4,x3=9,x1'=0.5,x2'=1,x3'=1.5",
        "--times",
        "5",
    ]);
    let indexed = json(&[
        "simulate",
        "x[i]'' = x[i+1] - 2*x[i] + x[i-1], i = 1..3",
        "--initial",
        "x[i]=i^2,x[i]'=i/2",
        "--times",
        "5",
    ]);
    assert_eq!(plain["samples"], indexed["samples"]);
    assert_eq!(plain["state"], indexed["state"]);
    let one = json(&[
        "simulate",
        "fput",
        "--set",
        "n=3,alpha=0",
        "--initial",
        "x[2]=1",
        "--times",
        "5",
        "--events",
        "x[2]",
    ]);
    assert_eq!(one["state"], plain["state"]);
    assert!(one["events"][0]["kind"].as_str().unwrap().contains("x2"), "{}", one["events"][0]);
    for (initial, part) in [
        ("y[i]=1", "no state variables y[i]"),
        ("x[i]=1/(i-2)", "has no value at i = 2"),
        ("x[i]=1,x2=3", "x2 is given twice"),
        ("x[i]=q", "has no value at i = 1"),
    ] {
        let output = run(&["simulate", "fput", "--set", "n=3", "--initial", initial, "--times", "1"]);
        assert_eq!(output.status.code(), Some(2));
        assert!(message(&output).contains(part), "{initial}: {}", message(&output));
    }
    let output = run(&["simulate", "fput", "--set", "n=2.5", "--initial", "x1=1", "--times", "1"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(message(&output).contains("n = 2.5 is not a number of bodies"), "{}", message(&output));
}

#[test]
fn the_drift_of_a_chain_is_by_the_work_of_its_springs() {
    let chain =
        json(&["simulate", "fput", "--set", "n=8,beta=1", "--initial", "x[i]=sin(pi*i/9)", "--times", "50"]);
    assert!(chain["energy_drift"].as_f64().unwrap() < 1e-11, "{chain}");
    for counted in ["backbone", "expand"] {
        let mut arguments = vec![counted, "fermi_pasta_ulam"];
        arguments.extend(if counted == "backbone" { &["--amplitudes", "1"][..] } else { &[] });
        assert!(!run(&arguments).status.success(), "{counted}");
    }
}
