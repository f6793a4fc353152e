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
mod quarter;
mod truncated;
mod words;

pub use averaged::{AveragedClaim, AveragedFormula, CycleQuantity, FlowTerms, ForceTerm};
pub use cycle::{CycleClaim, CycleFormula};
pub use error::DerivationError;
pub use letters::{Letters, OpenCondition};
pub use quarter::{QuarterClaim, QuarterFormula};
pub use truncated::{TruncatedClaim, TruncatedFormula};

use std::ops::RangeInclusive;

use super::evaluate::{Analysis, Values, evaluate};
use super::formula::{Decimal, Formula, Name, Statement};
use super::numbers::PRECISION;
use super::typeset::statement_latex;
use libration::algebra::{BigFloat, Floats, Polynomial, Polynomials, Rational, Rationals, Ring, Variable};
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
    /// All sides are the same power series, in digits, for several choices of the symbols.
    Choices {
        /// The variable of the series.
        variable: Name,
        /// Number of coefficients compared, including the constant one.
        coefficients: usize,
        /// Number of choices.
        choices: usize,
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
    /// A part of a quarter swing, which satisfies the equation of motion as a whole.
    Quarter(Box<QuarterFormula>),
    /// A part of the algebra of a few harmonics.
    Truncated(Box<TruncatedFormula>),
    /// The digits printed are those of the exact value.
    RoundedDigits,
    /// All sides have the same value, in many digits.
    Digits {
        /// Amplitudes or parameters of the comparison.
        compared_at: ComparedAt,
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
    /// Comparison for several choices of the symbols.
    Choices {
        /// Number of choices.
        choices: usize,
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
    /// A symbol without a value, which stays in the coefficients.
    Symbol(Variable),
}

/// Checks the same as [`same_series`], with further symbols.
pub fn same_series_where(
    variable: &Name,
    coefficients: usize,
    given: &[Given],
    statement: Statement,
) -> Result<CheckedEquation, DerivationError> {
    let series = ComparedSeries { variable, coefficients, given };
    let rest = |polynomial: &Polynomial| (!polynomial.is_zero()).then(|| polynomial.to_string());
    let compared = series.compared(Polynomials, &rest, &symbolic, &statement)?;
    let check = Check::Series { variable: variable.clone(), coefficients: compared };
    Ok(CheckedEquation::new(statement, check).with_letters(letters_of(given)))
}

/// Checks the same in digits, for several choices of the names, of which the call gives the number.
pub(super) fn same_series_for_choices(
    variable: &Name,
    coefficients: usize,
    choices: usize,
    given: &dyn Fn(usize) -> Vec<Given<'static>>,
    statement: Statement,
) -> Result<CheckedEquation, DerivationError> {
    // A sum of some hundred products of 256 bits is right to 70 digits.
    const LEAST: f64 = 1e-60;
    let floats = Floats { precision: PRECISION };
    let rest = |number: &BigFloat| {
        Some(number.to_f64()).filter(|value| value.abs() > LEAST).map(|value| format!("{value:e}"))
    };
    for choice in 0..choices {
        let series = ComparedSeries { variable, coefficients, given: &given(choice) };
        series.compared(floats, &rest, &|_, _| None, &statement)?;
    }
    let check = Check::Choices { variable: variable.clone(), coefficients, choices };
    Ok(CheckedEquation::new(statement, check).with_letters(letters_of(&given(0))))
}

/// The fraction for a symbol in one choice: squares, so that the root of a product of symbols is a fraction.
pub(super) fn chosen(index: usize, choice: usize) -> Rational {
    let [over, under] = [2 * index + choice + 3, index + 2].map(|n| i64::try_from(n).unwrap_or(1));
    let root = Rational::new(over, under).unwrap_or_else(|| Rational::from(1));
    root.clone() * root
}

fn symbolic(_: usize, symbol: &Variable) -> Option<Polynomial> {
    Some(Polynomial::variable(symbol.clone()))
}

pub(super) fn letters_of(given: &[Given]) -> Letters {
    let mut letters = Letters::default();
    for (index, given) in given.iter().enumerate() {
        match given {
            Given::Value(name, formula) => letters.values.push((name.clone(), formula.clone())),
            Given::Function(name, parameter, body) => {
                letters.functions.push((Name::new(name), vec![Name::new(parameter)], body.clone()));
            }
            Given::Symbol(symbol) => {
                letters.values.push((Name::from(symbol), Formula::Number(chosen(index, 0))));
            }
        }
    }
    letters
}

/// The series of a formula, with symbols in its coefficients.
pub(super) fn series_value(
    variable: &Name,
    coefficients: usize,
    given: &[Given],
    formula: &Formula,
) -> Result<Vec<Polynomial>, DerivationError> {
    let statement = Statement::from(formula.clone());
    let series = ComparedSeries { variable, coefficients, given };
    if given.iter().any(|input| matches!(input, Given::Symbol(_))) {
        let (ring, values) = series.values(Polynomials, &symbolic, &statement)?;
        return side(&statement, formula, &ring, &values);
    }
    let (ring, values) = series.values(Rationals, &|_, _| None, &statement)?;
    let numbers = side(&statement, formula, &ring, &values)?;
    Ok(numbers.into_iter().map(Polynomial::constant).collect())
}

/// A series in a variable, with what its further names denote.
#[derive(Clone, Copy)]
struct ComparedSeries<'a> {
    variable: &'a Name,
    coefficients: usize,
    given: &'a [Given<'a>],
}

