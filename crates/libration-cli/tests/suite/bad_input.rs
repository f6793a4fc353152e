//! Bad input gets a message with the argument, the value and the remedy.

use crate::command::{json, libration, message};
use libration_queries::{ParameterKind, ParameterType, questions};

/// Arguments, exit status, and parts of the message.
const CASES: [(&str, i32, &[&str]); 54] = [
    ("period nan", 2, &["AMPLITUDE", "nan"]),
    ("period inf", 2, &["AMPLITUDE", "inf"]),
    ("period -inf", 2, &["AMPLITUDE", "-inf", "60deg"]),
    ("period 60deg --length 1e-320 --gravity 1e300", 1, &["length 1e-320 m", "1e-290 to 1e290"]),
    ("motion 60deg --velocity 1e200", 1, &["energy", "too fast"]),
    ("fourier 60deg --harmonics 1e9", 2, &["--harmonics", "1e9", "whole number"]),
    ("formulas --amplitude 179.999deg --tolerance 1e-9", 1, &["1e-9", "larger"]),
    ("period 60furlongs", 2, &["AMPLITUDE", "60furlongs", "60deg"]),
    ("period 180deg", 1, &["AMPLITUDE", "below pi"]),
    ("period 200deg", 1, &["AMPLITUDE", "below pi"]),
    ("period 0deg:180deg:1deg", 1, &["AMPLITUDE", "below pi"]),
    ("period 0:3:1e-12", 2, &["elements", "larger step"]),
    ("period 0deg:90deg:0deg", 2, &["step"]),
    ("period 1:2", 2, &["START:STOP:STEP"]),
    ("period 60deg --length -1m", 2, &["'-1m'", "--length", "above zero"]),
    ("period 60deg --length 0", 2, &["--length", "above zero"]),
    ("period 60deg --length nan", 2, &["--length", "nan"]),
    ("period 60deg --length 1s", 2, &["--length", "1s", "a length"]),
    ("period 60deg --gravity 9.81m", 2, &["--gravity", "9.81m"]),
    ("period 60deg --gravity inf", 2, &["--gravity", "inf"]),
    ("period 60deg --formulas bernouli", 2, &["bernouli", "bernoulli"]),
    ("period 60deg --json --csv", 2, &["cannot be used with"]),
    ("period", 2, &["required"]),
    ("period --from-file /nonexistent/file", 1, &["/nonexistent/file"]),
    ("motion 60deg --velocity fast", 2, &["--velocity", "fast"]),
    ("motion 60deg --times 0:1e12:1", 2, &["--times", "larger step"]),
    ("motion 60deg --times 0:1:-0.1", 2, &["--times", "leads away"]),
    ("motion 60deg --velocity 1 --compare small-angle", 1, &["--compare", "released from rest"]),
    ("motion 200deg --compare fourier-3", 1, &["--compare", "between"]),
    ("motion 60deg --compare fourier-4", 2, &["fourier-4", "fourier-3"]),
    ("fourier 60deg --harmonics 0", 2, &["--harmonics"]),
    ("fourier 60deg --tolerance -1", 2, &["--tolerance", "above zero"]),
    ("formulas --amplitude 60deg", 2, &["--tolerance"]),
    ("figure errors --output errors.gif", 2, &["--output", ".svg", ".pdf", ".png"]),
    ("simulate pendulum --times 0,1", 2, &["--initial", "theta=60deg", "theta, theta'"]),
    ("simulate pendulum --initial theta=60deg", 2, &["--times"]),
    ("simulate penduum --initial theta=1 --times 0,1", 2, &["SYSTEM|EQUATION", "pendulum"]),
    ("simulate pendulum --initial x=1 --times 0,1", 2, &["--initial", "`x`", "theta, theta'"]),
    ("simulate pendulum --initial theta --times 0,1", 2, &["--initial", "NAME=VALUE"]),
    ("simulate pendulum --initial theta=1,theta=2 --times 0,1", 2, &["--initial", "twice"]),
    ("simulate pendulum --initial theta=60furlongs --times 0,1", 2, &["--initial", "60furlongs", "60deg"]),
    ("simulate pendulum --initial theta=1 --times 1,0.5", 2, &["--times", "follows"]),
    ("simulate pendulum --initial theta=1 --times 0,1 --tolerance 1", 2, &["--tolerance", "1e-18"]),
    ("simulate pendulum --initial theta=1 --times 0,1 --set c=1", 2, &["--set", "omega0"]),
    ("simulate x''=-k*x --initial x=1 --times 0,1", 2, &["--set", "k=0.1"]),
    ("simulate pendulum --initial theta=1 --times 0,1 --resume /nonexistent/file", 1, &["/nonexistent/file"]),
    ("simulate pendulum --initial theta=1 --times 0,1 --output /nonexistent/file", 1, &["/nonexistent/file"]),
    (
        "simulate pendulum --initial theta=1 --times 0,1 --events y-1",
        2,
        &["--events", "`y`", "theta, theta'"],
    ),
    (
        "simulate pendulum --initial theta=1 --times 0,1 --events turn(1)",
        2,
        &["--events", "turning, crossing"],
    ),
    // Axes exist only in a picture.
    ("section pendulum --initial theta=1 --period 1 --points 2 --axes theta,x", 2, &["--figure"]),
    ("bifurcation driven_pendulum --over A=1 --initial theta=1 --points 2 --axis x", 2, &["--figure"]),
    ("systems nothing", 2, &["KEY", "nothing"]),
    ("list nothing", 2, &["CATALOGUE|KEY", "nothing", "libration list shows all keys"]),
    ("fit periods /nonexistent/file", 1, &["/nonexistent/file"]),
];

