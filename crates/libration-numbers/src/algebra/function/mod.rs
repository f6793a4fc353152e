//! The elementary functions of equations; each file has all properties of one function.

#[doc(hidden)]
pub(crate) mod entry;
mod hyperbolic;
mod abs;
mod acos;
mod asin;
mod atan;
mod cos;
mod cosh;
mod exp;
mod ln;
mod sign;
mod sin;
mod sinh;
mod sqrt;
mod tan;
mod tanh;

use super::{BigFloat, Rational};
use entry::Entry;
pub(crate) use entry::{Divisor, Domain, Growth, Pair, Parity, Rule, Slope};

/// An elementary function of one argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// √x.
    Sqrt,
    /// sin x.
    Sin,
    /// cos x.
    Cos,
    /// tan x.
    Tan,
    /// arcsin x.
    Asin,
    /// arccos x.
    Acos,
    /// arctan x.
    Atan,
    /// sinh x.
    Sinh,
    /// cosh x.
    Cosh,
    /// tanh x.
    Tanh,
    /// eˣ.
    Exp,
    /// ln x.
    Ln,
    /// |x|.
    Abs,
    /// −1 below zero, 0 at zero, 1 above zero.
    Sign,
}

impl Function {
    /// All functions.
    pub const ALL: [Self; 14] = [
        Self::Sqrt,
        Self::Sin,
        Self::Cos,
        Self::Tan,
        Self::Asin,
        Self::Acos,
        Self::Atan,
        Self::Sinh,
        Self::Cosh,
        Self::Tanh,
        Self::Exp,
        Self::Ln,
        Self::Abs,
        Self::Sign,
    ];

    const fn entry(self) -> &'static Entry {
        match self {
            Self::Sqrt => &sqrt::ENTRY,
            Self::Sin => &sin::ENTRY,
            Self::Cos => &cos::ENTRY,
            Self::Tan => &tan::ENTRY,
            Self::Asin => &asin::ENTRY,
            Self::Acos => &acos::ENTRY,
            Self::Atan => &atan::ENTRY,
            Self::Sinh => &sinh::ENTRY,
            Self::Cosh => &cosh::ENTRY,
            Self::Tanh => &tanh::ENTRY,
            Self::Exp => &exp::ENTRY,
            Self::Ln => &ln::ENTRY,
            Self::Abs => &abs::ENTRY,
            Self::Sign => &sign::ENTRY,
        }
    }

    /// The name in text: `sqrt`, `asin`, ….
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.entry().name
    }

    /// The word that is printed, and accepted in text too: `arcsin` for `asin`, `sgn` for `sign`, otherwise the name.
    ///
    /// # Examples
    /// ```
    /// # extern crate libration_numbers as libration;
    /// use libration::expression::Function;
    /// assert_eq!([Function::Asin.word(), Function::Sinh.word()], ["arcsin", "sinh"]);
    /// ```
    #[must_use]
    pub const fn word(self) -> &'static str {
        self.entry().word
    }

    /// The function with this name.
    #[must_use]
    pub fn by_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|function| function.name() == name)
    }

    /// The LaTeX text before and after the argument.
    pub(crate) const fn latex(self) -> [&'static str; 2] {
        self.entry().latex
    }

    /// Parity of the function; `None` if it is neither even nor odd.
    pub const fn parity(self) -> Option<Parity> {
        self.entry().parity
    }

    pub const fn growth(self) -> Growth {
        self.entry().growth
    }

    /// Returns `true` if the function has a zero.
    pub const fn has_zeros(self) -> bool {
        self.entry().has_zeros
    }

    /// Domain of the function; `None` if it is defined everywhere except at poles.
    pub const fn domain(self) -> Option<Domain> {
        self.entry().domain
    }

    pub(crate) const fn rule(self) -> Rule {
        self.entry().rule
    }

    /// The value in double precision; NaN outside the domain.
    #[inline]
    pub fn at_double(self, x: f64) -> f64 {
        (self.entry().double)(x)
    }

    /// The value at a number of this precision, to a few ulp; `None` outside the domain.
    pub fn at_float(self, x: &BigFloat, precision: usize) -> Option<BigFloat> {
        (self.entry().float)(x, precision)
    }

    /// The value, if it is known to be a fraction.
    pub fn at_rational(self, x: &Rational) -> Option<Rational> {
        (self.entry().rational)(x)
    }
}
