//! A derivation as exercises: results are omitted and collected on a page of answers.

use super::answers::Question;
use super::check::{Check, CheckedEquation};
use super::document::{Block, Cells, Derivation, DerivationStep, DerivationTable};
use super::formula::{Formula, Name, Statement, number};
use super::prose::Prose;

impl Derivation {
    /// The same derivation with a question mark for each computed result, and the results as
    /// answers under the same numbers. Definitions, premises and tables of numbers are kept.
    ///
    /// # Examples
    /// ```
    /// use libration_derivation::{elliptic, to_markdown};
    /// let exercises = elliptic(None)?.exercises();
    /// assert_eq!(exercises.answers.len(), exercises.steps.len());
    /// assert!(to_markdown(&exercises).contains("## Answers"));
    /// # Ok::<(), libration_derivation::DerivationError>(())
    /// ```
    #[must_use]
    pub fn exercises(self) -> Self {
        let how = Prose::text(
            "Find what the question marks stand for, with a pencil: each follows from what stands before it. The answers are at the end, \
             under the numbers of the formulas.",
        );
        let results: Vec<Formula> = self.steps.iter().flat_map(|step| results_of(&step.blocks)).collect();
        let answers =
            self.steps.iter().map(|step| with_blocks(step, |block| answers_of(block, &results))).collect();
        let steps =
            self.steps.iter().map(|step| with_blocks(step, |block| exercise_of(block, &results))).collect();
        Self {
            title: format!("{}: exercises", self.title),
            introduction: vec![Block::Paragraph(how)],
            steps,
            answers,
        }
    }
}

/// The right sides that a reader is to find.
fn results_of(blocks: &[Block]) -> Vec<Formula> {
    let of_block = |block: &Block| match block {
        Block::Equation { equation, .. } if question(equation, &[]).is_some() => {
            equation.statement().rest.last().map(|(_, side)| side.clone()).into_iter().collect()
        }
        Block::Details { blocks, .. } => results_of(blocks),
        _ => vec![],
    };
    blocks.iter().flat_map(of_block).collect()
}

fn with_blocks(step: &DerivationStep, change: impl Fn(&Block) -> Vec<Block>) -> DerivationStep {
    DerivationStep {
        id: step.id.clone(),
        heading: step.heading.clone(),
        blocks: step.blocks.iter().flat_map(change).collect(),
    }
}

/// The block with question marks in place of its results.
fn exercise_of(block: &Block, results: &[Formula]) -> Vec<Block> {
    vec![match block {
        Block::Equation { number, equation } => match question(equation, results) {
            Some(statement) => {
                let is_comparable = Question::of(equation).is_some();
                Block::Exercise { number: *number, statement, is_comparable }
            }
            None => block.clone(),
        },
        Block::Table(table) if table.cells == Cells::Formulas => Block::Table(unsolved(table)),
        Block::Details { summary, blocks } => {
            let blocks = blocks.iter().flat_map(|block| exercise_of(block, results)).collect();
            Block::Details { summary: summary.clone(), blocks }
        }
        other => other.clone(),
    }]
}

/// The formulas omitted from the block.
fn answers_of(block: &Block, results: &[Formula]) -> Vec<Block> {
    match block {
        Block::Equation { equation, .. } if question(equation, results).is_some() => vec![block.clone()],
        Block::Table(table) if table.cells == Cells::Formulas => vec![block.clone()],
        Block::Details { blocks, .. } => blocks.iter().flat_map(|block| answers_of(block, results)).collect(),
        _ => vec![],
    }
}

/// The formula with a question mark for its result, or unchanged if it is to be proved; `None` if there is nothing to find. A formula of the
/// catalogue is given, unless it is one of these results.
fn question(equation: &CheckedEquation, results: &[Formula]) -> Option<Statement> {
    let statement = equation.statement();
    let is_named = matches!(equation.check(), Check::Catalogued { .. });
    let is_result = statement.rest.last().is_some_and(|(_, side)| results.contains(side));
    if (is_named && !is_result) || !equation.check().is_computed() {
        return None;
    }
    let unknown = || Formula::from(Name::new("?"));
    let (relation, _) = *statement.rest.first()?;
    let all = |is: fn(&Formula) -> bool| statement.rest.iter().all(|(_, side)| is(side));
    // A remainder O(…) is to be proved; the check contains the results of other formulas.
    if all(|side| matches!(side, Formula::Order(_))) {
        return Some(statement.clone());
    }
    Some(match all(|side| *side == number(0)) {
        true => Statement { first: unknown(), rest: statement.rest.clone() },
        false => Statement { first: statement.first.clone(), rest: vec![(relation, unknown())] },
    })
}

/// The rows with a question mark for everything except their subject.
fn unsolved(table: &DerivationTable) -> DerivationTable {
    let unknown = || Prose::formula(Name::new("?").into());
    let row = |row: &Vec<Prose>| {
        let others = row.iter().skip(1).map(|_| unknown());
        row.iter().take(1).cloned().chain(others).collect()
    };
    DerivationTable { rows: table.rows.iter().map(row).collect(), ..table.clone() }
}
