//! Differences between programming languages in a formula.

use libration::algebra::Rational;

/// A language that functions are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Language {
    C,
    Python,
    Rust,
    Fortran,
}

impl Language {
    /// A number that is read as the same bits.
    pub(in crate::command::expand) fn number(self, value: f64) -> String {
        match self {
            Self::Fortran => format!("{value:e}").replace('e', "d"),
            _ => format!("{value:?}"),
        }
    }

    pub(in crate::command::expand) fn call(self, function: &str, argument: &str) -> String {
        match self {
            Self::Rust => format!("f64::{function}({argument})"),
            _ => format!("{function}({argument})"),
        }
    }

    /// A letter to a power that is a multiple of one half.
    pub(in crate::command::expand) fn power(self, letter: &str, exponent: &Rational) -> String {
        let value = self.number(exponent.to_f64());
        match (self, exponent.is_integer()) {
            _ if *exponent == Rational::from(1) => letter.to_owned(),
            (Self::C, _) => format!("pow({letter}, {value})"),
            (Self::Rust, true) => format!("{letter}.powi({exponent})"),
            (Self::Rust, false) => format!("{letter}.powf({value})"),
            (Self::Python | Self::Fortran, true) if !exponent.is_negative() => {
                format!("{letter}**{exponent}")
            }
            (Self::Python | Self::Fortran, true) => format!("{letter}**({exponent})"),
            (Self::Python | Self::Fortran, false) => format!("{letter}**({value})"),
        }
    }

    /// Returns `true` if no variable may have this name.
    pub(in crate::command::expand) fn is_reserved(self, name: &str) -> bool {
        let words = match self {
            Self::C => C_WORDS,
            Self::Python => PYTHON_WORDS,
            Self::Rust => RUST_WORDS,
            Self::Fortran => FORTRAN_WORDS,
        };
        FUNCTIONS.contains(&name) || words.split(' ').any(|word| word == name)
    }

    /// A name that is the same as another where the language does not distinguish them.
    pub(super) fn folded(self, name: &str) -> String {
        if self == Self::Fortran { name.to_lowercase() } else { name.to_owned() }
    }
}

/// Functions that are defined or called.
const FUNCTIONS: &[&str] = &["frequency", "period", "displacement", "sqrt", "sin", "cos", "pow"];

const C_WORDS: &str = "auto break case char const continue default do double else enum extern float for goto if inline int long \
    register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while";
const PYTHON_WORDS: &str = "False None True and as assert async await break class continue def del elif else except finally for \
    from global if import in is lambda nonlocal not or pass raise return try while with yield";
const RUST_WORDS: &str = "Self abstract as async await become box break const continue crate do dyn else enum extern false final \
    fn for gen if impl in let loop macro match mod move mut override priv pub ref return self static struct super trait true try \
    type typeof unsafe unsized use virtual where while yield f64";
const FORTRAN_WORDS: &str = "real64 result oscillator";
