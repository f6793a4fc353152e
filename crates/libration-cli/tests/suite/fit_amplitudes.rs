//! `libration fit amplitudes`.

use crate::command::{directory, json, libration, message, text};
use serde_json::Value;

fn example() -> String {
    format!("{}/../../examples/amplitudes_synthetic.csv", env!("CARGO_MANIFEST_DIR"))
}

fn file(name: &str, text: &str) -> String {
    let path = directory(name).join("file.csv");
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

/// The distance of a value from the true one, in units of its uncertainty.
fn pull(answer: &Value, name: &str, truth: f64) -> f64 {
    let uncertainty = format!("{name}_uncertainty");
    (answer[name].as_f64().unwrap() - truth).abs() / answer[&uncertainty].as_f64().unwrap()
}

#[test]
fn the_example_of_amplitudes_gives_its_truth_back() {
    let answer = json(&format!("fit amplitudes {}", example()));
    assert_eq!(
        (&answer["rows"], &answer["sides"], &answer["against"]),
        (&30.into(), &"both".into(), &"time".into())
    );
    assert_eq!(answer["law"], "linear+quadratic");
    let [linear, quadratic] = [0, 1].map(|index| &answer["coefficients"][index]);
    assert!(pull(linear, "coefficient", 0.012) < 3.0 && linear["unit"] == "1/s", "{linear}");
    assert!(pull(quadratic, "coefficient", 0.015) < 3.0 && quadratic["unit"] == "1/rad", "{quadratic}");
    assert!(pull(&answer, "zero", 0.8_f64.to_radians()) < 3.0);
    let omega0 = [&answer["omega0_rad_per_s"], &answer["omega0_uncertainty_rad_per_s"]]
        .map(|value| value.as_f64().unwrap());
    assert!((omega0[0] - 4.43).abs() < 3.0 * omega0[1], "{omega0:?}");
    assert!(answer["log_decrement"].is_null() && answer["quality_amplitude"].as_f64().unwrap() > 0.6);
    assert!(answer["told_from_file"].to_string().contains("turning points of both sides (--sides one"));
    let sheet = text(&format!("fit amplitudes {}", example()));
    assert!(sheet.contains("2πE/ΔE at 4") && sheet.contains("reading at the equilibrium"), "{sheet}");
}

/// A = 12 cm·exp(−0.02 t), read every five swings of 1.25 s.
fn exponential(header: &str, position: impl Fn(f64) -> f64) -> String {
    let row = |k: u32| {
        let swings = 5.0 * f64::from(k);
        format!("{},{:.6}\n", position(swings), 12.0 * (-0.02 * 1.25 * swings).exp())
    };
    format!("{header}\n{}", (0..9).map(row).collect::<String>())
}

#[test]
fn what_is_missing_for_q_is_named() {
    let times = file("amplitudes-times", &exponential("t (s),A (cm)", |swings| 1.25 * swings));
    let answer = json(&format!("fit amplitudes {times}"));
    assert!(answer["quality"].is_null() && answer["note"].as_str().unwrap().contains("--period"), "{answer}");
    assert!((answer["decay_time_s"].as_f64().unwrap() - 50.0).abs() < 1e-3);
    assert!((answer["coefficients"][0]["coefficient"].as_f64().unwrap() - 0.04).abs() < 1e-6);
    // ω0² = (2π/T)² + γ².
    let truth = (std::f64::consts::TAU / 1.25).hypot(0.02) / 0.04;
    let with_period = json(&format!("fit amplitudes {times} --period 1.25s"));
    assert!((with_period["quality"].as_f64().unwrap() - truth).abs() < 1e-3, "{with_period}");
    assert!((with_period["log_decrement"].as_f64().unwrap() - 0.025).abs() < 1e-6);
    let swings = file("amplitudes-swings", &exponential("n,A (cm)", |swings| swings));
    let counted = json(&format!("fit amplitudes {swings}"));
    assert!((counted["quality"].as_f64().unwrap() - truth).abs() < 1e-3, "{counted}");
    assert!(
        (counted["decay_swings"].as_f64().unwrap() - 40.0).abs() < 1e-3 && counted["decay_time_s"].is_null()
    );
    let sheet = text(&format!("fit amplitudes {times}"));
    assert!(sheet.contains("not known: the period"), "{sheet}");
}

#[test]
fn a_table_without_a_header_asks_for_the_quantity_of_its_first_column() {
    let rows = exponential("", |swings| swings);
    let bare = file("amplitudes-bare", rows.trim_start());
    let refused = message(&libration(&format!("fit amplitudes {bare}")));
    assert!(refused.contains("--against"), "{refused}");
    let read = json(&format!("fit amplitudes {bare} --against swings --amplitude-unit cm"));
    assert!((read["first_amplitude"].as_f64().unwrap() - 0.12).abs() < 1e-6, "{read}");
    let angles = message(&libration(&format!("fit amplitudes {bare} --against swings")));
    assert!(angles.contains("--amplitude-unit") && angles.contains("up to 12, have no unit"), "{angles}");
}

#[test]
fn columns_are_found_by_their_names_in_any_order() {
    let rows: String = (0..10)
        .map(|k| format!("{k},{:.4},1.6,{:.3}\n", 20.0 * (-0.05 * f64::from(k)).exp(), 1.6 * f64::from(k)))
        .collect();
    let table = file("amplitudes-names", &format!("n,Amplitude (deg),T (s),t (s)\n{rows}"));
    let answer = json(&format!("fit amplitudes {table}"));
    let told = answer["told_from_file"].to_string();
    for role in ["position: column 4", "amplitude: column 2", "swing-number: column 1", "period: column 3"] {
        assert!(told.contains(role), "{told}");
    }
    assert!((answer["first_amplitude"].as_f64().unwrap() - 20.0_f64.to_radians()).abs() < 1e-3);
}

#[test]
fn a_refuted_law_is_the_first_line() {
    let sheet = text(&format!("fit amplitudes {} --model dry", example()));
    assert!(sheet.starts_with("warning: the rows refute dry damping"), "{sheet}");
}

#[test]
fn the_amplitudes_are_drawn() {
    let picture = directory("amplitudes-drawn").join("amplitudes.svg");
    text(&format!("fit amplitudes {} --figure {}", example(), picture.display()));
    let svg = std::fs::read_to_string(picture).unwrap();
    assert!(svg.contains("amplitude A / degrees") && svg.contains("residual / degrees"));
}

#[test]
fn uncertainties_in_per_cent_are_those_of_the_sizes_of_turning_points() {
    let of = |name: &str, head: &str, uncertainty: fn(f64) -> f64| {
        let size = |n: i32| (0..n).fold(10.0, |size, _| -0.98 * size);
        let line = |n: i32| format!("{n},{:.9},{:.9}\n", size(n), uncertainty(size(n)));
        let lines: String = (0..12).map(line).collect();
        let file = file(name, &format!("t (s),x (cm),{head}\n{lines}"));
        let answer = json(&format!("fit amplitudes {file} --period 2s --sides both"));
        answer["quality_uncertainty"].as_f64().unwrap()
    };
    let relative = of("amplitudes-per-cent", "u(x) (%)", |_| 2.0);
    let absolute = of("amplitudes-absolute", "u(x) (cm)", |x| 0.02 * x.abs());
    assert!((relative / absolute - 1.0).abs() < 1e-6, "{relative} {absolute}");
}

#[test]
fn rows_outside_a_range_of_times_are_ignored() {
    // After 32 s the pendulum was touched.
    let table = exponential("t (s),A (cm)", |swings| 1.25 * swings);
    let rows = table.lines().take(7).chain(["37.5,3.1", "43.75,2.9"]);
    let path = file("amplitudes-range", &rows.map(|row| format!("{row}\n")).collect::<String>());
    let decay = |options: &str| {
        json(&format!("fit amplitudes {path} --model linear{options}"))["decay_time_s"].as_f64().unwrap()
    };
    assert!((decay("") - 50.0).abs() > 1.0);
    assert!((decay(" --to 32") - 50.0).abs() < 1e-3);
    let answer = json(&format!("fit amplitudes {path} --from 6.25s --to 31.25s"));
    assert!(
        (answer["decay_time_s"].as_f64().unwrap() - 50.0).abs() < 1e-3 && answer["rows"] == 5,
        "{answer}"
    );
    assert!(answer["told_from_file"].to_string().contains("3 rows are ignored (--from, --to)"), "{answer}");
    let nothing = message(&libration(&format!("fit amplitudes {path} --from 100")));
    assert!(
        nothing.contains("no row is in this range (--from, --to): those of the file are from 0.0 to 43.75"),
        "{nothing}"
    );
}