#[test]
fn each_is_refused_with_its_exit_status_and_a_message_that_helps() {
    for (arguments, status, parts) in CASES {
        let output = libration(arguments);
        let message = message(&output);
        assert_eq!(output.status.code(), Some(status), "{arguments}: {message}");
        assert!(output.stdout.is_empty(), "{arguments}");
        assert!(message.starts_with("error: "), "{arguments}: {message}");
        for part in parts {
            assert!(message.contains(part), "{arguments}: `{part}` is not in: {message}");
        }
    }
}

#[test]
fn every_whole_number_is_asked_for_as_one() {
    let mut asked = 0;
    for question in questions() {
        let options = question.parameters.iter().filter(|parameter| parameter.kind == ParameterKind::Option);
        for option in options.filter(|option| option.value_type == ParameterType::Integer) {
            let arguments = format!("{} --{}=x", question.words, option.name);
            let message = message(&libration(&arguments));
            assert!(message.contains("whole number"), "{arguments}: {message}");
            asked += 1;
        }
    }
    assert!(asked > 30, "{asked}");
}

#[test]
fn messages_have_no_colour_when_nobody_looks() {
    assert!(!message(&libration("period nan")).contains('\u{1b}'));
}

#[test]
fn what_is_very_long_is_not_repeated_whole() {
    let long = "x".repeat(10_000);
    let sum = "x + ".repeat(2500);
    let cases: Vec<Vec<&str>> = vec![
        vec!["period", &long],
        vec!["period", "60deg", "--formulas", &long],
        vec!["motion", "60deg", "--times", &long],
        vec!["expand", &long],
        vec!["expand", "x'' + x = 0", "--about", &long],
        vec!["expand", "x'' + x = 0", "--set", &long],
        vec!["expand", "x'' + x = 0", "--evaluate", &long],
        vec!["expand", "pendulum", "--about", &sum],
        vec!["backbone", "duffing", "--amplitudes", &long],
        vec!["simulate", &long, "--initial", "x=1", "--times", "1"],
        vec!["simulate", "pendulum", "--initial", &long, "--times", "1"],
        vec!["simulate", "pendulum", "--initial", "theta=1", "--times", "1", "--events", &long],
        vec!["modes", "pendulum", "--about", &long],
        vec!["paper", "--only", &long],
        vec!["list", &long],
        vec!["fit", "periods", &long],
        vec![&long],
    ];
    for arguments in cases {
        let output = crate::command::run(&arguments);
        let message = message(&output);
        assert!(!output.status.success(), "{:?}", &arguments[..1]);
        assert!(message.chars().count() < 3000, "{}", message.chars().take(400).collect::<String>());
    }
}

