//! `libration response` and `libration orbit`.

use crate::command::{json, libration, message, run, text};
use serde_json::Value;

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or_else(|| panic!("{name} in {value}"))
}

#[test]
fn a_response_has_the_fields_of_the_contract() {
    let answer = json("response driven_pendulum --set A=0.15,c=0.1 --over omega=0.7:1");
    assert_eq!((&answer["parameter"], &answer["coordinate"]), (&"omega".into(), &"theta".into()));
    let branch = &answer["branches"][0];
    assert_eq!(
        (&branch["kind"], &branch["closed"], &branch["symmetric"]),
        (&"primary".into(), &false.into(), &true.into())
    );
    let points = branch["points"].as_array().unwrap();
    assert_eq!((number(&points[0], "parameter"), number(points.last().unwrap(), "parameter")), (0.7, 1.0));
    for point in points {
        assert!(number(point, "amplitude_max") > 0.0 && number(point, "error") < 1e-9, "{point}");
        assert!(
            (number(point, "period_s") * number(point, "parameter") - std::f64::consts::TAU).abs() < 1e-12
        );
        let sizes = point["multipliers"]
            .as_array()
            .unwrap()
            .iter()
            .map(|parts| parts[0].as_f64().unwrap().hypot(parts[1].as_f64().unwrap()));
        let is_attracting = sizes.fold(0.0, f64::max) < 1.0;
        assert_eq!(point["stability"], if is_attracting { "attracting" } else { "unstable" });
    }
    let special = branch["special"].as_array().unwrap();
    let folds: Vec<&Value> = special.iter().filter(|point| point["kind"] == "fold").collect();
    assert_eq!(folds.len(), 2);
    // By Fourier collocation and by shooting in 130-bit floats.
    assert!((number(folds[0], "parameter") - 0.8721575691379171688795389).abs() < 1e-13);
    assert!(
        (number(folds[0], "amplitude_max") - 0.910968343596304066).abs() < 1e-12
            && number(folds[0], "error") < 1e-13
    );
    let jumps = answer["jumps"].as_array().unwrap();
    assert_eq!(jumps.iter().map(|jump| jump["sweep"].as_str().unwrap()).collect::<Vec<_>>(), ["up", "down"]);
    // From SciPy's DOP853 and fsolve.
    let landing = (jumps[0]["to"][0].as_f64().unwrap(), jumps[0]["to_error"][0].as_f64().unwrap());
    assert!((landing.0.to_degrees() - 89.119173515280).abs() < 1e-9 && landing.1 < 1e-12, "{landing:?}");
}

#[test]
fn a_response_is_told_in_words() {
    let told = text("response driven_pendulum --set A=0.15,c=0.1 --over omega=0.7:1");
    let words = told.split_whitespace().collect::<Vec<_>>().join(" ");
    for part in [
        "Upwards in omega the solution jumps up at omega = 0.872158, from 52.195° to 89.119°",
        "Downwards in omega the solution jumps down at omega = 0.780633, from 106.32° to 22.624°",
        "fold 1 0.872157569137917",
    ] {
        assert!(words.contains(part), "{part} in {told}");
    }
    let csv = text("response driven_pendulum --set A=0.15,c=0.1 --over omega=0.7:1 --csv");
    let rows: Vec<Vec<&str>> = csv.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let fold = rows.iter().position(|row| row[1] == "fold").unwrap();
    // Beyond both neighbours, one of which is stable.
    let value = |row: usize| rows[row][2].parse::<f64>().unwrap();
    assert!(value(fold) > value(fold - 1) && value(fold) > value(fold + 1));
    assert_eq!((rows[fold - 1][5], rows[fold + 1][5]), ("attracting", "unstable"));
}

