//! `libration expand --format`: functions in programming languages, compiled, run and compared with the series.

use crate::command::{directory, json, message, run};
use serde_json::Value;
use std::path::Path;
use std::process::Command;

/// An expansion with symbolic parameters, their values in the order of the arguments, and points of evaluation.
struct Case {
    name: &'static str,
    arguments: &'static [&'static str],
    letters: &'static [(&'static str, &'static str)],
    amplitude: f64,
    time: f64,
}

const CASES: [Case; 8] = [
    Case {
        name: "duffing",
        arguments: &["duffing", "--order", "9"],
        letters: &[],
        amplitude: 0.4,
        time: 2.3,
    },
    Case {
        name: "mixed",
        arguments: &["x'' + w^2*x + a*x^2 + b*x^3 = 0", "--order", "7"],
        letters: &[("a", "0.3"), ("b", "-0.7"), ("w", "1.9")],
        amplitude: -0.35,
        time: 5.1,
    },
    Case {
        // Reserved words, a sum under the root, and symbols that differ only in case.
        name: "words",
        arguments: &["x'' + (lambda + k)*x + in*x^2 + K*sqrt(lambda)*x^3 = 0", "--order", "6"],
        letters: &[("K", "0.2"), ("in", "0.4"), ("k", "1.1"), ("lambda", "0.81")],
        amplitude: 0.25,
        time: 1.7,
    },
    Case {
        name: "shifted",
        arguments: &["x'' = a*x - time*x^3", "--about", "sqrt(a/time)", "--order", "5", "--gauge", "energy"],
        letters: &[("a", "1.44"), ("time", "0.25")],
        amplitude: 0.2,
        time: -3.0,
    },
    Case {
        name: "mirrored",
        arguments: &["x'' + x*x' + x = 0", "--order", "7"],
        letters: &[],
        amplitude: 0.5,
        time: 1.3,
    },
    Case {
        name: "mirrored_with_letters",
        arguments: &["x'' + c*x*x' + w^2*x + k*x^3 = 0", "--order", "5"],
        letters: &[("c", "0.6"), ("k", "-0.2"), ("w", "1.3")],
        amplitude: 0.4,
        time: -2.1,
    },
    Case {
        name: "cycle",
        arguments: &["van_der_pol", "--order", "6"],
        letters: &[],
        amplitude: 0.3,
        time: 4.0,
    },
    Case {
        name: "irrational_cycle",
        arguments: &["x'' - mu*(1 - 3*x^2)*x' + x = 0", "--order", "4"],
        letters: &[],
        amplitude: 0.3,
        time: 0.9,
    },
];

/// The value of a fraction or decimal given as text.
fn number(text: &Value) -> f64 {
    let text = text.as_str().unwrap();
    let (above, below) = text.split_once('/').unwrap_or((text, "1"));
    above.parse::<f64>().unwrap() / below.parse::<f64>().unwrap()
}

fn series(coefficients: &Value, at: f64) -> f64 {
    coefficients.as_array().unwrap().iter().rev().fold(0.0, |sum, coefficient| number(coefficient) + at * sum)
}

/// Frequency, period and displacement by the series of the command with numbers in place of the symbols.
fn expected(case: &Case) -> [f64; 3] {
    let mut arguments = vec!["expand"];
    let values: Vec<String> = case.letters.iter().map(|(name, value)| format!("{name}={value}")).collect();
    arguments.extend(case.arguments);
    values.iter().for_each(|value| arguments.extend(["--set", value]));
    arguments.push("--json");
    let output = run(&arguments);
    assert!(output.status.success(), "{arguments:?}: {}", message(&output));
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    let of = if answer["of_amplitude"].is_null() { &answer } else { &answer["of_amplitude"] };
    let frequency = number(&answer["omega0_squared"]).sqrt() * series(&of["frequency_ratio"], case.amplitude);
    let unit = number(&answer["unit_squared"]).sqrt();
    let wave = |(k, harmonic): (&String, &Value)| {
        let phase = k.parse::<f64>().unwrap() * frequency * case.time;
        series(&harmonic["cos"], case.amplitude) * phase.cos()
            + series(&harmonic["sin"], case.amplitude) * phase.sin()
    };
    let displacement: f64 = of["harmonics"].as_object().unwrap().iter().map(wave).sum();
    [frequency, std::f64::consts::TAU / frequency, number(&answer["equilibrium"]) + unit * displacement]
}

