//! The exercises of a notebook, whose answers `SymPy` compares.

use super::super::answers::Question;
use super::super::check::CheckedEquation;
use super::super::document::Block;
use super::super::formula::Formula;
use super::{expression, identifier};
use std::collections::BTreeSet;

/// The functions that compare an answer.
const COMPARISON: &str = include_str!("student.py");

/// The questions with their solutions, by the numbers of the formulas.
#[derive(Default)]
pub(crate) struct Questions {
    names: BTreeSet<String>,
    lines: Vec<(String, String)>,
}

impl Questions {
    /// Adds the answers of a step whose solutions are formulas of numbers, names and functions.
    pub(crate) fn add(&mut self, step: usize, answers: &[Block]) {
        for block in answers {
            match block {
                Block::Equation { number, equation } => {
                    self.add_equation(format!("{step}.{number}"), equation);
                }
                Block::Details { blocks, .. } => self.add(step, blocks),
                _ => {}
            }
        }
    }

    fn add_equation(&mut self, label: String, equation: &CheckedEquation) {
        let Some(Question { is_zero, asked, result }) = Question::of(equation) else { return };
        let Some(text) = expression(result) else { return };
        let question = asked.and_then(expression).unwrap_or_default();
        let names = asked.into_iter().chain([result]).flat_map(Formula::free_names);
        self.names.extend(names.filter_map(|name| identifier(&name)));
        let is_zero = if is_zero { "True" } else { "False" };
        let line = format!("    \"{label}\": ({is_zero}, \"{}\", \"{}\"),", digits(&question), digits(&text));
        self.lines.push((label, line));
    }

    /// Returns `true` if the answer with this number can be compared.
    pub(crate) fn has(&self, label: &str) -> bool {
        self.lines.iter().any(|(other, _)| other == label)
    }

    /// The cell that compares answers; `None` where none can be.
    pub(crate) fn comparison(&self) -> Option<String> {
        if self.lines.is_empty() {
            return None;
        }
        let names: Vec<&str> = self.names.iter().map(String::as_str).collect();
        let symbols = format!(
            "if sympy:\n    SYMBOLS = {{it: sympy.Symbol(it, positive=True) for it in \"{}\".split()}}\n    globals().update(SYMBOLS)",
            names.join(" ")
        );
        let lines: Vec<&str> = self.lines.iter().map(|(_, line)| line.as_str()).collect();
        let questions = format!("QUESTIONS = {{\n{}\n}}", lines.join("\n"));
        Some([COMPARISON.trim_end(), &symbols, &questions].join("\n\n\n"))
    }

    /// The cell for an answer.
    pub(crate) fn answer(&self, label: &str) -> Option<String> {
        let cell = || {
            format!(
                "answer = None  # in place of the question mark in ({label})\ncompare(\"{label}\", answer)"
            )
        };
        self.has(label).then(cell)
    }

    /// The symbols, as a sentence names them.
    pub(crate) fn symbols(&self) -> String {
        self.names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
    }
}

/// Text as hexadecimal digits.
fn digits(text: &str) -> String {
    text.bytes().map(|byte| format!("{byte:02x}")).collect()
}
