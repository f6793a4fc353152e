//! `libration motion` and `libration fourier`.

use crate::command::{close, directory, json, message, run, text};

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
fn the_state_after_an_eighth_of_a_swing_of_a_right_angle_is_known() {
    // For k² = 1/2 an eighth of the period is half a quarter period: from the turning point sin(θ/2) = k cd(K/2), and cd²(K/2) = 1/(1 + k′) by
    // the formulas for half the quarter period (DLMF 22.5), so that sin²(θ/2) = 1/(2 + √2).
    let omega0 = 9.80665_f64.sqrt();
    let period = 4.0 * 1.854_074_677_301_371_9 / omega0;
    let answer = json(&format!("motion 90deg --times {:?},{:?}", period / 8.0, period * 9.0 / 8.0));
    close(&answer["length_m"], 1.0, 0.0);
    close(&answer["gravity_m_per_s2"], 9.80665, 0.0);
    close(&answer["period_s"], period, 1e-15);
    close(&answer["amplitude_rad"], std::f64::consts::FRAC_PI_2, 1e-15);
    close(&answer["energy_ratio"], 0.5, 1e-15);
    let half = (2.0 + std::f64::consts::SQRT_2).recip();
    let angle = 2.0 * half.sqrt().asin();
    // θ′²/4ω0² = k² − sin²(θ/2), on the way down.
    let velocity = -2.0 * omega0 * (0.5 - half).sqrt();
    for sample in answer["samples"].as_array().unwrap() {
        close(&sample["angle_rad"], angle, 1e-14);
        close(&sample["angle_in_turn_rad"], angle, 1e-14);
        close(&sample["complement_rad"], std::f64::consts::PI - angle, 1e-14);
        close(&sample["velocity_rad_per_s"], velocity, 1e-14);
        assert_eq!(sample["turns"], 0);
    }
}

#[test]
fn the_state_on_the_separatrix_is_known() {
    // From the bottom with θ′ = 2ω0, and ω0 = 1: θ = 4 atan tanh(t/2) = gd-angle, θ′ = 2/cosh t.
    let answer = json("motion 0 --velocity 2rad/s --length 1m --gravity 1 --times 0.5,3");
    for sample in answer["samples"].as_array().unwrap() {
        let time = sample["time_s"].as_f64().unwrap();
        let angle = 4.0 * (0.5 * time).tanh().atan();
        close(&sample["angle_rad"], angle, 1e-14);
        close(&sample["angle_in_turn_rad"], angle, 1e-14);
        close(&sample["velocity_rad_per_s"], 2.0 / time.cosh(), 1e-14);
        // π − θ = 4 atan e^(−t) is free of cancellation.
        close(&sample["complement_rad"], 4.0 * (-time).exp().atan(), 1e-14);
    }
}

#[test]
fn a_rotation_comes_back_after_its_turn_one_turn_further() {
    let period = json("motion 0 --velocity 7rad/s --times 0")["period_s"].as_f64().unwrap();
    let answer = json(&format!("motion 0 --velocity 7rad/s --times {period:?},{:?}", 2.0 * period));
    // k² = (θ′/2ω0)² is above 1, and the time of a turn is 2K(1/k²)/(k ω0), by the arithmetic-geometric mean.
    let omega0 = 9.80665_f64.sqrt();
    let energy = (3.5 / omega0).powi(2);
    let (mut a, mut b) = (1.0, (1.0 - 1.0 / energy).sqrt());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    close(&answer["period_s"], std::f64::consts::PI / (a * energy.sqrt() * omega0), 1e-14);
    close(&answer["energy_ratio"], energy, 1e-14);
    for (turn, sample) in (1..).zip(answer["samples"].as_array().unwrap()) {
        close(&sample["angle_rad"], f64::from(turn) * std::f64::consts::TAU, 1e-14);
        close(&sample["velocity_rad_per_s"], 7.0, 1e-13);
        assert!(sample["angle_in_turn_rad"].as_f64().unwrap().abs() < 1e-13);
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

#[test]
fn a_time_whose_phase_is_not_known_has_no_state_and_a_note_says_why() {
    // 2⁹⁷ periods of 2.0413384658583684 s are 3.2346e29 s.
    let answer = json("motion 30deg --times 3.23e29,3.24e29");
    let [near, unknown] = [&answer["samples"][0], &answer["samples"][1]];
    assert!(near["angle_rad"].is_number() && near.get("note").is_none(), "{near}");
    assert!(unknown["angle_rad"].is_null() && unknown["velocity_rad_per_s"].is_null(), "{unknown}");
    assert!(unknown["note"].as_str().unwrap().contains("the phase is not known"), "{unknown}");
    assert!(
        text("motion 30deg --times 3.24e29")
            .ends_with("note: the phase is not known from 2⁹⁷ periods (1.6e29) on\n")
    );
    assert!(!text("motion 30deg --times 3.23e29").contains("note"));
}

#[test]
fn uncertainties_of_times_that_are_not_used_are_named_in_one_note() {
    let file = directory("motion-uncertain-times").join("times.txt");
    std::fs::write(&file, "# t\n0\n1.0(1)\n2 ± 0.1 s\n3\n4.00(2)\n").unwrap();
    let file = file.display().to_string();
    let note = |arguments: &[&str]| message(&run(arguments));
    let many = "the uncertainties of 3 of 5 times are not used here, only their values";
    assert_eq!(note(&["motion", "10deg", "--times-from", &file]).matches(many).count(), 1);
    let list = note(&["motion", "10deg", "--times", "1s±0.1s,2s"]);
    assert!(list.contains("the uncertainty of 1 of 2 times is not used here, only its value"), "{list}");
    let range = note(&["motion", "10deg", "--times", "0:1.0(1)s:0.5"]);
    assert!(range.contains("the uncertainty of `1.0(1)s` is not used here, only its value"), "{range}");
    let simulated = note(&["simulate", "pendulum", "--initial", "theta=1", "--times", "0,1.0(1),2.0(1)"]);
    assert!(simulated.contains("the uncertainties of 2 of 3 times"), "{simulated}");
    let until = note(&["decay", "60deg", "--linear", "0.1", "--until", "20(1)s"]);
    assert!(until.contains("the uncertainty of `20(1)s` is not used here"), "{until}");
    assert_eq!(note(&["motion", "10deg", "--times", "0,1,2"]), "");
}
