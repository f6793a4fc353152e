//! `libration expand`, and the oscillators of `libration list`.

use crate::command::{close, json, libration, message, run, text, unfolded};
use serde_json::Value;

fn list(value: &Value) -> Vec<&str> {
    value.as_array().unwrap().iter().map(|entry| entry.as_str().unwrap()).collect()
}

/// Asserts that every entry is text of a fraction in lowest terms, such as `-1/16`.
fn assert_fractions(value: &Value, length: usize, what: &str) {
    let entries = list(value);
    assert_eq!(entries.len(), length, "{what}");
    for entry in entries {
        let (above, below) = entry.split_once('/').unwrap_or((entry, "1"));
        let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        assert!(digits(above.strip_prefix('-').unwrap_or(above)) && digits(below), "{what}: {entry}");
    }
}

fn refusal(arguments: &[&str], status: i32) -> String {
    let output = run(arguments);
    assert_eq!(output.status.code(), Some(status), "{arguments:?}: {}", message(&output));
    assert!(output.stdout.is_empty(), "{arguments:?}");
    message(&output)
}

/// x″ + 3x·x′ + x³ + x = 0 has the period 2π and x = 2q·sin τ/(1 − 2q·cos τ + q²).
#[test]
fn a_mirrored_motion_is_written_in_sines() {
    let question = |more: &[&str]| {
        let words = [&["expand", "x''+3*x*x'+x^3+x=0", "--order", "4"], more].concat();
        String::from_utf8(run(&words).stdout).unwrap()
    };
    let answer: Value = serde_json::from_str(&question(&["--json"])).unwrap();
    assert_eq!(answer["phase_origin"], "passage");
    assert_eq!(list(&answer["frequency_ratio"]), ["1", "0", "0", "0"]);
    assert_eq!(list(&answer["harmonics"]["3"]["sin"]), ["0", "0", "0", "1/4", "0"]);
    assert_eq!(list(&answer["harmonics"]["3"]["cos"]), ["0"; 5]);
    assert_eq!(list(&answer["of_amplitude"]["harmonics"]["2"]["sin"]), ["0", "0", "1/2", "0", "-1/4"]);
    let shown = question(&[]);
    for part in ["ε is the coefficient of sin τ", "b₃ = 1/4 ε³", "x_min = -x_max", "b₂ = 1/2 A² - 1/4 A⁴"]
    {
        assert!(shown.contains(part), "{part}: {shown}");
    }
    assert!(!shown.contains("a₁"), "{shown}");
    let csv = question(&["--csv"]);
    assert!(csv.contains("sin_2,x_max,2,1/2") && !csv.contains("cos_2,x_max"), "{csv}");
    let latex = question(&["--latex"]);
    assert!(latex.contains("b_{3} &= ") && !latex.contains("a_{1}"), "{latex}");
    assert_eq!(json("expand pendulum --order 3")["phase_origin"], "turning point");
    assert_eq!(json("expand van_der_pol --order 3")["phase_origin"], "first harmonic");
}

/// x″ + x + x|x| = 0: Ω = 1 + 4A/(3π) + ….
#[test]
fn a_force_with_two_sides_has_powers_of_pi() {
    let question = |more: &[&str]| {
        let words = [&["expand", "x''+x+x*abs(x)=0", "--gauge", "x_max", "--order", "2"], more].concat();
        String::from_utf8(run(&words).stdout).unwrap()
    };
    let answer: Value = serde_json::from_str(&question(&["--json"])).unwrap();
    assert_eq!(list(&answer["frequency_ratio"]), ["1", "4/(3*pi)"]);
    assert_eq!(answer["precision"], "exact");
    assert_eq!((&answer["certificate"], &answer["certified"]), (&"quadrature".into(), &false.into()));
    assert_eq!(answer["has_all_harmonics"], false);
    assert_eq!(json("expand pendulum --order 3")["has_all_harmonics"], true);
    let shown = question(&[]);
    for part in ["Ω/ω0 = 1 + 4/(3*pi) A", "there are\nharmonics without end", "those that a quadrature gives"]
    {
        assert!(shown.contains(part), "{part}: {shown}");
    }
    assert!(question(&["--latex"]).contains(r"1 + \frac{4}{3 \pi} \epsilon"));
    // Functions do not take π as an argument.
    let code = question(&["--format", "python"]);
    assert!(code.contains("def frequency(amplitude):") && code.contains("0.4244131815783876"), "{code}");
    assert!(code.contains("the displacement is not whole"), "{code}");
}

