//! Corrections of gravity by the apparatus, and normal gravity, in all fits that give gravity.

use crate::command::{close, json, libration, message, text, unfolded};
use serde_json::Value;

fn example(name: &str) -> String {
    format!("{}/../../examples/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// Every fit that gives gravity, with a pendulum of about a metre.
fn fits() -> [String; 4] {
    [
        format!("fit periods {} --length 1m±1mm", example("period_table_synthetic.csv")),
        format!("fit gates {} --amplitude 40deg --length 1m±1mm", example("gate_synthetic.csv")),
        format!("fit trace {} --model linear --to 6s --length 1m±1mm", example("swing_synthetic.csv")),
        format!("fit lengths {}", example("lengths_synthetic.csv")),
    ]
}

fn number(answer: &Value, name: &str) -> f64 {
    answer[name].as_f64().unwrap_or_else(|| panic!("{name}: {answer}"))
}

fn row<'a>(answer: &'a Value, name: &str) -> &'a Value {
    let rows = answer["budget"].as_array().unwrap();
    rows.iter().find(|row| row["name"] == name).unwrap_or_else(|| panic!("{name}: {answer}"))
}

/// With a length of one metre κ/L² is κ; the row of the effect and the change of gravity are the same.
#[test]
fn the_shape_of_a_bob_is_one_option_of_every_fit_of_one_length() {
    for fit in &fits()[..3] {
        let bare = number(&json(fit), "gravity_m_per_s2");
        for (bob, gyration) in [
            ("ball:radius=5cm", 0.4 * 0.0025),
            ("disc:radius=5cm,thickness=1cm", 0.5 * 0.0025),
            ("cylinder:radius=3cm,height=8cm", 0.25 * 0.0009 + 0.0064 / 12.0),
            ("ring:radius=5cm,inner=3cm", 0.5 * (0.0025 + 0.0009)),
            ("cap:radius=5cm,height=3cm", 4.29609375e-4),
            ("gyration:radius=4cm", 0.0016),
        ] {
            // A round bob blocks the gate, which then gives amplitudes and another T0.
            if fit.contains("gates") && (0..3).any(|index| bob.starts_with(["ball", "disc", "ring"][index])) {
                continue;
            }
            let answer = json(&format!("{fit} --bob {bob}"));
            close(&row(&answer, "finite bob")["correction"], gyration, 1e-10);
            close(&answer["gravity_m_per_s2"], bare * (1.0 + gyration), 1e-9);
        }
        let disc = json(&format!("{fit} --bob disc:radius=5.0(5)cm"));
        let of_radius = number(row(&disc, "finite bob"), "uncertainty_m_per_s2");
        assert!((of_radius / (number(&disc, "gravity_m_per_s2") * 0.05 * 0.005) - 1.0).abs() < 2e-3);
    }
}

#[test]
fn temperature_support_and_knife_edge_are_corrected_in_every_fit() {
    for fit in fits() {
        let bare = json(&fit);
        let g = number(&bare, "gravity_m_per_s2");
        for name in ["temperature", "support", "knife edge"] {
            assert!(row(&bare, name)["correction"].is_null() && row(&bare, name)["usual_size"].is_number());
        }
        let warm = json(&format!("{fit} --expansion 12(1)e-6/K --warmer 5K±2K"));
        close(&warm["gravity_m_per_s2"], g * (1.0 + 6e-5), 1e-9);
        let of_warming = number(row(&warm, "temperature"), "uncertainty_m_per_s2");
        close(&Value::from(of_warming), g * f64::hypot(5e-6, 2.4e-5), 1e-4);
        let cold = json(&format!("{fit} --expansion 12e-6/K --warmer -5K"));
        close(&cold["gravity_m_per_s2"], g * (1.0 - 6e-5), 1e-9);
        let weak =
            number(&json(&format!("{fit} --bob-mass 200g --support-stiffness 2N/mm")), "gravity_m_per_s2");
        let blunt = number(&json(&format!("{fit} --edge-radius 1mm±0.2mm")), "gravity_m_per_s2");
        if fit.contains("lengths") {
            // Both are lengths that all rows share, and so a part of the offset; what bends the line is small.
            assert!((weak / g - 1.0).abs() < 1e-4 && (blunt / g - 1.0).abs() < 1e-4, "{weak} {blunt} {g}");
        } else {
            // L + mg/K, and L − p: a metre, 0.98 mm of g = 9.8 and a millimetre. The first examples have other lengths than they were given.
            assert!(
                (weak / g - 1.0) / (1e-4 * g) > 0.99 && (weak / g - 1.0) / (1e-4 * g) < 1.01,
                "{weak} {g}"
            );
            close(&Value::from(blunt), g / 1.001, 1e-9);
        }
    }
}

