//! Formulas and equations of motion as text, tree and tape.

mod jet;
mod tape;

use crate::algebra::Rational;

pub use crate::algebra::Function;
pub(crate) use jet::{Jet, NoSeries};
pub(crate) use tape::Tape;
pub use tape::WithoutValue;

/// A formula. The tree is what was written: nothing is reordered or simplified unless asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Expression {
    /// An exact number; never negative when it comes from text.
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

/// A name with its time derivatives: `x`, `x'`, `x''`, `mu`, `t`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol {
    /// The name in ASCII: `theta`, `omega0`.
    pub name: String,
    /// How many times it is differentiated with respect to time.
    pub primes: u8,
}
