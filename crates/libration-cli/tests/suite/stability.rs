//! `libration stability`.

use crate::command::{json, message, run, text};
use serde_json::Value;

const UPRIGHT: &str =
    "stability kapitza --set c=0.1 --map omega=5:10,a=0.1:0.4 --initial theta=180deg --lines 0";

#[test]
fn a_chart_has_its_curves_with_both_parameters() {
    let answer = json(UPRIGHT);
    assert_eq!(answer["parameters"], serde_json::json!(["omega", "a"]));
    let curves = answer["curves"].as_array().unwrap();
    assert_eq!(curves.len(), 1);
    assert_eq!((&curves[0]["kind"], &curves[0]["at_rest"]), (&"branch_point".into(), &true.into()));
    let points = curves[0]["points"].as_array().unwrap();
    // By Hill's matrix in floats of 130 bits.
    for (omega, edge) in [(5.0, 0.2877861746702333933585712), (10.0, 0.142045148229182661499441)] {
        let at = |value: &&Value| value["parameters"][0] == omega;
        let point = points.iter().find(at).unwrap_or_else(|| panic!("nothing at {omega}"));
        let off = point["parameters"][1].as_f64().unwrap() - edge;
        assert!(off.abs() < 1e-13 && point["error"].as_f64().unwrap() < 1e-12, "{point}");
    }
    let [rows, columns] =
        [&answer["rest_stable"], &answer["rest_stable"][0]].map(|list| list.as_array().unwrap().len());
    let [first, second] = [0, 1].map(|axis| answer["grid"][axis].as_array().unwrap().len());
    assert_eq!((rows, columns), (second, first));
    // Above the edge the equilibrium is stable up to the end of the map.
    let ends = answer["rest_stable_at"].as_array().unwrap();
    assert_eq!([&ends[0]["value"], &ends[1]["value"]], [5.0, 10.0]);
    for (end, edge) in ends.iter().zip([0.2877861746702333933585712, 0.142045148229182661499441]) {
        assert_eq!(end["ranges"].as_array().unwrap().len(), 1, "{end}");
        assert!((end["ranges"][0][0].as_f64().unwrap() - edge).abs() < 1e-13 && end["ranges"][0][1] == 0.4);
    }
}

/// On each curve of Mathieu's equation with the damping −c a multiplier is ±1 and the other one ±e^(2πc): the equilibrium is unstable on both
/// sides. An oscillator that is not coupled and loses or gains energy decides in the same way; where its damping d − 0.33 changes its sign on a
/// curve, a part of the curve is a boundary.
#[test]
fn a_curve_between_unstable_regions_is_not_a_stability_boundary() {
    let question = |damping: &str, second: &str| {
        format!("stability x''+{damping}*x'+(d+e*cos(t))*x=0{second} --map d=0.1:0.6,e=0.1:0.4 --lines 0")
    };
    for (damping, second, part) in [
        ("0.05", "", "whole"),
        ("0", "", "whole"),
        ("(-0.05)", "", "none"),
        ("(-1e-6)", "", "none"),
        ("0.05", ";y''+0.01*y'+2*y=0", "whole"),
        ("0.05", ";y''-0.01*y'+2*y=0", "none"),
    ] {
        let answer = json(&question(damping, second));
        let curves = answer["curves"].as_array().unwrap();
        let is_right = curves.iter().all(|curve| curve["stability_boundary"] == part);
        assert!(!curves.is_empty() && is_right, "{damping} {second}");
        let is_stable = |row: &Value| row.as_array().unwrap().contains(&true.into());
        assert_eq!(answer["rest_stable"].as_array().unwrap().iter().any(is_stable), part == "whole");
    }
    let told = text(&question("(-0.05)", ""));
    assert!(told.contains("equilibrium, unstable on both sides: period doubling"), "{told}");

    let mixed = question("0.05", ";y''+(d-0.33)*y'+2*y=0");
    assert!(text(&mixed).contains("equilibrium, in part a stability boundary: period doubling"));
    for curve in json(&mixed)["curves"].as_array().unwrap() {
        let points = curve["points"].as_array().unwrap();
        for point in points.iter().filter(|_| curve["kind"] == "period_doubling") {
            assert_eq!(point["boundary"], point["parameters"][0].as_f64().unwrap() > 0.33, "{point}");
        }
        let count = points.iter().filter(|point| point["boundary"] == true).count();
        let part = if count == 0 { "none" } else { "part" };
        assert!(curve["stability_boundary"] == part && count < points.len(), "{curve}");
    }
}

/// The folds of a driven pendulum are the same next to an oscillator that is not coupled, and those of unstable motions if it gains energy.
#[test]
fn folds_of_unstable_motions_are_named() {
    let folds = |second: &str| {
        let system = format!("x''+0.1*x'+sin(x)=A*cos(w*t);{second}");
        text(&format!("stability {system} --map w=0.85:1,A=0.05:0.2 --lines 1"))
    };
    assert!(folds("y''+0.01*y'+2*y=0").contains("fold of driven motions,"));
    assert!(folds("y''-0.01*y'+2*y=0").contains("fold of unstable driven motions,"));
}

#[test]
fn driven_motions_have_no_stability_at_rest() {
    let answer = json("stability driven_pendulum --set c=0.1 --map omega=0.9:1,A=0.05:0.1 --lines 1");
    assert_eq!(
        (&answer["rest_stable_at"], &answer["rest_stable"]),
        (&serde_json::json!([]), &serde_json::json!([]))
    );
}

#[test]
fn a_chart_is_told_in_words() {
    let told = text(UPRIGHT).split_whitespace().collect::<Vec<_>>().join(" ");
    for part in [
        "stability boundary of the equilibrium: branch point",
        "At omega = 5 the equilibrium is stable for a from 0.287786 to 0.4.",
        "At omega = 10 the equilibrium is stable for a from 0.142045 to 0.4.",
        "Tested at 33 × 33 points of the map, the equilibrium is stable at some of them and unstable at others;",
    ] {
        assert!(told.contains(part), "{part} in {told}");
    }
    let cusp = text("stability driven_pendulum --set c=0.1 --map omega=0.85:1,A=0.05:0.2 --lines 1");
    let told = cusp.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(told.contains("through a cusp at omega = 0.91477, A = 0.101459"), "{told}");
    let csv = text("stability driven_pendulum --set c=0.1 --map omega=0.85:1,A=0.05:0.2 --lines 1 --csv");
    assert!(csv.lines().any(|line| line.starts_with("1,cusp,false,0.9147700617")), "{csv}");
}

#[test]
fn what_cannot_be_is_refused_with_what_would_do() {
    let cases: [(&[&str], i32, &[&str]); 5] = [
        (&["stability", "pendulum", "--map", "omega0=1:2,omega0=1:2"], 2, &["--map", "twice"]),
        (&["stability", "kapitza", "--map", "omega=1:2"], 2, &["--map", "two parameters"]),
        (&["stability", "kapitza", "--map", "omega=1:1,a=0:1"], 2, &["--map", "no width"]),
        (&["stability", "kapitza", "--map", "omega=1:2,a=0:1", "--lines", "-1"], 2, &["--lines"]),
        (&["stability", "x''=-k*x-m*x'", "--map", "k=1:2,m=0:1"], 1, &["no drive"]),
    ];
    for (arguments, status, parts) in cases {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {}", message(&output));
        for part in parts {
            assert!(message(&output).contains(part), "{arguments:?}: {}", message(&output));
        }
    }
}