/// x″ + x³ = 0: Ω = π/(2K)·A with K = Γ(1/4)²/(4√π).
#[test]
fn a_pure_power_has_a_scaling_law() {
    let answer = json("expand pure_cubic");
    assert_eq!((&answer["exponent"], &answer["amplitude_exponent"]), (&"3".into(), &"1".into()));
    assert_eq!(answer["angular_frequency_constant"], "sqrt(2*pi)*Gamma(3/4)/Gamma(1/4)");
    close(&answer["angular_frequency_factor"], 0.847_213_084_793_979, 1e-15);
    close(&answer["period_factor"], 7.416_298_709_205_488, 1e-14);
    close(&answer["harmonics"][1]["ratio"], 0.043_049_495_577_492, 1e-13);
    assert_eq!(answer["angular_frequency_rad_per_s"], Value::Null);
    close(
        &json("expand pure_cubic --evaluate 2")["angular_frequency_rad_per_s"],
        1.694_426_169_587_958,
        1e-14,
    );
    let shown = text("expand x''+k*x*abs(x)=0");
    for part in ["Ω = C·√k·A^(1/2)", "T = 2π/(C·√k)·A^(-1/2)", "C = √(3π/2)·Γ(5/6)/Γ(1/3)"] {
        assert!(shown.contains(part), "{part}: {shown}");
    }
    assert!(text("expand pure_cubic --latex").contains(r"C &= \sqrt{2\,\pi}\,\frac{\Gamma"));
    for (words, part) in [
        (&["expand", "x''+k*x^3=0", "--evaluate", "1"][..], "give values to its symbols with --set"),
        (&["expand", "pure_cubic", "--evaluate", "0"], "give a finite number above zero"),
    ] {
        let refused = refusal(words, 2);
        assert!(refused.contains(part), "{refused}");
    }
}

/// The expansion parameter and the amplitudes are numbered where the equation has their names.
#[test]
fn symbols_of_the_equation_are_not_those_of_the_series() {
    let duffing = "expand duffing --letters epsilon --order 3";
    assert!(text(duffing).contains("\nΩ/ω0 = 1 + 3*epsilon/8 ε_1²\na₁ = ε_1\n"));
    let latex = text(&format!("{duffing} --latex"));
    assert!(latex.contains(r"1 + \frac{3 \epsilon}{8} \epsilon_{1}^{2} \\"), "{latex}");
    let mathml = text(&format!("{duffing} --format mathml"));
    assert!(mathml.contains("<msup><msub><mi>ε</mi><mn>1</mn></msub><mn>2</mn></msup>"), "{mathml}");
    assert_eq!(json(duffing)["variable"], "epsilon_1");
    assert!(text(&format!("{duffing} --csv")).contains("\nfrequency_ratio,epsilon_1,2,3*epsilon/8\n"));
    let question = "expand x''+x+A*x^2+h*x^3=0 --order 3";
    let shown = text(question);
    for part in [
        "ε² + ",
        "of the largest displacement A_1:",
        "(-h/32 - A^2/48) h_1³",
        "half the swing h_1:",
        "A/3 A_1²",
    ] {
        assert!(shown.contains(part), "{part}: {shown}");
    }
    assert!(text(&format!("{question} --latex")).contains(r"\frac{A}{3} A_{1}^{2}"));
    let law = text("expand A''+C*A^3=0");
    assert!(law.contains("Ω = C_1·√C·A_1\n") && law.contains("a₁/A_1 = 0.955"), "{law}");
}

#[test]
fn every_field_of_the_contract_is_there() {
    let order = 7;
    let answer = json("expand pendulum --order 7");
    assert_eq!(answer["equation"], "theta'' + sin(theta) = 0");
    assert_eq!(answer["order"], order);
    assert_eq!(answer["gauge"], "fundamental");
    assert_eq!(answer["variable"], "epsilon");
    assert_eq!(answer["omega0_squared"], "1");
    assert_eq!(answer["certified"], true);
    // Order N keeps x up to ε^N and the frequency up to ε^(N−1).
    assert_eq!(list(&answer["frequency_ratio"]), ["1", "0", "-1/16", "0", "1/1024", "0", "-1/65536"]);
    assert_fractions(&answer["x_max"], order + 1, "x_max");
    assert_fractions(&answer["x_min"], order + 1, "x_min");
    assert_eq!(list(&answer["harmonics"]["3"]["cos"])[3], "-1/192");
    for (k, harmonic) in answer["harmonics"].as_object().unwrap() {
        assert_fractions(&harmonic["cos"], order + 1, k);
        assert_fractions(&harmonic["sin"], order + 1, k);
    }
    let of = &answer["of_amplitude"];
    assert_fractions(&of["frequency_ratio"], order, "of_amplitude.frequency_ratio");
    assert_eq!(list(&of["period_ratio"]), ["1", "0", "1/16", "0", "11/3072", "0", "173/737280"]);
    assert_eq!(list(&of["epsilon"])[..4], ["0", "1", "0", "1/192"]);
    for (k, harmonic) in of["harmonics"].as_object().unwrap() {
        assert_fractions(&harmonic["cos"], order + 1, k);
        assert_fractions(&harmonic["sin"], order + 1, k);
    }
    assert_eq!(answer["of_half_swing"], Value::Null);
}

