//! `libration decay`.

use crate::command::{close, directory, json, libration, message, text, unfolded};

#[test]
fn the_three_laws_stand_beside_each_other() {
    // Turning points in 30 digits, averages with exact cycle integrals, A₀/(1 + 4cA₀t/3π).
    let answer = json("decay 1rad --quadratic 0.1 --omega0 1rad/s --cycles 4");
    let turns = answer["turning_points"].as_array().unwrap();
    assert_eq!(turns.len(), 9);
    let last = &turns[8];
    close(&last["cycle"], 4.0, 0.0);
    close(&last["time_s"], 25.9258226061544378696740806107, 1e-14);
    close(&last["amplitude_rad"], 0.475469880638686519348707158378, 1e-14);
    close(&last["averaged_rad"], 0.475444, 1e-6);
    let time = last["time_s"].as_f64().unwrap();
    close(&last["small_amplitude_rad"], 1.0 / (1.0 + 0.4 * time / (3.0 * std::f64::consts::PI)), 1e-14);
    close(
        &last["duration_of_the_cycle_s"],
        25.9258226061544378696740806107 - 19.5360787806192168477136780303,
        1e-13,
    );
    assert!(turns[7]["duration_of_the_cycle_s"].is_null());
    assert_eq!(answer["damping"][0]["exponent"], 2.0);
    assert!(answer["ending"].is_null());
}

/// ω0/c of linear damping; for small swings 3π/(8cA) of quadratic and πω0²A/(4d) of dry damping, to which powers of A² add.
#[test]
fn the_quality_factor_is_that_of_the_damping() {
    let linear = json("decay 120deg --linear 0.1 --omega0 3 --cycles 1");
    close(&linear["quality"], 30.0, 1e-14);
    let pi = std::f64::consts::PI;
    let quadratic = json("decay 0.01 --quadratic 0.1 --omega0 3 --cycles 1");
    close(&quadratic["quality"], 3.0 * pi / (8.0 * 0.1 * 0.01), 0.01);
    let dry = json("decay 0.01 --dry 0.001 --omega0 3 --cycles 2");
    close(&dry["quality"], pi * 9.0 * 0.01 / (4.0 * 0.001), 0.001);
    // A fall of the amplitude with that of the energy: ∝ A.
    let turns = dry["turning_points"].as_array().unwrap();
    let [first, last] = [&turns[0], &turns[4]]
        .map(|row| row["quality"].as_f64().unwrap() / row["amplitude_rad"].as_f64().unwrap());
    assert!((last / first - 1.0).abs() < 1e-4, "{first} {last}");
    let sheet = text("decay 60deg --quadratic 0.1");
    assert!(sheet.contains("2πE/ΔE at the first amplitude"), "{sheet}");
}

/// The law of a linear spring is A₀·e^(−ct/2), to which powers of A are added;
/// the phase and the cycles agree with the integration within the stated errors.
#[test]
fn the_slow_flow_stands_beside_the_integration_with_its_errors() {
    let question = "decay 30deg --linear 0.1 --omega0 1 --cycles 3 --order 7 --damping-order 4";
    let answer = json(question);
    assert_eq!([&answer["slow_flow_order"], &answer["slow_flow_damping_order"]], [7, 4]);
    let turns = answer["turning_points"].as_array().unwrap();
    let mut largest = [0.0_f64; 2];
    for (turn, number) in turns.iter().zip(0_u32..) {
        let value = |name: &str| turn[name].as_f64().unwrap();
        let [amplitude, phase] = [value("slow_flow_error_rad"), value("slow_flow_phase_error_rad")];
        close(&turn["slow_flow_rad"], value("amplitude_rad") + amplitude, 1e-15);
        close(&turn["slow_flow_phase_rad"], std::f64::consts::PI * f64::from(number) + phase, 1e-14);
        largest = [largest[0].max(amplitude.abs()), largest[1].max(phase.abs())];
        if number > 0 && number.is_multiple_of(2) {
            let cycle = value("duration_of_the_cycle_s") + value("slow_flow_duration_error_s");
            close(&turn["slow_flow_duration_s"], cycle, 1e-14);
            assert!(value("slow_flow_duration_error_s").abs() < 2e-6, "{turn}");
        } else {
            assert!(turn["slow_flow_duration_s"].is_null());
        }
    }
    close(&answer["largest_error_slow_flow_rad"], largest[0], 1e-15);
    close(&answer["largest_phase_error_slow_flow_rad"], largest[1], 1e-15);
    // A⁸ of 30° over π is 6e-7, and c⁵ 1e-5 of A.
    assert!(largest.iter().all(|error| (1e-12..2e-6).contains(error)), "{largest:?}");
    let shown = text(question);
    assert!(shown.contains("slow flow") && shown.contains("4 of the damping"), "{shown}");
    assert!(json("decay 30deg --linear 0.1")["slow_flow_order"].is_null());
}

