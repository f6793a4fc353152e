//! Equations with the checks they have passed. An equation that fails its check cannot be made.

use std::ops::RangeInclusive;

use super::evaluate::{Analysis, NoEvaluation, Values, evaluate};
use super::formula::{Decimal, DecimalUnit, Formula, Name, Statement, rounded};
use super::numbers::Coefficients;
use super::prose::Prose;
use super::typeset::statement_latex;
use libration::algebra::{Rationals, Ring};
use libration::pendulum::PendulumError;
use libration::perturbation::{ExpansionError, OpenGaugeError};
use libration::series::PowerSeries;
use libration::watch::Interrupted;

/// A statement that has passed a check.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckedEquation {
    statement: Statement,
    check: Check,
}

/// How a statement was checked.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Check {
    /// Nothing to check: a name is given to the right side.
    Definition,
    /// Nothing to check: where the derivation starts.
    Premise,
    /// A part of the motion that is put into the equation of motion as a whole, below.
    Below,
    /// Nothing to check: a number of the reader's.
    Given,
    /// All sides are the same power series, computed with exact fractions.
    Series {
        /// The variable of the series.
        variable: Name,
        /// How many coefficients were compared, the constant one included.
        coefficients: usize,
    },
    /// All sides are the same exact numbers.
    Rationals {
        /// The index.
        index: Name,
        /// Its first value.
        first: i64,
        /// Its last value.
        last: i64,
    },
    /// All sides are the same exact number.
    Fraction,
    /// A name is given to the right side, which is the formula of this key in the catalogue: it has its value at
    /// several amplitudes.
    Catalogued {
        /// The key.
        key: String,
    },
    /// A motion was put into the equation of motion, with exact fractions, at so many phases, which decides.
    Phases {
        /// The expansion parameter.
        variable: Name,
        /// The highest power that was compared.
        order: usize,
        /// How many phases.
        phases: usize,
    },
    /// Coefficients with open letters were put into the equation of motion with so many choices of fractions for the
    /// letters, each at as many phases as decide.
    Substituted {
        /// How many choices.
        choices: usize,
    },
    /// The digits printed are those of the exact value.
    RoundedDigits,
    /// All sides have the same value, in many digits.
    Digits {
        /// Where they were compared.
        place: ComparedAt,
        /// The value at the first of these places.
        value: Decimal,
        /// The largest difference, relative to the size of the sides.
        difference: f64,
        /// Whether a side comes from the library's closed solution, in double precision.
        against: Against,
    },
}

/// Where the sides of a statement were compared.
#[derive(Clone, Debug, PartialEq)]
pub enum ComparedAt {
    /// There is nothing to choose.
    Everywhere,
    /// At several amplitudes.
    Amplitudes {
        /// The one whose value is shown.
        at: Decimal,
        /// All of them.
        amplitudes: Vec<Decimal>,
    },
    /// For several values of an index.
    Cases {
        /// The index.
        index: Name,
        /// Its first value.
        first: i64,
        /// Its last value.
        last: i64,
    },
}

/// What a formula is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Against {
    /// Its other side, in many digits.
    OtherSide,
    /// The library's exact motion or period, in double precision.
    Library,
}