#[test]
fn the_half_swing_is_for_asymmetric_wells_and_amplitudes_for_families() {
    let quadratic = json("expand quadratic --order 4");
    assert!(quadratic["of_amplitude"].is_object() && quadratic["of_half_swing"].is_object());
    assert!(quadratic["harmonics"]["0"].is_object() && quadratic["harmonics"]["2"].is_object());
    let cycle = json("expand van_der_pol --order 4");
    assert_eq!(cycle["variable"], "mu");
    for absent in ["gauge", "of_amplitude", "of_half_swing"] {
        assert_eq!(cycle[absent], Value::Null, "{absent}");
    }
    assert_eq!(list(&cycle["frequency_ratio"]), ["1", "0", "-1/16", "0", "17/3072"]);
    // The gauge of the phase excludes sin τ.
    assert!(list(&cycle["harmonics"]["1"]["sin"]).iter().all(|entry| *entry == "0"));
}

#[test]
fn every_oscillator_of_the_catalogue_is_expanded_or_has_a_scaling_law() {
    let catalogue = json("oscillators");
    let oscillators = catalogue["oscillators"].as_array().unwrap();
    assert!(oscillators.len() >= 14);
    for oscillator in oscillators {
        let key = oscillator["key"].as_str().unwrap();
        let output = libration(&format!("expand {key} --order 5 --json"));
        if key == "pure_cubic" {
            let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
            assert_eq!(answer["angular_frequency_constant"], "sqrt(2*pi)*Gamma(3/4)/Gamma(1/4)");
            continue;
        }
        let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(answer["frequency_ratio"][0], "1", "{key}");
        for field in ["title", "equation", "description", "domain", "source"] {
            assert!(oscillator[field].as_str().is_some_and(|text| !text.is_empty()), "{key}: {field}");
        }
    }
}

#[test]
fn no_gauge_changes_what_can_be_measured() {
    let physical = json("expand pendulum --order 7");
    for gauge in ["x_max", "half_swing", "energy", "nome", "A1=1,A3=-1", "A1=2,A2=1/3"] {
        let answer = json(&format!("expand pendulum --order 7 --gauge {gauge}"));
        assert_eq!(answer["gauge"], gauge);
        assert_ne!(answer["of_amplitude"]["epsilon"], physical["of_amplitude"]["epsilon"], "{gauge}");
        for relation in ["frequency_ratio", "period_ratio", "harmonics"] {
            assert_eq!(answer["of_amplitude"][relation], physical["of_amplitude"][relation], "{gauge}");
        }
    }
}

#[test]
fn equations_are_shown_as_they_are_expanded() {
    let listing = text("expand relativistic --order 3");
    assert!(
        listing.contains("x'' = -x*(1 - x'^2)^(3/2)\nwith c = 1\nabout x = 0, where ω0² = 1\n"),
        "{listing}"
    );
    let soft = text("expand duffing --set epsilon=-1/2 --order 3");
    assert!(soft.contains("x'' + x - 0.5*x^3 = 0\nwith epsilon = -1/2\n"), "{soft}");
    let pendulum = text("expand pendulum --set ω0=3 --order 3");
    assert!(
        pendulum.contains("theta'' + 9*sin(theta) = 0\nwith omega0 = 3\nabout theta = 0, where ω0² = 9\n")
    );
    let left = text("expand double_well --about=-1 --order 3");
    assert!(left.contains("about x = -1, where ω0² = 2"), "{left}");
    let typed = String::from_utf8(run(&["expand", "x'' + k*x = 0", "--set", "k=4"]).stdout).unwrap();
    assert!(typed.contains("x'' + 4*x = 0\nwith k = 4\n"), "{typed}");
}

#[test]
fn latex_is_balanced() {
    for key in ["pendulum", "quadratic", "van_der_pol", "rayleigh_cubic", "relativistic"] {
        let latex = text(&format!("expand {key} --order 6 --latex"));
        let count = |mark: &str| latex.matches(mark).count();
        assert_eq!(count("{"), count("}"), "{key}");
        assert_eq!(count("\\begin{align*}"), count("\\end{align*}"), "{key}");
        assert_eq!(count("\\["), count("\\]"), "{key}");
        assert!(count("\\frac{") > 3 && latex.is_ascii(), "{key}");
    }
}

#[test]
fn latex_writes_the_strength_as_the_equation_does() {
    let output = run(&["expand", "x'' + x = lambda_1*(1 - x^2)*x'", "--order", "2", "--latex"]);
    let latex = String::from_utf8(output.stdout).unwrap();
    assert!(latex.contains(r"\frac{\Omega}{\omega_0} &= 1 - \frac{1}{16} \lambda_{1}^{2}"), "{latex}");
}