fn code(case: &Case, format: &str) -> String {
    let output = run(&[&["expand"], case.arguments, &["--format", format]].concat());
    assert!(output.status.success(), "{}: {}", case.name, message(&output));
    String::from_utf8(output.stdout).unwrap()
}

/// The calls of the three functions.
fn calls(case: &Case, number: impl Fn(&str) -> String) -> [String; 3] {
    let amplitude = number(&format!("{:?}", case.amplitude));
    let letters: String = case.letters.iter().map(|(_, value)| format!(", {}", number(value))).collect();
    let time = number(&format!("{:?}", case.time));
    [
        format!("frequency({amplitude}{letters})"),
        format!("period({amplitude}{letters})"),
        format!("displacement({amplitude}, {time}{letters})"),
    ]
}

/// Runs a program that prints three numbers, and compares them. Both sides round each of fewer than a hundred steps once: 1e-13.
fn assert_printed(case: &Case, format: &str, program: &mut Command) {
    let output = program.output().unwrap();
    assert!(output.status.success(), "{} in {format}: {}", case.name, message(&output));
    let text = String::from_utf8(output.stdout).unwrap();
    let printed: Vec<f64> = text.split_whitespace().map(|number| number.parse().unwrap()).collect();
    assert_eq!(printed.len(), 3, "{text}");
    for (printed, expected) in printed.iter().zip(expected(case)) {
        let error = (printed - expected).abs();
        assert!(
            error <= 1e-13 * expected.abs().max(1.0),
            "{} in {format}: {printed}, not {expected}",
            case.name
        );
    }
}

fn built(compiler: &str, arguments: &[&str], folder: &Path) {
    let output = Command::new(compiler).args(arguments).current_dir(folder).output().unwrap();
    assert!(output.status.success(), "{compiler} {arguments:?}: {}", message(&output));
}

fn is_there(program: &str) -> bool {
    Command::new(program).arg("--version").output().is_ok_and(|output| output.status.success())
}

#[test]
fn python_computes_what_the_series_say() {
    let folder = directory("expansion_code_python");
    for case in &CASES {
        let prints: String = calls(case, str::to_owned).map(|call| format!("print(repr({call}))\n")).concat();
        let file = folder.join(format!("{}.py", case.name));
        std::fs::write(&file, code(case, "python") + "\n\n" + &prints).unwrap();
        assert_printed(case, "python", Command::new("python3").arg(file));
    }
}

#[test]
fn rust_computes_what_the_series_say() {
    let folder = directory("expansion_code_rust");
    let (mut modules, mut main) = (String::new(), String::new());
    for case in &CASES {
        modules += &format!("mod {} {{\n{}}}\n", case.name, code(case, "rust"));
        let prints =
            calls(case, str::to_owned).map(|call| format!("println!(\"{{:?}}\", {}::{call});\n", case.name));
        main += &format!(
            "if std::env::args().any(|argument| argument == \"{}\") {{\n{}}}\n",
            case.name,
            prints.concat()
        );
    }
    std::fs::write(folder.join("code.rs"), format!("{modules}fn main() {{\n{main}}}\n")).unwrap();
    built("rustc", &["--edition", "2024", "-o", "code", "code.rs"], &folder);
    for case in &CASES {
        assert_printed(case, "rust", Command::new(folder.join("code")).arg(case.name));
    }
}

#[test]
fn c_computes_what_the_series_say() {
    if !is_there("cc") {
        return;
    }
    let folder = directory("expansion_code_c");
    for case in &CASES {
        let prints =
            calls(case, str::to_owned).map(|call| format!("printf(\"%.17g\\n\", {call});\n")).concat();
        let main = format!("#include <stdio.h>\nint main(void)\n{{\n{prints}return 0;\n}}\n");
        std::fs::write(folder.join("code.c"), code(case, "c") + &main).unwrap();
        built("cc", &["-std=c99", "-Wall", "-Werror", "-o", case.name, "code.c", "-lm"], &folder);
        assert_printed(case, "c", &mut Command::new(folder.join(case.name)));
    }
}

