//! `libration motion` and `libration fourier`.

use crate::command::{close, json, text};

#[test]
fn every_field_of_the_contract_is_there() {
    let answer = json("motion 150deg --times 0:1:0.5");
    assert_eq!(answer["regime"], "libration");
    close(&answer["period_s"], 1.7622037295 * 2.0064092926, 1e-9);
    // sin² 75°
    close(&answer["energy_ratio"], 0.9330127018922193, 1e-15);
    let samples = answer["samples"].as_array().unwrap();
    assert_eq!(samples.len(), 3);
    assert_eq!(samples[1]["time_s"], 0.5);
    for field in ["angle_rad", "turns", "angle_in_turn_rad", "complement_rad", "velocity_rad_per_s"] {
        assert!(samples[1][field].is_number(), "{field}");
    }
}

#[test]
fn a_fast_start_is_a_rotation_that_counts_its_turns() {
    let answer = json("motion 0 --velocity 7rad/s --times 0,10");
    assert_eq!(answer["regime"], "rotation");
    let last = &answer["samples"][1];
    let unwrapped =
        last["turns"].as_f64().unwrap() * std::f64::consts::TAU + last["angle_in_turn_rad"].as_f64().unwrap();
    close(&last["angle_rad"], unwrapped, 1e-14);
    assert!(last["turns"].as_i64().unwrap() >= 7);
}

#[test]
fn an_infinite_period_is_null_with_a_note() {
    let answer = json("motion 0 --velocity 2rad/s --length 1m --gravity 1 --times 0,1");
    assert_eq!(answer["regime"], "separatrix");
    assert!(answer["period_s"].is_null());
    assert!(answer["note"].as_str().unwrap().contains("period_s is infinite"));
}

#[test]
fn approximate_motions_stand_beside_the_exact_one() {
    let answer = json("motion 60deg --times 0.7 --compare small-angle,fourier-3,fourier-5,fourier-7");
    let sample = &answer["samples"][0];
    let exact = sample["angle_rad"].as_f64().unwrap();
    let approximations = sample["approximations"].as_array().unwrap();
    assert_eq!(approximations[0]["key"], "small-angle");
    let errors: Vec<f64> = approximations.iter().map(|a| a["error_rad"].as_f64().unwrap().abs()).collect();
    assert!(errors.is_sorted_by(|a, b| a > b), "{errors:?}");
    close(&approximations[3]["angle_rad"], exact, 1e-3);
    let table = text("motion 60deg --compare fourier-3 --times 0,1 --csv");
    assert!(table.lines().next().unwrap().ends_with("fourier-3_angle_rad,fourier-3_error_rad"));
}

#[test]
fn without_times_one_period_is_shown() {
    let answer = json("motion 90deg");
    let samples = answer["samples"].as_array().unwrap();
    assert_eq!(samples.len(), 25);
    close(&samples[24]["angle_rad"], std::f64::consts::FRAC_PI_2, 1e-13);
}

#[test]
fn harmonics_follow_the_nome() {
    let answer = json("fourier 90deg --harmonics 3");
    assert_eq!(answer["regime"], "libration");
    assert_eq!(answer["mean_velocity_rad_per_s"], 0.0);
    let q = (-std::f64::consts::PI).exp();
    for (index, term) in answer["harmonics"].as_array().unwrap().iter().enumerate() {
        let n = [1.0, 3.0, 5.0][index];
        let sign = [1.0, -1.0, 1.0][index];
        close(&term["n"], n, 0.0);
        close(&term["angle_rad"], sign * 8.0 * q.powf(n / 2.0) / (n * (1.0 + q.powf(n))), 1e-14);
        assert!(term["velocity_rad_per_s"].is_number());
    }
}

#[test]
fn the_angle_is_the_sum_of_its_harmonics_at_the_start() {
    let answer = json("fourier 150deg --tolerance 1e-17");
    let terms = answer["harmonics"].as_array().unwrap().clone();
    let sum: f64 = terms.iter().map(|term| term["angle_rad"].as_f64().unwrap()).sum();
    assert!((sum - 150f64.to_radians()).abs() < 1e-14);
}