#[test]
fn limit_cycles_are_followed_to_their_hopf_points() {
    let brusselator = "x' = 1 + x^2 y - (b + 1) x; y' = b x - x^2 y";
    let output = run(&["response", brusselator, "--over", "b=1.5:3", "--json"]);
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    let branch = &answer["branches"][0];
    assert_eq!((&branch["beginning"], &branch["ending"]), (&"range_end".into(), &"rest".into()));
    let special = &branch["special"].as_array().unwrap()[..];
    assert!(special.len() == 1 && special[0]["kind"] == "hopf", "{special:?}");
    assert!((number(&special[0], "parameter") - 2.0).abs() < 1e-14);
    for point in branch["points"].as_array().unwrap() {
        let multipliers = point["multipliers"].as_array().unwrap().iter();
        let errors = point["multiplier_errors"].as_array().unwrap();
        let is_one = |(multiplier, error): (&Value, &Value)| {
            let stated = error.as_f64().unwrap();
            stated < 1e-12 && (multiplier[0].as_f64().unwrap() - 1.0).abs() <= stated.max(1e-15)
        };
        assert!(multipliers.zip(errors).any(is_one), "{point}");
    }
    let told = text("response van_der_pol --over mu=0.5:2 --digits 20");
    assert!(told.contains("symmetric, limit cycle:"), "{told}");
    let refused = libration("response van_der_pol --over mu=0.5:2 --drive-periods 2");
    assert!(!refused.status.success() && message(&refused).contains("no drive"), "{}", message(&refused));
}

#[test]
fn special_points_have_the_digits_that_are_asked_for() {
    let question =
        "response driven_pendulum --set A=0.15,c=0.1 --over omega=0.86:0.88 --generations 0 --digits 25";
    // By Fourier collocation and by shooting in 130-bit floats.
    let fold = "0.8721575691379171688795389";
    let answer = json(question);
    let special = &answer["branches"][0]["special"][0];
    assert_eq!(special["parameter_digits"], fold);
    assert!(number(special, "parameter_digits_error") < 1e-25, "{special}");
    let told = text(question);
    assert!(told.contains(&format!("fold on branch 1: omega = {fold} to ")), "{told}");
}

#[test]
fn a_curve_that_closes_is_found_from_a_value_within_the_range() {
    let duffing = "x'' = -0.15*x' - x - x^3 + 5*cos(w*t)";
    let start = ["--drive-periods", "3", "--initial", "x=1.4,x'=1.5", "--generations", "0", "--json"];
    let ask = |at: &str| run(&[&["response", duffing, "--over", "w=2.5:6", "--at", at], &start[..]].concat());
    let output = ask("4.5");
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(answer["branches"][0]["closed"], true, "{}", message(&output));
    let outside = ask("7");
    assert_eq!(outside.status.code(), Some(2));
    assert!(message(&outside).contains("--at") && message(&outside).contains("outside the range"));
}

#[test]
fn a_response_to_the_frequency_zero_and_over_the_top_is_named() {
    let slow = text("response driven_pendulum --set A=0.15,c=0.1 --over omega=0:1 --generations 0");
    assert!(
        slow.split_whitespace().collect::<Vec<_>>().join(" ").contains("continues to zero frequency"),
        "{slow}"
    );
    let over = text("response driven_pendulum --set A=0.2,c=0.1 --over omega=0.3:1.4 --generations 0");
    assert!(over.split_whitespace().collect::<Vec<_>>().join(" ").contains("beyond the top"), "{over}");
}

#[test]
fn answers_of_an_order_are_found_or_the_reason_is_told() {
    let ask = |c: &str, forms: &[&str]| {
        let duffing = format!("x'' = -{c}*x' - x - x^3 + 5*cos(w*t)");
        let orders = ["--over", "w=3:6", "--orders", "1/3,2/4", "--generations", "0"];
        let output = run(&[&["response", &duffing], &orders[..], forms].concat());
        assert!(output.status.success(), "{}", message(&output));
        String::from_utf8(output.stdout).unwrap()
    };
    let answer: Value = serde_json::from_str(&ask("0.15", &["--json"])).unwrap();
    let isola = &answer["branches"][1];
    assert_eq!(
        (&isola["kind"], &isola["closed"], &isola["drive_periods"]),
        (&"free_oscillation".into(), &true.into(), &3.into())
    );
    let [third, half] = &answer["orders"].as_array().unwrap()[..] else { panic!("{}", answer["orders"]) };
    assert_eq!(third, &serde_json::json!({"order": "1/3", "branches": 1, "finding": "found", "share": null}));
    assert_eq!((&half["order"], &half["finding"]), (&"1/2".into(), &"no_work".into()));
    let told = ask("0.6", &[]).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        told.contains("order 1/3: to first order, the drive supplies at most ")
            && told.contains(" % of the energy lost to damping"),
        "{told}"
    );
    for (orders, reason) in [("0/3", "two whole numbers from 1 to 100"), ("a", "two whole numbers")] {
        let refused = libration(&format!("response driven_pendulum --over omega=1:2 --orders {orders}"));
        assert!(
            refused.status.code() == Some(2) && message(&refused).contains(reason),
            "{}",
            message(&refused)
        );
    }
    let refused = libration("response van_der_pol --over mu=0.5:2 --orders 1/3");
    assert!(message(&refused).contains("no drive"), "{}", message(&refused));
}

