//! A derivation as data: steps of sentences, checked formulas and tables.

use super::check::CheckedEquation;
use super::formula::{Formula, Statement};
use super::prose::Prose;

/// A worked derivation.
#[derive(Clone, Debug, PartialEq)]
pub struct Derivation {
    /// Title: the subject of the derivation.
    pub title: String,
    /// Starting point and aim of the derivation.
    pub introduction: Vec<Block>,
    /// The steps in order.
    pub steps: Vec<DerivationStep>,
    /// Formulas omitted by [`exercises`](Self::exercises), each in its step; empty if nothing is omitted.
    pub answers: Vec<DerivationStep>,
}

impl Derivation {
    /// The derivation, beginning with a sentence which states that the last steps are missing.
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
    /// Identifier for links, unaffected when other steps are added or removed.
    pub id: String,
    /// Heading: the purpose of the step.
    pub heading: String,
    /// Content of the step.
    pub blocks: Vec<Block>,
}

/// A part of a step.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// Sentences.
    Paragraph(Prose),
    /// An aside: a common error, or a limitation.
    Remark(Prose),
    /// A formula with its check.
    Equation {
        /// Number of the formula in its step, from 1.
        number: usize,
        /// The formula.
        equation: CheckedEquation,
    },
    /// A formula whose result the reader is to find, or which the reader is to prove.
    Exercise {
        /// The number of the formula in its step.
        number: usize,
        /// The formula, with a question mark for the result if the reader is to find it.
        statement: Statement,
        /// `true` if [`Derivation::judge`] compares answers to it.
        is_comparable: bool,
    },
    /// Numbers or formulas in rows.
    Table(DerivationTable),
    /// Blocks that are folded away until a reader opens them.
    Details {
        /// The summary of the content.
        summary: String,
        /// The parts.
        blocks: Vec<Self>,
    },
}

/// The level of detail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wanted {
    /// The steps alone.
    Formulas,
    /// The steps with the numbers of a swing.
    Numbers,
}

/// Numbers or formulas in rows.
#[derive(Clone, Debug, PartialEq)]
pub struct DerivationTable {
    /// Kind of the cells.
    pub cells: Cells,
    /// The titles of the columns.
    pub head: Vec<Prose>,
    /// The cells, row by row.
    pub rows: Vec<Vec<Prose>>,
    /// Source and check of the numbers.
    pub note: Prose,
}

/// The kind of the cells of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cells {
    /// Numbers that were computed.
    Numbers,
    /// The subject of each row, and formulas of any length that a reader can find.
    Formulas,
}

impl DerivationTable {
    pub(super) fn numbers(head: Vec<Prose>, rows: Vec<Vec<Prose>>, note: Prose) -> Self {
        Self { cells: Cells::Numbers, head, rows, note }
    }
}

impl DerivationStep {
    pub(super) fn new(id: &str, heading: &str) -> Self {
        Self { id: id.to_owned(), heading: heading.to_owned(), blocks: Vec::new() }
    }

    /// Adds a paragraph in which each `{}` is the next formula.
    pub(super) fn say<const N: usize>(self, template: &str, formulas: [Formula; N]) -> Self {
        self.with(Block::Paragraph(Prose::new(template, formulas)))
    }

    /// Adds a paragraph that was composed elsewhere.
    pub(super) fn paragraph(self, prose: Prose) -> Self {
        self.with(Block::Paragraph(prose))
    }

    /// Adds a paragraph if a condition holds.
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

    /// Adds an aside.
    pub(super) fn remark<const N: usize>(self, template: &str, formulas: [Formula; N]) -> Self {
        self.with(Block::Remark(Prose::new(template, formulas)))
    }

    /// Adds a checked formula.
    pub(super) fn show(self, equation: CheckedEquation) -> Self {
        let number = formulas_in(&self.blocks) + 1;
        self.with(Block::Equation { number, equation })
    }

    /// Adds checked formulas.
    pub(super) fn show_all(self, equations: Vec<CheckedEquation>) -> Self {
        equations.into_iter().fold(self, Self::show)
    }

    /// Adds a table.
    pub(super) fn table(self, table: DerivationTable) -> Self {
        self.with(Block::Table(table))
    }

    /// Adds a folded block with the content that `add` appends.
    pub(super) fn fold(mut self, summary: &str, add: impl FnOnce(Self) -> Self) -> Self {
        let before = self.blocks.len();
        self = add(self);
        let blocks = self.blocks.split_off(before.min(self.blocks.len()));
        self.with(Block::Details { summary: summary.to_owned(), blocks })
    }

    fn with(mut self, block: Block) -> Self {
        self.blocks.push(block);
        self
    }
}

/// Number of numbered formulas.
fn formulas_in(blocks: &[Block]) -> usize {
    let formulas = |block: &Block| match block {
        Block::Equation { .. } | Block::Exercise { .. } => 1,
        Block::Details { blocks, .. } => formulas_in(blocks),
        Block::Paragraph(_) | Block::Remark(_) | Block::Table(_) => 0,
    };
    blocks.iter().map(formulas).sum()
}