#[test]
fn csv_has_a_row_for_each_coefficient() {
    let rows = text("expand pendulum --order 5 --csv");
    assert!(rows.starts_with("quantity,variable,power,coefficient\nfrequency_ratio,epsilon,0,1\n"));
    assert!(rows.contains("\ncos_3,epsilon,3,-1/192\n") && rows.contains("\nperiod_ratio,x_max,4,11/3072\n"));
    assert!(rows.lines().all(|line| line.split(',').count() == 4));
}

#[test]
fn irrational_coefficients_are_announced() {
    let output = run(&["expand", "x'' + sin(x)*sqrt(2 + x) = 0", "--order", "3", "--json"]);
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(answer["precision"].as_str().unwrap().ends_with("digits"), "{}", answer["precision"]);
    assert_eq!(answer["certified"], false);
}

#[test]
fn a_series_in_numbers_stands_beside_the_exact_value() {
    let answer = json("expand pendulum --evaluate 40deg");
    assert_eq!((&answer["quantity"], &answer["radius_is"]), (&"period".into(), &"proven".into()));
    close(&answer["amplitude"], 40_f64.to_radians(), 1e-15);
    // 1/agm(1, cos 20°), by mpmath.
    close(&answer["exact"], 1.031_340_519_130_037, 1e-15);
    close(&answer["radius"], std::f64::consts::PI, 1e-15);
    for step in answer["steps"].as_array().unwrap() {
        let number = |name: &str| step[name].as_f64().unwrap();
        assert_eq!(step["bound_is"], "proven");
        // The rounding errors of the sum and of the exact value are added to the bound.
        assert!(number("error").abs() <= number("bound") + 5e-16, "{step}");
        assert!(step["coefficient"].is_string() && step["power"].is_u64());
    }
    assert_eq!(answer["terms_needed"], serde_json::json!({"1e-3": 1, "1e-6": 4, "1e-9": 6, "1e-12": 8}));
    assert!(answer["pade"][1]["error"].as_f64().unwrap().abs() < 1e-9);
}

#[test]
fn other_oscillators_have_exact_values_too() {
    // Sources: the energy integral with 60 digits; for the limit cycle a Taylor method of order 55.
    let cases = [
        ("duffing --evaluate 0.5", 5.768_845_544_751_767),
        ("sinh --evaluate 1", 5.911_611_295_076_775),
        ("quadratic --evaluate 0.1", 6.311_599_097_216_832),
        ("van_der_pol --evaluate 0.5", 6.380_675_801_773_586),
    ];
    for (question, period) in cases {
        let answer = json(&format!("expand {question}"));
        close(&answer["exact"], period / std::f64::consts::TAU, 1e-12);
        let last = answer["steps"].as_array().unwrap().last().unwrap();
        let is_polynomial = question.starts_with("duffing") || question.starts_with("quadratic");
        let (expected, stated, other) =
            if is_polynomial { ("proven", "bound", "estimate") } else { ("estimated", "estimate", "bound") };
        assert_eq!(last["bound_is"], expected, "{question}");
        assert!(last[stated].as_f64().unwrap() < 1e-9 && last[other].is_null(), "{question}: {last}");
        assert!(last["error"].as_f64().unwrap().abs() < 1e-9, "{question}: {last}");
    }
    // T·Ω = 2π, and the third harmonic of the pendulum at 2 rad by its nome.
    let frequency = json("expand duffing --evaluate 0.5 --quantity frequency");
    close(&frequency["exact"], std::f64::consts::TAU / 5.768_845_544_751_767, 1e-12);
}

/// T/T0 by energy integrals in 120 digits, for the decimal and not for the nearest `f64`.
#[test]
fn exact_values_hold_their_uncertainty_next_to_a_separatrix() {
    let cases = [
        ("duffing_soft --evaluate 0.999999999", 62.535_279_781_833_69),
        ("duffing_soft --evaluate 0.99999", 36.484_517_388_730_866),
        ("quadratic --evaluate 0.499999999999", 32.195_369_307_414_59),
        ("pendulum --evaluate pi-1e-12", 118.841_850_630_433_54),
    ];
    for (question, period) in cases {
        let answer = json(&format!("expand {question} --order 3"));
        let stated = answer["exact_uncertainty"].as_f64().unwrap();
        close(&answer["exact"], period / std::f64::consts::TAU, stated + 1e-14);
        assert!(stated < 1e-13, "{question}: {stated:e}");
    }
    let sheet = text("expand duffing_soft --evaluate 0.999999999 --order 3");
    assert!(sheet.contains("exact value   9.9527988949"), "{sheet}");
}

#[test]
fn on_the_separatrix_there_is_the_series_and_no_exact_value() {
    let questions = [
        "quadratic --evaluate 0.5",
        "rotating_hoop --evaluate 180deg",
        "pendulum --evaluate 180deg",
        "duffing_soft --evaluate 1",
    ];
    for question in questions {
        let answer = json(&format!("expand {question} --order 5"));
        assert_eq!(answer["exact"], Value::Null, "{question}");
        let note = answer["note"].as_str().unwrap();
        assert!(note.contains("the period is infinite"), "{question}: {note}");
        assert!(answer["steps"].as_array().unwrap().len() > 1 && answer["steps"][0]["error"] == Value::Null);
        let sheet = text(&format!("expand {question} --order 5"));
        assert!(sheet.contains("exact value   none: the period is infinite"), "{sheet}");
    }
}