#[test]
fn answers_that_go_around_are_followed() {
    let question = "response driven_pendulum --set c=0.5,A=2 --over omega=0.8:1 --turns 1 --generations 1";
    let answer = json(question);
    let branches = answer["branches"].as_array().unwrap();
    let turns = |value: &Value| (value["turns"].as_i64().unwrap(), value["drive_periods"].as_i64().unwrap());
    // Two branches at the lower end, one of which is unstable throughout, and the secondary branch.
    assert_eq!(branches.iter().map(turns).collect::<Vec<_>>(), [(1, 1), (1, 1), (2, 2)]);
    // By Taylor shooting in 40 digits.
    let doubling = &branches[0]["special"][0];
    assert!((number(doubling, "parameter") - 0.847446163297482).abs() < 1e-13, "{doubling}");
    assert!(
        branches[0]["points"].as_array().unwrap().iter().all(|point| number(point, "amplitude_max") < 3.0)
    );
    let words = text(question).split_whitespace().collect::<Vec<_>>().join(" ");
    for part in
        ["one turn in a period of the drive", "2 turns in 2 periods of the drive", "from uniform rotation"]
    {
        assert!(words.contains(part), "{part} in {words}");
    }
    let cases = [
        ("response driven_pendulum --over omega=0.8:1 --turns 0", 2, "whole number from 1 to 100"),
        ("response driven_pendulum --set c=0.5,A=0.1 --over omega=0.8:1 --turns 1", 2, "a stronger drive"),
        ("response duffing --over epsilon=1:2 --turns 1", 1, "no drive"),
    ];
    for (question, status, reason) in cases {
        let refused = libration(question);
        assert!(
            refused.status.code() == Some(status) && message(&refused).contains(reason),
            "{}",
            message(&refused)
        );
    }
}

#[test]
fn slow_sweeps_are_listed_where_they_are_asked_for() {
    let question = "response driven_pendulum --set A=0.15,c=0.1 --over omega=0.7:1";
    assert_eq!(json(question)["sweeps"], serde_json::json!([]));
    let answer = json(&format!("{question} --sweeps 4"));
    let sweeps = answer["sweeps"].as_array().unwrap();
    let values: Vec<(&str, f64)> = sweeps
        .iter()
        .map(|sweep| (sweep["direction"].as_str().unwrap(), number(sweep, "parameter")))
        .collect();
    let expected = [("up", [0.7, 0.8, 0.9, 1.0]), ("down", [1.0, 0.9, 0.8, 0.7])];
    let expected = expected.iter().flat_map(|(way, all)| all.iter().map(move |value| (*way, *value)));
    assert!(expected.zip(&values).all(|(a, b)| a.0 == b.0 && (a.1 - b.1).abs() < 1e-15), "{values:?}");
    // At 0.8 both responses exist: below 30° in the upward sweep, above 100° in the downward one.
    let at = |index: usize| number(&sweeps[index], "amplitude_max").to_degrees();
    assert!(at(1) < 30.0 && at(6) > 100.0, "{sweeps:?}");
    let csv = text(&format!("{question} --sweeps 4 --csv"));
    assert!(csv.lines().next().unwrap().ends_with(",error,sweep"), "{csv}");
    assert_eq!(csv.lines().filter(|line| line.ends_with(",up")).count(), 4);
    let table = text(&format!("{question} --sweeps 4"));
    assert!(table.lines().filter(|line| line.trim_start().starts_with("down ")).count() == 4, "{table}");
    let refused = libration("response van_der_pol --over mu=0.5:2 --sweeps 4");
    assert!(refused.status.code() == Some(2) && message(&refused).contains("nothing drives"));
}

