//! A derivation as data: steps of sentences, checked formulas and tables.

use super::check::CheckedEquation;
use super::formula::Formula;
use super::prose::Prose;

/// A worked derivation.
#[derive(Clone, Debug, PartialEq)]
pub struct Derivation {
    /// What is derived.
    pub title: String,
    /// Where it begins and where it leads.
    pub introduction: Vec<Block>,
    /// The steps in order.
    pub steps: Vec<DerivationStep>,
}

impl Derivation {
    /// The same with a sentence at its beginning that the last steps are missing.
    #[must_use]
    pub fn broken_off(mut self) -> Self {
        let told = "This derivation was interrupted: what follows its last step here is missing.";
        self.introduction.push(Block::Paragraph(Prose::text(told)));
        self
    }
}

/// A step of a derivation.
#[derive(Clone, Debug, PartialEq)]
pub struct DerivationStep {
    /// What it does.
    pub heading: String,
    /// How.
    pub blocks: Vec<Block>,
}

/// A part of a step.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// Sentences.
    Paragraph(Prose),
    /// An aside: a common error, a limit of what was said.
    Remark(Prose),
    /// A formula with its check.
    Equation(CheckedEquation),
    /// Numbers in rows.
    Table(DerivationTable),
}

/// What a reader wants to see.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wanted {
    /// The steps.
    Formulas,
    /// The steps with the numbers of a swing.
    Numbers,
}

/// Numbers in rows.
#[derive(Clone, Debug, PartialEq)]
pub struct DerivationTable {
    /// The titles of the columns.
    pub head: Vec<Prose>,
    /// The cells, row by row.
    pub rows: Vec<Vec<Prose>>,
    /// How the numbers were made and checked.
    pub note: Prose,
}

impl DerivationStep {
    pub(super) fn new(heading: &str) -> Self {
        Self { heading: heading.to_owned(), blocks: Vec::new() }
    }

    /// A paragraph, each `{}` of which is the next formula.
    pub(super) fn say<const N: usize>(self, template: &str, formulas: [Formula; N]) -> Self {
        self.with(Block::Paragraph(Prose::new(template, formulas)))
    }

    /// A paragraph where there is something to say.
    pub(super) fn say_where<const N: usize>(
        self,
        wanted: Wanted,
        template: &str,
        formulas: [Formula; N],
    ) -> Self {
        match wanted {
            Wanted::Numbers => self.say(template, formulas),
            Wanted::Formulas => self,
        }
    }

    /// An aside.
    pub(super) fn remark<const N: usize>(self, template: &str, formulas: [Formula; N]) -> Self {
        self.with(Block::Remark(Prose::new(template, formulas)))
    }

    /// A checked formula.
    pub(super) fn show(self, equation: CheckedEquation) -> Self {
        self.with(Block::Equation(equation))
    }

    /// Checked formulas.
    pub(super) fn show_all(self, equations: Vec<CheckedEquation>) -> Self {
        equations.into_iter().fold(self, Self::show)
    }

    /// A table.
    pub(super) fn table(self, table: DerivationTable) -> Self {
        self.with(Block::Table(table))
    }

    fn with(mut self, block: Block) -> Self {
        self.blocks.push(block);
        self
    }
}
