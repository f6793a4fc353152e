//! `libration derive`.

use crate::command::{directory, libration, message, run, text, unfolded};
use std::fs;
use std::process::Command;

const ROADS: [&str; 6] = ["elliptic", "short", "formulas", "perturbation", "averaging", "limit-cycle"];

#[test]
fn every_road_is_written_in_every_format() {
    for road in ROADS {
        let markdown = text(&format!("derive --method {road}"));
        assert!(markdown.starts_with("# ") && markdown.contains("```math"), "{road}");
        let latex = text(&format!("derive --method {road} --format latex"));
        assert!(latex.starts_with("\\documentclass") && latex.ends_with("\\end{document}\n"), "{road}");
        let html = text(&format!("derive --method {road} --format html"));
        assert!(html.starts_with("<!DOCTYPE html>") && html.contains("<math display=\"block\">"), "{road}");
        assert!(!html.contains("http"), "{road} fetches something");
    }
}

#[test]
fn braces_of_latex_and_tags_of_html_are_closed() {
    for road in ROADS {
        let numbers = if ["averaging", "limit-cycle"].contains(&road) { "" } else { "--amplitude 40deg" };
        let latex = text(&format!("derive --method {road} {numbers} --format latex"));
        let count = |mark: &str| latex.matches(mark).count();
        assert_eq!(count("{"), count("}"), "{road}");
        assert_eq!(count("\\left("), count("\\right)"), "{road}");
        assert_eq!(count("\\begin{"), count("\\end{"), "{road}");
        let html = text(&format!("derive --method {road} {numbers} --format html"));
        for tag in [
            "p", "math", "mrow", "mfrac", "msqrt", "msup", "msub", "msubsup", "mi", "mn", "mo", "table", "td",
        ] {
            let opened =
                html.matches(&format!("<{tag}>")).count() + html.matches(&format!("<{tag} ")).count();
            assert_eq!(opened, html.matches(&format!("</{tag}>")).count(), "{road}: {tag}");
        }
    }
}

/// Several symbols or a drive need the derivation in small parameters, to products of two.
#[test]
fn symbols_and_drives_are_averaged() {
    const DUFFING: &str = "x''+2*eps*mu*x'+w0^2*x+eps*a*x^3=eps*F*cos(W*t)";
    let driven = text(&format!("derive --method averaging {DUFFING} --resonance 1/1"));
    assert!(driven.contains(r"A_{\mathrm{max}}:=\frac{F}{2\mu w_{0}}"), "{driven}");
    let second = text(&format!("derive --method averaging {DUFFING} --resonance 1/1 --damping-order 2"));
    assert!(second.contains(r"-\frac{15\varepsilon ^{2}a^{2}A^{4}}{256w_{0}^{3}}"), "{second}");
    let third =
        run(&["derive", "--method", "averaging", DUFFING, "--resonance", "1/1", "--damping-order", "3"]);
    let said = String::from_utf8(third.stderr).unwrap();
    assert!(third.status.code() == Some(1) && said.contains("products of two small terms"), "{said}");
    let cycle = text("derive --method limit-cycle x''+x=eps*(m*(1-x^2)*x'-b*x^3)");
    assert!(cycle.contains("A_{0}:=2"), "{cycle}");
    for (words, reason) in [
        (format!("--method averaging {DUFFING}"), "--resonance"),
        (format!("--method averaging {DUFFING} --resonance 1/1 --order 3"), "--order"),
        (format!("--method averaging {DUFFING} --resonance one"), "--resonance"),
        (format!("--method perturbation {DUFFING} --resonance 1/1"), "--resonance"),
        ("--method averaging --resonance 1/1".to_owned(), "equation"),
        ("--method averaging x''+c*x'+a*x=0 --small d:1".to_owned(), "--small"),
    ] {
        let words: Vec<&str> = ["derive"].into_iter().chain(words.split(' ')).collect();
        let output = run(&words);
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(2) && said.contains(reason), "{words:?}: {said}");
    }
}

