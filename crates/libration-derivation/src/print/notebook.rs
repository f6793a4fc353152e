//! Derivations as a Jupyter notebook: its cells repeat the checks with Python's fractions and floats, and those of exercises compare the
//! reader's answers by `SymPy`.

use super::super::check::{
    Check, CheckedEquation, FlowTerms, OpenCondition, QuarterFormula, TruncatedFormula,
};
use super::super::document::{Block, Derivation, DerivationStep};
use super::super::formula::{Name, Statement};
use super::super::python::{self, Questions};
use super::super::typeset::statement_latex;
use super::{BlockPosition, markdown_text};
use libration::algebra::Rational;

/// The derivation as a notebook of format 4.5.
#[must_use]
pub fn to_notebook(derivation: &Derivation) -> String {
    let mut notebook = Notebook::default();
    notebook.say(&format!("# {}", markdown_text::title(derivation)));
    notebook.blocks(BlockPosition::INTRODUCTION, &derivation.introduction);
    if derivation.answers.is_empty() {
        notebook.say(
            "Formulas that can be checked with Python’s own fractions and floats have a cell that does so again, on your computer: it raises an \
             error where the formula does not hold. The check made while this was written stands below the others. A folded cell defines the functions that the cells use.",
        );
    } else {
        notebook.begin_exercises(derivation);
    }
    let mut answers = "## Answers";
    for (position, step) in BlockPosition::steps(derivation) {
        if position.is_answer && !answers.is_empty() {
            notebook.say(std::mem::take(&mut answers));
            if notebook.questions.comparison().is_some() {
                notebook.say("The cells below give `sin`, `cos` and `pi` other meanings: run the first cell again before you answer again.");
            }
        }
        notebook.step(position, step);
    }
    notebook.written()
}

/// The cells so far, and the text of the next one.
#[derive(Default)]
struct Notebook<'a> {
    cells: Vec<String>,
    text: String,
    /// The condition whose ansatz is defined in the cells, and the coefficients that are known for it.
    ansatz: Option<&'a OpenCondition>,
    determined: Vec<&'a Name>,
    /// The equation whose slow flow is defined in the cells.
    flow: Option<&'a FlowTerms>,
    /// `true` if the quarter swing is defined in the cells.
    has_quarter: bool,
    /// The exercises whose answers are compared.
    questions: Questions,
    /// The place of the cell with the functions that checks use, and the code of the checks.
    prelude: Option<usize>,
    checks: Vec<String>,
    /// The force and the harmonics that are kept.
    few: Option<(&'a [Rational], &'a [usize])>,
}

impl<'a> Notebook<'a> {
    /// The cell that compares answers, with what it says and the symbols that it knows.
    fn begin_exercises(&mut self, derivation: &Derivation) {
        for (position, step) in BlockPosition::steps(derivation).filter(|(position, _)| position.is_answer) {
            self.questions.add(position.step, &step.blocks);
        }
        let Some(code) = self.questions.comparison() else { return };
        let symbols = self.questions.symbols();
        self.say(&format!(
            "Write what you have found into the cells, as a formula of SymPy in place of `None`, and run them: each says that the answer is \
             right, right but not simplified, or in which terms it is wrong. The symbols are {symbols}. A condition that vanishes may be given \
             with any factor. Run the next, folded cell first."
        ));
        self.compute_folded("comparison", &code);
    }

    fn step(&mut self, position: BlockPosition<'a>, step: &'a DerivationStep) {
        self.end_text();
        let level = if position.is_answer { "###" } else { "##" };
        self.say(&format!("{level} {}. {}", position.step, markdown_text::heading(step)));
        self.blocks(position, &step.blocks);
    }

    fn blocks(&mut self, position: BlockPosition<'a>, blocks: &'a [Block]) {
        for block in blocks {
            match block {
                Block::Equation { number, equation } => self.equation(position, *number, equation),
                Block::Exercise { number, statement, .. } => {
                    self.say(&formula(position, *number, statement));
                    if let Some(code) = self.questions.answer(&position.number(*number)) {
                        self.compute(&format!("exercise-{}-{number}", position.id), &code);
                    }
                }
                Block::Details { summary, blocks } => {
                    self.say(&format!("*{summary}:*"));
                    self.blocks(position, blocks);
                }
                other => self.say(&markdown_text::block(position, other)),
            }
        }
    }

    fn equation(&mut self, position: BlockPosition<'a>, number: usize, equation: &'a CheckedEquation) {
        self.say(&formula(position, number, equation.statement()));
        let Some(code) = python::check(equation) else {
            return self.say(&markdown_text::check(equation));
        };
        let mut lines = vec![format!("# ({})", position.number(number))];
        if let Check::Substituted { condition: Some(condition), .. } = equation.check() {
            self.begin(condition);
            lines.extend(self.lower(condition));
            self.determined.extend(&condition.fixes);
        }
        if let Check::Truncated(formula) = equation.check() {
            self.begin_few(formula);
        }
        if let Check::Quarter(formula) = equation.check() {
            self.begin_quarter(formula);
        }
        if let Check::Averaged(formula) = equation.check() {
            self.begin_flow(&formula.flow, python::slow_flow);
        }
        if let Check::Cycle(formula) = equation.check() {
            self.begin_flow(&formula.flow, python::limit_cycle);
        }
        lines.push(code);
        let kind = if position.is_answer { "answer" } else { "check" };
        let name = format!("{kind}-{}-{number}", position.id);
        self.check(&name, &lines.join("\n"));
    }