#[test]
fn fortran_computes_what_the_series_say() {
    if !is_there("gfortran") {
        return;
    }
    let folder = directory("expansion_code_fortran");
    for case in &CASES {
        let prints =
            calls(case, |name| format!("{name}_real64")).map(|call| format!("  print *, {call}\n")).concat();
        let main = format!(
            "program main\n  use, intrinsic :: iso_fortran_env, only: real64\n  use oscillator\n  implicit none\n{prints}end program main\n"
        );
        std::fs::write(folder.join("code.f90"), code(case, "fortran") + &main).unwrap();
        built("gfortran", &["-std=f2008", "-Wall", "-o", case.name, "code.f90"], &folder);
        assert_printed(case, "fortran", &mut Command::new(folder.join(case.name)));
    }
}

#[test]
fn the_comment_says_what_order_gauge_and_reach_the_functions_have() {
    let code = run(&["expand", "pendulum", "--order", "5", "--gauge", "energy", "--format", "c"]);
    let code = String::from_utf8(code.stdout).unwrap();
    for part in
        ["theta'' + sin(theta) = 0", "order 5", "gauge energy", "converges for amplitudes below 3.14159"]
    {
        assert!(code.contains(part), "{part}: {code}");
    }
    let letters = run(&["expand", "duffing", "--letters", "epsilon", "--format", "rust"]);
    assert!(String::from_utf8(letters.stdout).unwrap().contains("with symbols, the radius of convergence"));
    let order = run(&["expand", "duffing", "--order", "61", "--format", "c"]);
    let code = String::from_utf8(order.stdout).unwrap();
    assert!(code.lines().all(|line| line.len() < 132), "{code}");
    for refused in [&["--json"][..], &["--evaluate", "1"], &["--latex"]] {
        assert_eq!(run(&[&["expand", "duffing", "--format", "c"], refused].concat()).status.code(), Some(2));
    }
    assert_eq!(json("expand duffing --order 3")["order"], 3);
}

/// Slow flows whose formulas have capitals and small letters, words that languages reserve, π, several coordinates, and long products.
const FLOWS: [&[&str]; 6] = [
    &["expand", "x'' + 2*eps*None*x' + NAN^2*x + eps*Some*x^3 = eps*Sin*cos(W*t)", "--resonance", "1/1"],
    &["expand", "x'' + 2*eps*lambda*x' + in^2*x + eps*a*x^3 = eps*F*cos(W*t)", "--resonance", "1/1"],
    &["expand", "x'' + w0^2*x + eps*R*sign(x') = eps*F*cos(W*t)", "--resonance", "1/1"],
    &["expand", "x''+m*x'+x+x^2=F*cos(W*t)", "--resonance", "1/1", "--small", "m:2,F:2", "--order", "4"],
    &["resonance", "x''+w1^2*x+eps*a*x*y=0; y''+w2^2*y+eps*B*x^2=0", "--ratios", "1:2", "--order", "3"],
    &[
        "resonance",
        "x''+natural_frequency^2*x+small_parameter*coupling_coefficient_of_the_first_coordinate*x*y=0; y''+w2^2*y+small_parameter*b*x^2=0",
        "--ratios",
        "1:2",
        "--small",
        "small_parameter:1",
    ],
];

/// Reads the CSV of a slow flow, and prints for each formula the name of its function, the values of its symbols by their names, and its own value.
const READ: &str = r#"
import re, sys
from math import cos, pi, sin, sqrt
known = {"cos", "pi", "sin", "sqrt", "abs"}
for line in sys.argv[1].splitlines()[1:]:
    *names, formula = line.split(",")
    words = sorted(set(re.findall(r"[A-Za-z_]\w*", formula)) - known)
    values = {word: 0.37 + 0.11 * place for place, word in enumerate(words)}
    symbol = lambda found: found[0] if found[0] in known else f"values['{found[0]}']"
    value = eval(re.sub(r"[A-Za-z_]\w*", symbol, formula.replace("^", "**")))
    print("_".join(reversed(names)), *values.values(), value)
"#;

/// The calls of the functions of a slow flow, with their values.
fn calls_of(flow: &[&str], number: impl Fn(&str) -> String) -> Vec<(String, f64)> {
    let table = String::from_utf8(run(&[flow, &["--csv"]].concat()).stdout).unwrap();
    let read = Command::new("python3").args(["-c", READ, &table]).output().unwrap();
    let call = |line: &str| {
        let words: Vec<&str> = line.split(' ').collect();
        let arguments: Vec<String> = words[1..words.len() - 1].iter().map(|word| number(word)).collect();
        (format!("{}({})", words[0], arguments.join(", ")), words[words.len() - 1].parse().unwrap())
    };
    String::from_utf8(read.stdout).unwrap().lines().map(call).collect()
}

