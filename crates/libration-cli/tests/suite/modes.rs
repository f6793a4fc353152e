//! `libration modes` and `libration backbone`.

use crate::command::{close, directory, json, libration, message, run, text, unfolded};
use crate::drawing::Drawing;
use serde_json::Value;

fn json_of(arguments: &[&str]) -> Value {
    let output = run(&[arguments, &["--json"]].concat());
    assert!(output.status.success(), "{arguments:?}: {}", message(&output));
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn the_double_pendulum_is_exact() {
    let answer = json("modes double_pendulum");
    assert_eq!(answer["coordinates"], serde_json::json!(["theta1", "theta2"]));
    assert_eq!(answer["exact_equilibrium"], serde_json::json!(["0", "0"]));
    let slow = &answer["modes"][0];
    assert_eq!(slow["exact_angular_frequency"], "sqrt(2 - sqrt(2))");
    assert_eq!(slow["exact_shape"], serde_json::json!(["1/2*sqrt(2)", "1"]));
    assert_eq!(slow["exact_relative_shift"], "-31/64 + 5/16*sqrt(2)");
    close(&slow["angular_frequency_rad_per_s"], (2.0 - 2.0_f64.sqrt()).sqrt(), 1e-15);
    let sheet = text("modes double_pendulum");
    assert!(sheet.contains("mode 2: ω = sqrt(2 + sqrt(2)) = 1.84775906502257"), "{sheet}");
    assert!(sheet.contains("Ω = ω(1 + (-31/64 - 5/16*sqrt(2)) a²)"), "{sheet}");
}

#[test]
fn the_resonance_of_the_spring_pendulum_is_said() {
    let answer = json("modes spring_pendulum --set kappa=3");
    let swings = &answer["modes"][0];
    assert_eq!(swings["resonances"][0]["multiple"], 2);
    assert_eq!(swings["resonances"][0]["exact"], true);
    assert_eq!(swings["shift"], Value::Null);
    assert!(swings["no_shift"].as_str().unwrap().contains("resonance 2:1"));
    let sheet = text("modes spring_pendulum --set kappa=3");
    assert!(sheet.contains("1:2 with mode 2, exactly"), "{sheet}");
}

#[test]
fn every_named_system_has_modes_or_a_reason() {
    let systems = json("systems");
    for system in systems["systems"].as_array().unwrap() {
        let key = system["key"].as_str().unwrap();
        let output = libration(&format!("modes {key}"));
        let told = message(&output);
        let reasons = ["choose another equilibrium", "no equilibrium was found", "is of the first order"];
        let has_reason = reasons.iter().any(|reason| told.contains(reason));
        assert!(output.status.success() || has_reason, "{key}: {told}");
    }
}

#[test]
fn modes_about_another_equilibrium_are_found() {
    let answer = json("modes pendulum --about theta=170deg");
    assert_eq!(answer["modes"][0]["behaviour"], "unstable");
    close(&answer["equilibrium"][0], std::f64::consts::PI, 1e-15);
    close(&answer["modes"][0]["growth_rate_per_s"], 1.0, 1e-15);
    let csv = text("modes coupled_pendulums --csv");
    assert_eq!(
        csv.lines().next(),
        Some(
            "mode,behaviour,angular_frequency_rad_per_s,growth_rate_per_s,exact_angular_frequency,shape_theta1,shape_theta2,shift"
        )
    );
    assert_eq!(csv.lines().nth(1), Some("1,oscillating,1.0,0.0,1,1.0,1.0,-0.0625"));
}

#[test]
fn questions_about_modes_without_an_answer_are_refused() {
    for (arguments, status, words) in [
        (["modes", "x'' = -x + cos(t)"].as_slice(), 1, "time t"),
        (&["modes", "x'' = -x^2 - 1"], 1, "no equilibrium"),
        (&["modes", "pendulum", "--about", "phi=1"], 2, "no coordinate `phi`: it has theta"),
        (&["modes", "pendulum", "--about", "theta"], 2, "has no value"),
        (&["modes", "x'' = -x", "--about", "x=1kg"], 2, "not a number"),
        (&["backbone", "duffing"], 2, "--amplitudes"),
        (&["backbone", "duffing", "--amplitudes", "1deg"], 2, "angle units"),
        (&["backbone", "duffing", "--amplitudes", "0:1:0.5"], 2, "above zero"),
        (&["backbone", "van_der_pol", "--amplitudes", "1"], 1, "limit cycle"),
        (&["backbone", "x'' = -y; y'' = -x", "--amplitudes", "1"], 1, "normal modes"),
        (&["backbone", "x'' = -x - x'", "--amplitudes", "1"], 1, "no period"),
    ] {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {}", message(&output));
        assert!(message(&output).contains(words), "{arguments:?}: {}", message(&output));
    }
}

#[test]
fn the_backbone_of_the_pendulum_has_three_roads() {
    let answer = json("backbone pendulum --amplitudes 40deg,90deg --order 21");
    close(&answer["omega0_rad_per_s"], 1.0, 1e-15);
    close(&answer["series_radius"], std::f64::consts::PI, 1e-15);
    let point = &answer["points"][1];
    close(&point["exact"], 0.847_213_084_793_979_1, 1e-15);
    close(&point["angular_frequency_rad_per_s"], 0.847_213_084_793_979_1, 1e-14);
    close(&point["series_angular_frequency_rad_per_s"], 0.847_213_084_793_979_1, 1e-6);
    close(&point["other_turning_point"], -std::f64::consts::FRAC_PI_2, 1e-14);
    assert_eq!(point["series_remainder_is"], "proven");
    let missing =
        (point["series_angular_frequency_rad_per_s"].as_f64().unwrap() - 0.847_213_084_793_979_1).abs();
    assert!((missing..1e-5).contains(&point["series_remainder_rad_per_s"].as_f64().unwrap()), "{point}");
    let morse = json("backbone morse --amplitudes 0.1 --order 21");
    assert_eq!(morse["points"][0]["series_remainder_is"], "estimated");
    assert!(point["exact_uncertainty"].as_f64().unwrap() < 1e-15);
    let sheet = text("backbone pendulum --amplitudes 40deg,90deg");
    assert!(sheet.contains("90°  0.8472130847939"), "{sheet}");
}

#[test]
fn a_force_without_a_linear_part_has_orbits_only() {
    let answer = json_of(&["backbone", "x'' = -x^3", "--amplitudes", "0.5,2"]);
    assert!(answer["no_series"].as_str().is_some() && answer["omega0_rad_per_s"] == Value::Null);
    for (index, amplitude) in [0.5, 2.0].into_iter().enumerate() {
        // Γ(1/4)²/√π.
        let frequency = std::f64::consts::TAU * amplitude / 7.416_298_709_205_487_7;
        close(&answer["points"][index]["angular_frequency_rad_per_s"], frequency, 1e-14);
    }
    // Beyond the barrier there is no orbit, and the table continues.
    let csv = text("backbone duffing_soft --amplitudes 0.9,1.1 --csv");
    assert!(csv.lines().nth(2).unwrap().starts_with("1.1,,,"), "{csv}");
}

/// 2π over the energy integrals in 120 digits.
#[test]
fn the_backbone_holds_its_uncertainty_next_to_a_separatrix() {
    let cases = [
        (
            "backbone duffing_soft --amplitudes 0.99999,0.999999999999",
            [36.484_517_388_730_866, 82.073_362_182_602_65],
        ),
        ("backbone pendulum --amplitudes 3rad,pi-1e-12", [16.155_539_372_393_375, 118.841_850_630_433_54]),
        ("backbone double_well --amplitudes 0.4,0.42", [6.756_369_163_739_06, 15.084_420_399_954_246]),
    ];
    for (question, periods) in cases {
        let answer = json(question);
        for (point, period) in answer["points"].as_array().unwrap().iter().zip(periods) {
            let (stated, frequency) = (
                point["angular_frequency_uncertainty_rad_per_s"].as_f64().unwrap(),
                std::f64::consts::TAU / period,
            );
            close(&point["angular_frequency_rad_per_s"], frequency, stated + 2e-16 * frequency);
            assert!(stated < 1e-13, "{question}: {stated:e}");
        }
    }
}

#[test]
fn the_backbone_says_where_orbits_are_of_another_family() {
    let answer = json("backbone double_well --amplitudes 0.41,0.42");
    let [one, both] = answer["points"].as_array().unwrap().as_slice() else { panic!("{answer}") };
    assert!(one["encloses"] == Value::Null && one.get("note").is_none(), "{one}");
    close(&both["encloses"], 0.0, 1e-15);
    assert!(both["note"].as_str().unwrap().contains("encloses the equilibrium at 0"), "{both}");
    let sheet = text("backbone double_well --amplitudes 0.41,0.42,0.5");
    assert!(sheet.contains("At 2 of the amplitudes, the first at 0.42, the orbit also encloses"), "{sheet}");
    let top = json("backbone pendulum --amplitudes 90deg,180deg");
    let top = &top["points"][1];
    assert!(
        top["exact"] == Value::Null && top["note"].as_str().unwrap().contains("period is infinite"),
        "{top}"
    );
}

#[test]
fn a_centre_that_has_no_series_has_its_orbits() {
    let falling = json_of(&["backbone", "x'' = -sign(x)", "--amplitudes", "0.5,2"]);
    // 2π over 4√(2A).
    close(&falling["points"][0]["angular_frequency_rad_per_s"], std::f64::consts::FRAC_PI_2, 1e-14);
    close(&falling["points"][1]["angular_frequency_rad_per_s"], std::f64::consts::FRAC_PI_4, 1e-14);
    let isochronous = json_of(&["backbone", "x'' + 3*x*x' + x^3 + x = 0", "--amplitudes", "0.5,1"]);
    for point in isochronous["points"].as_array().unwrap() {
        close(&point["angular_frequency_rad_per_s"], 1.0, 1e-12);
    }
}

#[test]
fn a_followed_mode_ends_at_a_separatrix_with_what_it_has() {
    let arguments = ["modes", "x''=-x+x^3", "--follow", "1", "--amplitudes", "0.5,0.99,1,1.01"];
    let answer = json_of(&arguments);
    let points = answer["points"].as_array().unwrap();
    assert_eq!(points.len(), 2, "{answer}");
    assert!(answer["lost"].as_str().unwrap().contains("the accelerations vanish at [1.0]"), "{answer}");
    let sheet = text("modes pendulum --follow 1 --amplitudes 170deg,200deg");
    let sheet = unfolded(&sheet);
    assert!(sheet.contains("about another equilibrium"), "{sheet}");
    assert!(!sheet.contains("becomes") && !sheet.contains("nan"), "{sheet}");
}

#[test]
fn both_pictures_label_their_axes() {
    let folder = directory("modes");
    let picture = |arguments: &str, name: &str| {
        let path = folder.join(name);
        text(&format!("{arguments} --figure {}", path.display()));
        let drawing = Drawing::read(&std::fs::read_to_string(path).unwrap());
        drawing
            .texts
            .into_iter()
            .map(|text| text.content.replace('\u{a0}', " "))
            .collect::<Vec<_>>()
            .join("\n")
    };
    let shapes = picture("modes double_pendulum", "modes.svg");
    for label in ["component in the mode", "θ₁", "mode 2, ω = 1.84776"] {
        assert!(shapes.contains(label), "{label}");
    }
    let curve = picture("backbone pendulum --amplitudes 10deg:170deg:20deg", "backbone.svg");
    for label in ["amplitude / degrees", "frequency Ω", "orbits", "series, order 9"] {
        assert!(curve.contains(label), "{label}");
    }
}

#[test]
fn amplitudes_count_from_an_equilibrium_without_expansion_and_that_is_said() {
    for about in [&[][..], &["--about", "1"]] {
        let arguments = ["backbone", "x''=-(x-1)^3", "--amplitudes", "0.5,1"];
        let output = run(&[&arguments[..], about, &["--json"]].concat());
        assert!(output.status.success(), "{}", message(&output));
        let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert!(answer["centre"] == 1.0 && answer["centre_is_equilibrium"] == true, "{answer:#}");
        let frequency = answer["points"][1]["angular_frequency_rad_per_s"].as_f64().unwrap();
        // 2π/(4K(1/√2)).
        assert!((frequency - 0.847_213_084_793_979_1).abs() < 1e-14, "{answer:#}");
        let table = run(&[&arguments[..], about].concat());
        let table = String::from_utf8(table.stdout).unwrap();
        assert!(
            table.contains("equilibrium  1.0") && table.contains("amplitudes are measured from it"),
            "{table}"
        );
    }
    let none = run(&["backbone", "x''=exp(x)", "--amplitudes", "1"]);
    let told = unfolded(&String::from_utf8(none.stdout).unwrap());
    assert!(told.contains("no stable one found: amplitudes are measured from 0"), "{told}");
}

/// cosh 800 is 10³⁴⁷; numbers with a larger exponent range can follow the motion.
#[test]
fn what_is_beyond_the_range_of_numbers_is_called_so() {
    let refusal = |arguments: &[&str]| {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {}", message(&output));
        message(&output)
    };
    let told = refusal(&["simulate", "x''=-sinh(x)*cosh(1000*x)", "--initial", "x=1", "--times", "1"]);
    assert!(told.contains("a part of the equations of motion is beyond 1.8e308"), "{told}");
    let told = refusal(&["backbone", "x''=-abs(x)*x*cosh(x)", "--amplitudes", "800"]);
    assert!(told.contains("beyond 1.8e308"), "{told}");
    let told = refusal(&["simulate", "x''=-1/x", "--initial", "x=0,x'=1", "--times", "1"]);
    assert!(told.contains("have no finite value"), "{told}");
    let told = refusal(&["modes", "x''=-x-cosh(1000)*x"]);
    assert!(told.contains("beyond the range of numbers"), "{told}");
    // Exactly where constants keep their names, and to 40 digits at orders where they do not.
    let told = text("expand x''=-x/cosh(1000)");
    assert!(told.contains("ω0 = 1/sqrt(c1), with c1 = cosh(1000)"), "{told}");
    let told = text("expand x''=-x/cosh(1000) --order 17");
    assert!(told.contains("e-434"), "{told}");
}

#[test]
fn a_mode_is_followed_to_large_amplitudes_with_its_stability() {
    let answer = json("modes double_pendulum --follow 2 --amplitudes 20deg,60deg");
    let points = answer["points"].as_array().unwrap();
    // By collocation and by shooting in 130-bit floats.
    assert!((points[1]["period_s"].as_f64().unwrap() - 6.287_859_494_514_626).abs() < 1e-12, "{points:?}");
    assert!((points[1]["start"][1].as_f64().unwrap() + 1.099_990_501_943_477_8).abs() < 1e-11);
    // Two pairs of multipliers, because energy is conserved.
    assert_eq!((&points[0]["stability"], &points[1]["stability"]), (&"neutral".into(), &"unstable".into()));
    // Every multiplier has an error, and the two at 1, which belong to a family of orbits, are within it.
    for point in answer["points"].as_array().unwrap() {
        let multipliers = point["multipliers"].as_array().unwrap();
        let errors = point["multiplier_errors"].as_array().unwrap();
        assert_eq!((multipliers.len(), errors.len()), (4, 4));
        let pairs = multipliers.iter().zip(errors);
        let at_one = pairs.filter(|(z, error)| {
            let [re, im] = [0, 1].map(|part| z[part].as_f64().unwrap());
            (re - 1.0).hypot(im) <= error.as_f64().unwrap() && error.as_f64().unwrap() < 1e-3
        });
        assert!(at_one.count() >= 2, "{point}");
    }
    let told = text("modes double_pendulum --follow 2 --amplitudes 20deg,60deg");
    assert!(told.contains("It becomes unstable"), "{told}");
    for (arguments, part) in [
        (&["modes", "double_pendulum", "--follow", "3", "--amplitudes", "0.1"][..], "there is no mode 3"),
        (&["modes", "double_pendulum", "--follow", "1"][..], "--amplitudes"),
        (
            &["modes", "double_pendulum", "--follow", "1", "--amplitudes", "0.1", "--coordinate", "x"][..],
            "no coordinate",
        ),
    ] {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", message(&output));
        assert!(message(&output).contains(part), "{arguments:?}: {}", message(&output));
    }
}

#[test]
fn motions_with_a_factor_t_are_stated_with_what_becomes_of_them() {
    let said = |equations: &str| {
        let output = run(&["modes", equations]);
        unfolded(&String::from_utf8(output.stdout).unwrap())
    };
    assert!(said("x'' + 2*x' + x = 0").contains("that contain a factor t: 1; they decay in the end"));
    assert!(said("x'' = -x + y; y'' = -y").contains("a factor t: 1; they grow without limit"));
    assert!(!said("x'' = -x; y'' = -y").contains("factor t"));
}
