//! Errors in equations of motion.

use std::collections::BTreeSet;

use super::{Expression, Symbol};
use crate::expression::{ParseError, ValueError};
use crate::quantity::excerpt;

/// Reason why a text is not a set of equations of motion, or why values do not fit it.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum EquationError {
    /// A side of an equation that is not a formula.
    #[error(transparent)]
    Formula(#[from] ParseError),
    /// A formula without an `=`.
    #[error("`{formula}` has no = sign: write {example}")]
    WithoutEqualsSign {
        /// The formula, shortened.
        formula: String,
        /// The equation that was probably meant.
        example: String,
    },
    /// a = b = c.
    #[error("an equation has one = sign: separate several equations by ;")]
    SecondEqualsSign,
    /// No derivative.
    #[error(
        "`{equation}` has no derivative: mark the acceleration with two primes, as in x'' = -x, or a rate of change with one, as in \
         x' = -x"
    )]
    WithoutDerivative {
        /// The equation, shortened.
        equation: String,
    },
    /// An equation of second order without its second derivative.
    #[error("`{equation}` has no second derivative: mark the acceleration with two primes, as in x'' = -x")]
    WithoutAcceleration {
        /// The equation, shortened.
        equation: String,
    },
    /// A derivative of the third order or above.
    #[error("`{0}` is a derivative above the second: give equations of the second order, as in x'' = -x")]
    ThirdOrder(Symbol),
    /// t''.
    #[error("t is the time and cannot be a variable: call the variable x, say")]
    TimeAsVariable,
    /// x' = y together with x'' = -x.
    #[error(
        "`{equation}` is an equation for {rate}, but {name} has one for {name}'' already, with which {rate} is the velocity: leave one of \
         them out, or call one of the two variables something else",
        name = .rate.name
    )]
    RateOfAccelerated {
        /// The equation, shortened.
        equation: String,
        /// The derivative in the equation.
        rate: Symbol,
    },
    /// Two second derivatives in one equation, or two rates of change.
    #[error(
        "`{first}` and `{second}` appear in one equation: solve for each of them, as in x{primes} = …; y{primes} = …",
        primes = "'".repeat(usize::from(.first.primes))
    )]
    Coupled {
        /// The derivative found first.
        first: Symbol,
        /// The derivative found second.
        second: Symbol,
    },
    /// Two equations for one variable.
    #[error("there are two equations for {0}: give one for each variable")]
    SolvedTwice(Symbol),
    /// `x[i]` without `, i = 1..32`.
    #[error(
        "the index {letter} of {name} has no range: write it after the equation, as in x[i]'' = -x[i], i = 1..32"
    )]
    IndexWithoutRange {
        /// The member of the family.
        name: String,
        /// The letter of the index.
        letter: Symbol,
    },
    /// `x[i/2]`.
    #[error("the index of {name} is {value}{place}: give whole numbers")]
    IndexNotWhole {
        /// The member of the family.
        name: String,
        /// The value of the index.
        value: String,
        /// Text with the number of the range for which the index has this value, or empty.
        place: String,
    },
    /// `x[-1]''` = 0.
    #[error("{0} has an index below zero: count variables and parameters from 0 or from 1 on")]
    NegativeIndex(String),
    /// i = 5..1.
    #[error("{letter} = {first}..{last} has no number in it: give the smaller one first")]
    EmptyRange {
        /// The letter of the index.
        letter: String,
        /// The first number.
        first: u32,
        /// The last number.
        last: u32,
    },
    /// i = 1..100000.
    #[error("the ranges stand for more than {limit} equations: give smaller ranges")]
    TooManyEquations {
        /// The maximum number.
        limit: usize,
    },
    /// `x[3]` = 0 together with an equation for `x[3]''`.
    #[error("`{equation}` gives a value to {name}, which has an equation of motion: leave one of them out")]
    ValueOfVariable {
        /// The equation, shortened.
        equation: String,
        /// The member of the family.
        name: String,
    },
    /// `x[0]` = `x[-1]`, both outside.
    #[error(
        "{name} is defined by {other}, which is outside the range too: define it by members inside, t and parameters"
    )]
    EndByEnd {
        /// The member outside the range.
        name: String,
        /// The other member outside the range.
        other: String,
    },
    /// `x[0]'` where `x[0]` = `2*x[1]`.
    #[error(
        "an equation contains {rate}, which cannot be derived for an end defined as {end}: define the end by t and parameters, or as one other member"
    )]
    RateOfEnd {
        /// The velocity of the member.
        rate: Symbol,
        /// The equation of the member outside the range.
        end: String,
    },
    /// x0 next to `x[i]`.
    #[error(
        "`{name}` may be a parameter or {indexed}, which is outside the range: write {indexed}, or call the parameter something else"
    )]
    AmbiguousMember {
        /// The name without brackets.
        name: String,
        /// The name with an index.
        indexed: String,
    },
    /// A derivative of a variable without an equation.
    #[error("`{0}` is a derivative, but no equation has {name}'': write one, after a ;", name = .0.name)]
    ForeignDerivative(Symbol),
    /// x''^2, sin(x'') or the like.
    #[error("the equation is not linear in {0}: write it solved for {0}, as in {0} = …")]
    NotLinear(Symbol),
    /// A highest derivative with a factor of zero.
    #[error("{0} drops out of the equation, because its factor is zero: write an equation that contains it")]
    DropsOut(Symbol),
    /// A part that is undefined, such as 1/0.
    #[error(transparent)]
    NoValue(#[from] ValueError),
    /// A value that is undefined, such as 1/0.
    #[error("{name} has no value: {why}")]
    ValueWithout {
        /// The parameter.
        name: String,
        /// The undefined part.
        why: ValueError,
    },
    /// A value for a name that does not denote a parameter.
    #[error("the equation has no parameter `{name}`: {known}")]
    UnknownParameter {
        /// The given name, shortened.
        name: String,
        /// The known parameters.
        known: String,
    },
    /// Two values for one parameter.
    #[error("{0} is given twice: give it one value")]
    SetTwice(String),
    /// A value that contains symbols.
    #[error("the value of {name} contains {inside}: give a constant such as 0.1, 2/3 or sqrt(2)")]
    NotConstant {
        /// The parameter.
        name: String,
        /// The first symbol in the value.
        inside: Symbol,
    },
}

