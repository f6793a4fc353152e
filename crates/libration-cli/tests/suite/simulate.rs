//! Motions in time by the command.

use crate::command::{close, directory, json, libration, message, run, text, unfolded};
use serde_json::Value;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6};
use std::fs;

fn sample(answer: &Value, index: usize) -> Vec<f64> {
    let state = answer["samples"][index]["state"].as_array().unwrap();
    state.iter().map(|value| value.as_f64().unwrap()).collect()
}

/// The errors of a sample or an event; `None` if they are null.
fn error(row: &Value) -> Option<Vec<f64>> {
    row["error"].as_array().unwrap().iter().map(Value::as_f64).collect()
}

#[test]
fn a_damped_pendulum_is_that_of_the_reference() {
    let answer = json(
        "simulate damped_pendulum --set c=0.1,n=2 --initial theta=1,theta'=0 --times 0.5,30 --tolerance 1e-15",
    );
    let fields: Vec<&str> = answer.as_object().unwrap().keys().map(String::as_str).collect();
    let expected = [
        "schema",
        "system",
        "equations",
        "parameters",
        "state",
        "samples",
        "events",
        "energy_drift",
        "energy_drift_uncertainty",
        "steps",
        "half_ulp_of_start",
        "resume",
        "note",
    ];
    assert_eq!(fields, expected);
    assert_eq!(
        (&answer["system"], &answer["state"]),
        (&"damped_pendulum".into(), &serde_json::json!(["theta", "theta'"]))
    );
    close(&answer["samples"][0]["time_s"], 0.5, 0.0);
    // From `damped.csv` of the library.
    close(&answer["samples"][0]["state"][0], 0.896390819265663239817, 1e-15);
    close(&answer["samples"][1]["state"][0], -0.28686664229216129236, 1e-14);
    assert_eq!(answer["energy_drift"], Value::Null);
    assert!(answer["note"].as_str().unwrap().contains("not conserved"), "{}", answer["note"]);
}

#[test]
fn a_conservative_motion_reports_how_well_it_keeps_its_energy() {
    for system in [
        "pendulum --initial theta=60deg",
        "double_pendulum --initial theta1=1,theta2=-0.5",
        "morse --initial x=0.5",
    ] {
        let answer = json(&format!("simulate {system} --times 0:20:5"));
        let drift = answer["energy_drift"].as_f64().unwrap();
        assert!(drift < 1e-11, "{system}: {drift}");
        assert!(answer["note"].is_null() && answer["steps"].as_u64().unwrap() > 10, "{answer}");
    }
    let answer =
        run(&["simulate", "x'' = y - x; y'' = x - y", "--initial", "x=1", "--times", "0,1", "--json"]);
    let answer: Value = serde_json::from_slice(&answer.stdout).unwrap();
    assert_eq!(answer["system"], "x'' = y - x; y'' = x - y");
    assert!(answer["energy_drift"].as_f64().unwrap() < 1e-12);
    let (half, frequency) = (0.5, 2_f64.sqrt());
    assert!((sample(&answer, 1)[0] - half * (1.0 + frequency.cos())).abs() < 1e-12);
}

#[test]
fn every_form_has_the_same_numbers() {
    let question = "simulate spring_pendulum --initial theta=0.5 --times 0:2:0.25";
    let answer = json(question);
    let table = text(&format!("{question} --csv"));
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("time_s,r,theta,r',theta',r_error,theta_error,r'_error,theta'_error"));
    for (index, line) in lines.enumerate() {
        let numbers: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        assert_eq!(numbers[1..5], sample(&answer, index));
        assert_eq!(numbers[5..], error(&answer["samples"][index]).unwrap());
    }
    // r is not given, and begins where the spring carries the weight.
    assert_eq!(sample(&answer, 0), [1.1, 0.5, 0.0, 0.0]);
    let sheet = text(question);
    let said = unfolded(&sheet);
    assert!(said.contains("(r, r', theta' not given, so at rest)") && said.contains("r' / (m/s)"), "{sheet}");
}

#[test]
fn initial_values_have_units_and_names_as_physicists_write_them() {
    let start = |initial: &str, system: &str| {
        let arguments = ["simulate", system, "--initial", initial, "--times", "0", "--json"];
        let output = run(&arguments);
        assert!(output.status.success(), "{initial}: {}", message(&output));
        sample(&serde_json::from_slice(&output.stdout).unwrap(), 0)
    };
    assert_eq!(start("theta=90deg,theta'=30deg/s", "pendulum"), [FRAC_PI_2, FRAC_PI_6]);
    assert_eq!(start("θ = pi/2, θ̇ = 1", "pendulum"), [FRAC_PI_2, 1.0]);
    assert_eq!(start("x=sqrt(2)", "x'' = -x"), [2f64.sqrt(), 0.0]);
    assert_eq!(start("r=120cm,r'=-5cm/s", "spring_pendulum"), [1.2, 0.0, -0.05, 0.0]);
    assert_eq!(start("x'=0.1", "double_well"), [1.0, 0.1]);
}