/// Writes, builds and runs a program that prints the functions of each slow flow, and compares the values.
fn assert_flows(
    language: &str,
    number: fn(&str) -> String,
    program: fn(&str, &[String]) -> String,
    ran: fn(&Path) -> Command,
) {
    let folder = directory(&format!("slow_flow_{language}"));
    for flow in FLOWS {
        let code = run(&[flow, &["--format", language]].concat());
        assert!(code.status.success(), "{flow:?}: {}", message(&code));
        let (calls, values): (Vec<String>, Vec<f64>) = calls_of(flow, number).into_iter().unzip();
        assert!(calls.len() >= 6, "{flow:?}");
        let code = program(&String::from_utf8(code.stdout).unwrap(), &calls);
        std::fs::write(folder.join("code"), code).unwrap();
        let output = ran(&folder).output().unwrap();
        assert!(output.status.success(), "{flow:?} in {language}: {}", message(&output));
        let text = String::from_utf8(output.stdout).unwrap();
        let printed: Vec<f64> = text.split_whitespace().map(|value| value.parse().unwrap()).collect();
        assert_eq!(printed.len(), values.len(), "{text}");
        for ((printed, value), call) in printed.iter().zip(values).zip(calls) {
            // A few hundred roundings of terms that are below ten.
            let limit = 1e-13 * value.abs().max(1.0);
            assert!((printed - value).abs() < limit, "{call} in {language}: {printed}, not {value}");
        }
    }
}

fn printed(calls: &[String], before: &str, after: &str) -> String {
    calls.iter().map(|call| format!("{before}{call}{after}\n")).collect()
}

#[test]
fn slow_flows_in_python_are_their_formulas() {
    let program = |code: &str, calls: &[String]| format!("{code}\n\n{}", printed(calls, "print(repr(", "))"));
    let ran = |folder: &Path| {
        let mut python = Command::new("python3");
        python.arg(folder.join("code"));
        python
    };
    assert_flows("python", str::to_owned, program, ran);
}

#[test]
fn slow_flows_in_rust_are_their_formulas() {
    let program = |code: &str, calls: &[String]| {
        format!(
            "#![deny(warnings)]\n{code}\nfn main() {{\n{}}}\n",
            printed(calls, "println!(\"{:?}\", ", ");")
        )
    };
    let ran = |folder: &Path| {
        built("rustc", &["--edition", "2024", "-o", "program", "code"], folder);
        Command::new(folder.join("program"))
    };
    assert_flows("rust", str::to_owned, program, ran);
}

#[test]
fn slow_flows_in_c_are_their_formulas() {
    if !is_there("cc") {
        return;
    }
    let program = |code: &str, calls: &[String]| {
        let prints = printed(calls, "printf(\"%.17g\\n\", ", ");");
        format!("{code}\n#include <stdio.h>\nint main(void)\n{{\n{prints}return 0;\n}}\n")
    };
    let ran = |folder: &Path| {
        built("cc", &["-std=c99", "-Wall", "-Werror", "-o", "program", "-x", "c", "code", "-lm"], folder);
        Command::new(folder.join("program"))
    };
    assert_flows("c", str::to_owned, program, ran);
}

#[test]
fn slow_flows_in_fortran_are_their_formulas() {
    if !is_there("gfortran") {
        return;
    }
    let program = |code: &str, calls: &[String]| {
        let uses = "use, intrinsic :: iso_fortran_env, only: real64\n  use slow_flow\n  implicit none";
        let prints = printed(calls, "  print *, ", "").replace(", ", ", &\n    ");
        format!("{code}\nprogram main\n  {uses}\n{prints}end program main\n")
    };
    let ran = |folder: &Path| {
        let options = ["-std=f2008", "-ffree-form", "-Wall", "-Werror", "-o", "program", "-x", "f95", "code"];
        built("gfortran", &options, folder);
        Command::new(folder.join("program"))
    };
    assert_flows("fortran", |name| format!("{name}_real64"), program, ran);
}