#[test]
fn an_answer_is_judged_in_place_of_the_derivation() {
    let derive = |answer: &str, format: &str| {
        let output = run(&["derive", "--method", "short", "--answer", answer, "--format", format]);
        let said = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        (output.status.code(), unfolded(&said))
    };
    assert_eq!(derive("3.1=omega0^2*(1 - theta0^2/8)", "markdown"), (Some(0), unfolded("right\n")));
    let (status, html) = derive("2.3 = cos(psi)/4 + cos(3*psi)/4", "html");
    assert!(status == Some(0) && html.starts_with("<p class=\"wrong\">wrong: the term in <math>"), "{html}");
    for (answer, reason) in [
        ("3.1", "--answer: `3.1`: give the number of a formula and an answer"),
        ("7.7=1", "--answer: there is no exercise (7.7)"),
        ("3.1=zeta", "--answer: the derivation has no symbol ζ"),
    ] {
        let (status, said) = derive(answer, "markdown");
        assert!(status == Some(2) && said.contains(reason), "{said}");
    }
    assert!(derive("3.1=1", "latex").1.contains("--format"));
}

#[test]
fn numbers_are_those_of_the_pendulum() {
    let derivation = text("derive --method elliptic --amplitude 40deg --length 57cm --gravity 9.81");
    // 2π√(l/g)/agm(1, cos 20°), by mpmath.
    assert!(derivation.contains("1.5620138239"));
    assert!(!text("derive --method elliptic").contains("digits printed"));
}

#[test]
fn a_file_is_written_in_place_of_the_screen() {
    let path = directory("derive").join("period.html");
    let output = libration(&format!("derive --method elliptic --format html --output {}", path.display()));
    assert!(output.status.success(), "{}", message(&output));
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.lines().count() == 1 && said.contains("period.html written: "), "{said}");
    assert!(fs::read_to_string(&path).unwrap().ends_with("</html>\n"));
    assert_eq!(fs::read_dir(path.parent().unwrap()).unwrap().count(), 1);
}

#[test]
fn questions_without_sense_are_refused() {
    let cases = [
        ("derive", 2, "--method"),
        ("derive --method straight", 2, "elliptic"),
        ("derive --method elliptic --format pdf", 2, "latex"),
        ("derive --method elliptic --length 1m", 2, "--amplitude"),
        ("derive --method elliptic --amplitude 200deg", 1, "--amplitude"),
        ("derive --method formulas --amplitude 179.99deg", 1, "179.9"),
        ("derive --method elliptic --gauge x_max", 2, "--gauge"),
        ("derive --method formulas duffing", 2, "OSCILLATOR"),
        ("derive --method perturbation --order 1", 2, "2 to 9"),
        ("derive --method perturbation --order 10", 2, "--order"),
        ("derive --method perturbation --gauge best", 2, "fundamental"),
        ("derive --method perturbation nonsense", 2, "nonsense"),
        ("derive --method perturbation van_der_pol", 1, "velocity"),
        ("derive --method perturbation duffing --amplitude 0.5 --length 1m", 2, "--length"),
        ("derive --method perturbation duffing --gauge nome", 1, "nome"),
        ("derive --method perturbation duffing --amplitude 0", 1, "--amplitude"),
        ("derive --method perturbation x''+x+a*x^3=0 --amplitude 0.5", 1, "--amplitude"),
        ("derive --method perturbation x''+x+x*abs(x)=0 --gauge energy", 1, "x_max"),
        ("derive --method perturbation x''+x+max(x,0)^2=0", 1, "odd forces"),
        ("derive --method perturbation x''+x+x*x'=0", 1, "even powers"),
        ("derive --method averaging --amplitude 0.5", 2, "--amplitude"),
        ("derive --method averaging --gauge energy", 2, "--gauge"),
        ("derive --method averaging --about 1", 2, "--about"),
        ("derive --method averaging --damping-order 5", 2, "--damping-order"),
        ("derive --method averaging --order 10", 2, "--order"),
        ("derive --method averaging duffing", 1, "no parameter is symbolic"),
        ("derive --method averaging x''+a*x'+b*x'^3+x=0", 2, "--small"),
        ("derive --method averaging x''+a*x'+x=0 --small b", 2, "--small"),
        ("derive --method averaging x''+c*x'+2*x=0", 1, "unit of time"),
        ("derive --method limit-cycle --amplitude 0.5", 2, "--amplitude"),
        ("derive --method limit-cycle --damping-order 2", 2, "--damping-order"),
        ("derive --method limit-cycle duffing", 1, "no parameter is symbolic"),
        ("derive --method limit-cycle x''+c*(x'+x^3)+x=0", 1, "no limit cycle"),
        ("derive --method limit-cycle rayleigh_cubic", 1, "fraction"),
        ("derive --method perturbation --damping-order 2", 2, "--damping-order"),
        ("derive --method formulas --small c", 2, "--small"),
        ("derive --method elliptic --output /nonexistent/a/b.md", 1, "/nonexistent/a/b.md"),
    ];
    for (arguments, status, part) in cases {
        let output = libration(arguments);
        assert_eq!(output.status.code(), Some(status), "{arguments}");
        assert!(message(&output).contains(part), "{arguments}: {}", message(&output));
        assert!(output.stdout.is_empty(), "{arguments}");
    }
}

