//! `libration plan`.

use crate::command::{close, json, libration, message, text};

const USUAL: &str = "plan --g-to 1e-3 --length 1.0000(5)m --angle-noise 0.2deg --rate 60";

/// u(g)/g = 2·√24·σ/(A·√N·ω0·T) for small undamped swings with a known amplitude: Rife and Boorstyn.
#[test]
fn small_swings_are_planned_by_the_bound_for_a_sinusoid() {
    let answer =
        json(&format!("{USUAL} --amplitudes 1deg --g-to 6e-4 --angle-scale 0").replace("--g-to 1e-3 ", ""));
    let choice = &answer["choices"][0];
    let [swings, duration] = ["swings", "duration_s"].map(|name| choice[name].as_f64().unwrap());
    let amplitude = 1.0_f64.to_radians();
    close(&choice["duration_s"], swings * 2.006409 * (1.0 + amplitude * amplitude / 16.0), 1e-6);
    let phase = 3.1315571 * duration;
    let noise = 2.0 * 24.0_f64.sqrt() * 0.2 / (60.0 * duration).sqrt() / phase;
    close(&choice["noise"], noise, 1e-3);
    close(&choice["total"], noise.hypot(5e-4), 1e-3);
    assert!(choice["total"].as_f64().unwrap() <= 6e-4 && choice["is_best"] == true);
}

#[test]
fn the_best_has_the_fewest_swings_and_a_scale_that_is_too_wrong_none() {
    let answer = json(USUAL);
    let choices = answer["choices"].as_array().unwrap();
    let swings: Vec<Option<u64>> = choices.iter().map(|choice| choice["swings"].as_u64()).collect();
    assert_eq!(answer["swings"].as_u64(), swings.iter().flatten().min().copied());
    assert!(swings.last().unwrap().is_none() && choices.last().unwrap()["duration_s"].is_null());
    assert!(
        choices.iter().all(|choice| choice["swings"].is_null() || choice["total"].as_f64().unwrap() <= 1e-3)
    );
    let exact = json(&format!("{USUAL} --angle-scale 0"));
    assert!(exact["choices"].as_array().unwrap().iter().all(|choice| choice["swings"].is_u64()));
}

#[test]
fn a_length_that_is_known_too_badly_is_said_with_what_would_do() {
    let answer = json("plan --g-to 0.1% --length 1.00(1)m --angle-noise 0.2deg --rate 60");
    close(&answer["length_uncertainty_needed_m"], 1e-3 / 2.0_f64.sqrt(), 1e-12);
    assert!(answer["advice"][0].as_str().unwrap().contains("measure the length to 0.71 mm"), "{answer:#}");
    assert!(json(USUAL)["length_uncertainty_needed_m"].is_null());
    assert!(text(USUAL).contains("release at"));
}

#[test]
fn what_cannot_be_planned_is_refused() {
    for (change, reason) in [
        ("--angle-noise 0.2deg", "--angle-noise 0"),
        ("--rate 60", "--rate 1"),
        ("--g-to 1e-3", "--g-to 1e-3 --clock 1%"),
        ("--g-to 1e-3", "--g-to 0"),
        ("--rate 60", "--rate 60 --amplitudes 200deg"),
        ("--rate 60", "--rate -60"),
    ] {
        let output = libration(&USUAL.replace(change, reason));
        assert!(matches!(output.status.code(), Some(1 | 2)), "{reason}");
        assert!(
            message(&output).starts_with("error: ") && output.stdout.is_empty(),
            "{reason}: {}",
            message(&output)
        );
    }
}