/// Compares the functions of a slow flow of damping with the sums of the coefficients in its CSV.
const SUMMED: &str = r#"
import csv, inspect, math, sys
code, table, amplitude, phase, strength = sys.argv[1:]
at = {amplitude: 0.4, phase: 1.1, strength: 0.3}
exec(code)
sums = {"amplitude": 0.0, "phase": 0.0, "displacement": 0.0}
for row in csv.DictReader(table.splitlines()):
    term = float(row["value"])*0.3**int(row["parameter_power"])*0.4**int(row["amplitude_power"])
    wave, *numbers = row["quantity"].split("_")
    if wave in ("cos", "sin"):
        k, power = map(int, numbers)
        sums["displacement"] += term*1.1**power*getattr(math, wave)(k*1.1)
    else:
        sums[wave] += term
for name, expected in sums.items():
    of = globals()[name]
    value = of(**{word: at[word] for word in inspect.signature(of).parameters})
    assert abs(value - expected) < 1e-14, (name, value, expected)
"#;

/// Whole and half swings, π and roots in coefficients, a mean, and an equation whose displacement or strength is called as the amplitude or the phase.
#[test]
fn slow_flows_of_damping_are_their_coefficients_as_functions() {
    for (equation, letters) in [
        ("x'' + 2*mu*x' + sin(x) = 0", ["A", "psi", "mu"]),
        ("x'' + c*x'*abs(x') + x + x^3 = 0", ["A", "psi", "c"]),
        ("x'' + 2*x + c*sign(x') = 0", ["A", "psi", "c"]),
        ("A'' + psi*(A^2 - 1)*A' + A = 0", ["A_1", "psi_1", "psi"]),
    ] {
        let question = ["expand", equation, "--order", "4", "--damping-order", "2"];
        let written = |form: &[&str]| String::from_utf8(run(&[&question, form].concat()).stdout).unwrap();
        let flow: Value = serde_json::from_str(&written(&["--json"])).unwrap();
        assert_eq!(
            [&flow["letters"]["amplitude"], &flow["letters"]["phase"], &flow["small_parameter"]],
            letters
        );
        let code = written(&["--format", "python"]);
        let table = written(&["--csv"]);
        let arguments = ["-c", SUMMED, &code, &table].into_iter().chain(letters);
        let output = Command::new("python3").args(arguments).output().unwrap();
        assert!(output.status.success(), "{equation}: {}\n{code}", message(&output));
        let text = written(&[]);
        assert!(text.contains(&format!("\n{}′ = ", letters[0])), "{text}");
    }
}

/// The frequency is that of `--evaluate`; six harmonics miss less than 1e-7 of a cubic oscillator's displacement where it turns.
#[test]
fn scaling_laws_are_functions() {
    let question = ["expand", "x''+k*x^3=0"];
    let code = String::from_utf8(run(&[&question[..], &["--format", "python"]].concat()).stdout).unwrap();
    let frequency = &json("expand x''+k*x^3=0 --set k=3 --evaluate 2")["angular_frequency_rad_per_s"];
    let printed = format!(
        "{code}\nassert abs(angular_frequency(2.0, 3.0) - {frequency}) < 1e-14\n\
         assert abs(period(2.0, 3.0)*{frequency} - 6.283185307179586) < 1e-14\n\
         assert abs(displacement(2.0, 0.0) - 2.0) < 2e-7\n"
    );
    let output = Command::new("python3").args(["-c", &printed]).output().unwrap();
    assert!(output.status.success(), "{}\n{printed}", message(&output));
}

/// Fortran has one name for X and x: the second function gets another.
#[test]
fn coordinates_that_differ_by_a_capital_have_functions_in_fortran() {
    let flow = ["resonance", "X''+w1^2*X+eps*a*X*x=0; x''+w2^2*x+eps*b*X^2=0", "--ratios", "1:2"];
    let code = run(&[&flow[..], &["--format", "fortran"]].concat());
    let code = String::from_utf8(code.stdout).unwrap();
    assert!(code.contains("function amplitude_X(") && code.contains("function amplitude_x_("), "{code}");
    if !is_there("gfortran") {
        return;
    }
    let folder = directory("slow_flow_capitals");
    std::fs::write(folder.join("code"), code).unwrap();
    built("gfortran", &["-std=f2008", "-ffree-form", "-Wall", "-Werror", "-c", "-x", "f95", "code"], &folder);
}
