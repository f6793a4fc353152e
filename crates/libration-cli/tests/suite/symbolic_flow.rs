//! `libration expand` with symbols, several small terms and a drive: the fields, numbers compared with `orbit`, and programs.

use crate::command::{message, run, unfolded};
use serde_json::Value;

const DUFFING: &str = "x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = eps*F*cos(W*t)";

fn answer(words: &[&str]) -> Value {
    let output = run(&[words, &["--json"]].concat());
    assert!(output.status.success(), "{words:?}: {}", message(&output));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn shown(words: &[&str]) -> String {
    let output = run(words);
    assert!(output.status.success(), "{words:?}: {}", message(&output));
    String::from_utf8(output.stdout).unwrap()
}

fn refused(words: &[&str]) -> String {
    let output = run(words);
    assert!(!output.status.success(), "{words:?}");
    message(&output)
}

#[test]
fn a_driven_oscillator_has_its_slow_flow_and_steady_states_as_formulas() {
    let driven = answer(&["expand", DUFFING, "--resonance", "1/1"]);
    assert_eq!(driven["slow_flow"]["amplitude"], "-eps*mu*A - eps*F/(2*w0)*sin(phi)");
    assert_eq!(driven["slow_flow"]["phase"], "-eps*sigma + 3*eps*a*A^2/(8*w0) - eps*F/(2*w0*A)*cos(phi)");
    assert_eq!(driven["steady_state"]["peak_amplitude"], "F/(2*mu*w0)");
    assert_eq!(driven["steady_state"]["equations"].as_array().unwrap().len(), 2);
    assert_eq!(driven["drive_frequency"], "w0 + eps*sigma");
    assert_eq!(driven["letters"]["amplitude"], "A");
    assert_eq!(driven["values"], Value::Null);
    let dry = answer(&["expand", "x'' + w0^2*x + eps*R*sign(x') = eps*F*cos(W*t)", "--resonance", "1/1"]);
    // (2·ω0·σ·A)² + (4R/π)² = F².
    assert_eq!(dry["steady_state"]["relation"], "-F^2 + 16*R^2/pi^2 + 4*w0^2*sigma^2*A^2");
    assert_eq!(dry["steady_state"]["peak_amplitude"], Value::Null);
    assert!(dry["steady_state"]["notes"][0].as_str().unwrap().starts_with("peak_amplitude"));
}

#[test]
fn symbols_of_free_oscillators_need_no_option() {
    let cycle = answer(&["expand", "x'' + x = eps*(m*(1 - x^2)*x' - b*x^3)"]);
    assert_eq!(cycle["slow_flow"]["amplitude"], "eps*m*A/2 - eps*m*A^3/8");
    let two_sided = answer(&["expand", "x'' + w^2*x + c*x*abs(x) = 0"]);
    assert_eq!(two_sided["slow_flow"]["phase"], "4*c*A/(3*w*pi)");
    let named = answer(&["expand", "x'' + c*x' + w^2*x + b*x^3 = 0", "--small", "c:1,b:1"]);
    assert_eq!(named["slow_flow"]["amplitude"], "-c*A/2");
    assert_eq!(named["small_orders"], serde_json::json!({"c": 1, "b": 1}));
}

#[test]
fn numbers_are_those_of_the_integrated_motion_within_their_errors() {
    let set = ["--set", "mu=0.1", "--set", "w0=1", "--set", "a=1", "--set", "F=0.5", "--set", "eps=0.1"];
    let exact = answer(&["orbit", "x'' + 0.02*x' + x + 0.1*x^3 = 0.05*cos(1.03*t)"]);
    let exact =
        exact["harmonics"].as_array().unwrap().iter().find(|harmonic| harmonic["n"] == 1).unwrap().clone();
    let mut last = f64::INFINITY;
    for order in ["1", "2", "3"] {
        let words =
            [&["expand", DUFFING, "--resonance", "1/1", "--evaluate", "1.03", "--order", order], &set[..]]
                .concat();
        let values = answer(&words)["values"].clone();
        assert_eq!(values["drive_angular_frequency_rad_per_s"], 1.03);
        let states = values["steady_states"].as_array().unwrap();
        assert_eq!(states.len(), 1, "{values}");
        let difference = states[0]["amplitude"].as_f64().unwrap() - exact["amplitude"].as_f64().unwrap();
        let error = states[0]["amplitude_error"].as_f64().unwrap();
        assert!(difference.abs() < 1.2 * error && error < last / 5.0, "order {order}: {difference}, {error}");
        assert_eq!(states[0]["is_stable"], true);
        last = error;
    }
    let listing = shown(&[&["expand", DUFFING, "--resonance", "1/1", "--set", "W=1.03"], &set[..]].concat());
    assert!(listing.contains("in numbers at W = 1.03, sigma = 0.3:\nA = 1.147"), "{listing}");
}

/// The response at W = 1.3 has three states by shooting: A = 0.1452, 2.9596 and 3.0481.
#[test]
fn steady_states_beyond_the_series_are_named_with_the_reason() {
    let text = "x'' + eps*(m*x' + a*x^3) + x = eps*F*cos(W*t)";
    let set = ["--set", "eps=0.1", "--set", "m=0.2", "--set", "a=1", "--set", "F=1", "--order", "3"];
    let words = [&["expand", text, "--resonance", "1/1", "--evaluate", "1.3"], &set[..]].concat();
    let values = answer(&words)["values"].clone();
    assert_eq!(values["steady_states"].as_array().unwrap().len(), 1, "{values}");
    let left_out = values["left_out"].as_array().unwrap();
    assert!(
        left_out.len() == 2 && left_out.iter().all(|state| state["reason"] == "beyond_reach"),
        "{values}"
    );
    let listing = shown(&words);
    assert!(listing.contains("left out: A = 2.9, phi = "), "{listing}");
    assert!(!listing.contains("no steady state"), "{listing}");
    // The only state is A = 1.0075 by shooting; the linear order has A = 0.71.
    let soft = "x'' + w^2*(x - x^3/6) + eps*m*x' = eps*F*cos(W*t)";
    let set = ["--set", "w=1", "--set", "eps=0.1", "--set", "m=1", "--set", "F=1"];
    let listing = shown(&[&["expand", soft, "--resonance", "1/1", "--evaluate", "0.95"], &set[..]].concat());
    assert!(listing.contains("no steady state within reach of the series\nleft out: A = 0.71"), "{listing}");
}

#[test]
fn formulas_are_written_as_mathematics() {
    let of = |format: &str| shown(&["expand", DUFFING, "--resonance", "1/1", "--format", format]);
    assert!(of("latex").contains(r"\dot A = -\mathrm{eps} \mu A"), "{}", of("latex"));
    assert!(of("mathml").contains("<mtext>peak amplitude</mtext><mo>=</mo><mfrac>"));
}

#[test]
fn what_has_no_such_slow_flow_is_refused_with_what_would_work() {
    let said = |words: &[&str]| refused(&[&["expand"], words].concat());
    assert!(said(&[DUFFING]).contains("name the resonance"));
    assert!(said(&[DUFFING, "--resonance", "one"]).contains("cannot read `one`"));
    assert!(said(&[DUFFING, "--resonance", "1/1", "--small", "eps:x"]).contains("cannot read the order"));
    assert!(said(&["x'' + x = F*cos(W*t)", "--resonance", "1/1"]).contains("unless it is small"));
    assert!(said(&["x'' + eps*x^3 + x = 0", "--resonance", "1/1"]).contains("does not depend on t"));
    let missing = said(&[DUFFING, "--resonance", "1/1", "--evaluate", "1.1", "--set", "eps=0.1"]);
    assert!(missing.contains("no value is given for F, a, mu, w0"), "{missing}");
}

#[test]
fn a_drive_of_a_given_frequency_determines_the_detuning() {
    let setting = |drive: &str| {
        let equation = format!("x'' + x + eps*x^3 = eps*F*cos({drive}*t)");
        let output = run(&["expand", &equation, "--resonance", "1/1"]);
        assert!(output.status.success(), "{}", message(&output));
        unfolded(&String::from_utf8(output.stdout).unwrap())
    };
    assert!(setting("1").contains("eps of order 1; sigma = 0 for the frequency of the drive, 1 "));
    assert!(setting("11/10").contains("frequency of the drive, which gives sigma: 11/10 = 1 + eps*sigma"));
    assert!(setting("W").contains("eps of order 1; W = 1 + eps*sigma"));
}

#[test]
fn notes_name_the_terms_and_orders_that_are_missing() {
    let text = "x''+m*x'+x+c*x^3=F*cos(W*t)";
    let asked = |small: &str, order: &[&str]| {
        answer(&[&["expand", text, "--resonance", "1/1", "--small", small], order].concat())
    };
    let raised = asked("c:1,m:2,F:2", &[]);
    assert_eq!(raised["order"], 3);
    assert_eq!(raised["steady_state"]["peak_amplitude"], "F/m");
    let lower = asked("c:1,m:2,F:2", &["--order", "2"]);
    assert_eq!(lower["steady_state"]["relation"], Value::Null);
    assert!(lower["steady_state"]["notes"][0].as_str().unwrap().contains("need order 3"), "{lower}");
    let without = shown(&["expand", text, "--resonance", "1/1", "--small", "c:3,m:1,F:1", "--order", "2"]);
    assert!(without.contains("terms above order 2 are left out of x'': -c*x^3"), "{without}");
    let free = shown(&["expand", "x''+m*x'+x+c*x^3=0", "--small", "c:1,m:2", "--order", "1"]);
    assert!(free.contains("to order 1 the amplitude does not change"), "{free}");
    assert!(free.contains("terms above order 1 are left out of x'': -m*x'"), "{free}");
}
