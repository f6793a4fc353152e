//! Equations with the checks that they have passed. An equation that fails its check cannot be constructed.
//!
//! # Method
//! A check evaluates the formula as it is printed. It is evaluated as a number of 256 bits at several amplitudes, with
//! integrals by the double exponential rule and sums to convergence, or as a power series with rational coefficients, as
//! far as they are certain. A definition assigns the value of its name for the following checks. A motion from perturbation
//! theory is substituted into the equation of motion at enough rational values of cos τ to decide for all phases.

mod averaged;
mod cycle;
mod error;
mod letters;
mod truncated;
mod words;

pub use averaged::{AveragedClaim, AveragedFormula, CycleQuantity, FlowTerms, ForceTerm};
pub use cycle::{CycleClaim, CycleFormula};
pub use error::DerivationError;
pub use letters::{Letters, OpenCondition};
pub use truncated::{TruncatedClaim, TruncatedFormula};

use std::ops::RangeInclusive;

use super::evaluate::{Analysis, Values, evaluate};
use super::formula::{Decimal, Formula, Name, Statement};
use super::numbers::Coefficients;
use super::typeset::statement_latex;
use libration::algebra::{Rational, Rationals, Ring};
use libration::series::PowerSeries;

/// A statement that has passed a check.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckedEquation {
    statement: Statement,
    check: Check,
    letters: Letters,
}

/// The method by which a statement was checked.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Check {
    /// Nothing to check: a name is defined as the right side.
    Definition,
    /// Nothing to check: a premise of the derivation.
    Premise,
    /// A part of the motion, which is substituted into the equation of motion as a whole further below.
    Below,
    /// Nothing to check: a number given by the reader.
    Given,
    /// All sides are the same power series, computed with exact fractions.
    Series {
        /// The variable of the series.
        variable: Name,
        /// Number of coefficients compared, including the constant one.
        coefficients: usize,
    },
    /// All sides are the same exact numbers.
    Rationals {
        /// The index.
        index: Name,
        /// The first value of the index.
        first: i64,
        /// The last value of the index.
        last: i64,
    },
    /// All sides are the same exact number.
    Fraction,
    /// A name is defined as the right side, which is the formula of the catalogue with this key: the values agree at several amplitudes.
    Catalogued {
        /// The key.
        key: String,
        /// The first term of the formula's error at small amplitudes, as coefficient and power; `None` if there is none.
        leading_error: Option<(Rational, u32)>,
    },
    /// A motion was substituted into the equation of motion, in exact fractions, at enough phases to decide.
    Phases {
        /// The expansion parameter.
        variable: Name,
        /// The highest power that was compared.
        order: usize,
        /// Number of phases.
        phases: usize,
    },
    /// Coefficients with undetermined symbols were substituted into the equation of motion,
    /// with several choices of fractions for the symbols, each at enough phases to decide.
    Substituted {
        /// Number of choices.
        choices: usize,
        /// The condition on the coefficients, if it is one of the open gauge.
        condition: Option<Box<OpenCondition>>,
    },
    /// A part of a slow flow, which satisfies the equation of motion as a whole.
    Averaged(Box<AveragedFormula>),
    /// A part of a limit cycle, which satisfies the equation of motion as a whole.
    Cycle(Box<CycleFormula>),
    /// A part of the algebra of a few harmonics.
    Truncated(Box<TruncatedFormula>),
    /// The digits printed are those of the exact value.
    RoundedDigits,
    /// All sides have the same value, in many digits.
    Digits {
        /// Amplitudes or parameters of the comparison.
        place: ComparedAt,
        /// The value at the first amplitude or parameter.
        value: Decimal,
        /// The largest difference, relative to the size of the sides.
        difference: f64,
        /// Source of the value compared: the other side, or the library's closed solution in double precision.
        against: Against,
    },
}

/// The amplitudes or parameters at which the sides of a statement were compared.
#[derive(Clone, Debug, PartialEq)]
pub enum ComparedAt {
    /// The statement contains no variable value.
    Everywhere,
    /// Comparison at several amplitudes.
    Amplitudes {
        /// The amplitude whose value is shown.
        at: Decimal,
        /// All amplitudes.
        amplitudes: Vec<Decimal>,
    },
    /// Comparison for several values of an index.
    Cases {
        /// The index.
        index: Name,
        /// The first value of the index.
        first: i64,
        /// The last value of the index.
        last: i64,
    },
}

/// The value with which a formula is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Against {
    /// The other side of the statement, in many digits.
    OtherSide,
    /// The library's exact motion or period, in double precision.
    Library,
}

impl CheckedEquation {
    /// The statement.
    #[must_use]
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// The method of the check.
    #[must_use]
    pub fn check(&self) -> &Check {
        &self.check
    }

    /// The meanings of the names in the formula when it was checked.
    #[must_use]
    pub fn letters(&self) -> &Letters {
        &self.letters
    }

    pub(super) fn new(statement: Statement, check: Check) -> Self {
        Self { statement, check, letters: Letters::default() }
    }

    /// The equation with the meanings of its names.
    pub(super) fn with_letters(self, letters: Letters) -> Self {
        Self { letters, ..self }
    }