#[test]
fn an_orbit_of_each_kind_is_told() {
    let kind = |question: &str| json(question)["kind"].as_str().unwrap().to_owned();
    assert_eq!(kind("orbit driven_pendulum --set A=0.15,c=0.1,omega=0.82"), "driven");
    assert_eq!(kind("orbit pendulum --initial theta=60deg"), "released");
    assert_eq!(kind("orbit pendulum --initial theta'=1.9"), "family");
    assert_eq!(kind("orbit van_der_pol --initial x=0.5"), "limit_cycle");
    assert_eq!(kind("orbit x'=10*(y-x);y'=x*(28-z)-y;z'=x*y-8/3*z --initial x=1,y=1,z=20"), "passed");
    assert_eq!(kind("orbit lotka_volterra --initial x=1,y=2 --period 6.5"), "family");
    let near = "orbit double_pendulum --period 8 --initial theta1=0.1,theta2=0.141";
    assert_eq!(kind(near), "near");
}

#[test]
fn a_response_that_repeats_earlier_says_so() {
    let notes = |periods: &str| {
        message(&libration(&format!("orbit x''+0.1*x'+x+x^3=cos(t) --initial x=1 {periods}")))
    };
    assert!(notes("--drive-periods 6").contains("repeats after 1 of 6 periods of the drive"));
    assert!(notes("--period 12.566").contains("repeats after 1 of 2 periods"));
    assert!(notes("--period 10").contains("--period: the force does not repeat after 10.0"));
    assert_eq!(notes("--drive-periods 1"), "");
    // This one has three periods of the drive in its own.
    let subharmonic = "orbit x''+0.05*x'+x+x^3=5*cos(9*t) --drive-periods 3 --initial x=3";
    assert_eq!(message(&libration(subharmonic)), "");
}

#[test]
fn only_a_drive_sets_the_period_and_digits_end_where_the_error_begins() {
    let sheet = text("orbit lotka_volterra --initial x=2,y=1");
    for part in ["one of a family, through the start", "6.60848267123506 s, to 2e-14", "x = 2.0000000000000"]
    {
        assert!(sheet.contains(part), "{part}: {sheet}");
    }
    let closed = text("orbit kepler --period 6.28 --initial x=0.5,y'=1.7320508");
    for sheet in [&sheet, &closed, &text("orbit x'=y;y'=-x --initial x=1")] {
        assert!(!sheet.contains("drive") && !sheet.contains("limit cycle"), "{sheet}");
    }
    let driven = text("orbit driven_pendulum --set A=0.15,c=0.1,omega=0.82");
    assert!(driven.contains("set by the drive"), "{driven}");
    // The error of the period of a small swing is that of its position near the equilibrium, where a rounding of 2e-16 is 2e-12 of the swing.
    let small = text("orbit lotka_volterra --initial x=1.0001,y=1");
    assert!(small.contains(" 6.28318531242 s, to 3e-11"), "{small}");
}

#[test]
fn a_drive_that_is_off_is_named() {
    for question in [
        "response driven_pendulum --set c=0.1,omega=0.8 --over omega0=0.5:1.5",
        "orbit driven_pendulum --set c=0.1,omega=0.8 --initial theta=1",
    ] {
        let output = libration(question);
        assert_eq!(output.status.code(), Some(1), "{question}");
        for part in ["since A = 0", "--set A=0.1"] {
            assert!(message(&output).contains(part), "{question}: {}", message(&output));
        }
    }
}

#[test]
fn what_cannot_be_is_refused_with_what_would_do() {
    let cases: [(&[&str], i32, &[&str]); 8] = [
        (&["response", "pendulum", "--over", "omega0=1:2"], 1, &["family", "libration backbone"]),
        (&["response", "driven_pendulum", "--over", "omega=1"], 2, &["--over", "omega=0.3:1.4"]),
        (&["response", "driven_pendulum", "--over", "omega=1:1"], 2, &["--over", "no width"]),
        (&["response", "driven_pendulum", "--over", "b=1:2"], 2, &["--over", "b"]),
        (
            &["response", "driven_pendulum", "--over", "omega=1:2", "--coordinate", "x"],
            2,
            &["--coordinate", "theta"],
        ),
        (&["orbit", "pendulum"], 2, &["--initial", "theta=60deg"]),
        (&["orbit", "double_pendulum", "--initial", "theta1=1"], 2, &["--period", "no period is known"]),
        (
            &["orbit", "pendulum", "--initial", "theta=1", "--drive-periods", "2"],
            2,
            &["--drive-periods", "no drive"],
        ),
    ];
    for (arguments, status, parts) in cases {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {}", message(&output));
        for part in parts {
            assert!(message(&output).contains(part), "{arguments:?}: {}", message(&output));
        }
    }
}
