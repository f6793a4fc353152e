//! `libration melnikov`.

use crate::command::{json, message, run, text};
use serde_json::Value;

fn words(question: &str) -> String {
    text(question).split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn thresholds_are_found_over_a_parameter() {
    let answer = json("melnikov driven_pendulum --set c=0.1,omega=2/3 --over A=0:1");
    let thresholds = answer["thresholds"].as_array().unwrap();
    assert_eq!(thresholds.len(), 2);
    // (4c/π)·cosh(πΩ/2) by mpmath.
    let value = |number: &Value| number["value"].as_f64().unwrap();
    assert!(thresholds.iter().all(|threshold| (value(threshold) - 0.203_754_851_014_665_07).abs() < 1e-15));
    assert_eq!((&answer["parameter"], value(&answer)), (&"A".into(), value(&thresholds[0])));
    // From two manifolds in 150-bit floats.
    let tangency = |name: &str| thresholds[0][name].as_f64().unwrap();
    assert!((tangency("tangency") - 0.203_712_546_072_548).abs() <= tangency("tangency_error"));
    assert!(tangency("tangency_error") < 1e-12 && thresholds[0]["no_tangency"].is_null());
    assert!(
        (tangency("tangency_velocity_rad_per_s") - 2.0).abs() < 0.01 && tangency("tangency_phase_rad") > 6.0
    );
    let separatrix = &answer["separatrices"][0];
    assert!((separatrix["mean_rad2_per_s2"].as_f64().unwrap() + 0.8).abs() < 1e-15);
    assert_eq!((&separatrix["simple_zeros"], &answer["closed_form"]), (&Value::Null, &true.into()));
    assert!(
        words("melnikov driven_pendulum --set c=0.1,omega=2/3 --over A=0:0.1")
            .contains("No threshold in the range")
    );
}

#[test]
fn a_tangency_is_told_beside_the_threshold_or_why_none_is_known() {
    let weak = words("melnikov driven_pendulum --set c=0.05,omega=1 --over A=0:1");
    assert!(weak.contains("above 0.1597877617496"), "{weak}");
    let strong = "melnikov driven_pendulum --set c=2,omega=1 --over A=0:100";
    assert!(words(strong).contains("The tangency is not known: no periodic motion"), "{}", words(strong));
    let answer = json(strong);
    assert!(
        answer["thresholds"][1]["tangency"].is_null() && answer["thresholds"][1]["no_tangency"].is_string()
    );
}

#[test]
fn zeros_and_resonances_are_told_in_words() {
    let strong = words("melnikov driven_pendulum --set c=0.1,omega=1,A=0.5");
    assert!(
        strong.contains("it has simple zeros") && strong.contains("they cross above 0.638957 of this drive"),
        "{strong}"
    );
    let weak = words("melnikov driven_pendulum --set c=0.1,omega=1,A=0.1");
    assert!(weak.contains("the manifolds do not cross; they cross above 3.19479 times"), "{weak}");
    assert!(words("melnikov damped_pendulum --set c=0.1").contains("nothing depends on the phase"));
    assert!(words("melnikov x''+sin(x)=0.001*cos(4*t) --max-drive-periods 6").contains("do not overlap"));
    assert!(weak.contains("1:3 libration 0.33333333 175.8765"), "{weak}");
    assert!(words("melnikov x''+sin(x-1/2)=0.1*cos(t)").contains("drive 1 rad/s, hangs at 0.5 rad"));
}

#[test]
fn what_is_no_perturbed_pendulum_is_refused() {
    let cases: [(&[&str], i32, &[&str]); 5] = [
        (&["melnikov", "duffing"], 1, &["neither the sine", "x'' = -sin(x)"]),
        (&["melnikov", "double_pendulum"], 1, &["2 coordinates"]),
        (&["melnikov", "x'' + sin(x) = t"], 1, &["not periodic"]),
        (&["melnikov", "driven_pendulum", "--over", "A=1"], 2, &["--over", "NAME=FROM:TO"]),
        (&["melnikov", "driven_pendulum", "--over", "A=1:1"], 2, &["--over", "empty"]),
    ];
    for (arguments, status, parts) in cases {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {}", message(&output));
        for part in parts {
            assert!(message(&output).contains(part), "{arguments:?}: {}", message(&output));
        }
    }
}