/// A half-width of a rectangular distribution counts as itself over √3.
#[test]
fn half_widths_are_read_in_quantities() {
    let fit = &fits()[0].replace("--length 1m±1mm", "--length");
    let output = |length: &str| {
        let words: Vec<&str> = fit.split_whitespace().chain([length, "--json"]).collect();
        let output =
            std::process::Command::new(env!("CARGO_BIN_EXE_libration")).args(words).output().unwrap();
        serde_json::from_slice::<Value>(&output.stdout).unwrap()
    };
    let [rectangular, standard] = ["1m±3mm rectangular", "1m±1mm"]
        .map(|length| number(row(&output(length), "length"), "uncertainty_m_per_s2"));
    assert!((rectangular / standard - 3.0_f64.sqrt()).abs() < 1e-6, "{rectangular} {standard}");
}

#[test]
fn impossible_apparatus_is_refused_with_the_option_that_helps() {
    let [periods, .., lengths] = fits();
    for (options, status, reason) in [
        ("--bob sphere:radius=2cm", 2, "`sphere` is not a shape"),
        ("--bob disc:thickness=2cm", 2, "needs its radius"),
        ("--bob cylinder:radius=2cm", 2, "needs its height"),
        ("--bob ball:radius=2cm,height=3cm", 2, "has no `height`"),
        ("--bob ball:radius=2cm,radius=3cm", 2, "given twice"),
        ("--bob ball:radius=2cm --bob-radius 2cm", 2, "bob-radius"),
        ("--bob ring:radius=2cm,inner=3cm", 2, "its hole is not smaller than the ring"),
        ("--bob cap:radius=2cm,height=5cm", 2, "it is higher than the ball"),
        ("--warmer 3K", 2, "--expansion"),
        ("--support-stiffness 20N/mm", 2, "--bob-mass"),
        ("--bob-mass 200g --support-stiffness 1N/m", 1, "support"),
        ("--latitude 100deg", 2, "beyond the poles"),
        ("--latitude 48deg --elevation 10km", 2, "surface of the Earth"),
        ("--elevation 500m", 2, "--latitude"),
    ] {
        for fit in [&periods, &lengths] {
            let refused = libration(&format!("{fit} {options}"));
            assert_eq!(refused.status.code(), Some(status), "{options}: {}", message(&refused));
            assert!(unfolded(&message(&refused)).contains(reason), "{options}: {}", message(&refused));
        }
    }
    let table = example("period_table_synthetic.csv");
    for options in ["--bob-radius 2cm", "--edge-radius 1mm", "--latitude 48deg"] {
        let refused = libration(&format!("fit periods {table} {options}"));
        assert_eq!(refused.status.code(), Some(2));
        assert!(unfolded(&message(&refused)).contains("--length"), "{}", message(&refused));
    }
    let bar = example("bar_synthetic.csv");
    let refused = libration(&format!("fit lengths {bar} --model bar --rod-mass 3g --bob-mass 1kg"));
    assert!(message(&refused).contains("rod-mass") && refused.status.code() == Some(2));
}

/// At 48° and 500 m by `reference/normal_gravity.py`; at 3 km the anomaly of mountains.
#[test]
fn normal_gravity_stands_next_to_every_result() {
    for fit in fits() {
        let answer = json(&format!("{fit} --latitude 48deg --elevation 500m"));
        close(&answer["normal_gravity_m_per_s2"], 9.80736771266, 6e-8);
        close(&answer["normal_gravity_uncertainty_m_per_s2"], 3e-4, 1e-12);
        let (g, u) = (number(&answer, "gravity_m_per_s2"), number(&answer, "gravity_uncertainty_m_per_s2"));
        let deviation = (g - 9.80736771266) / u.hypot(3e-4);
        close(&answer["normal_gravity_deviation"], deviation, 1e-3);
        let sheet = unfolded(&text(&format!("{fit} --latitude -48deg --elevation 3000m")));
        assert!(sheet.contains("9.7997 ± 0.0010 m/s²") && sheet.contains("GRS80"), "{sheet}");
        assert!(json(&fit).get("normal_gravity_m_per_s2").is_none());
    }
}