#[test]
fn perturbation_has_the_published_coefficients_in_both_published_gauges() {
    let derivation = text("derive --method perturbation --order 5");
    // B. Black and V. Vel, Am. J. Phys. 91, 776 (2023), equations (38), (45), (46), (48)-(51), with the correct (46).
    for coefficient in [
        r"-\frac{1}{4096}",
        r"\frac{1}{20480}",
        r"\frac{17}{61440}\theta _{0}^{5}",
        r"\frac{63}{4096}",
        r"\frac{129}{1024}",
        r"\frac{1}{3072}\theta _{0}^{4}",
        r"d_{4}=-\frac{1}{8}A_{1}A_{3}+\frac{1}{1024}A_{1}^{4}",
    ] {
        assert!(derivation.contains(coefficient), "{coefficient}");
    }
    assert!(derivation.contains("enough to decide for all"));
}

#[test]
fn other_oscillators_and_gauges_are_derived() {
    for arguments in [
        "quadratic --order 4",
        "duffing --order 7 --gauge x_max",
        "morse --order 3 --amplitude 0.1",
        "double_well --order 4 --gauge half_swing",
        "sinh --gauge energy",
        "rotating_hoop --set gamma=1/3",
        "x''+w^2*x+a*x^2+b*x^3=0 --order 4 --gauge energy",
        "theta''+g/l*sin(theta)=0 --gauge x_max",
        "x''-k*x+b*x^3=0 --about sqrt(k/b) --order 3",
        "relativistic --gauge A1=1,A3=-1 --amplitude 0.2",
        "pendulum --order 9 --gauge nome --amplitude 60deg --length 57cm",
    ] {
        let derivation = text(&format!("derive --method perturbation {arguments}"));
        assert!(derivation.contains("enough to decide for all"), "{arguments}");
    }
}

/// Exercises in every format, with the answers on a separate page.
#[test]
fn exercises_have_their_answers_at_the_end() {
    let question = "derive --method perturbation --order 3 --exercises --format";
    for (form, answers) in
        [("markdown", "## Answers"), ("latex", "\\part*{Answers}"), ("html", "id=\"answers\"")]
    {
        let page = text(&format!("{question} {form}"));
        let (asked, answered) = page.split_once(answers).unwrap();
        assert!(!asked.contains("192") && answered.contains("192"), "{form}");
    }
}

/// Runs the cells of a notebook in order: each formula is confirmed again on the reader's computer.
#[test]
fn notebooks_check_their_formulas_again() {
    let questions = [
        "--method elliptic",
        "--method elliptic --amplitude 40deg",
        "--method formulas --amplitude 170deg",
        "--method perturbation --order 7 --amplitude 60deg",
        "--method perturbation --order 4 --gauge A1=1,A2=1/2 --exercises",
        "--method perturbation helmholtz_duffing --order 5",
        "--method perturbation double_well --order 4 --gauge energy",
        "--method perturbation x''+w^2*x+a*x^2+b*x^3=0 --order 3",
        "--method perturbation x''+sqrt(2)*x+a*x*x'^2=0 --exercises",
        "--method perturbation x''+x+x*abs(x)=0 --order 4 --amplitude 0.1",
        "--method averaging --order 3",
        "--method averaging --set n=2",
        "--method damping --set n=3 --order 3 --exercises",
        "--method averaging --set n=0 --order 3",
        "--method averaging van_der_pol --order 7 --damping-order 3",
        "--method limit-cycle --order 5",
        "--method limit-cycle rayleigh --order 4 --exercises",
        "--method limit-cycle x''+4*x=e*((1-x^2)*x'-x^3+x^2) --order 4",
        "--method averaging x''+c*x'-2*x+2*x^3=0 --order 2",
        "--method averaging x''+2*eps*mu*x'+w0^2*x+eps*a*x^3=eps*F*cos(W*t) --resonance 1/1",
        "--method averaging x''+2*eps*mu*x'+w0^2*x+eps*a*x^3=F*cos(W*t) --resonance 1/3 --exercises",
        "--method averaging x''+c*x'*abs(x')+k*x+b*x^3=F*cos(W*t) --resonance 1/1 --small c:1,b:1,F:1",
        "--method limit-cycle x''+w^2*x=eps*(a*x'-b*x'^3-d*x^3-h*x^5)",
    ];
    let notebooks = questions.map(|question| {
        let cells = code_cells(&format!("derive {question} --format ipynb"));
        assert!(cells.len() > 20, "{question}: {}", cells.len());
        cells.join("\n")
    });
    for (question, complaint) in questions.iter().zip(complaints("notebooks", &notebooks)) {
        assert_eq!(complaint, None, "{question}");
    }
}

