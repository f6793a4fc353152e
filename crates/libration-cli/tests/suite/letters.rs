//! `libration expand` with symbolic parameters.

use crate::command::{json, message, run, text, unfolded};
use serde_json::Value;

const MIXED: &str = "x'' + w^2*x + a*x^2 + b*x^3 = 0";

fn answer(arguments: &[&str]) -> Value {
    let output = run(&[&["expand"], arguments, &["--json"]].concat());
    assert!(output.status.success(), "{arguments:?}: {}", message(&output));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn list(value: &Value) -> Vec<&str> {
    value.as_array().unwrap().iter().map(|entry| entry.as_str().unwrap()).collect()
}

fn words(arguments: &[&str]) -> String {
    let output = run(&[&["expand"], arguments].concat());
    assert!(output.status.success(), "{arguments:?}: {}", message(&output));
    unfolded(&String::from_utf8(output.stdout).unwrap())
}

fn refusal(arguments: &[&str], status: i32) -> String {
    let output = run(&[&["expand"], arguments].concat());
    assert_eq!(output.status.code(), Some(status), "{arguments:?}: {}", message(&output));
    message(&output)
}

#[test]
fn parameters_without_a_value_stay_letters() {
    // A. H. Nayfeh, D. T. Mook, Nonlinear Oscillations, section 2.3.
    let series = answer(&[MIXED, "--order", "3"]);
    assert_eq!(list(&series["letters"]), ["a", "b", "w"]);
    assert_eq!((series["omega0_squared"].as_str(), series["omega0"].as_str()), (Some("w^2"), Some("w")));
    assert_eq!(list(&series["frequency_ratio"]), ["1", "0", "3*b/(8*w^2) - 5*a^2/(12*w^4)"]);
    assert_eq!(list(&series["angular_frequency"]), ["w", "0", "3*b/(8*w) - 5*a^2/(12*w^3)"]);
    assert_eq!(list(&series["harmonics"]["2"]["cos"]), ["0", "0", "a/(6*w^2)", "0"]);
    assert_eq!((&series["certified"], &series["certificate"]), (&true.into(), &"potential".into()));
}

#[test]
fn values_replace_some_letters_and_no_letters_are_left_where_all_have_one() {
    let some = answer(&[MIXED, "--set", "w=2,a=1/3", "--order", "3"]);
    assert_eq!(list(&some["letters"]), ["b"]);
    assert_eq!(list(&some["frequency_ratio"])[2], "-5/1728 + 3*b/32");
    let all = answer(&[MIXED, "--set", "w=2,a=1/3", "--set", "b=1", "--order", "3"]);
    assert_eq!((all["letters"].clone(), &all["omega0"]), (Value::Array(vec![]), &Value::Null));
    assert_eq!(list(&all["frequency_ratio"])[2], "157/1728");
}

#[test]
fn parameters_of_built_in_oscillators_stay_letters_when_they_are_named() {
    let series = json("expand cubic_quintic --letters alpha,beta --order 5");
    assert_eq!(series["parameters"], serde_json::json!({}));
    assert_eq!(list(&series["frequency_ratio"])[4], "5*beta/16 - 15*alpha^2/256");
    let one = json("expand cubic_quintic --letters beta --set alpha=1/2 --order 5");
    assert_eq!((one["parameters"]["alpha"].as_str(), list(&one["letters"])), (Some("1/2"), vec!["beta"]));
    let greek = answer(&["pendulum", "--letters", "ω0", "--order", "3"]);
    assert_eq!(
        (list(&greek["angular_frequency"])[2], list(&greek["letters"])),
        ("-omega0/16", vec!["omega0"])
    );
    assert_eq!(list(&json("expand van_der_pol --order 2")["letters"]), Vec::<&str>::new());
}

#[test]
fn a_root_that_is_no_product_is_said() {
    let sum = words(&["x'' + (k1 + k2)*x + b*x^3 = 0", "--order", "3"]);
    let setting =
        "where ω0² = k1 + k2, so that ω0 = sqrt(k1 + k2), which is called omega0 in the coefficients";
    assert!(sum.contains(setting) && sum.contains("3*b/(8*omega0^2) ε²"), "{sum}");
    let product = words(&["m*x'' + 2*k*x + b*x^3 = 0", "--order", "3"]);
    assert!(
        product.contains("where ω0² = 2*k/m, so that ω0 = sqrt(2*k/m) for positive symbols"),
        "{product}"
    );
    assert!(!product.contains(" Ω = "), "{product}");
    let square = words(&["m*x'' + k*x + b*x^3 = 0", "--order", "3"]);
    assert!(square.contains("Ω = sqrt(k)/sqrt(m) + 3*b/(8*sqrt(k)*sqrt(m)) ε²"), "{square}");
}

/// Asserts that every element is closed, in the order of nesting.
fn assert_balanced(line: &str) {
    let mut open: Vec<&str> = vec![];
    for tag in line.split('<').skip(1).map(|rest| rest.split('>').next().unwrap()) {
        match tag.strip_prefix('/') {
            Some(end) => assert_eq!(open.pop(), Some(end), "{line}"),
            None => open.push(tag.split(' ').next().unwrap()),
        }
    }
    assert!(open.is_empty(), "{line}");
}

#[test]
fn letters_are_written_in_every_form() {
    let latex = run(&["expand", MIXED, "--order", "3", "--latex"]);
    let latex = String::from_utf8(latex.stdout).unwrap();
    let frequency = r"\left(\frac{3 b}{8 w^{2}} - \frac{5 a^{2}}{12 w^{4}}\right) \epsilon^{2}";
    assert!(latex.contains(frequency), "{latex}");
    let mathml = run(&["expand", MIXED, "--order", "3", "--format", "mathml"]);
    let mathml = String::from_utf8(mathml.stdout).unwrap();
    let frequency = "<mfrac><mi>Ω</mi><msub><mi>ω</mi><mn>0</mn></msub></mfrac><mo>=</mo><mn>1</mn><mo>+</mo><mrow><mo>(</mo><mfrac>\
                     <mrow><mn>3</mn><mo>&#x2062;</mo><mi>b</mi></mrow><mrow><mn>8</mn><mo>&#x2062;</mo><msup><mi>w</mi><mn>2</mn>\
                     </msup></mrow></mfrac><mo>−</mo>";
    assert!(mathml.contains(frequency), "{mathml}");
    for line in mathml.lines() {
        assert_balanced(line);
    }
    let csv = run(&["expand", MIXED, "--order", "3", "--csv"]);
    let csv = String::from_utf8(csv.stdout).unwrap();
    assert!(csv.contains("frequency_ratio,epsilon,2,3*b/(8*w^2) - 5*a^2/(12*w^4)\n"), "{csv}");
    let bent = words(&["x'' = a*x - b*x^3", "--about", "sqrt(a/b)", "--order", "3", "--gauge", "x_max"]);
    assert!(bent.contains("about x = sqrt(a)/sqrt(b), where ω0² = 2*a"), "{bent}");
    assert!(bent.contains("x_max = ε x_min"), "{bent}");
    // The values of parameters apply to the equilibrium too.
    let question = ["x'' = a*x - b*x^3", "--about", "sqrt(a/b)", "--set", "a=4", "--order", "3"];
    assert_eq!(answer(&question)["equilibrium"], "2/sqrt(b)");
    let series = answer(&[&question[..], &["--set", "b=9"]].concat());
    assert_eq!((&series["equilibrium"], &series["letters"]), (&"2/3".into(), &Value::Array(vec![])));
}

#[test]
fn what_letters_cannot_say_is_refused() {
    let cases: [(&[&str], i32, &str); 9] = [
        (&[MIXED, "--evaluate", "1"], 1, "no value is given for a, b, w"),
        (&["duffing", "--letters", "epsilon", "--evaluate", "1"], 2, "give epsilon values with --set"),
        (&["duffing", "--letters", "mu"], 2, "--letters: the equation has no parameter `mu`"),
        (&["duffing", "--letters", "epsilon", "--set", "epsilon=1"], 2, "it has none"),
        (&[MIXED, "--letters", "c"], 2, "its parameters are a, b, w"),
        (&[MIXED, "--gauge", "nome"], 1, "pendulum"),
        (&["x'' + c*x' + k*x = 0"], 1, "-c times the velocity"),
        (&["x'' + a + k*x = 0"], 1, "no value is given for a, k"),
        (&["x'' = a*x"], 1, "omega0^2 = -a is negative"),
    ];
    for (arguments, status, part) in cases {
        let message = refusal(arguments, status);
        assert!(message.contains(part), "{arguments:?}: {message}");
    }
    // Orbits need numbers.
    let output = run(&["backbone", MIXED, "--amplitudes", "1"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(message(&output).contains("no value is given for a"), "{}", message(&output));
}

#[test]
fn constants_that_no_product_of_letters_is_are_named_and_explained() {
    let series = answer(&["x'' + sqrt(2)*x + a*x^3 + pi*x^5 = 0", "--order", "5"]);
    assert_eq!(series["constants"], serde_json::json!({"c1": "sqrt(2)"}));
    assert_eq!(list(&series["frequency_ratio"])[4], "5*pi/(16*c1) - 15*a^2/(256*c1^2)");
    let said = words(&["x'' + sqrt(2)*x + a*x^3 = 0", "--order", "3"]);
    assert!(
        said.contains("where ω0² = c1, so that ω0 = sqrt(c1) for positive symbols, with c1 = sqrt(2)"),
        "{said}"
    );
    let code = run(&["expand", "x'' + sqrt(2)*x + a*x^3 = 0", "--order", "3", "--format", "python"]);
    let code = String::from_utf8(code.stdout).unwrap();
    assert!(
        code.contains("the argument c1 stands for sqrt(2)") && code.contains("(amplitude, a, c1)"),
        "{code}"
    );
}

#[test]
fn letters_are_listed_among_the_fields() {
    let fields = text("fields expand");
    for name in ["letters[]", "omega0_name", "frequency[]"] {
        assert!(fields.contains(name), "{name}: {fields}");
    }
}