#[test]
fn a_slow_flow_that_is_not_known_is_refused() {
    for (question, status, reason) in [
        ("decay 30deg --power 1.5:0.1 --order 3", 2, "whole powers of the velocity"),
        ("decay 30deg --linear 0.1 --order 61", 2, "--order"),
        ("decay 30deg --linear 0.1 --damping-order 3", 2, "--order"),
    ] {
        let refused = libration(question);
        assert_eq!(refused.status.code(), Some(status), "{question}");
        assert!(message(&refused).contains(reason), "{}", message(&refused));
    }
}

#[test]
fn dry_friction_ends_it() {
    let answer = json("decay 1rad --dry 0.05 --omega0 1 --cycles 1000");
    assert_eq!(answer["ending"], "sticks");
    close(&answer["sticking_amplitude_rad"], 0.05_f64.asin(), 1e-15);
    let turns = answer["turning_points"].as_array().unwrap();
    assert_eq!(turns.len(), 10);
    close(&turns[9]["amplitude_rad"], 0.0457993352786800781089756367415, 1e-13);
    assert!(text("decay 1rad --dry 0.05 --omega0 1").contains("stopped by dry friction after 28.905941 s"));
    // By SciPy's DOP853 with an event: at rest after 30.43257 s at 0.0020132 rad = 0.11535°.
    let question = "decay 90deg --dry 0.2 --linear 0.02";
    let sheet = unfolded(&text(question));
    assert!(sheet.contains("on its way down, after 30.43256") && sheet.contains("0.1153"), "{sheet}");
    let answer = json(question);
    assert_eq!(answer["ending"], "sticks");
    assert!((answer["rest_angle_rad"].as_f64().unwrap() - 0.002_013_2).abs() < 1e-7, "{answer}");
    assert!(text("decay 0.3 --dry 0.2 --omega0 1").contains("on its way down, after 3.1758"));
}

#[test]
fn seconds_come_from_length_and_gravity() {
    let here = json("decay 40deg --linear 0.1 --power 1.5:0.05 --length 25cm --gravity 9.81 --until 10s");
    let turns = here["turning_points"].as_array().unwrap();
    let last = turns.last().unwrap()["time_s"].as_f64().unwrap();
    assert!(last <= 10.0 && last > 9.0, "{last}");
    close(&here["omega0_rad_per_s"], (9.81_f64 / 0.25).sqrt(), 1e-15);
    close(&here["length_m"], 0.25, 0.0);
}

#[test]
fn the_table_has_a_row_for_each_cycle() {
    let table = text("decay 60deg --linear 0.1 --cycles 3");
    assert!(table.contains("θ″ + 0.1 θ′ + ω0² sin θ = 0"), "{table}");
    assert_eq!(table.lines().filter(|line| line.trim_start().starts_with(char::is_numeric)).count(), 4);
    let csv = text("decay 60deg --linear 0.1 --cycles 3 --csv");
    assert_eq!(csv.lines().count(), 8);
    assert!(csv.lines().all(|line| line.matches(',').count() == 7), "{csv}");
}

#[test]
fn the_picture_shows_all_laws_and_the_period() {
    let path = directory("decay").join("decay.svg");
    text(&format!("decay 90deg --dry 0.2 --linear 0.02 --figure {}", path.display()));
    let svg = std::fs::read_to_string(path).unwrap();
    for label in ["averaged", "law of small amplitudes", "turning points", "period / s", "time t / s"] {
        assert!(svg.contains(label), "{label}");
    }
}

#[test]
fn what_does_not_swing_is_said() {
    let cases: [(&str, i32, &[&str]); 9] = [
        ("decay 40deg", 2, &["--linear", "libration motion"]),
        ("decay 40deg --linear -1", 2, &["--linear", "above zero"]),
        ("decay 40deg --power 1.5", 2, &["--power", "1.5:0.1"]),
        ("decay 40deg --power -1:0.1", 2, &["--power", "zero or more"]),
        ("decay 40deg --linear 0.1 --omega0 1 --length 1m", 2, &["--omega0", "cannot be used with"]),
        ("decay 180deg --linear 0.1", 1, &["decay", "below pi"]),
        ("decay 2deg --dry 1", 1, &["dry friction", "5.85"]),
        ("decay 20deg --linear 20", 1, &["too strong"]),
        ("decay 20deg --linear 1 --until -1s", 2, &["--until", "above zero"]),
    ];
    for (arguments, status, parts) in cases {
        let output = libration(arguments);
        let message = message(&output);
        assert_eq!(output.status.code(), Some(status), "{arguments}: {message}");
        assert!(parts.iter().all(|part| message.contains(part)), "{arguments}: {message}");
    }
}
