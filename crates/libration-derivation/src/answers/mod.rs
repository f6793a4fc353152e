//! Answers to exercises, compared with the results of the derivation.
//!
//! # Method
//! An answer is right if it agrees with the result in 77 digits at three draws of the symbols. Those that the derivation has defined or found before the
//! exercise have these values, so that sin(θ0/2) may stand for k, and T0 ω0/ω for the period. A condition that vanishes may have any factor that is a product
//! of powers. Terms of answers that are not right are named where both are sums of products of powers, sines and cosines; otherwise values of both
//! are given.

mod comparison;
mod question;
mod terms;

pub(crate) use question::Question;

use super::check::CheckedEquation;
use super::document::{Block, Derivation, DerivationStep};
use super::formula::{Formula, Name, Relation, Statement, Subscript, number, sqrt};
use super::prose::Prose;
use comparison::Comparison;
use libration::expression::{Expression, ParseError};

/// The judgement of an answer to an exercise.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Judgement {
    /// The answer is the result.
    Right,
    /// The answer equals the result, but can be written with fewer operations or without powers of sines and cosines.
    NotSimplified,
    /// The answer is another one, with the terms that differ or values of both.
    Wrong(Prose),
}

/// The reason why an answer is not compared.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AnswerError {
    /// A number that no exercise with a comparable answer has.
    #[error("there is no exercise ({number}) whose answer can be compared: those are {numbers}")]
    Number {
        /// The number that was given.
        number: String,
        /// The numbers of the exercises.
        numbers: String,
    },
    /// A text that is not a formula.
    #[error(transparent)]
    Formula(#[from] ParseError),
    /// A symbol that the derivation does not have.
    #[error("the derivation has no symbol {symbol}: its symbols are {symbols}")]
    Symbol {
        /// The symbol of the answer.
        symbol: String,
        /// The symbols of the derivation.
        symbols: String,
    },
    /// Formulas without values in common.
    #[error("the answer cannot be compared: it has no value where the result has one")]
    NoValue,
}

impl Judgement {
    /// The judgement as a sentence.
    #[must_use]
    pub fn to_prose(&self) -> Prose {
        match self {
            Self::Right => Prose::text("right"),
            Self::NotSimplified => Prose::text("right, but not simplified"),
            Self::Wrong(reason) => Prose::text("wrong: ").and(reason.clone()),
        }
    }
}

impl Derivation {
    /// The numbers of the exercises whose answers can be compared, such as `2.3`; none before [`exercises`](Self::exercises).
    #[must_use]
    pub fn comparable(&self) -> Vec<String> {
        self.questions().into_iter().map(|(number, ..)| number).collect()
    }