#[test]
fn a_motion_around_both_wells_is_not_what_the_series_is_for() {
    let around = json("expand double_well --evaluate 0.42 --order 5");
    close(&around["exact"], 15.084_420_399_954_246 / std::f64::consts::TAU * 2_f64.sqrt(), 1e-13);
    close(&around["encloses"], 0.0, 1e-15);
    assert!(around["note"].as_str().unwrap().contains("also encloses the equilibrium at"));
    let sheet = text("expand double_well --evaluate 0.42 --order 5");
    assert!(sheet.contains("\nbut ") && sheet.contains("encloses the equilibrium at 0"), "{sheet}");
    // sqrt(2) - 1 = 0.41421356... is the barrier.
    let inside = json("expand double_well --evaluate 0.4142 --order 5");
    assert!(
        inside["encloses"] == Value::Null && !inside["note"].as_str().unwrap().contains("encloses"),
        "{inside}"
    );
    assert!(!text("expand double_well --evaluate 0.4142 --order 5").contains("another equilibrium"));
}

#[test]
fn it_is_seen_where_a_series_stops_helping() {
    let beyond = json("expand duffing --evaluate 1.5");
    let smallest = beyond["smallest_term_power"].as_u64().unwrap();
    let steps = beyond["steps"].as_array().unwrap();
    let error = |step: &Value| step["error"].as_f64().unwrap().abs();
    assert!(smallest < 30 && error(steps.last().unwrap()) > 10.0 * error(&steps[1]));
    assert_eq!(beyond["terms_needed"]["1e-3"], Value::Null);
    let told = text("expand duffing --evaluate 1.5");
    assert!(told.contains("← smallest term") && told.contains("BEYOND"), "{told}");
    let inside = text("expand duffing --evaluate 0.5");
    assert!(!inside.contains("← smallest term") && inside.contains("this amplitude is inside"), "{inside}");
    let over_the_top = unfolded(&text("expand pendulum --evaluate 200deg"));
    assert!(
        over_the_top.contains("none: at the displacement")
            && over_the_top.contains("(proven); this amplitude is BEYOND")
    );
}

#[test]
fn the_terms_are_csv_too() {
    let rows = text("expand pendulum --evaluate 1 --order 5 --csv");
    assert!(
        rows.starts_with("power,coefficient,term,sum,error,bound,bound_is,estimate\n0,1,1.0,1.0,"),
        "{rows}"
    );
    assert_eq!(rows.lines().count(), 4);
    assert!(rows.contains("\n4,11/3072,"));
}

#[test]
fn an_unknown_name_is_answered_with_the_nearest_ones() {
    let message = refusal(&["expand", "pendulem"], 2);
    assert!(message.contains("`pendulem`; the nearest are pendulum"), "{message}");
    assert!(refusal(&["oscillators", "dufing"], 2).contains("duffing"));
    // Text that is not a name is parsed as an equation.
    let message = refusal(&["expand", "x'' + x"], 2);
    assert!(message.contains("= 0") && !message.contains("the keys are"), "{message}");
}

#[test]
fn an_ambiguous_formula_is_refused_with_a_hint_below_it() {
    let message = refusal(&["expand", "x'' + sin x^2 = 0"], 2);
    assert!(message.contains("sin(x^2) or sin(x)^2"), "{message}");
    assert!(message.contains("\n  x'' + sin x^2 = 0\n        ^"), "{message}");
    assert!(refusal(&["expand", "x'' + 1/2x = 0"], 2).contains("(1/2)*x or 1/(2*x)"));
}

