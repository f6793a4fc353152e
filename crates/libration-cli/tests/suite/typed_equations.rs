//! Equations of motion in the notation of physicists.

use crate::command::{message, run, unfolded};
use serde_json::Value;

fn json(arguments: &[&str]) -> (Value, String) {
    let output = run(&[arguments, &["--json"]].concat());
    assert!(output.status.success(), "{arguments:?}: {}", message(&output));
    (serde_json::from_slice(&output.stdout).unwrap(), message(&output))
}

#[test]
fn an_expansion_says_how_a_free_equation_was_read() {
    for (text, reading) in [
        (r"\ddot{\theta} + \sin\theta = 0", "theta'' + sin(theta) = 0"),
        (r"\frac{d^2\theta}{dt^2} = -\sin\theta", "theta'' = -sin(theta)"),
        ("d²θ/dt² + sin θ = 0", "theta'' + sin(theta) = 0"),
        ("d2x/dt2 + x(1 + x^2) = 0", "x'' + x*(1 + x^2) = 0"),
        ("x''(t) + 2x(t) = 0", "x'' + 2*x = 0"),
        ("x'' + log(1 + x) = 0", "x'' + ln(1 + x) = 0"),
    ] {
        let (answer, note) = json(&["expand", text, "--order", "3"]);
        assert_eq!((answer["read_as"].as_str(), answer["equation"].as_str()), (Some(reading), Some(reading)));
        assert_eq!(note, format!("note: the equation is read as {reading}\n"));
        let words = run(&["expand", text, "--order", "3"]);
        let words = unfolded(&String::from_utf8(words.stdout).unwrap());
        assert!(words.contains(&format!("read as {reading} about")), "{words}");
        let (mut plain, silent) = json(&["expand", reading, "--order", "3"]);
        assert_eq!((plain["read_as"].take(), silent.as_str()), (Value::Null, ""));
        let mut answer = answer;
        answer["read_as"] = Value::Null;
        assert_eq!(answer, plain);
    }
}

#[test]
fn every_question_that_takes_equations_reads_them_alike() {
    let free = "d²x/dt² + x(1 + x²) = 0";
    let plain = "x'' + x*(1 + x^2) = 0";
    for rest in [
        &["simulate", "", "--initial", "x=1", "--times", "1"][..],
        &["backbone", "", "--amplitudes", "0.5"],
        &["modes", ""],
    ] {
        let with = |text: &'static str| {
            let arguments: Vec<&str> =
                rest.iter().map(|word| if word.is_empty() { text } else { word }).collect();
            json(&arguments)
        };
        let ((one, note), (other, silent)) = (with(free), with(plain));
        assert_eq!(one, other, "{rest:?}");
        assert_eq!(
            (note.as_str(), silent.as_str()),
            ("note: the equation is read as x'' + x*(1 + x^2) = 0\n", "")
        );
    }
}

#[test]
fn two_readings_are_named_and_none_is_taken() {
    for (text, part) in [
        ("x'' + sin x^2 = 0", "may be sin(x^2) or sin(x)^2"),
        ("x'' + 1/2x = 0", "(1/2)*x or 1/(2*x)"),
        ("x'' + k(1 + x) = 0", "`k(` is not a known function: write k*( for a product"),
        ("x'' + x(t - 1) = 0", "x at another time"),
    ] {
        let output = run(&["expand", text]);
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(message(&output).contains(part), "{text}: {}", message(&output));
    }
}
