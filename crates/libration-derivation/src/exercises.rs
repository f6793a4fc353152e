//! A derivation as exercises: results are omitted and collected on a page of answers.

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
        let answers = self.steps.iter().map(|step| with_blocks(step, answers_of)).collect();
        let steps = self.steps.iter().map(|step| with_blocks(step, exercise_of)).collect();
        Self {
            title: format!("{}: exercises", self.title),
            introduction: vec![Block::Paragraph(how)],
            steps,
            answers,
        }
    }
}

fn with_blocks(step: &DerivationStep, change: fn(&Block) -> Vec<Block>) -> DerivationStep {
    DerivationStep {
        id: step.id.clone(),
        heading: step.heading.clone(),
        blocks: step.blocks.iter().flat_map(change).collect(),
    }
}

/// The block with question marks in place of its results.
fn exercise_of(block: &Block) -> Vec<Block> {
    vec![match block {
        Block::Equation { number, equation } => match question(equation) {
            Some(statement) => Block::Exercise { number: *number, statement },
            None => block.clone(),
        },
        Block::Table(table) if table.cells == Cells::Formulas => Block::Table(unsolved(table)),
        Block::Details { summary, blocks } => {
            Block::Details { summary: summary.clone(), blocks: blocks.iter().flat_map(exercise_of).collect() }
        }
        other => other.clone(),
    }]
}

/// The formulas omitted from the block.
fn answers_of(block: &Block) -> Vec<Block> {
    match block {
        Block::Equation { equation, .. } if question(equation).is_some() => vec![block.clone()],
        Block::Table(table) if table.cells == Cells::Formulas => vec![block.clone()],
        Block::Details { blocks, .. } => blocks.iter().flat_map(answers_of).collect(),
        _ => vec![],
    }
}

/// The formula with a question mark for its result, or unchanged if it is to be proved; `None` if there is nothing to find.
fn question(equation: &CheckedEquation) -> Option<Statement> {
    let statement = equation.statement();
    let is_named = matches!(equation.check(), Check::Catalogued { .. });
    if is_named || !equation.check().is_computed() {
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