    /// A premise of the derivation.
    pub(super) fn premise(statement: Statement) -> Self {
        Self::new(statement, Check::Premise)
    }

    /// A definition of a name.
    pub(super) fn definition(statement: Statement) -> Self {
        Self::new(statement, Check::Definition)
    }
}

/// Checks that all formulas of the statement are the same series in this variable, to at least `coefficients` coefficients.
pub fn same_series(
    variable: &Name,
    coefficients: usize,
    statement: Statement,
) -> Result<CheckedEquation, DerivationError> {
    same_series_where(variable, coefficients, &[], statement)
}

/// A further symbol in a series, with its meaning.
#[derive(Clone, Debug)]
pub enum Given<'a> {
    /// A name that denotes a formula of the variable.
    Value(Name, Formula),
    /// A name that denotes a function of one parameter.
    Function(&'a str, &'a str, Formula),
}

/// Checks the same as [`same_series`], with further symbols.
pub fn same_series_where(
    variable: &Name,
    coefficients: usize,
    given: &[Given],
    statement: Statement,
) -> Result<CheckedEquation, DerivationError> {
    let (ring, values) = series_values(variable, coefficients, given, &statement)?;
    let first = side(&statement, &statement.first, &ring, &values)?;
    let mut compared = first.len();
    for (_, formula) in &statement.rest {
        let other = side(&statement, formula, &ring, &values)?;
        compared = compared.min(other.len());
        let difference = ring.subtract(&first, &other);
        if let Some(place) = difference.iter().position(|c| !c.is_zero()) {
            let reason = format!("its sides differ by {} in the power {place}", difference[place]);
            return Err(failed(&statement, reason));
        }
    }
    if compared < coefficients {
        return Err(failed(&statement, format!("only {compared} coefficients can be compared")));
    }
    let check = Check::Series { variable: variable.clone(), coefficients: compared };
    Ok(CheckedEquation::new(statement, check).with_letters(letters_of(given)))
}

pub(super) fn letters_of(given: &[Given]) -> Letters {
    let mut letters = Letters::default();
    for given in given {
        match given {
            Given::Value(name, formula) => letters.values.push((name.clone(), formula.clone())),
            Given::Function(name, parameter, body) => {
                letters.functions.push((Name::new(name), vec![Name::new(parameter)], body.clone()));
            }
        }
    }
    letters
}

/// The series of a formula.
pub(super) fn series_value(
    variable: &Name,
    coefficients: usize,
    given: &[Given],
    formula: &Formula,
) -> Result<Coefficients, DerivationError> {
    let statement = Statement::from(formula.clone());
    let (ring, values) = series_values(variable, coefficients, given, &statement)?;
    side(&statement, formula, &ring, &values)
}

/// The ring of series in a variable, and the values of the symbols.
fn series_values(
    variable: &Name,
    coefficients: usize,
    given: &[Given],
    statement: &Statement,
) -> Result<(PowerSeries<Rationals>, Values<Coefficients>), DerivationError> {
    // Quotients of series without constant term lose coefficients.
    let ring = PowerSeries::rational(coefficients + 6);
    let mut values = Values::default();
    values.set(variable, ring.variable().expect("fractions have a one"));
    for given in given {
        match given {
            Given::Value(name, formula) => {
                let value = side(statement, formula, &ring, &values)?;
                values.set(name, value);
            }
            Given::Function(name, parameter, body) => {
                values.define(&Name::new(name), &[parameter], body.clone());
            }
        }
    }
    Ok((ring, values))
}

/// Checks that all formulas of the statement are the same fraction.
pub fn equal_fractions(statement: Statement) -> Result<CheckedEquation, DerivationError> {
    let equation = equal_rationals("n", 1..=1, statement)?;
    Ok(CheckedEquation { check: Check::Fraction, ..equation })
}

/// Checks that all formulas of the statement are the same fractions for these values of an index.
pub(super) fn equal_rationals(
    index: &str,
    cases: RangeInclusive<i64>,
    statement: Statement,
) -> Result<CheckedEquation, DerivationError> {
    let ring = PowerSeries::rational(1);
    let index = Name::new(index);
    let (first, last) = (*cases.start(), *cases.end());
    for case in cases {
        let mut values = Values::default();
        values.set_index(&index, case);
        let value = side(&statement, &statement.first, &ring, &values)?;
        for (_, formula) in &statement.rest {
            let other = side(&statement, formula, &ring, &values)?;
            if value.is_empty() || value != other {
                return Err(failed(&statement, format!("its sides differ for {case}")));
            }
        }
    }
    Ok(CheckedEquation::new(statement, Check::Rationals { index, first, last }))
}

/// The value of one side of the statement.
pub(super) fn side<R: Analysis>(
    statement: &Statement,
    formula: &Formula,
    ring: &R,
    values: &Values<R::Element>,
) -> Result<R::Element, DerivationError> {
    evaluate(formula, ring, values)
        .map_err(|reason| DerivationError::Unchecked { formula: statement_latex(statement), reason })
}

pub(super) fn failed(statement: &Statement, reason: String) -> DerivationError {
    DerivationError::Failed { formula: statement_latex(statement), reason }
}