/// The polynomials of a few harmonics and the formulas of the catalogue are checked by cells too.
#[test]
fn notebooks_check_few_harmonics_and_formulas_of_the_catalogue() {
    let cells = code_cells("derive --method perturbation --order 3 --format ipynb").join("\n");
    let few = ["few.has_ratio", "few.leaves", "few.is_at_zero", "few.begins", "few.asks(5"];
    assert!(few.iter().all(|call| cells.contains(call)));
    let cells = code_cells("derive --method formulas --format ipynb");
    let formulas = |call: &str| cells.iter().skip(1).filter(|cell| cell.contains(call)).count();
    assert_eq!((formulas("error_begins("), formulas("error_vanishes_at_the_top(")), (8, 1));
    let changes = [("64)/(16*", "64)/(17*"), ("Q(3, 8)", "Q(3, 7)"), ("exact(8)/(pi", "exact(9)/(pi")];
    let wrong = changes.map(|(right, wrong)| {
        let is_changed = |cell: &String| cell.contains("error_") && cell.contains(right);
        let index = 1 + cells.iter().skip(1).position(is_changed).unwrap();
        WrongNotebook::new(&cells, index, cells[index].replace(right, wrong))
    });
    assert_all_are_found("notebooks_catalogue", &wrong);
}

#[test]
fn notebooks_of_driven_oscillators_find_wrong_formulas() {
    let cells = code_cells(
        "derive --method averaging x''+2*eps*mu*x'+w0^2*x+eps*a*x^3=eps*F*cos(W*t) --resonance 1/1 --format ipynb",
    );
    let changes = [("cos(3*ψ)", "3*ε", "4*ε"), ("(5.7)", "/(2*", "/(3*"), ("(6.3)", "(-F**2", "(-F**3")];
    let wrong = changes.map(|(inside, right, wrong)| {
        let index = cells.iter().position(|cell| cell.contains(inside) && cell.contains(right)).unwrap();
        WrongNotebook::new(&cells, index, cells[index].replace(right, wrong))
    });
    assert_all_are_found("notebooks_driven", &wrong);
}

/// A wrong number stops the cell in which it stands.
#[test]
fn notebooks_find_wrong_formulas() {
    let mut all = vec![];
    for (question, least) in [
        ("perturbation --order 5", 20),
        ("averaging --set n=2 --order 4", 15),
        ("averaging van_der_pol --order 5", 10),
        ("limit-cycle --order 3", 8),
        ("perturbation x''+x+x*abs(x)=0 --order 4", 8),
    ] {
        let wrong = with_a_wrong_cell(&code_cells(&format!("derive --method {question} --format ipynb")));
        assert!(wrong.len() > least, "{question}: {}", wrong.len());
        all.extend(wrong);
    }
    assert_all_are_found("notebooks_wrong", &all);
}

/// A notebook with one changed cell.
struct WrongNotebook {
    cell: String,
    program: String,
}

impl WrongNotebook {
    fn new(cells: &[String], index: usize, wrong: String) -> Self {
        let mut cells = cells.to_vec();
        cells[index].clone_from(&wrong);
        Self { cell: wrong, program: cells.join("\n") }
    }
}