#[test]
fn small_numbers_are_not_written_with_hundreds_of_zeros() {
    for arguments in [
        "backbone pendulum --amplitudes -1e-300",
        "figure errors --from -1e-300 --output errors.svg",
        "simulate pendulum --initial theta=1 --times 1e-300,-1e-300,2e-300",
        "bifurcation driven_pendulum --vary A=-1e-300:1e300:1e-301 --initial theta=1",
        "expand duffing --evaluate -1e-300",
        "decay 60deg --linear -1e-300",
        "motion 60deg --velocity 1e300",
    ] {
        let message = message(&libration(arguments));
        assert!(
            message.starts_with("error: ") && !message.contains(&"0".repeat(20)),
            "{arguments}: {message}"
        );
    }
    let listing = crate::command::text("expand x''=-x-1e-300*x^3 --order 5");
    assert!(listing.contains("375e-303 ε²") && !listing.contains(&"0".repeat(20)), "{listing}");
    let slow = crate::command::text("expand x''=-1e-300*sin(x) --order 5");
    assert!(slow.contains("ω0² = 1e-300") && !slow.contains(&"0".repeat(20)), "{slow}");
}

/// Released at the double next to π − 1e-20 a pendulum swings in 154.9 s, released at π − 1e-20 in 192.5 s.
#[test]
fn starts_that_are_rounded_next_to_the_top_are_told() {
    for (start, told) in [
        ("pi-1e-20", "pi-1e-20: 1e-20 rad from the upright position becomes 1.22465e-16 rad"),
        ("180deg-1e-9deg", "180deg-1e-9deg: 1.7453"),
        ("180deg", "180deg: the upright position becomes 1.22465e-16 rad from it"),
    ] {
        for question in
            ["simulate pendulum --times 0", "orbit pendulum", "section pendulum --at theta --points 1"]
        {
            let output = libration(&format!("{question} --initial theta={start}"));
            assert_eq!(message(&output).matches(told).count(), 1, "{question}: {}", message(&output));
        }
    }
    // The upright position itself may be meant as an equilibrium.
    let rest = "stability kapitza --set c=0.1 --map omega=5:6,a=0.1:0.4 --lines 0 --initial theta=180deg";
    assert!(message(&libration(rest)).is_empty(), "{}", message(&libration(rest)));
    for clear in ["3.141592653589793", "179.9deg", "-1"] {
        let output = libration(&format!("simulate pendulum --times 0 --initial theta={clear}"));
        assert!(message(&output).is_empty(), "{clear}: {}", message(&output));
    }
}

#[test]
fn a_decimal_comma_is_named() {
    let told = message(&libration("period 60deg --gravity 9,81"));
    assert!(told.contains("`9,81` has a comma: write it with a decimal point, 9.81"), "{told}");
    let told = message(&libration("period 200deg"));
    assert!(told.contains("an amplitude of 3.490658503988659 rad, 200°, is not below pi"), "{told}");
}

#[test]
fn tolerances_of_formulas_may_be_percentages() {
    let [parts, percent] =
        ["1e-3", "0.1%"].map(|tolerance| json(&format!("formulas --tolerance {tolerance}")));
    assert_eq!(parts, percent);
    assert!(!libration("formulas --tolerance 0%").status.success());
}

#[test]
fn bare_angles_above_half_a_turn_are_said_to_be_radians() {
    let note = "taken as 60 rad = 9.549 turns; for degrees write 60deg";
    for question in [
        "motion 60 --times 0",
        "simulate pendulum --initial theta=60 --times 0",
        "section driven_pendulum --set A=1 --initial theta=60 --points 1 --skip 0",
        "expand pendulum --order 3 --evaluate 60",
        "modes pendulum --about theta=60",
        "derive --method perturbation --order 2 --amplitude 60",
    ] {
        let output = libration(question);
        assert_eq!(message(&output).matches(note).count(), 1, "{question}: {}", message(&output));
    }
    let refused = libration("period 60");
    assert_eq!(refused.status.code(), Some(1));
    assert!(message(&refused).contains("60deg"), "{}", message(&refused));
    let file = crate::command::directory("bare").join("degrees.txt");
    std::fs::write(&file, "1\n3.2\n60\n").unwrap();
    let listed = libration(&format!("period --from-file {}", file.display()));
    assert_eq!(message(&listed).matches("taken as").count(), 1, "{}", message(&listed));
    for clear in ["motion 60deg --times 0", "motion 60rad --times 0", "motion 3.1 --times 0", "period 3"] {
        assert!(message(&libration(clear)).is_empty(), "{clear}");
    }
}
