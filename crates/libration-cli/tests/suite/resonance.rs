//! `libration resonance`.

use crate::command::{json, message, run, text};

#[test]
fn an_exchange_of_energy_is_told_beside_the_whole_motion() {
    let question =
        "resonance spring_pendulum --set kappa=3 --order 4 --initial r=1.373333333333333333,theta=0.04";
    let answer = json(question);
    let exchange = &answer["exchange"];
    let number = |name: &str| exchange[name].as_f64().unwrap();
    // From a return map in long double.
    let expected = 148.545_397_098_687_13;
    assert!((number("measured_period_s") / expected - 1.0).abs() < 1e-9, "{exchange}");
    assert!((number("period_s") / expected - 1.0).abs() < 1e-3);
    let difference = number("period_s") / number("measured_period_s") - 1.0;
    assert!((number("relative_difference") - difference).abs() < 1e-15);
    assert_eq!(answer["slow_terms"][0]["exact"], "9/32*sqrt(3)*i");
    assert_eq!(answer["slow_terms"][0]["kind"], "resonance");
    let words = text(question).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("resonant terms let modes exchange energy"), "{words}");
    assert!(words.contains("exchange of the whole motion 148.54539"), "{words}");
}

#[test]
fn modes_without_resonance_keep_their_amplitudes() {
    let told = text("resonance double_pendulum --initial theta1=0.1");
    assert!(told.contains("No resonance to this order"), "{told}");
    let answer = json("resonance double_pendulum --initial theta1=0.1");
    assert!(answer["no_exchange"].as_str().unwrap().contains("no two modes are in resonance"));
    assert!(answer.get("exchange").is_none());
}

/// The slow flow of two quadratically coupled oscillators near 1:2 and what conserves their energy: A. H. Nayfeh, D. T. Mook, Nonlinear
/// Oscillations, section 6.2.1.
#[test]
fn equations_with_symbols_have_their_slow_flow_as_formulas() {
    let coupled = "x''+w1^2*x+eps*a*x*y=0; y''+w2^2*y+eps*b*x^2=0";
    let ask = |further: &[&str]| run(&[&["resonance", coupled, "--json"], further].concat());
    let answer: serde_json::Value = serde_json::from_slice(&ask(&["--ratios", "1:2"]).stdout).unwrap();
    assert_eq!(answer["small_orders"], serde_json::json!({"eps": 1}));
    let [x, y] = [0, 1].map(|index| &answer["coordinates"][index]);
    assert_eq!(x["slow_flow"]["amplitude"], "eps*a*A_x*A_y/(4*w1)*sin(2*phi_x - phi_y)");
    assert_eq!(y["slow_flow"]["amplitude"], "-eps*b*A_x^2/(8*w1)*sin(2*phi_x - phi_y)");
    assert_eq!(y["frequency_difference"], "eps*sigma_y");
    assert_eq!(y["frequency_squared"], "w2^2");
    assert_eq!(answer["steady_state"]["equations"].as_array().unwrap().len(), 4);
    let refused = |further: &[&str], expected: &str| {
        let message = String::from_utf8(ask(further).stderr).unwrap();
        assert!(message.contains(expected), "{message}");
    };
    refused(&[], "--ratios: the natural frequency of equation 2");
    refused(&["--ratios", "1:2:3"], "for each of the 2 coordinates");
    refused(&["--ratios", "1:two"], "--ratios: cannot read `1:two`");
    refused(&["--ratios", "1:2", "--resonance", "1/1"], "--resonance: the acceleration does not depend on t");
    refused(&["--ratios", "1:2", "--initial", "x=1"], "--initial: it needs numbers for all symbols");
    refused(&["--ratios", "1:2", "--about", "x=1"], "--about: a slow flow with symbols");
}

#[test]
fn a_slow_flow_of_coupled_coordinates_is_typeset() {
    let flow = ["resonance", "x''+w1^2*x+eps*a*x*y=0; y''+w2^2*y+eps*b*x^2=0", "--ratios", "1:2"];
    let written = |format: &[&str]| String::from_utf8(run(&[&flow, format].concat()).stdout).unwrap();
    let latex = written(&["--latex"]);
    assert_eq!(latex, written(&["--format", "latex"]));
    let parts = [
        r"\[ \ddot{y} + w_{2}^{2} y + \mathrm{eps} b x^{2} = 0 \]",
        r"\[ \dot{A_{y}} = -\frac{\mathrm{eps} b A_{x}^{2}}{8 w_{1}} \sin\left(2 \varphi_{x} - \varphi_{y}\right) \]",
    ];
    assert!(parts.iter().all(|part| latex.contains(part)), "{latex}");
    let mathml = written(&["--format", "mathml"]);
    assert_eq!(
        mathml.lines().filter(|line| line.starts_with("<math") && line.ends_with("</math>")).count(),
        7
    );
    assert!(mathml.contains("<mtext>rate of the phase of y</mtext><mo>=</mo>"), "{mathml}");
}

#[test]
fn what_has_no_normal_form_is_refused() {
    let cases: [(&[&str], i32, &[&str]); 7] = [
        (&["resonance", "damped_pendulum", "--set", "c=0.1"], 1, &["mode 1", "damping to zero"]),
        (&["resonance", "double_pendulum", "--order", "1"], 2, &["--order", "2 to 9"]),
        (&["resonance", "double_pendulum", "--order", "12"], 2, &["--order"]),
        (&["resonance", "double_pendulum", "--figure", "x.svg"], 2, &["--initial"]),
        (&["resonance", "x' = -x"], 1, &["first order"]),
        (&["resonance", "double_pendulum", "--latex"], 2, &["--latex: it writes the formulas", "--ratios"]),
        (&["resonance", "double_pendulum", "--format", "c"], 2, &["--format: it writes the formulas"]),
    ];
    for (arguments, status, parts) in cases {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {}", message(&output));
        for part in parts {
            assert!(message(&output).contains(part), "{arguments:?}: {}", message(&output));
        }
    }
}

#[test]
fn another_equilibrium_is_that_about_which_modes_change_slowly() {
    // Lindstedt's series of the double well about x = 1: Ω = √2·(1 − 3/4·a²).
    let answer = json("resonance x''=x-x^3 --about x=0.9");
    assert_eq!((&answer["equilibrium"][0], &answer["order"]), (&1.0.into(), &3.into()));
    let shift = answer["slow_terms"][0]["imaginary"].as_f64().unwrap();
    assert!((shift + 0.75 * 2_f64.sqrt()).abs() < 1e-14, "{shift}");
    let refused = run(&["resonance", "x''=x-x^3", "--about", "y=1"]);
    assert_eq!(refused.status.code(), Some(2), "{}", message(&refused));
    assert!(message(&refused).contains("no coordinate `y`: it has x"), "{}", message(&refused));
}