#[test]
fn what_cannot_be_expanded_is_refused_with_its_reason() {
    let cases: [(&[&str], i32, &str); 27] = [
        (&["expand", "pendulum", "--order", "0"], 2, "1 to 1000"),
        (&["expand", "pendulum", "--order", "99999"], 2, "1 to 1000"),
        (&["expand", "pendulum", "--gauge", "nonsense"], 2, "half_swing"),
        (&["expand", "pendulum", "--gauge", "A2=1"], 2, "A1=1"),
        (&["expand", "duffing", "--gauge", "nome"], 1, "pendulum"),
        (&["expand", "van_der_pol", "--gauge", "x_max"], 1, "leave the gauge out"),
        (&["expand", "x'' - x = 0"], 1, "omega0^2 is -1"),
        (&["expand", "x'' + 0.1*x' + x = 0"], 1, "decay"),
        (&["expand", "x'' + x = cos(t)"], 1, "depends on t"),
        (&["expand", "x'' + k*x = 0", "--evaluate", "1"], 1, "k=0.1"),
        (&["expand", "double_well", "--about", "0.3"], 1, "no equilibrium at 0.3"),
        (&["expand", "pendulum", "--set", "g=9.8"], 2, "its only parameter is omega0"),
        (&["expand", "duffing", "--set", "epsilon"], 2, "NAME=VALUE"),
        (&["expand", "duffing", "--evaluate", "40deg"], 2, "give a number"),
        (&["expand", "pendulum", "--evaluate", "40furlongs"], 2, "60deg"),
        (&["expand", "duffing", "--evaluate", "-1"], 1, "above zero"),
        (&["expand", "pendulum", "--evaluate", "1", "--quantity", "a2"], 1, "a1, a3, a5"),
        (&["expand", "pendulum", "--evaluate", "1", "--quantity", "energy"], 2, "frequency"),
        (&["expand", "x'' + 1/0*x = 0"], 2, "`1/0` has no value: division by zero"),
        (&["expand", "duffing", "--set", "epsilon=1/0"], 2, "--set: epsilon has no value: `1/0`"),
        (&["expand", "x'' + x*a/b = 0", "--set", "a=1,b=0"], 2, "division by zero"),
        (&["expand", "x'' + 2*x + abs(x) = 0"], 1, "hint: libration backbone finds"),
        (&["expand", "x'' + x^3 + x^5 = 0"], 1, "the restoring force has no linear part"),
        (&["expand", "x'' + x + y^2 = 0"], 1, "no value is given for y"),
        (
            &["expand", "pendulum", "--about", "foo"],
            2,
            "--about: cannot read `foo` as a position: give a number or an angle",
        ),
        // In a formula degrees are plain numbers, whatever the coordinate is.
        (&["expand", "duffing", "--about", "360deg"], 1, "there is no equilibrium at 2*pi"),
        (&["expand", "pendulum", "--about", "1/0"], 1, "`1/0` has no value"),
    ];
    for (arguments, status, part) in cases {
        let message = refusal(arguments, status);
        assert!(message.contains(part), "{arguments:?}: {message}");
        assert!(message.starts_with("error: "), "{arguments:?}: {message}");
    }
}

#[test]
fn advice_is_followed_by_an_answer() {
    let answered = |arguments: &[&str]| {
        let output = run(arguments);
        assert!(output.status.success(), "{arguments:?}: {}", message(&output));
    };
    for equation in ["x'' + 2*x + abs(x) = 0", "x'' + x + x*abs(x) = 0", "x'' + x^3 = 0"] {
        answered(&["backbone", equation, "--amplitudes", "0.5"]);
    }
    let excited = "x'' - mu*(1-x^2)*x' + x + x^3 = 0";
    answered(&["simulate", excited, "--set", "mu=0.1", "--initial", "x=1", "--times", "1"]);
    answered(&["expand", "x'' + x + x^10001 = 0"]);
    answered(&["expand", "x'' = -(x - 12.5)*exp(-x^2/100)", "--about", "12.5", "--order", "3"]);
}

#[test]
fn names_of_angles_are_the_same_for_all_commands() {
    let about = json("expand pendulum --about 360deg --order 3");
    close(
        &about["equilibrium"].as_str().unwrap().parse::<f64>().unwrap().into(),
        std::f64::consts::TAU,
        1e-15,
    );
    for name in ["theta", "theta1", "phi_2", "vartheta"] {
        let equation = format!("{name}'' + sin({name}) = 0");
        for arguments in [
            &["expand", &equation, "--evaluate", "40deg"][..],
            &["expand", &equation, "--about", "0deg"],
            &["backbone", &equation, "--amplitudes", "40deg"],
            &["simulate", &equation, "--initial", &format!("{name}=40deg"), "--times", "1"],
        ] {
            let output = run(arguments);
            assert!(output.status.success(), "{arguments:?}: {}", message(&output));
        }
    }
}

#[test]
fn the_catalogue_is_listed_with_parameters_and_sources() {
    let duffing = text("list duffing");
    for part in ["x'' + x + epsilon*x^3 = 0", "epsilon = 1: strength", "source", "Duffing"] {
        assert!(duffing.contains(part), "{part}: {duffing}");
    }
    let answer = json("list van_der_pol");
    assert_eq!(answer["oscillators"][0]["expansion_parameter"], "mu");
    assert_eq!(answer["oscillators"][0]["parameters"][0]["name"], "mu");
    assert_eq!(text("oscillators duffing morse --csv").lines().count(), 3);
}

/// Coefficients by powers of the small parameter and of the amplitude.
fn rows(value: &Value) -> Vec<Vec<&str>> {
    value.as_array().unwrap().iter().map(list).collect()
}

