//! `libration figure`.

use crate::command::{directory, json, libration, message, text};

fn drawn(arguments: &str) -> String {
    let path = directory(&format!("figure-{}", arguments.split(' ').next().unwrap())).join("figure.svg");
    let output = libration(&format!("figure {arguments} --output {}", path.display()));
    assert!(output.status.success(), "{arguments}: {}", message(&output));
    std::fs::read_to_string(path).unwrap()
}

#[test]
fn each_picture_labels_its_axes() {
    let cases = [
        ("errors --formulas bernoulli,black_vel_1", ["amplitude θ₀ / degrees", "|fractional error of T|"]),
        ("motion --amplitudes 30deg,150deg", ["time t / T₀", "angle θ / θ₀"]),
        ("phase", ["angle θ / rad", "velocity θ′ / ω₀"]),
        ("spectrum", ["harmonic n", "coefficient |aₙ| / rad"]),
        ("series pendulum", ["amplitude θ₀ / degrees", "radius of convergence, 180°"]),
        ("series duffing --amplitudes 0.5,1.1", ["last power of A kept", "A = 1.1"]),
        ("series van_der_pol --quantity frequency", ["strength μ", "|error of Ω/ω₀|"]),
    ];
    for (arguments, labels) in cases {
        let svg = drawn(arguments);
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"), "{arguments}");
        for label in labels {
            assert!(svg.contains(label), "{arguments}: {label}");
        }
    }
}

#[test]
fn a_png_is_a_png() {
    let path = directory("png").join("spectrum.png");
    text(&format!("figure spectrum --width 500 --height 400 --output {}", path.display()));
    assert!(std::fs::read(path).unwrap().starts_with(b"\x89PNG\r\n"));
}

#[test]
fn the_numbers_behind_a_picture_are_in_its_json() {
    let path = directory("numbers").join("errors.svg");
    let answer = json(&format!("figure errors --formulas black_vel_1 --output {}", path.display()));
    assert_eq!(answer["figure"], "errors");
    let points = answer["series"][0]["points"].as_array().unwrap();
    let least = points
        .iter()
        .filter(|p| p[0].as_f64().unwrap() > 90.0)
        .min_by(|a, b| a[1].as_f64().unwrap().total_cmp(&b[1].as_f64().unwrap()));
    let zero = least.unwrap()[0].as_f64().unwrap();
    assert!((zero - 141.124673660617753).abs() < 0.01, "the one-term formula is exact at {zero}°");
}
