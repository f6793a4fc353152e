//! Formulas and equations of motion as text, tree and tape.
//!
//! ```
//! # extern crate libration_numbers as libration;
//! use libration::expression::{Equation, Symbol};
//!
//! // In the usual notation; the factor of the highest derivative may be on either side.
//! let equation: Equation = "l θ″ + 2 c θ' + g sin(θ) = 0".parse()?;
//! assert_eq!(equation.variables(), ["theta"]);
//! let acceleration = &equation.accelerations()[0];
//! assert_eq!(acceleration.derivative(&Symbol::plain("g")).to_latex(), r"-\frac{\sin\left(\theta\right)}{l}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod letters;

#[doc(hidden)]
pub(crate) mod decimal;
mod lexer;
mod members;
mod parser;
mod display;
mod latex;
mod precedence;
mod derivative;
mod normal_form;
#[doc(hidden)]
pub(crate) mod simplify;
mod symbols;
mod equation;

#[doc(hidden)]
pub(crate) mod instruction;
#[doc(hidden)]
pub(crate) mod jet;
mod no_value;
mod overflow;
#[doc(hidden)]
pub(crate) mod side;
#[doc(hidden)]
pub(crate) mod tape;
mod taylor_series;
mod value;

use crate::algebra::Rational;

pub use crate::algebra::Function;
pub use equation::{Equation, EquationError, Order, SecondOrderError};
pub use error::{Fault, ParseError};
pub(crate) use jet::Jet;
pub use letters::greek_letter;
pub use lexer::LONGEST_TEXT;
pub use no_value::ValueError;
pub use parser::{DEEPEST_NESTING, DEEPEST_TREE};
pub(crate) use tape::Tape;
pub use tape::WithoutValue;

/// A formula. The tree corresponds to the text: nothing is reordered or simplified unless requested.
///
/// A formula from text is at most [`DEEPEST_TREE`] levels deep, and one derived from it a small multiple of that; the methods call themselves
/// for each level.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::expression::{Expression, Symbol};
/// let force: Expression = "-ω0² sin(θ)".parse()?;
/// assert_eq!(force.to_string(), "-omega0^2*sin(theta)");
/// assert_eq!(force.derivative(&Symbol::plain("theta")).to_string(), "-omega0^2*cos(theta)");
/// # Ok::<(), libration::expression::ParseError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Expression {
    /// An exact number; never negative if it comes from text.
    Number(Rational),
    /// π.
    Pi,
    /// A variable or a parameter.
    Symbol(Symbol),
    /// −a.
    Negate(Box<Self>),
    /// a + b.
    Add(Box<Self>, Box<Self>),
    /// a − b.
    Subtract(Box<Self>, Box<Self>),
    /// a·b.
    Multiply(Box<Self>, Box<Self>),
    /// a/b.
    Divide(Box<Self>, Box<Self>),
    /// aᵇ.
    Power(Box<Self>, Box<Self>),
    /// f(a).
    Call(Function, Box<Self>),
}

impl From<i64> for Expression {
    fn from(integer: i64) -> Self {
        Self::Number(Rational::from(integer))
    }
}

/// A name with its time derivatives: `x`, `x'`, `x''`, `mu`, `t`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol {
    /// The name in ASCII: `theta`, `omega0`.
    pub name: String,
    /// Order of the derivative with respect to time.
    pub primes: u8,
}