    /// Defines the ansatz of a condition, unless the previous conditions have the same one.
    fn begin(&mut self, condition: &'a OpenCondition) {
        let is_same = self.ansatz.is_some_and(|ansatz| ansatz.harmonics == condition.harmonics);
        if let (false, Some(code)) = (is_same, python::ansatz(condition)) {
            (self.ansatz, self.determined) = (Some(condition), vec![]);
            self.check(&format!("ansatz-{}", self.cells.len()), &code);
        }
    }

    fn begin_few(&mut self, formula: &'a TruncatedFormula) {
        let terms = (formula.force.as_slice(), formula.harmonics.as_slice());
        if let (false, Some(code)) = (self.few == Some(terms), python::few_harmonics(formula)) {
            self.few = Some(terms);
            self.check(&format!("few-{}", self.cells.len()), &code);
        }
    }

    /// Defines the quarter swing, of which a derivation has one.
    fn begin_quarter(&mut self, formula: &QuarterFormula) {
        if let (false, Some(code)) = (self.has_quarter, python::quarter_swing(formula)) {
            self.has_quarter = true;
            self.check(&format!("quarter-{}", self.cells.len()), &code);
        }
    }

    fn begin_flow(&mut self, flow: &'a FlowTerms, written: fn(&FlowTerms) -> Option<String>) {
        if let (false, Some(code)) = (self.flow == Some(flow), written(flow)) {
            self.flow = Some(flow);
            self.check(&format!("flow-{}", self.cells.len()), &code);
        }
    }

    /// The coefficients that a condition takes from lower powers and that have no cell yet.
    fn lower(&mut self, condition: &'a OpenCondition) -> Vec<String> {
        let missing: Vec<_> =
            condition.lower.iter().filter(|(name, _)| !self.determined.contains(&name)).collect();
        self.determined.extend(missing.iter().map(|(name, _)| name));
        missing.into_iter().filter_map(|(name, value)| python::coefficient(name, value)).collect()
    }

    /// Adds a paragraph of text.
    fn say(&mut self, text: &str) {
        if !self.text.is_empty() {
            self.text.push_str("\n\n");
        }
        self.text.push_str(text);
    }

    fn end_text(&mut self) {
        if !self.text.is_empty() {
            let (id, source) = (self.cells.len(), json(&std::mem::take(&mut self.text)));
            self.cells.push(format!(
                "{{\"cell_type\": \"markdown\", \"id\": \"text-{id}\", \"metadata\": {{}}, \"source\": {source}}}"
            ));
        }
    }

    /// A cell of a check, the first of them after the functions that they use.
    fn check(&mut self, id: &str, code: &str) {
        self.end_text();
        if self.prelude.is_none() {
            self.prelude = Some(self.cells.len());
            self.cells.push(String::new());
        }
        self.checks.push(code.to_owned());
        self.compute(id, code);
    }

    fn compute(&mut self, id: &str, code: &str) {
        self.end_text();
        self.cells.push(code_cell(id, "{}", code));
    }

    /// A cell whose code is hidden until the reader opens it.
    fn compute_folded(&mut self, id: &str, code: &str) {
        self.end_text();
        self.cells.push(code_cell(id, FOLDED, code));
    }

    fn written(mut self) -> String {
        self.end_text();
        if let Some(index) = self.prelude {
            self.cells[index] = code_cell("prelude", FOLDED, &python::prelude_for(&self.checks));
        }
        format!(
            "{{\n \"cells\": [\n  {}\n ],\n \"metadata\": {{\"kernelspec\": {{\"display_name\": \"Python 3\", \"language\": \"python\", \
             \"name\": \"python3\"}}, \"language_info\": {{\"name\": \"python\"}}}},\n \"nbformat\": 4,\n \"nbformat_minor\": 5\n}}\n",
            self.cells.join(",\n  ")
        )
    }
}

/// The metadata of a folded cell, for Jupyter and for what is made of notebooks.
const FOLDED: &str = r#"{"jupyter": {"source_hidden": true}, "tags": ["hide-input"]}"#;

fn code_cell(id: &str, metadata: &str, code: &str) -> String {
    format!(
        "{{\"cell_type\": \"code\", \"execution_count\": null, \"id\": \"{id}\", \"metadata\": {metadata}, \"outputs\": [], \"source\": {}}}",
        json(code)
    )
}

/// A displayed formula with its number, in notebook syntax.
fn formula(position: BlockPosition<'_>, number: usize, statement: &Statement) -> String {
    format!("$$\n{}\n\\tag{{{}}}\n$$", statement_latex(statement), position.number(number))
}

/// Text as a JSON string.
fn json(text: &str) -> String {
    let escaped = text.chars().fold(String::with_capacity(text.len() + 2), |mut escaped, letter| {
        match letter {
            '"' | '\\' => escaped.extend(['\\', letter]),
            '\n' => escaped.push_str("\\n"),
            letter if letter.is_control() => escaped.push_str(&format!("\\u{:04x}", u32::from(letter))),
            letter => escaped.push(letter),
        }
        escaped
    });
    format!("\"{escaped}\"")
}