#[test]
fn a_damped_pendulum_has_a_slow_flow() {
    let answer = json("expand damped_pendulum --set n=2 --order 4 --damping-order 2");
    assert_eq!(answer["small_parameter"], "c");
    assert_eq!(answer["gauge"], "x_max");
    assert_eq!(answer["half_swing"], true);
    // A′ = −(4c/3π)A² + …, the law for small swings.
    let zero = ["0", "0", "0", "0", "0"];
    assert_eq!(rows(&answer["amplitude_rate"])[0], zero);
    assert_eq!(rows(&answer["amplitude_rate"])[1][..4], ["0", "0", "-4/(3*pi)", "0"]);
    assert_eq!(rows(&answer["phase_rate"])[0], ["1", "0", "-1/16", "0"]);
    assert_eq!(answer["motion"][0]["cos"].as_array().unwrap().len(), 3);
    let shown = text("expand damped_pendulum --set n=2 --order 2 --damping-order 1");
    assert!(shown.contains("A′ = -4/(3π) c A²\nψ′ = 1\n"), "{shown}");
    let latex = text("expand damped_pendulum --set n=2 --order 2 --latex");
    assert!(latex.contains(r"\dot A &= -\frac{4}{3 \pi} c A^{2} \\"), "{latex}");
    let csv = text("expand damped_pendulum --order 1 --damping-order 2 --csv");
    assert!(
        csv.contains("\namplitude_rate,1,1,-1/2,-0.5\nphase_rate,0,0,1,1.0\nphase_rate,2,0,-1/8,-0.125\n"),
        "{csv}"
    );
}

#[test]
fn any_letter_may_be_the_small_one() {
    let of_key = json("expand damped_pendulum --small c2 --order 2");
    assert_eq!(of_key["small_parameter"], "c2");
    let fundamental = text("expand van_der_pol --damping-order 2 --order 5 --gauge fundamental");
    // Bogoliubov and Mitropolsky's A′ = ½μA(1 − A²/4) and ψ′ = 1 − μ²(1/8 − A²/8 + 7A⁴/256).
    assert!(fundamental.contains("A′ = 1/2 mu A - 1/8 mu A³\n"), "{fundamental}");
    assert!(fundamental.contains("ψ′ = 1 - 1/8 mu² + 1/8 mu² A² - 7/256 mu² A⁴\n"), "{fundamental}");
}

/// The limit cycle of van der Pol's oscillator with the force of Duffing's, whose A is 2 and whose frequency rises by 3A²/8.
#[test]
fn slow_flows_tell_their_limit_cycles() {
    let question = "x''+x=k*((1-x^2)*x'-x^3)";
    let answer = json(&format!("expand {question} --small k --order 7 --damping-order 3"));
    let cycle = &answer["limit_cycles"][0];
    close(&cycle["amplitude"][0], 2.0, 1e-14);
    close(&cycle["angular_frequency_rad_per_s"][1], 1.5, 1e-13);
    close(&cycle["exponent_per_s"][1], -1.0, 1e-13);
    let shown = text(&format!("expand {question} --small k --order 7 --damping-order 3"));
    assert!(shown.contains("limit cycle, in digits, attracting for k > 0:\nA = 2 "), "{shown}");
    assert_eq!(json("expand damped_pendulum --set n=2")["limit_cycles"], serde_json::json!([]));
}

/// The amplitude differs from 2 if the cubic term is not small; the reference comes from integrations of the full equation.
#[test]
fn limit_cycles_over_exact_orbits_stand_below_the_slow_flow() {
    let question = "x''+x+x^3=e*(1-x^2)*x'";
    let answer = json(&format!("expand {question} --small e --order 3"));
    let cycle = &answer["leading_limit_cycles"][0];
    close(&cycle["amplitude"], 1.935_091_977_5, 1e-9);
    close(&cycle["other_side"], -1.935_091_977_5, 1e-9);
    assert!(
        cycle["amplitude_uncertainty"].as_f64().unwrap() < 1e-12
            && cycle["exponent_per_s"].as_f64().unwrap() < 0.0
    );
    assert_eq!(answer["limit_cycles"], serde_json::json!([]));
    let shown = text(&format!("expand {question} --small e --order 3"))
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    assert!(shown.contains("attracting for e > 0: from -1.935091977 to A = 1.93509197"), "{shown}");
    let takes =
        text("expand x''+x+x^3+e*x'=0 --small e --order 3").split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(takes.contains("for e > 0 the small terms take energy over every exact orbit"), "{takes}");
}