    /// Compares an answer, such as `3/4*cos(psi) + 1/4*cos(3*psi)`, to the exercise with this number.
    ///
    /// # Errors
    /// A number that [`comparable`](Self::comparable) does not have, a text that is not a formula of the symbols of the derivation, and an answer
    /// that has no real value where the result has one.
    ///
    /// # Examples
    /// ```
    /// use libration_derivation::{Judgement, first_correction};
    /// let exercises = first_correction(None)?.exercises();
    /// assert_eq!(exercises.judge("3.1", "omega0^2*(1 - theta0^2/8)")?, Judgement::Right);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn judge(&self, number: &str, answer: &str) -> Result<Judgement, AnswerError> {
        let questions = self.questions();
        let Some((_, position, question)) = questions.iter().find(|(label, ..)| label == number) else {
            let number = number.to_owned();
            return Err(AnswerError::Number { number, numbers: self.comparable().join(", ") });
        };
        let formula = Formula::from(&answer.parse::<Expression>()?);
        let symbols = self.symbols();
        let is_unknown = |symbol: &String| symbols.iter().all(|(other, _)| other != symbol);
        if let Some(symbol) = formula.free_names().iter().map(key).find(is_unknown) {
            let symbols = symbols.iter().map(|(key, _)| key.as_str()).collect::<Vec<_>>().join(", ");
            return Err(AnswerError::Symbol { symbol, symbols });
        }
        let comparison = Comparison {
            question: *question,
            formula,
            symbols: &symbols,
            established: self.established_before(*position),
        };
        let samples = comparison.samples();
        if samples.is_empty() { Err(AnswerError::NoValue) } else { Ok(comparison.judge(&samples)) }
    }

    /// The exercises with their numbers and places.
    fn questions(&self) -> Vec<(String, EquationNumber, Question<'_>)> {
        let mut all = vec![];
        for (position, equation) in equations(&self.answers) {
            all.extend(
                Question::of(equation)
                    .map(|question| (format!("{}.{}", position.0, position.1), position, question)),
            );
        }
        all
    }

    /// The symbols with the formulas that the derivation has given for them before a place, in their order.
    fn established_before(&self, position: EquationNumber) -> Vec<(&Name, Formula)> {
        let mut all: Vec<(EquationNumber, &Name, Formula)> = vec![];
        for (number, equation) in equations(&self.steps).into_iter().chain(equations(&self.answers)) {
            if number < position
                && let Some((name, value)) = equation.statement().as_value()
            {
                all.insert(all.partition_point(|(other, ..)| *other < number), (number, name, value));
            }
        }
        all.into_iter().map(|(_, name, value)| (name, value)).collect()
    }

    /// The statements of the steps and of the answers.
    fn statements(&self) -> Vec<&Statement> {
        self.steps.iter().chain(&self.answers).flat_map(|step| statements(&step.blocks)).collect()
    }

    /// The symbols that an answer may have.
    fn symbols(&self) -> Symbols {
        let statements = self.statements();
        let sides = statements
            .iter()
            .flat_map(|statement| statement.rest.iter().map(|(_, side)| side).chain([&statement.first]));
        let mut symbols = Symbols::new();
        for name in
            sides.flat_map(Formula::free_names).filter(|name| name.can_be_typed() && name.letter != "?")
        {
            let key = key(&name);
            if let Err(index) = symbols.binary_search_by(|(other, _)| other.cmp(&key)) {
                symbols.insert(index, (key, name));
            }
        }
        symbols
    }
}

impl Statement {
    /// The symbol that the statement gives, itself or its square, with its elementary formula.
    fn as_value(&self) -> Option<(&Name, Formula)> {
        let (relation, value) = self.rest.last()?;
        let is_given = matches!(relation, Relation::Defined | Relation::Equal) && value.is_elementary();
        match &self.first {
            Formula::Name(name) if is_given => Some((name, value.clone())),
            Formula::Power(base, exponent) if is_given && **exponent == number(2) => match &**base {
                Formula::Name(name) => Some((name, sqrt(value.clone()))),
                _ => None,
            },
            _ => None,
        }
    }
}

/// The symbols of a derivation, in the order of their keys.
type Symbols = Vec<(String, Name)>;

/// The numbers of a step and of a formula in it.
type EquationNumber = (usize, usize);

fn equations(steps: &[DerivationStep]) -> Vec<(EquationNumber, &CheckedEquation)> {
    fn collect<'a>(step: usize, blocks: &'a [Block], all: &mut Vec<(EquationNumber, &'a CheckedEquation)>) {
        for block in blocks {
            match block {
                Block::Equation { number, equation } => all.push(((step, *number), equation)),
                Block::Details { blocks, .. } => collect(step, blocks, all),
                _ => {}
            }
        }
    }
    let mut all = vec![];
    steps.iter().enumerate().for_each(|(n, step)| collect(n + 1, &step.blocks, &mut all));
    all
}

fn statements(blocks: &[Block]) -> Vec<&Statement> {
    let mut all = vec![];
    for block in blocks {
        match block {
            Block::Equation { equation, .. } => all.push(equation.statement()),
            Block::Exercise { statement, .. } => all.push(statement),
            Block::Details { blocks, .. } => all.extend(statements(blocks)),
            _ => {}
        }
    }
    all
}

/// The name as text without a line before its index.
fn key(name: &Name) -> String {
    let below = match &name.subscript {
        Some(Subscript::Word(word)) => word.clone(),
        Some(Subscript::Index(index)) => match &**index {
            Formula::Number(value) => value.to_string(),
            _ => String::new(),
        },
        None => String::new(),
    };
    format!("{}{below}{}", name.letter, "'".repeat(usize::from(name.primes)))
}