/// Why a derivation cannot be given.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DerivationError {
    /// A formula that does not hold: an error of this program.
    #[error("the formula {formula} fails its check: {reason}")]
    Failed {
        /// The formula in LaTeX.
        formula: String,
        /// How it fails.
        reason: String,
    },
    /// A formula that cannot be evaluated.
    #[error("the formula {formula} cannot be checked: {reason}")]
    Unchecked {
        /// The formula in LaTeX.
        formula: String,
        /// Why.
        reason: NoEvaluation,
    },
    /// An amplitude at which the steps cannot be shown with their numbers.
    #[error(
        "an amplitude of {degrees:?} degrees: the numbers of each step are shown for 0.01 to 179.9 degrees; `libration period` answers for all"
    )]
    Amplitude {
        /// The amplitude in degrees.
        degrees: f64,
    },
    /// An order that is not derived step by step.
    #[error("order {order} is not derived step by step: give 2 to 9; `libration expand` goes on")]
    Order {
        /// What was asked for.
        order: usize,
    },
    /// An acceleration that depends on the velocity.
    #[error(
        "the acceleration depends on the velocity: the derivation is for forces of the position alone; `libration expand` answers for others"
    )]
    Velocity,
    /// Numbers that are no fractions.
    #[error(
        "the equilibrium, the frequency or the Taylor coefficients are no fractions: the derivation is exact; `libration expand` answers in digits"
    )]
    NoFractions,
    /// No expansion.
    #[error(transparent)]
    Expansion(#[from] ExpansionError),
    /// No equations with the gauge left open.
    #[error(transparent)]
    OpenGauge(#[from] OpenGaugeError),
    /// An amplitude that is none.
    #[error("an amplitude of {0:?} is not positive and finite")]
    NotAnAmplitude(f64),
    /// A pendulum that cannot be.
    #[error(transparent)]
    Pendulum(#[from] PendulumError),
    /// The watch said so before the first step.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}

impl CheckedEquation {
    /// What is stated.
    #[must_use]
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// How it was checked.
    #[must_use]
    pub fn check(&self) -> &Check {
        &self.check
    }

    pub(super) fn new(statement: Statement, check: Check) -> Self {
        Self { statement, check }
    }

    /// Where the derivation starts.
    pub(super) fn premise(statement: Statement) -> Self {
        Self::new(statement, Check::Premise)
    }

    /// A name and what it stands for.
    pub(super) fn definition(statement: Statement) -> Self {
        Self::new(statement, Check::Definition)
    }
}

/// Checks that all formulas of the statement are the same series in this variable, in at least so many coefficients.
pub(super) fn same_series(
    variable: &Name,
    coefficients: usize,
    statement: Statement,
) -> Result<CheckedEquation, DerivationError> {
    same_series_where(variable, coefficients, &[], statement)
}

/// What else a letter stands for in a series.
pub(super) enum Given<'a> {
    /// A name stands for a formula of the variable.
    Value(Name, Formula),
    /// A name stands for a function of one parameter.
    Function(&'a str, &'a str, Formula),
}

/// As [`same_series`], with further letters.
pub(super) fn same_series_where(
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
    Ok(CheckedEquation::new(statement, Check::Series { variable: variable.clone(), coefficients: compared }))
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

/// The ring of series in a variable, and what the letters stand for.
fn series_values(
    variable: &Name,
    coefficients: usize,
    given: &[Given],
    statement: &Statement,
) -> Result<(PowerSeries<Rationals>, Values<Coefficients>), DerivationError> {
    // Quotients of series that begin with a power of the variable lose coefficients.
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
pub(super) fn equal_fractions(statement: Statement) -> Result<CheckedEquation, DerivationError> {
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

/// The value of a formula of the statement.
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

impl Check {
    /// Whether there was something to check, and it was computed.
    pub(super) fn is_computed(&self) -> bool {
        !matches!(self, Self::Definition | Self::Premise | Self::Given)
    }

    /// The check in words.
    pub(super) fn to_prose(&self) -> Prose {
        match self {
            Self::Definition => Prose::text("definition"),
            Self::Premise => Prose::text("the starting point"),
            Self::Below => Prose::text("checked with the equation of motion, below"),
            Self::Given => Prose::text("as given"),
            Self::Series { variable, coefficients } => Prose::new(
                "checked: the same power series in {}, exactly, through {}",
                [variable.into(), last_power(variable, *coefficients)],
            ),
            Self::Rationals { index, first, last } => Prose::new(
                "checked: the same fractions, exactly, for {} = {} ",
                [index.into(), (*first).into()],
            )
            .and(Prose::new("to {}", [(*last).into()])),
            Self::Fraction => Prose::text("checked: the same fraction, exactly"),
            Self::Catalogued { key } => Prose::text(format!(
                "definition; checked: it has the values of the formula {key} in the catalogue"
            )),
            Self::Phases { variable, order, phases } => Prose::new(
                &format!(
                    "checked: put into the equation of motion with exact fractions, through {{}}, at {phases} phases, which are enough to decide for all"
                ),
                [last_power(variable, order + 1)],
            ),
            Self::Substituted { choices } => Prose::text(format!(
                "checked: put into the equation of motion with exact fractions, for {choices} choices of the letters"
            )),
            Self::RoundedDigits => Prose::text("checked: the digits printed are those of the exact value"),
            Self::Digits { place, value, difference, against } => {
                place.to_prose().and(agreement(value, *difference, *against))
            }
        }
    }
}

impl ComparedAt {
    fn to_prose(&self) -> Prose {
        match self {
            Self::Everywhere => Prose::text("checked: "),
            Self::Cases { index, first, last } => {
                Prose::new("checked for {} = {}", [index.into(), Formula::from(*first)])
                    .and(Prose::new(" to {}; for the first ", [Formula::from(*last)]))
            }
            Self::Amplitudes { at, amplitudes } => {
                let mut prose = Prose::new("checked at {} = ", [Name::new("θ").index(0).into()]);
                for (n, amplitude) in amplitudes.iter().enumerate() {
                    let comma = match n {
                        0 => "",
                        n if n + 1 == amplitudes.len() => " and ",
                        _ => ", ",
                    };
                    prose = prose
                        .and(Prose::text(comma))
                        .and(Prose::formula(Formula::Decimal(amplitude.clone())));
                }
                prose.and(Prose::new("; at {} ", [Formula::Decimal(at.clone())]))
            }
        }
    }
}

fn last_power(variable: &Name, coefficients: usize) -> Formula {
    Formula::from(variable).pow(i64::try_from(coefficients.saturating_sub(1)).unwrap_or(i64::MAX))
}

fn agreement(value: &Decimal, difference: f64, against: Against) -> Prose {
    let value = Formula::Decimal(value.clone());
    let sides = Prose::new("both sides are {}", [value]);
    let sides = match against {
        Against::OtherSide => sides,
        Against::Library => sides.and(Prose::text(", one of them from the exact motion in double precision")),
    };
    if difference == 0.0 {
        return sides.and(Prose::text("; equal in all digits"));
    }
    sides.and(Prose::new("; largest relative difference {}", [rounded(difference, 1, DecimalUnit::One)]))
}
