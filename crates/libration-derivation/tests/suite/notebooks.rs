//! Notebooks: folded helpers, cells for answers, and exercises that do not contain their answers.

use libration::oscillator::{NamedOscillator, NumbersOrLetters};
use libration::perturbation::Gauge;
use libration::progress::Quiet;
use std::sync::LazyLock;

use libration_derivation::{
    Block, Derivation, Formula, averaging, elliptic, first_correction, formula_latex, formulas, limit_cycle,
    perturbation, to_notebook,
};

/// Each method, to each order from 1 to 5 that it has.
pub(crate) static DERIVATIONS: LazyLock<Vec<(String, Derivation)>> = LazyLock::new(derivations);

fn derivations() -> Vec<(String, Derivation)> {
    let pendulum = NamedOscillator::by_key("pendulum").unwrap().oscillator(&[]).unwrap();
    let well = NamedOscillator::by_key("helmholtz_duffing").unwrap().oscillator(&[]).unwrap();
    let of = |equation: &str| NumbersOrLetters::new(&equation.parse().unwrap(), None).unwrap();
    let derived =
        |equation: &str, order| perturbation(of(equation), order, &Gauge::Fundamental, None, &Quiet).unwrap();
    let damped = "theta'' + c*theta' + sin(theta) = 0".parse().unwrap();
    let rubbed = "x'' + x + c*x'*abs(x') = 0".parse().unwrap();
    let excited = "x'' - mu*(1 - x^2)*x' + x = 0".parse().unwrap();
    let mut all = vec![
        ("elliptic".to_owned(), elliptic(None).unwrap()),
        ("short".to_owned(), first_correction(None).unwrap()),
        ("formulas".to_owned(), formulas(None).unwrap()),
        ("asymmetric".to_owned(), perturbation(&well, 3, &Gauge::Fundamental, None, &Quiet).unwrap()),
        ("symbols".to_owned(), derived("x'' + w^2*x + a*x^2 + b*x^3 = 0", 4)),
        ("velocity".to_owned(), derived("x'' + w^2*x + a*x*x'^2 + b*x^3 = 0", 5)),
        ("two-sided".to_owned(), derived("x'' + x + x*abs(x) = 0", 4)),
        ("driven".to_owned(), crate::symbolic_slow_flow::duffing()),
        ("second-order".to_owned(), crate::symbolic_slow_flow::second_order()),
        ("rubbing".to_owned(), averaging(&rubbed, None, 2, 1, &Quiet).unwrap()),
    ];
    for order in 1..=5 {
        let mut add = |name: &str, derivation: Option<Derivation>| {
            all.extend(derivation.map(|derivation| (format!("{name} {order}"), derivation)));
        };
        add("perturbation", perturbation(&pendulum, order, &Gauge::Fundamental, None, &Quiet).ok());
        add("averaging", averaging(&damped, None, order, 2, &Quiet).ok());
        add("limit-cycle", limit_cycle(&excited, None, order, &Quiet).ok());
    }
    all
}

/// The results of the answers, in LaTeX.
fn results(blocks: &[Block]) -> Vec<String> {
    let of_block = |block: &Block| match block {
        Block::Equation { equation, .. } => {
            let statement = equation.statement();
            let is_zero = |formula: &Formula| formula_latex(formula) == "0";
            let all_are_zero = statement.rest.iter().all(|(_, side)| is_zero(side));
            let sides = statement.rest.iter().map(|(_, side)| side).filter(|side| !is_zero(side));
            let first = all_are_zero.then_some(&statement.first);
            sides.chain(first).filter(|side| !matches!(side, Formula::Order(_))).map(formula_latex).collect()
        }
        Block::Details { blocks, .. } => results(blocks),
        _ => vec![],
    };
    blocks.iter().flat_map(of_block).collect()
}

/// The cells without the escapes of JSON, spaces, and the ends of lines within a formula.
fn joined(notebook: &str) -> String {
    let text = notebook
        .replace("\\n", "\n")
        .replace("\\\"", "\"")
        .replace("\\\\", "\\")
        .replace(r"\\", "")
        .replace(r"\quad", "");
    text.chars().filter(|letter| !letter.is_whitespace() && *letter != '&').collect()
}

/// A result that is a whole right side above the line would be read there. Names and bare numbers, of which exercises speak, do not count.
#[test]
fn exercises_do_not_contain_their_answers_above_the_line() {
    let (mut searched, mut matched) = (0, 0);
    for (name, derivation) in DERIVATIONS.iter() {
        let exercises = derivation.clone().exercises();
        let results: Vec<String> =
            exercises.answers.iter().flat_map(|answer| results(&answer.blocks)).collect();
        let notebook = joined(&to_notebook(&exercises));
        let (above, below) = notebook.split_once("##Answers").unwrap_or((&notebook, ""));
        let is_long = |string: &&String| string.split("+O").next().is_some_and(|start| start.len() > 12);
        for result in results
            .iter()
            .filter(is_long)
            .filter(|result| result.chars().any(|character| character.is_ascii_digit()))
        {
            let result = joined(result);
            let stands = |ending: &str| above.contains(&format!("={result}{ending}"));
            assert!(
                !stands(r"\tag") && !stands("=") && !above.contains(&format!("{result}=0")),
                "{name}: {result}"
            );
            searched += 1;
            matched += usize::from(below.contains(&result));
        }
    }
    // The search finds what stands below, but for formulas that are broken within brackets.
    assert!(searched > 500 && matched * 20 > searched * 19, "{matched} of {searched}");
}

#[test]
fn helpers_are_folded_and_only_those_that_the_cells_use() {
    for (name, derivation) in DERIVATIONS.iter() {
        let notebook = to_notebook(derivation);
        let cells: Vec<&str> =
            notebook.lines().filter(|line| line.contains("\"cell_type\": \"code\"")).collect();
        let folded: Vec<&&str> =
            cells.iter().filter(|cell| cell.contains("\"source_hidden\": true")).collect();
        assert_eq!(folded.len(), 1, "{name}");
        assert!(folded[0].contains("\"id\": \"prelude\""), "{name}");
        let uses =
            |class: &str| cells.iter().filter(|cell| !folded.contains(cell)).any(|cell| cell.contains(class));
        for class in ["Ansatz(", "FewHarmonics(", "SlowFlow(", "LimitCycle(", "Quarter("] {
            let is_carried = folded[0].contains(&format!("class {}", class.trim_end_matches('(')));
            // A limit cycle takes its equation from a slow flow.
            assert_eq!(is_carried, uses(class), "{name}: {class}");
        }
    }
}

/// Two fifths of the results at least have a cell in which they are compared; the others are integrals, derivatives, sums and numbers.
#[test]
fn exercises_have_cells_for_answers() {
    for (name, derivation) in DERIVATIONS.iter() {
        let exercises = derivation.clone().exercises();
        let asked: usize = exercises.answers.iter().map(|answer| results(&answer.blocks).len()).sum();
        let notebook = to_notebook(&exercises);
        let (above, _) = notebook.split_once("## Answers").unwrap_or((&notebook, ""));
        let cells = above.matches("answer = None").count();
        assert!(5 * cells >= 2 * asked, "{name}: {cells} of {asked}");
        assert_eq!(cells > 0, above.contains("\"id\": \"comparison\""), "{name}");
    }
}