impl EquationError {
    pub(super) fn without_equals_sign(formula: &Expression) -> Self {
        let second = formula.symbols().into_iter().find(|symbol| symbol.primes == 2);
        let text = excerpt(&formula.to_string());
        let example = match second {
            Some(_) => format!("{text} = 0"),
            None => format!("x'' = {text} for an acceleration, or x'' + {text} = 0"),
        };
        Self::WithoutEqualsSign { formula: text, example }
    }

    pub(super) fn without_derivative(left: &Expression, right: &Expression) -> Self {
        Self::WithoutDerivative { equation: equation_text(left, right) }
    }

    pub(super) fn rate_of_accelerated(left: &Expression, right: &Expression, rate: Symbol) -> Self {
        Self::RateOfAccelerated { equation: equation_text(left, right), rate }
    }

    pub(super) fn without_acceleration(left: &Expression, right: &Expression) -> Self {
        Self::WithoutAcceleration { equation: equation_text(left, right) }
    }

    pub(super) fn unknown_parameter(name: &str, parameters: &BTreeSet<String>) -> Self {
        let names: Vec<&str> = parameters.iter().map(String::as_str).collect();
        let available = match names.as_slice() {
            [] => "it has none".to_owned(),
            [one] => format!("its only parameter is {one}"),
            several => format!("its parameters are {}", several.join(", ")),
        };
        Self::UnknownParameter { name: excerpt(name), known: available }
    }
}

fn equation_text(left: &Expression, right: &Expression) -> String {
    excerpt(&format!("{left} = {right}"))
}

/// An equation of first order where accelerations are required.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the equation for {variable}' is of the first order, and this needs an acceleration: give one of the second order, as in \
     {variable}'' = -{variable}"
)]
pub struct SecondOrderError {
    /// The variable of the equation.
    pub variable: String,
}
