//! `libration figure`.

use crate::command::{directory, json, libration, message, run, text};
use crate::drawing::Drawing;

fn drawn(arguments: &str) -> String {
    let path = directory(&format!("figure-{}", arguments.split(' ').next().unwrap())).join("figure.svg");
    let output = libration(&format!("figure {arguments} --output {}", path.display()));
    assert!(output.status.success(), "{arguments}: {}", message(&output));
    std::fs::read_to_string(path).unwrap()
}

#[test]
fn each_picture_labels_its_axes() {
    let cases = [
        ("errors --formulas bernoulli,denman", ["amplitude θ₀ / degrees", "|fractional error of T|"]),
        ("motion --amplitudes 30deg,150deg", ["time t / T₀", "angle θ / θ₀"]),
        ("phase", ["angle θ / rad", "velocity θ′ / ω₀"]),
        ("spectrum", ["harmonic n", "coefficient |aₙ| / rad"]),
        ("series pendulum", ["amplitude θ₀ / degrees", "radius of convergence, 180°"]),
        ("series duffing --amplitudes 0.5,1.1", ["highest power of A", "A = 1.1"]),
        ("series van_der_pol --quantity frequency", ["strength μ", "|error of Ω/ω₀|"]),
    ];
    for (arguments, labels) in cases {
        let svg = drawn(arguments);
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"), "{arguments}");
        let drawing = Drawing::read(&svg);
        for label in labels {
            assert!(
                drawing.texts.iter().any(|text| text.content.replace('\u{a0}', " ") == label),
                "{arguments}: {label}"
            );
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
    let answer = json(&format!("figure errors --formulas denman --output {}", path.display()));
    assert_eq!(answer["figure"], "errors");
    let points = answer["series"][0]["points"].as_array().unwrap();
    let least = points
        .iter()
        .filter(|p| p[0].as_f64().unwrap() > 90.0)
        .min_by(|a, b| a[1].as_f64().unwrap().total_cmp(&b[1].as_f64().unwrap()));
    let zero = least.unwrap()[0].as_f64().unwrap();
    assert!((zero - 141.124673660617753).abs() < 0.01, "the one-term formula is exact at {zero}°");
}

/// The picture of a query.
fn asked(question: &str) -> String {
    let name: String = question.chars().filter(char::is_ascii_alphanumeric).take(60).collect();
    let path = directory(&format!("figure-of-{name}")).join("figure.svg");
    text(&format!("{question} --figure {}", path.display()));
    std::fs::read_to_string(path).unwrap()
}

#[test]
fn pictures_say_what_they_were_made_with() {
    let cases = [
        ("motion 60deg --length 2m", "θ₀ = 60°, l = 2 m, g = 9.80665 m/s²"),
        ("decay 60deg --linear 0.1 --omega0 1rad/s --cycles 3", "θ₀ = 60°, ω₀ = 1 rad/s, c₁ = 0.1 1/s"),
        (
            "simulate driven_pendulum --set A=1.5,c=1/2 --initial theta=0.5 --times 0:1:0.5",
            "A = 1.5 1/s², c = 0.5 1/s",
        ),
        ("modes double_pendulum", "l₁ = 1 m"),
    ];
    for (question, expected) in cases {
        let svg = asked(question);
        let words = Drawing::read(&svg).of_class("parameters").join(" ").replace('\u{a0}', " ");
        assert!(words.contains(expected), "{question}: {words}");
        // The description for those who cannot see the picture.
        let description = svg.split_once("<desc>").unwrap().1.split_once("</desc>").unwrap().0;
        assert!(
            description.contains(expected) && description.contains(" against "),
            "{question}: {description}"
        );
        assert!(
            svg.contains("<title>")
                && svg.contains(" viewBox=\"0 0 ")
                && svg.contains("prefers-color-scheme:dark")
        );
    }
}

#[test]
fn nothing_hides_the_exact_curve_or_the_data() {
    let svg = asked("motion 150deg --compare small-angle,fourier-3");
    let curves: Vec<&str> = svg.split("<path class=\"curve\" ").skip(1).collect();
    let colour = |curve: &str| curve.split_once("stroke=\"").unwrap().1[..7].to_owned();
    // Wide beneath the other curves and thin above them.
    assert_eq!([0, 3].map(|index| colour(curves[index])), ["#0072B2", "#0072B2"]);
    assert!(curves[0].contains("stroke-opacity") && !curves[3].contains("stroke-opacity"));
    let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    for fit in ["periods", "lengths", "trace"] {
        let file = match fit {
            "periods" => "period_table_synthetic.csv",
            "lengths" => "lengths_synthetic.csv",
            _ => "swing_synthetic.csv --model linear",
        };
        let svg = asked(&format!("fit {fit} {examples}/{file}"));
        for panel in svg.split("<g class=\"panel\">").skip(1) {
            let last_curve = panel.rfind("class=\"curve\"").unwrap();
            assert!(panel.find("class=\"markers\"").unwrap() > last_curve, "{fit}");
        }
    }
}

#[test]
fn a_picture_is_as_large_as_it_is_asked_for() {
    let sides = |options: &str| {
        let drawing = Drawing::read(&drawn(&format!("spectrum {options}")));
        (drawing.width, drawing.height)
    };
    let mm = 96.0 / 25.4;
    for (options, width, height) in [
        ("--width 120mm --height 9cm", 120.0 * mm, 90.0 * mm),
        ("--width 600 --height 480px", 600.0, 480.0),
        ("--size slide", 1280.0, 720.0),
    ] {
        let (found_width, found_height) = sides(options);
        // To hundredths of a unit.
        assert!((found_width - width).abs() < 0.006 && (found_height - height).abs() < 0.006, "{options}");
    }
    let path = directory("png-size").join("spectrum.png");
    text(&format!("figure spectrum --width 254mm --height 127mm --output {}", path.display()));
    let bytes = std::fs::read(path).unwrap();
    let side = |from: usize| u32::from_be_bytes(bytes[from..from + 4].try_into().unwrap());
    assert_eq!((side(16), side(20)), (3000, 1500), "300 pixels in an inch");
}

/// The titles and the parameter line of a picture; angles are in the unit of the axes.
#[test]
fn pictures_of_typed_equations_are_titled_by_them_and_have_one_unit() {
    let file = directory("titles").join("picture.svg");
    let drawn = |arguments: &[&str]| {
        let output = run(&[arguments, &["--figure", &file.display().to_string()]].concat());
        assert!(output.status.success(), "{}", message(&output));
        let answer = String::from_utf8(output.stdout).unwrap();
        assert!(!answer.contains("\n\n\n") && !answer.contains("the equations of motion"), "{answer}");
        let svg = std::fs::read_to_string(&file).unwrap();
        let drawing = Drawing::read(&svg);
        let of_class = |class| drawing.of_class(class).join(" ").replace('\u{a0}', " ");
        format!("{}; {}; {svg}", of_class("title"), of_class("parameters"))
    };
    let simulated = ["simulate", "x'' = -x", "--initial", "x=1", "--times", "0:10:1"];
    let in_time = drawn(&simulated);
    assert!(in_time.contains("Motion of x′′ = -x"), "{in_time}");
    let plane = drawn(&[&simulated[..], &["--axes", "x,x'"]].concat());
    assert!(plane.contains("= -x: x′ against x"), "{plane}");
    let long = "x1'' = -x1 - x2*sin(x1)*cos(x1)*sin(x1); x2'' = -x2 - x1*sin(x2)*cos(x2)";
    let coordinates = drawn(&["simulate", long, "--initial", "x1=1", "--times", "0:10:1"]);
    assert!(coordinates.contains("Motion of x₁, x₂"), "{coordinates}");
    let turning = drawn(&[
        "simulate",
        "pendulum",
        "--initial",
        "theta=1",
        "--times",
        "0:10:1",
        "--axes",
        "theta,theta'",
    ]);
    assert!(turning.contains("θ(0) = 1 rad") && turning.contains("θ / rad"), "{turning}");
    let section =
        ["section", "driven_pendulum", "--set", "A=1.2,c=1/2", "--initial", "theta=0.25", "--points", "20"];
    let section = drawn(&section);
    assert!(section.contains("θ(0) = 0.25 rad") && section.contains("θ / rad"), "{section}");
    let in_time = drawn(&["simulate", "pendulum", "--initial", "theta=60deg", "--times", "0:10:1"]);
    assert!(in_time.contains("θ(0) = 60°") && in_time.contains("θ / degrees"), "{in_time}");
}

/// The spectrum of a rotating angle is rejected, that of its velocity is drawn.
#[test]
fn what_grows_without_bound_has_no_spectrum() {
    let file = directory("unbounded").join("figure.svg").display().to_string();
    let question = "figure trajectories pendulum --initial theta'=3 --to 100 --spectrum";
    let output = libration(&format!("{question} theta --output {file}"));
    assert_eq!(output.status.code(), Some(1));
    // 41.44 turns of 2kK(k) with k = 2/3.
    let reason = "θ goes from 0 to 260.4 and swings little about that: draw the spectrum of θ′";
    assert!(message(&output).contains(reason), "{}", message(&output));
    text(&format!("{question} theta' --output {file}"));
}

/// An unknown parameter is reported with the option that names it.
#[test]
fn a_parameter_is_refused_in_the_name_of_its_option() {
    let file = directory("varied").join("figure.svg").display().to_string();
    let picture = format!("figure trajectories driven_pendulum --output {file}");
    for question in [&picture[..], "bifurcation driven_pendulum --points 3"] {
        for (values, option) in [
            ("--over cc=1,2", "--over"),
            ("--set cc=1 --over c=1,2", "--set"),
            ("--set c=1 --over c=1,2", "--over"),
        ] {
            let output = libration(&format!("{question} {values}"));
            assert_eq!(output.status.code(), Some(2));
            let written = message(&output);
            assert!(written.starts_with(&format!("error: {option}: ")), "{question} {values}: {written}");
        }
    }
}