/// The notebooks with a changed fraction, one for each cell with a fraction that may be changed.
fn with_a_wrong_cell(cells: &[String]) -> Vec<WrongNotebook> {
    let wrong = |(index, cell): (usize, &String)| {
        // The last number is changed, since the first ones may belong to given symbols.
        let at = cell.rfind("Q(").filter(|_| !is_for_any_function(cell))?;
        let changed = format!("{}Q(7, 6)*Q({}", &cell[..at], &cell[at + 2..]);
        Some(WrongNotebook::new(cells, index, changed))
    };
    cells.iter().enumerate().skip(1).filter_map(wrong).collect()
}

fn assert_all_are_found(name: &str, wrong: &[WrongNotebook]) {
    let programs: Vec<String> = wrong.iter().map(|notebook| notebook.program.clone()).collect();
    for (notebook, complaint) in wrong.iter().zip(complaints(name, &programs)) {
        assert!(complaint.is_some(), "{}", notebook.cell);
    }
}

fn code_cells(question: &str) -> Vec<String> {
    let notebook: serde_json::Value = serde_json::from_str(&text(question)).unwrap();
    assert_eq!((notebook["nbformat"].as_i64(), notebook["nbformat_minor"].as_i64()), (Some(4), Some(5)));
    let cells = notebook["cells"].as_array().unwrap();
    let mut ids: Vec<&str> = cells.iter().map(|cell| cell["id"].as_str().unwrap()).collect();
    let is_allowed = |letter: char| letter.is_ascii_alphanumeric() || letter == '-' || letter == '_';
    assert!(ids.iter().all(|id| (1..=64).contains(&id.len()) && id.chars().all(is_allowed)));
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), cells.len());
    let code = cells.iter().filter(|cell| cell["cell_type"] == "code");
    code.map(|cell| cell["source"].as_str().unwrap().to_owned()).collect()
}

/// Runs programs one after the other, each in a separate namespace.
const RUNNER: &str = r#"
import contextlib, io, json, sys, traceback

def complaint(program):
    try:
        with contextlib.redirect_stdout(io.StringIO()):
            exec(compile(program, "notebook", "exec"), {"__name__": "__main__"})
    except BaseException:
        return traceback.format_exc()

with open(sys.argv[1], encoding="utf-8") as programs:
    print(json.dumps([complaint(program) for program in json.load(programs)]))
"#;

/// Python's error for each of these programs; `None` for those that run to the end.
fn complaints(name: &str, programs: &[String]) -> Vec<Option<String>> {
    let path = directory(name).join("programs.json");
    fs::write(&path, serde_json::to_string(programs).unwrap()).unwrap();
    let output = Command::new("python3").args(["-c", RUNNER]).arg(path).output().unwrap();
    assert!(output.status.success(), "{}", message(&output));
    let outputs: Vec<Option<String>> = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(outputs.len(), programs.len());
    outputs
}

/// Returns `true` for a cell that holds for any function, so that a number in its example may change.
fn is_for_any_function(cell: &str) -> bool {
    cell.contains("r = lambda") || cell.contains("y = lambda")
}

/// A straight line for dry friction, an exponential for viscous damping, reciprocals for higher powers.
#[test]
fn the_decay_of_every_power_of_the_velocity_is_derived() {
    for (n, rate, law) in [
        (0, r"A'=-\frac{2c}{\pi }", r":=A_{0}-\beta \tau"),
        (1, r"A'=-\frac{1}{2}cA", r":=A_{0}e^{-\beta \tau }"),
        (2, r"A'=-\frac{4cA^{2}}{3\pi }", r":=\frac{A_{0}}{1+\beta A_{0}\tau }"),
        (3, r"A'=-\frac{3}{8}cA^{3}", r":=\frac{A_{0}}{\sqrt{1+2\beta A_{0}^{2}\tau }}"),
    ] {
        let page = text(&format!("derive --method averaging --set n={n} --order 3 --damping-order 1"));
        assert!(page.contains(rate) && page.contains(law), "{n}: {page}");
    }
}

/// Côté's document states the period of a physical pendulum with the centre of mass alone; the moment of inertia is needed too.
#[test]
fn the_period_of_any_rigid_body_is_derived() {
    let derivation = text("derive --method elliptic");
    let law = r"\omega _{0}^{2}:=\frac{Mgd}{I}";
    assert!(derivation.contains(law) && derivation.contains(r"\frac{2L}{3}"));
}