/// A ring of series, and the values of names in it.
type InSeries<R> = (PowerSeries<R>, Values<Vec<<R as Ring>::Element>>);
/// The value of a symbol, given with its place among the names.
type SymbolValues<'a, E> = &'a dyn Fn(usize, &Variable) -> Option<E>;

impl ComparedSeries<'_> {
    /// The number of coefficients in which all sides agree, at least as many as are asked for.
    fn compared<R: Ring>(
        &self,
        numbers: R,
        rest: &dyn Fn(&R::Element) -> Option<String>,
        symbols: SymbolValues<'_, R::Element>,
        statement: &Statement,
    ) -> Result<usize, DerivationError> {
        let (ring, values) = self.values(numbers, symbols, statement)?;
        let first = side(statement, &statement.first, &ring, &values)?;
        let mut compared = first.len();
        for (_, formula) in &statement.rest {
            let other = side(statement, formula, &ring, &values)?;
            compared = compared.min(other.len());
            let difference = ring.subtract(&first, &other);
            if let Some((power, rest)) =
                difference.iter().map(rest).enumerate().find_map(|(n, rest)| Some((n, rest?)))
            {
                return Err(failed(statement, format!("its sides differ by {rest} in the power {power}")));
            }
        }
        match compared < self.coefficients {
            true => Err(failed(statement, format!("only {compared} coefficients can be compared"))),
            false => Ok(compared),
        }
    }

    /// The ring of series in the variable, and the values of the names.
    fn values<R: Ring>(
        &self,
        numbers: R,
        symbols: SymbolValues<'_, R::Element>,
        statement: &Statement,
    ) -> Result<InSeries<R>, DerivationError> {
        // Quotients of series without constant term lose coefficients.
        let ring = PowerSeries { coefficients: numbers, terms: self.coefficients + 6 };
        let mut values = Values::default();
        values.set(self.variable, ring.variable().expect("fractions have a one"));
        for (index, given) in self.given.iter().enumerate() {
            match given {
                Given::Value(name, formula) => {
                    let value = side(statement, formula, &ring, &values)?;
                    values.set(name, value);
                }
                Given::Function(name, parameter, body) => {
                    values.define(&Name::new(name), &[parameter], body.clone());
                }
                Given::Symbol(symbol) => {
                    let mut value = ring.zero();
                    if let (Some(first), Some(number)) = (value.first_mut(), symbols(index, symbol)) {
                        *first = number;
                    }
                    values.set(&Name::from(symbol), value);
                }
            }
        }
        Ok((ring, values))
    }
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