#[test]
fn slow_flows_that_cannot_be_are_refused() {
    for (arguments, status, expected) in [
        (&["expand", "x''+0.1*x'+x=0", "--damping-order", "2"][..], 1, "leave the one without a value"),
        (&["expand", "x''+0.1*x'+x=0"], 1, "libration expand with --damping-order 2"),
        (&["expand", "x''+x+c*x*sign(x')=0"], 1, "a polynomial in position and velocity"),
        (&["expand", "x''+x+a*x^3+c*sign(x')=0"], 1, "a symbolic expansion about"),
        (&["expand", "x''+c*x'+x+b*x^3=0", "--damping-order", "2"], 2, "such as --small c"),
        (&["expand", "x''+c*x'+x=0", "--small", "k"], 2, "`k` is not a symbolic parameter"),
        (&["expand", "x''+c*x'*abs(x')+x=0", "--small", "c", "--gauge", "fundamental"], 2, "give x_max"),
        (&["expand", "damped_pendulum", "--evaluate", "1"], 2, "not a series at one amplitude"),
        (&["expand", "damped_pendulum", "--about", "pi"], 2, "nearest to zero"),
        (&["expand", "damped_pendulum", "--damping-order", "21"], 2, "20"),
    ] {
        let message = refusal(arguments, status);
        assert!(message.contains(expected), "{arguments:?}: {message}");
    }
    // No hint to what was tried in vain.
    for equation in ["x''+x+c*x*sign(x')=0", "x''+mu*x'+log(2+x')*x=0"] {
        let message = refusal(&["expand", equation], 1);
        assert!(message.contains("libration simulate") && !message.contains("--damping-order"), "{message}");
    }
}

/// Sources: dry friction takes 4cA per swing from the energy A²/2, so that A′ = −2c/π; for −c·x′|x′|, A′ = −4cA²/3π; for the last case see the
/// test of the derivation, A = 2 and Ω = 1 + 3·A²/8·eps/5 for the force x³/5.
#[test]
fn strengths_without_an_expansion_as_a_limit_cycle_have_their_slow_flow_for_an_answer() {
    for (equation, expected) in [
        ("x'' + x + c*sign(x') = 0", "A′ = -2/π c\n"),
        ("x'' + x + c*x'*abs(x') = 0", "A′ = -4/(3π) c A²"),
        ("x'' + x = eps*((1-x^2)*x' - x^3/5)", "Ω = 1 + 0.3 eps"),
        ("x'' + 2*mu*x' + sin(x) = 0", "A′ = -mu A"),
        ("x'' + x + c*x'^3 = 0", "A′ = -3/8 c A³\n"),
        ("x'' + c*x' + x = 0", "A′ = -1/2 c A\n"),
        ("theta'' + c*theta'*abs(theta') + sin(theta) = 0", "A′ = -4/(3π) c A²"),
        ("x'' - mu*(1-x^2)*x' + x + x^3 = 0", "1.93509197749"),
    ] {
        let output = run(&["expand", equation, "--order", "3"]);
        let words = String::from_utf8(output.stdout.clone()).unwrap();
        assert!(output.status.success() && words.contains(expected), "{words} {}", message(&output));
        assert!(message(&output).contains("this is the slow flow"), "{}", message(&output));
    }
}

/// The remainder of the period is bounded, not estimated, if the force is an
/// odd polynomial; far outside the range of convergence there is no bound.
#[test]
fn remainders_of_odd_polynomials_are_proven() {
    let answer = json("expand x''=-x+x^3 --order 5 --evaluate 0.999");
    let last = answer["steps"].as_array().unwrap().last().unwrap().clone();
    let (error, bound) = (last["error"].as_f64().unwrap().abs(), last["bound"].as_f64().unwrap());
    assert_eq!(last["bound_is"], "proven");
    assert!(error <= bound && bound < 1.01 * error, "{error} {bound}");
    let outside = text("expand duffing --evaluate 1e300");
    for word in ["inf ", "nan", "1 for 1e-3"] {
        assert!(!outside.contains(word), "{word}: {outside}");
    }
    assert!(outside.contains("beyond range") && outside.contains("unknown"));
}

#[test]
fn a_limit_cycle_at_a_strength_is_compared_with_the_orbit_next_to_it() {
    let near = json("expand van_der_pol --order 1 --evaluate 0.5");
    // By SciPy's DOP853 and a fast Fourier transform.
    assert!((near["orbit_distance"].as_f64().unwrap() / 0.03191796203045061 - 1.0).abs() < 1e-3, "{near}");
    assert!(near["orbit_distance_uncertainty"].as_f64().unwrap() < 1e-11, "{near}");
    let far = json("expand van_der_pol --order 15 --evaluate 6");
    let warning = "no periodic orbit is near the limit cycle that the series gives here";
    assert!(far["note"].as_str().unwrap().contains(warning), "{far}");
    assert!(!near["note"].as_str().is_some_and(|note| note.contains(warning)), "{near}");
    // Long lines are wrapped.
    let sheet = text("expand van_der_pol --order 15 --evaluate 6");
    assert!(sheet.contains("warning") && sheet.contains("no periodic orbit"), "{sheet}");
    assert!(text("expand van_der_pol --order 1 --evaluate 0.5").contains("distance"));
    assert!(json("expand duffing --evaluate 0.5")["orbit_distance"].is_null());
}
