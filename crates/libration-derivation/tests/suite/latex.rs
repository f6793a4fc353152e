//! The LaTeX of every derivation: rows have as many cells as their table has columns, and documents compile if `pdflatex` is present.

use libration::oscillator::{NamedOscillator, Oscillator, SymbolicOscillator};
use libration::perturbation::Gauge;
use libration::progress::Quiet;
use libration_derivation::{
    Derivation, averaging, elliptic, first_correction, formulas, limit_cycle, perturbation, to_latex,
    to_notebook,
};
use std::process::Command;

/// One derivation of each kind, and each as exercises.
fn derivations() -> Vec<(&'static str, Derivation)> {
    let pendulum = NamedOscillator::by_key("pendulum").unwrap().oscillator(&[]).unwrap();
    let two_sided = Oscillator::new(&"x'' + x + x^2/2 + x^3 = 0".parse().unwrap()).unwrap();
    let kinked = Oscillator::new(&"x'' + x + x*abs(x) = 0".parse().unwrap()).unwrap();
    let letters = "m*x'' + k*x + a*x^2 + b*x*x'^2 = 0".parse().unwrap();
    let letters = SymbolicOscillator::new(&letters).unwrap();
    let damped = "theta'' + c*theta' + sin(theta) = 0".parse().unwrap();
    let rubbed = "x'' + x + c*x'*abs(x') = 0".parse().unwrap();
    let excited = "x'' - mu*(1 - x^2)*x' + x = 0".parse().unwrap();
    let documents = vec![
        ("elliptic", elliptic(None).unwrap()),
        ("first_correction", first_correction(None).unwrap()),
        ("formulas", formulas(None).unwrap()),
        ("perturbation", perturbation(&pendulum, 5, &Gauge::Fundamental, None, &Quiet).unwrap()),
        ("two-sided", perturbation(&two_sided, 3, &Gauge::Fundamental, None, &Quiet).unwrap()),
        ("symbols", perturbation(&letters, 4, &Gauge::Fundamental, None, &Quiet).unwrap()),
        ("quarter", perturbation(&kinked, 4, &Gauge::Fundamental, None, &Quiet).unwrap()),
        ("averaging", averaging(&damped, None, 3, 2, &Quiet).unwrap()),
        ("rubbing", averaging(&rubbed, None, 3, 1, &Quiet).unwrap()),
        ("driven", crate::symbolic_slow_flow::duffing()),
        ("second-order", crate::symbolic_slow_flow::second_order()),
        ("limit-cycle", limit_cycle(&excited, None, 3, &Quiet).unwrap()),
    ];
    let exercises: Vec<_> =
        documents.iter().map(|(name, document)| (*name, document.clone().exercises())).collect();
    documents.into_iter().chain(exercises).collect()
}

/// The columns of a specification such as `r>{\raggedright}p{0.35\textwidth}`: letters outside braces.
fn columns(specification: &str) -> usize {
    let mut depth = 0;
    let mut columns = 0;
    for letter in specification.chars() {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            'r' | 'l' | 'c' | 'p' if depth == 0 => columns += 1,
            _ => {}
        }
    }
    columns
}

/// The text up to the closing brace of a group whose opening brace was consumed, and the rest.
fn in_braces(text: &str) -> (&str, &str) {
    let mut depth = 1;
    for (at, letter) in text.char_indices() {
        depth += match letter {
            '{' => 1,
            '}' => -1,
            _ => 0,
        };
        if depth == 0 {
            return (&text[..at], &text[at + 1..]);
        }
    }
    panic!("braces are not closed: {text}")
}

#[test]
fn tables_have_as_many_columns_as_cells() {
    let mut tables = 0;
    for (name, derivation) in derivations() {
        for table in to_latex(&derivation).split("\\begin{tabular}{").skip(1) {
            let (specification, rest) = in_braces(table);
            let rows = rest.split_once("\\end{tabular}").unwrap().0;
            for row in rows.lines().filter(|row| row.ends_with("\\\\")) {
                let cells = 1 + row.replace("\\&", "").matches('&').count();
                assert_eq!(cells, columns(specification), "{name}: {specification}: {row}");
            }
            tables += 1;
        }
    }
    assert!(tables > 20, "{tables}");
}

#[test]
fn documents_compile_where_pdflatex_is_present() {
    if Command::new("pdflatex").arg("--version").output().is_err() {
        return;
    }
    let directory = std::env::temp_dir().join(format!("libration-latex-{}", std::process::id()));
    std::fs::create_dir_all(&directory).unwrap();
    for (number, (name, derivation)) in derivations().into_iter().enumerate() {
        let file = format!("{name}-{number}.tex");
        std::fs::write(directory.join(&file), to_latex(&derivation)).unwrap();
        let output = Command::new("pdflatex")
            .args(["-interaction=nonstopmode", "-halt-on-error", &file])
            .current_dir(&directory)
            .output()
            .unwrap();
        let log = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(output.status.success(), "{name}: {}", &log[log.len().saturating_sub(2000)..]);
    }
    std::fs::remove_dir_all(&directory).unwrap();
}

/// A check before the answers would reveal them. Formulas of the catalogue are not results, and keep their checks.
#[test]
fn notebooks_of_exercises_compute_nothing_before_their_answers() {
    let exercises = derivations()
        .into_iter()
        .filter(|(name, derivation)| *name != "formulas" && !derivation.answers.is_empty());
    for (name, derivation) in exercises {
        let notebook = to_notebook(&derivation);
        let (exercises, answers) = notebook.split_once("## Answers").unwrap();
        let cells = exercises.matches("\"cell_type\": \"code\"").count();
        let headings =
            ["\"id\": \"exercise-", "\"id\": \"comparison\""].map(|id| exercises.matches(id).count());
        assert_eq!(cells, headings.iter().sum::<usize>(), "{name}");
        assert!(answers.contains("\"answer-"), "{name}");
    }
}