#[test]
fn motions_run_backward_too() {
    let there = json("simulate pendulum --initial theta=1,theta'=0.3 --times 0:-3:-1 --tolerance 1e-15");
    let [angle, velocity] = sample(&there, 3).try_into().unwrap();
    let back = json(&format!(
        "simulate pendulum --initial theta={angle:?},theta'={velocity:?} --times 3 --tolerance 1e-15"
    ));
    let [angle, velocity] = sample(&back, 0).try_into().unwrap();
    assert!((angle - 1.0).abs() < 1e-14 && (velocity - 0.3).abs() < 1e-14);
}

#[test]
fn a_singularity_ends_the_answer_and_says_so() {
    let output = run(&["simulate", "x'' = 2 x^3", "--initial", "x=1,x'=1", "--times", "0:2:0.4", "--json"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(message(&output).contains("singularity"), "{}", message(&output));
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(answer["samples"].as_array().unwrap().len(), 3);
    assert!(answer["stopped"].as_str().unwrap().contains("singularity"), "{answer}");
}

/// Times and kinds of the events in a result.
fn events(answer: &Value) -> Vec<(f64, String)> {
    let event =
        |event: &Value| (event["time_s"].as_f64().unwrap(), event["kind"].as_str().unwrap().to_owned());
    answer["events"].as_array().unwrap().iter().map(event).collect()
}

#[test]
fn turning_points_passages_and_levels_are_found() {
    let question = "simulate damped_pendulum --set c=0.1 --initial theta=1 --times 0:10:5 --tolerance 1e-15";
    let turnings = events(&json(&format!("{question} --events turning")));
    // From `damped.csv` of the library.
    let expected = [3.323972347874400124, 6.594035276141596549, 9.827704016085721970];
    assert_eq!(turnings[0], (0.0, "turning, at the start".to_owned()));
    assert_eq!(turnings.len(), 1 + expected.len());
    for ((time, kind), expected) in turnings[1..].iter().zip(expected) {
        assert!(kind == "turning" && (time - expected).abs() < 1e-14, "{time} {kind}");
    }
    let passages = events(&json(&format!("{question} --events crossing")));
    assert_eq!(passages.len(), 3);
    let levels = events(&json(&format!("{question} --events theta-0.5,c-0.2")));
    assert_eq!(levels.iter().map(|(_, kind)| kind.as_str()).collect::<Vec<_>>(), ["theta - 0.5"; 3]);
    let table = text(&format!("{question} --events turning --csv"));
    let start = "time_s,theta,theta',time_error_s,theta_error,theta'_error,event\n0.0,1.0,0.0,,0.0,0.0,\n";
    assert!(table.starts_with(start), "{table}");
    assert_eq!(table.lines().filter(|line| line.ends_with(",turning")).count(), 3);
    let without = text(&format!("{question} --events turning --csv --no-errors"));
    assert!(without.starts_with("time_s,theta,theta',event\n0.0,1.0,0.0,\n"), "{without}");
    let coupled = "simulate double_pendulum --initial theta1=1 --times 0,3 --events turning";
    assert!(events(&json(coupled)).iter().any(|(_, kind)| kind == "turning of theta2"));
    let sheet = text(&format!("{question} --events turning"));
    assert!(sheet.contains("3.32397234787") && sheet.contains("event"), "{sheet}");
}

#[test]
fn rotations_pass_the_lowest_point_in_every_turn() {
    let answer = json("simulate pendulum --initial theta'=3 --times 0,20 --events crossing,turning");
    let end = sample(&answer, 1)[0];
    // The start is one of the events, and a rotation never turns back.
    let turns = (1..100).take_while(|&turn| f64::from(turn) * std::f64::consts::TAU <= end).count();
    assert!(turns > 3);
    assert_eq!(events(&answer).len(), 1 + turns, "{end}");
}

#[test]
fn event_rows_stand_among_the_samples_in_the_order_of_time() {
    for (start, times) in [("theta=1", "0:10:0.25"), ("theta=1,theta'=0.5", "0:-10:-0.25")] {
        let table = text(&format!(
            "simulate pendulum --initial {start} --times {times} --events turning,crossing,theta-0.5 --csv"
        ));
        let rows: Vec<(f64, bool)> = table
            .lines()
            .skip(1)
            .map(|line| (line.split(',').next().unwrap().parse::<f64>().unwrap().abs(), !line.ends_with(',')))
            .collect();
        assert!(rows.is_sorted_by(|before, after| before.0 <= after.0), "{table}");
        assert_eq!(rows.iter().filter(|row| !row.1).count(), 41);
        assert!(rows.iter().filter(|row| row.1).count() > 5, "{table}");
    }
}

#[test]
fn the_end_of_a_formula_is_named_with_place_and_time() {
    // As in the library, by mpmath.
    for (equation, start, point, time) in [
        ("x'' = -exp(-1/x)", "x=1", "x = ", "t = 2.66631248"),
        ("x'' = -1 + atan(1/x)/10", "x=1", "x = ", "t = 1."),
    ] {
        let output = run(&["simulate", equation, "--initial", start, "--times", "0:2.8:0.4", "--json"]);
        assert_eq!(output.status.code(), Some(1), "{equation}");
        let message = message(&output);
        assert!(message.contains(point) && message.contains(time) && message.contains("x' = -"), "{message}");
        let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
        let samples = answer["samples"].as_array().unwrap();
        assert!(samples.iter().all(|sample| sample["state"][0].as_f64().unwrap() >= 0.0), "{answer}");
    }
}

#[test]
fn length_and_gravity_make_the_pendulum_that_of_other_commands() {
    let period = json("period 60deg --length 57cm --gravity 9.81")["period_s"].as_f64();
    let period = period.unwrap_or_else(|| {
        json("motion 60deg --length 57cm --gravity 9.81 --times 0")["period_s"].as_f64().unwrap()
    });
    for system in ["pendulum", "damped_pendulum", "driven_pendulum", "vertically_driven_pendulum"] {
        let question = format!("simulate {system} --length 57cm --gravity 9.81 --initial theta=60deg");
        let answer = json(&format!("{question} --times 0,{period:?} --tolerance 1e-14"));
        assert!((sample(&answer, 1)[0] - sample(&answer, 0)[0]).abs() < 1e-12, "{system}");
        let omega0 = answer["parameters"]["omega0"].as_f64().unwrap();
        assert!((omega0 - (9.81_f64 / 0.57).sqrt()).abs() < 1e-15, "{omega0}");
    }
    let double = json("simulate double_pendulum --length 2 --initial theta1=1 --times 0");
    let parameters = &double["parameters"];
    assert_eq!(
        [&parameters["l1"], &parameters["l2"], &parameters["g"]],
        [&Value::from(2.0), &2.0.into(), &9.80665.into()]
    );
    for (arguments, expected) in [
        ("pendulum --length 1 --set omega0=2", "--set"),
        ("physical_pendulum --length 1", "--set"),
        ("morse --length 1", "damped_pendulum"),
        ("coupled_pendulums --length 0m", "--length"),
    ] {
        let output = libration(&format!("simulate {arguments} --initial theta=1 --times 0"));
        assert_eq!(output.status.code(), Some(2), "{arguments}");
        assert!(message(&output).contains(expected), "{arguments}: {}", message(&output));
    }
    let sheet = text("simulate pendulum --initial theta=1 --times 0");
    assert!(sheet.contains("omega0 = 1") && sheet.contains("--length 1m"), "{sheet}");
    let sheet = text("simulate pendulum --length 1m --initial theta=1 --times 0");
    assert!(!sheet.contains("--length 1m"), "{sheet}");
}

#[test]
fn forces_next_to_poles_get_their_answer() {
    for (equation, initial, times) in [
        ("x''=1/(2-x)", "x=1.9,x'=1", "0,0.5"),
        ("x''=tan(x)", "x=1,x'=1", "0,0.2,5"),
        ("x''=1/(3-x)", "x=2.9,x'=1", "0,0.5"),
        ("x''=1/cos(x)", "x=1.5,x'=1", "0,0.5"),
        ("x''=1/(x-2)^2", "x=1.9,x'=1", "0,0.5"),
    ] {
        let output = run(&["simulate", equation, "--initial", initial, "--times", times, "--json"]);
        let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert!(output.status.code() == Some(1) && answer["stopped"].is_string(), "{equation}");
        // The part of the work of the forces that was not reached is reported.
        let [drift, uncertainty] =
            ["energy_drift", "energy_drift_uncertainty"].map(|name| answer[name].as_f64().unwrap());
        assert!(
            drift < 0.1 && uncertainty > 0.0 && uncertainty < 0.1,
            "{equation}: {drift:e} {uncertainty:e}"
        );
    }
}

#[test]
fn pictures_have_an_axis_for_each_unit() {
    let picture = directory("simulation").join("spring.svg");
    text(&format!(
        "simulate spring_pendulum --initial theta=0.5,r=1 --times 0:20:1 --events turning --figure {}",
        picture.display()
    ));
    let drawn = fs::read_to_string(&picture).unwrap();
    for label in ["time t / s", "r / m", "θ / degrees", "Motion of the spring pendulum"] {
        assert!(drawn.contains(label), "{label}");
    }
}

#[test]
fn formulas_are_columns_in_every_form() {
    let question = ["simulate", "x'' = -k*x", "--set", "k=4", "--initial", "x=1", "--times", "0:1:0.5"];
    let columns = ["--columns", "energy = x'^2/2 + k*x^2/2, x'', max(x, t)", "--events", "turning"];
    let ask = |form: &[&str]| {
        let output = run(&[&question[..], &columns, form].concat());
        assert!(output.status.success(), "{}", message(&output));
        String::from_utf8(output.stdout).unwrap()
    };
    let answer: Value = serde_json::from_str(&ask(&["--json"])).unwrap();
    assert_eq!(answer["columns"], serde_json::json!(["energy", "x''", "max(x, t)"]));
    for row in answer["samples"].as_array().unwrap().iter().chain(answer["events"].as_array().unwrap()) {
        let (x, time) = (row["state"][0].as_f64().unwrap(), row["time_s"].as_f64().unwrap());
        close(&row["columns"][0], 2.0, row["columns_error"][0].as_f64().unwrap());
        assert!(row["columns_error"][0].as_f64().unwrap() < 1e-14, "{row}");
        assert_eq!(row["columns"][1].as_f64(), Some(-4.0 * x));
        assert_eq!(row["columns"][2].as_f64(), Some(x.max(time)));
    }
    let table = ask(&["--csv"]);
    let mut lines = table.lines();
    let names = "time_s,x,x',energy,x'',\"max(x, t)\",time_error_s,x_error,x'_error,energy_error,x''_error,\"max(x, t)_error\",event";
    assert_eq!(lines.next(), Some(names));
    let first: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert_eq!(first[..6], ["0.0", "1.0", "0.0", "2.0", "-4.0", "1.0"]);
    assert!(unfolded(&ask(&[])).contains("max(x, t)"));
}

#[test]
fn columns_that_cannot_be_are_refused() {
    for (columns, reason) in [
        ("p = m*x'", "p: the system has no `m`: it has x, x', k, and the time t"),
        ("x = 2", "the name x is in use already"),
        ("a = 1, a = 2", "the name a is in use already"),
        ("e = (x", "e: at character 1: this bracket"),
        (" = x", "`= x` is not a formula"),
        ("e = ", "`e =` is not a formula"),
        ("x, ", "`` is not a formula"),
    ] {
        let question = ["simulate", "x'' = -k*x", "--set", "k=4", "--initial", "x=1", "--times", "1"];
        let output = run(&[&question[..], &["--columns", columns]].concat());
        assert_eq!(output.status.code(), Some(2), "{columns}");
        assert!(message(&output).contains(reason), "{columns}: {}", message(&output));
    }
}

#[test]
fn a_motion_ends_at_an_event() {
    let question = "simulate duffing_soft --initial x=0.1 --times 0:100:1";
    let until = "--until x=0 --direction rising --count 2";
    let answer = json(&format!("{question} {until} --set epsilon=0"));
    let expected = 3.5 * std::f64::consts::PI;
    let (time, error) = (&answer["until"]["time_s"], answer["until"]["time_error_s"].as_f64().unwrap());
    assert!((time.as_f64().unwrap() - expected).abs() <= error && error < 1e-10, "{answer}");
    assert_eq!(answer["samples"].as_array().unwrap().len(), 11);
    assert_eq!(answer["events"].as_array().unwrap().len(), 2);
    close(&answer["until"]["state"][1], 0.1, 1e-11);
    assert!(unfolded(&text(&format!("{question} {until}"))).contains("ends at t = "));
    let never = libration("simulate pendulum --initial theta=1 --times 0,5 --until theta=2");
    assert_eq!(never.status.code(), Some(1));
    assert!(message(&never).contains("`theta=2` does not occur before t = 5.0 s"), "{}", message(&never));
    for bad in ["--until y=0", "--until theta=0 --count 0", "--count 2", "--until theta=0=1"] {
        let output = libration(&format!("simulate pendulum --initial theta=1 --times 0,5 {bad}"));
        assert_eq!(output.status.code(), Some(2), "{bad}: {}", message(&output));
    }
}

/// Columns of continued runs equal those of one run, and the count of events continues.
#[test]
fn columns_and_counted_events_survive_a_stop() {
    let folder = directory("columns_and_counts");
    let (file, whole) = (folder.join("motion.csv"), folder.join("whole.csv"));
    let ask = |times: &str, file: &std::path::Path, more: &[&str]| {
        let file = file.to_str().unwrap();
        let question = ["simulate", "pendulum", "--initial", "theta=1", "--times", times, "--output", file];
        let asked = ["--columns", "e=theta'^2/2-cos(theta)", "--until", "theta=0", "--count", "9"];
        run(&[&question[..], &asked, more].concat())
    };
    ask("0:20:0.5", &file, &[]);
    let output = ask("0:80:0.5", &file, &["--resume", file.to_str().unwrap()]);
    assert!(output.status.success(), "{}", message(&output));
    assert!(ask("0:80:0.5", &whole, &[]).status.success());
    assert_eq!(fs::read_to_string(&file).unwrap(), fs::read_to_string(&whole).unwrap());
    let other = ["--resume", file.to_str().unwrap(), "--columns", "e=1"];
    let question = ["simulate", "pendulum", "--times", "0:90:0.5", "--until", "theta=0", "--count", "9"];
    let refused = run(&[&question[..], &other].concat());
    assert!(message(&refused).contains("--columns"), "{}", message(&refused));
}

/// x′ = x − x², which is 1/(1 + e⁻ᵗ), and a swing that is the same before and after its start.
#[test]
fn times_may_lie_on_both_sides_of_the_start() {
    let question = ["simulate", "x' = x - x^2", "--initial", "x=0.5", "--times=-10:10:2.5"];
    let output = run(&[&question[..], &["--json"]].concat());
    assert!(output.status.success(), "{}", message(&output));
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    let times: Vec<f64> =
        answer["samples"].as_array().unwrap().iter().map(|row| row["time_s"].as_f64().unwrap()).collect();
    assert_eq!(times, [-10.0, -7.5, -5.0, -2.5, 0.0, 2.5, 5.0, 7.5, 10.0]);
    for (index, time) in times.iter().enumerate() {
        let exact = 1.0 / (1.0 + (-time).exp());
        assert!((sample(&answer, index)[0] - exact).abs() < 1e-11 * exact, "{time}");
    }
    let swing =
        json("simulate pendulum --initial theta=1 --times=-7:7:7 --events crossing --tolerance 1e-14");
    let bits = |index: usize| sample(&swing, index)[0].to_bits();
    assert_eq!(bits(0), bits(2));
    assert!((sample(&swing, 0)[1] + sample(&swing, 2)[1]).abs() <= 0.0);
    let passed: Vec<f64> =
        swing["events"].as_array().unwrap().iter().map(|row| row["time_s"].as_f64().unwrap()).collect();
    assert!(passed.len() == 4 && passed.is_sorted(), "{passed:?}");
    assert!((passed[0] + passed[3]).abs() < 1e-12 && (passed[1] + passed[2]).abs() < 1e-12, "{passed:?}");
    assert!(swing["energy_drift"].as_f64().unwrap() < 1e-13);
    for option in ["--until theta=0", "--animate --figure swing.svg"] {
        let refused = libration(&format!("simulate pendulum --initial theta=1 --times=-1:1:1 {option}"));
        assert_eq!(refused.status.code(), Some(2), "{option}");
        assert!(message(&refused).contains("in one direction"), "{}", message(&refused));
    }
    let turned = libration("simulate pendulum --initial theta=1 --times=1,0,-1");
    assert_eq!(turned.status.code(), Some(2));
    assert!(message(&turned).contains("in ascending order"), "{}", message(&turned));
}

#[test]
fn each_coordinate_may_have_its_own_tolerance() {
    let question = |tolerance: &str, form: &str| {
        let words = ["simulate", "x''=-x; φ''=-900*φ", "--initial", "x=1,phi=1", "--times", "0,30"];
        run(&[&words[..], &["--tolerance", tolerance, form]].concat())
    };
    let answer = |tolerance| serde_json::from_slice::<Value>(&question(tolerance, "--json").stdout).unwrap();
    let (all, one) = (answer("1e-13"), answer("phi=1e-5, 1e-13"));
    let steps = |answer: &Value| answer["steps"].as_u64().unwrap();
    assert!(4 * steps(&one) < 3 * steps(&all), "{} of {}", steps(&one), steps(&all));
    close(&one["samples"][1]["state"][0], 30_f64.cos(), 1e-13);
    let missed = one["samples"][1]["state"][1].as_f64().unwrap() - 900_f64.cos();
    assert!((1e-10..1e-3).contains(&missed.abs()), "{missed}");
    assert_eq!(answer("phi=1e-13, x=1e-13")["samples"], all["samples"]);
    let sheet = unfolded(&String::from_utf8(question("φ=1e-5,1e-13", "--events=turning").stdout).unwrap());
    assert!(sheet.contains("tolerance 1e-13 per step, 1e-5 in phi"), "{sheet}");
    for (tolerance, reason) in [
        ("q=1e-3", "--tolerance: the system has no coordinate `q`: it has x, phi"),
        ("x'=1e-3", "the system has no coordinate `x'`"),
        ("x=1e-3,x=1e-4", "x has two tolerances"),
        ("1e-3,1e-4", "two tolerances without a name"),
        ("x=1", "give a number from 1e-18 to 0.1"),
        ("x=", "give a number from 1e-18 to 0.1"),
    ] {
        let output = question(tolerance, "--csv");
        assert!(output.status.code() == Some(2) && message(&output).contains(reason), "{}", message(&output));
    }
}

#[test]
fn runs_are_gone_on_with_to_the_same_tolerances() {
    let file = directory("own_tolerances").join("long.csv").display().to_string();
    let asked = |times: &str, tolerance: &str, resume: &[&str]| {
        let words =
            ["simulate", "x''=-x; y''=-9*y", "--times", times, "--tolerance", tolerance, "--output", &file];
        run(&[&words[..], resume].concat())
    };
    let whole = asked("0:20:1", "x=1e-8,y=1e-5", &["--initial", "x=1,y=1"]);
    assert!(whole.status.success(), "{}", message(&whole));
    let expected = fs::read(&file).unwrap();
    assert!(asked("0:9:1", "x=1e-8,y=1e-5", &["--initial", "x=1,y=1"]).status.success());
    let refused = asked("0:20:1", "x=1e-8", &["--resume", &file]);
    assert!(message(&refused).contains("give the --tolerance of that run"), "{}", message(&refused));
    let resumed = asked("0:20:1", "y=1e-5,x=1e-8", &["--resume", &file]);
    assert!(resumed.status.success(), "{}", message(&resumed));
    assert_eq!(fs::read(&file).unwrap(), expected);
}

#[test]
fn derivatives_by_parameters_and_starts_are_columns() {
    let question = ["simulate", "x''=-k*x", "--set", "k=4", "--initial", "x=1"];
    let asked = |more: &[&str]| run(&[&question[..], &["--sensitivity", "k, x'"], more].concat());
    let names = ["e", "dx/dk", "dx'/dk", "dx/dx'(0)", "dx'/dx'(0)"];
    let exact = |t: f64| {
        let (sin, cos) = (2.0 * t).sin_cos();
        [2.0, -t * sin / 4.0, -sin / 4.0 - t * cos / 2.0, sin / 2.0, cos]
    };
    for times in ["--times=0:5:1", "--times=0:-5:-1", "--times=-3:3:1"] {
        let more = [times, "--columns", "e=x'^2/2+k*x^2/2", "--events", "turning", "--json"];
        let answer: Value = serde_json::from_slice(&asked(&more).stdout).unwrap();
        assert_eq!(answer["columns"], serde_json::json!(names));
        assert!(answer["energy_drift"].as_f64().unwrap() < 1e-13);
        let rows = answer["samples"].as_array().unwrap().iter().chain(answer["events"].as_array().unwrap());
        for row in rows {
            assert_eq!(row["state"].as_array().unwrap().len(), 2);
            let exact = exact(row["time_s"].as_f64().unwrap());
            let columns = row["columns"].as_array().unwrap().iter().zip(exact);
            for ((computed, exact), error) in columns.zip(row["columns_error"].as_array().unwrap()) {
                let (off, error) = ((computed.as_f64().unwrap() - exact).abs(), error.as_f64().unwrap());
                // The rounding errors of the closed form.
                assert!(off <= error + 4e-15 && error < 1e-12, "{row}");
            }
        }
    }
    let csv = String::from_utf8(asked(&["--times", "0,1", "--csv"]).stdout).unwrap();
    let derivatives = "dx/dk,dx'/dk,dx/dx'(0),dx'/dx'(0)";
    let errors = derivatives.replace(',', "_error,");
    let zeros = "0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,0.0,0.0";
    let begin = format!("time_s,x,x',{derivatives},x_error,x'_error,{errors}_error\n{zeros}\n");
    assert!(csv.starts_with(&begin), "{csv}");
    let until = asked(&["--times", "0,9", "--until", "x = 0", "--json"]);
    let until: Value = serde_json::from_slice(&until.stdout).unwrap();
    assert_eq!(until["until"]["state"].as_array().unwrap().len(), 2);
}

#[test]
fn what_does_not_go_with_derivatives_of_the_motion_is_refused() {
    let asked = |options: &[&str]| {
        let question = ["simulate", "x''=-k/x^2", "--set", "k=1", "--initial", "x=1", "--times", "0,9"];
        message(&run(&[&question[..], options].concat()))
    };
    for (options, reason) in [
        (&["k", "--figure", "a.svg"][..], "--figure: it does not draw the derivatives of --sensitivity"),
        (&["k", "--resume", "a.json"], "--resume: states are kept without the derivatives"),
        (&["q"], "--sensitivity: the system has no parameter or state variable `q`: it has k, x, x'"),
        (&["k,x,k"], "--sensitivity: k is given twice"),
        (&["k", "--tolerance", "q=1e-9"], "the system has no coordinate `q`: it has x"),
    ] {
        let told = asked(&[&["--sensitivity"], options].concat());
        assert!(told.contains(reason) && !told.contains("delta"), "{options:?}: {told}");
    }
    let stopped = asked(&["--sensitivity", "k"]);
    assert!(stopped.contains("t = 1.11") && !stopped.contains("delta"), "{stopped}");
    let friction =
        ["simulate", "x''=-x-sign(x')/9", "--initial", "x=1", "--times", "0,1", "--sensitivity", "x"];
    assert!(message(&run(&friction)).contains("a force jumps where x' is zero"));
}

/// At t = 10 and 50, from `state_errors.csv` (`reference/state_errors.py`).
const TRUTH: [[f64; 4]; 2] = [
    [2.251330516205132145295, 1.288484491003162599902, 0.447226772579647563582, 0.194474924043406667387],
    [-2.446185634339284863574, -23.92666652141450953403, 0.269643446868338875056, 0.456626431080599767355],
];

#[test]
fn chaotic_motions_have_errors_as_far_as_they_are_determined() {
    let question = "simulate double_pendulum --initial theta1=2,theta2=2 --times 10,50,80,100";
    let answer = json(question);
    let until = answer["determined_until_s"].as_f64().unwrap();
    assert!((60.0..80.0).contains(&until), "{until}");
    let samples = answer["samples"].as_array().unwrap();
    let have_errors: Vec<bool> = samples.iter().map(|sample| error(sample).is_some()).collect();
    assert_eq!(have_errors, [true, true, false, false]);
    for (index, truth) in TRUTH.into_iter().enumerate() {
        let errors = error(&samples[index]).unwrap();
        for ((computed, truth), error) in sample(&answer, index).iter().zip(truth).zip(errors) {
            let off = (computed - truth).abs();
            assert!(off <= error && error < 1e-3, "{index}: {off:e} {error:e}");
        }
    }
    // The values beyond the limit, which are not printed, are far from the truth, -5.163773181 and -38.317931200.
    assert!((sample(&answer, 3)[0] + 5.163773181).abs() > 0.1);
    let sheet = unfolded(&text(question));
    assert!(sheet.contains("not determined in double precision after t = 7"), "{sheet}");
    assert!(sheet.contains("2 rows after it are left out") && !sheet.contains("\n 100 "), "{sheet}");
    assert!(sheet.contains("half a unit in the last place of the start"), "{sheet}");
    let table = text(&format!("{question} --csv"));
    assert!(table.lines().nth(4).unwrap().ends_with(",,,,"), "{table}");
}

#[test]
fn without_errors_the_answer_says_so() {
    let question = "simulate pendulum --initial theta=1 --times 0,5";
    let answer = json(&format!("{question} --no-errors"));
    assert_eq!(answer["no_errors"], "--no-errors");
    assert!(answer["samples"][1]["error"].is_null() && answer["half_ulp_of_start"].is_null(), "{answer}");
    assert_eq!(answer["samples"][1]["state"], json(question)["samples"][1]["state"]);
    assert!(text(&format!("{question} --no-errors")).contains("not estimated (--no-errors)"));
    assert!(!text(question).contains("not estimated"));
    let until = json(&format!("{question} --no-errors --until theta=0"));
    assert!(until["until"]["time_s"].is_number() && until["until"]["time_error_s"].is_null(), "{until}");
}

/// The digits end where the error begins: at t = 50 four of thirteen remain. The state and a formula are in one row.
#[test]
fn no_digits_are_shown_beyond_the_error() {
    let question = "simulate double_pendulum --initial theta1=2,theta2=2 --times 0:60:10 --columns y=sin(theta1)+sin(theta2)";
    let answer = json(question);
    let sheet = text(question);
    let rows: Vec<Vec<&str>> = sheet.lines().map(|line| line.split_whitespace().collect()).collect();
    for (index, sample) in answer["samples"].as_array().unwrap().iter().enumerate().skip(1) {
        let time = format!("{}", sample["time_s"].as_f64().unwrap());
        let row = rows.iter().find(|row| row.len() == 6 && row[0] == time).unwrap();
        let of_column = sample["columns_error"][0].as_f64().unwrap();
        let errors = error(sample).unwrap().into_iter().chain([of_column]);
        for (cell, error) in row[1..].iter().zip(errors) {
            let places = cell.split_once('.').map_or(0, |(_, places)| places.len());
            let last = 10_f64.powi(-i32::try_from(places).unwrap());
            assert!(last > 0.1 * error, "{index}: {cell} with an error of {error:e}");
        }
    }
}

/// Sixty degrees and pi/3 differ at most in the last digit.
#[test]
fn a_start_on_an_event_does_not_cross_it() {
    for (question, expected) in [
        ("--initial theta=60deg --times 0,5 --events theta-pi/3", vec!["theta - pi/3, at the start"]),
        ("--initial theta=-60deg --times 0,5 --events theta+pi/3", vec!["theta + pi/3, at the start"]),
        ("--initial theta=60deg --times 0,-5 --events pi/3-theta", vec!["pi/3 - theta, at the start"]),
    ] {
        let computed: Vec<String> = events(&json(&format!("simulate pendulum {question}")))
            .into_iter()
            .map(|(_, kind)| kind)
            .collect();
        assert_eq!(computed, expected, "{question}");
    }
    let until = "simulate pendulum --initial theta=60deg --times 0,20 --until theta=pi/3 --direction falling";
    let output = libration(until);
    assert_eq!(output.status.code(), Some(1), "{}", message(&output));
}

#[test]
fn commas_in_brackets_separate_nothing() {
    let run_all = |arguments: &[&str]| {
        let output = run(&[arguments, &["--json"]].concat());
        assert!(output.status.success(), "{arguments:?}: {}", message(&output));
        serde_json::from_slice::<Value>(&output.stdout).unwrap()
    };
    let question = ["simulate", "pendulum", "--initial", "theta=max(1, 0.5)", "--times", "0,5"];
    let answer = run_all(&[&question[..], &["--events", "max(theta,0.1)-0.2,turning"]].concat());
    close(&answer["samples"][0]["state"][0], 1.0, 0.0);
    let kinds: Vec<String> = events(&answer).into_iter().map(|(_, kind)| kind).collect();
    assert_eq!(kinds.len(), 3, "{kinds:?}");
    let set = ["simulate", "x'' = -k*x", "--set", "k=max(4, 1)", "--initial", "x=1", "--times", "1"];
    assert!((sample(&run_all(&set), 0)[0] - 2_f64.cos()).abs() < 1e-12);
    let over = [
        "bifurcation",
        "driven_pendulum",
        "--set",
        "c=1/2",
        "--over",
        "A=max(0.1, 0),0.2",
        "--initial",
        "theta=0.2",
    ];
    run_all(&[&over[..], &["--points", "2", "--skip", "2"]].concat());
}

/// The continued run has the same bytes, for forces with jumps and where the motion is no longer determined.
#[test]
fn errors_survive_a_stop() {
    let folder = directory("errors_survive");
    for (name, system, initial, first, whole) in [
        ("friction", "x'' = -x - sign(x')/100", "x=1", "0:5:0.5", "0:20:0.5"),
        ("clearance", "x'' = -x - max(x - 0.5, 0)", "x=1", "0:9:0.5", "0:20:0.5"),
        ("lost", "theta'' = -sin(theta)", "theta=3.14159265", "0:70:5", "0:90:5"),
    ] {
        let columns = ["--columns", "a = 2*t, max(t, 3), d = t^2"];
        for (form, columns) in [("csv", &[][..]), ("json", &[]), ("csv", &columns), ("json", &columns)] {
            let files = ["part", "whole"].map(|part| folder.join(format!("{name}_{part}.{form}")));
            let [part, other] = files.each_ref().map(|file| file.to_str().unwrap());
            let ask = |times: &str, more: &[&str]| {
                let question = ["simulate", system, "--initial", initial, "--times", times];
                let output = run(&[&question[..], &["--events", "turning"], columns, more].concat());
                assert!(output.status.success(), "{name}: {}", message(&output));
            };
            ask(first, &["--output", part]);
            ask(whole, &["--resume", part, "--output", part]);
            ask(whole, &["--output", other]);
            let [resumed, at_once] = files.map(|file| fs::read_to_string(file).unwrap());
            assert_eq!(resumed, at_once, "{name} {form}");
        }
    }
    let part = folder.join("friction_part.csv");
    let question =
        ["simulate", "x'' = -x - sign(x')/100", "--times", "0:30:0.5", "--events", "turning", "--no-errors"];
    let refused = run(&[&question[..], &["--resume", part.to_str().unwrap()]].concat());
    assert!(message(&refused).contains("leave out --no-errors"), "{}", message(&refused));
}

/// 1/x′ at a start from rest and the logarithm of a negative number, in a table of one motion and in one of several.
#[test]
fn cells_without_a_finite_number_are_empty_in_csv() {
    let columns = "p = 1/x', q = ln(x - 2), r = x";
    let one =
        run(&["simulate", "x'' = -x", "--initial", "x=1", "--times", "0,1", "--columns", columns, "--csv"]);
    let one = String::from_utf8(one.stdout).unwrap();
    let lines: Vec<&str> = one.lines().collect();
    assert!(lines[0].starts_with("time_s,x,x',p,q,r,"), "{one}");
    assert!(lines[1].starts_with("0.0,1.0,0.0,,,1.0,"), "{one}");
    let cells: Vec<&str> = lines[2].split(',').collect();
    assert!(cells[3].parse::<f64>().is_ok_and(f64::is_finite) && cells[4].is_empty(), "{one}");
    let file = directory("simulate-not-finite").join("motions.csv");
    fs::write(&file, "x\n1\n").unwrap();
    let each = file.display().to_string();
    let many =
        run(&["simulate", "x'' = -x", "--each", &each, "--times", "0,1", "--columns", columns, "--csv"]);
    let many = String::from_utf8(many.stdout).unwrap();
    assert!(many.lines().nth(1).unwrap().contains("0.0,1.0,0.0,,,1.0"), "{many}");
    for word in ["nan", "NaN", "inf"] {
        assert!(!one.contains(word) && !many.contains(word), "{word}");
    }
}
