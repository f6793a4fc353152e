//! Formats of formulas, and differences between programming languages in them.

use libration::algebra::Rational;

/// Formats of formulas besides tables, JSON and CSV.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Format {
    /// The same as --latex
    Latex,
    /// Formulas in MathML, one per line
    Mathml,
    /// Functions in C
    C,
    /// Functions in Python
    Python,
    /// Functions in Rust
    Rust,
    /// A module in Fortran 2008
    Fortran,
}

/// The options for formats of formulas.
#[derive(Debug, clap::Args)]
pub(crate) struct FormatOptions {
    /// Write LaTeX
    #[arg(long, conflicts_with_all = ["json", "csv"])]
    latex: bool,
    /// Write formulas or functions of a programming language
    #[arg(long, value_enum, conflicts_with_all = ["json", "csv", "latex"])]
    format: Option<Format>,
}

impl FormatOptions {
    /// The format, if one is requested.
    pub(crate) fn format(&self) -> Option<Format> {
        self.format.or(self.latex.then_some(Format::Latex))
    }

    /// The name of the option that was given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        if self.latex { Some("latex") } else { self.format.map(|_| "format") }
    }
}

impl Format {
    pub(crate) fn language(self) -> Option<Language> {
        match self {
            Self::Latex | Self::Mathml => None,
            Self::C => Some(Language::C),
            Self::Python => Some(Language::Python),
            Self::Rust => Some(Language::Rust),
            Self::Fortran => Some(Language::Fortran),
        }
    }
}

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
    pub(crate) fn number(self, value: f64) -> String {
        match self {
            Self::Fortran => format!("{value:e}").replace('e', "d"),
            _ => format!("{value:?}"),
        }
    }

    pub(crate) fn pi(self) -> String {
        match self {
            Self::Rust => "std::f64::consts::PI".to_owned(),
            _ => self.number(std::f64::consts::PI),
        }
    }

    pub(crate) fn call(self, function: &str, argument: &str) -> String {
        match self {
            Self::Rust => format!("f64::{function}({argument})"),
            _ => format!("{function}({argument})"),
        }
    }

    /// A symbol, or a number, to a power that is a multiple of one half.
    pub(crate) fn power(self, letter: &str, exponent: &Rational) -> String {
        let value = self.number(exponent.to_f64());
        match (self, exponent.is_integer()) {
            _ if *exponent == Rational::from(1) => letter.to_owned(),
            (Self::C, _) => format!("pow({letter}, {value})"),
            (Self::Rust, true) => format!("f64::powi({letter}, {exponent})"),
            (Self::Rust, false) => format!("f64::powf({letter}, {value})"),
            (Self::Python | Self::Fortran, true) if !exponent.is_negative() => {
                format!("{letter}**{exponent}")
            }
            (Self::Python | Self::Fortran, true) => format!("{letter}**({exponent})"),
            (Self::Python | Self::Fortran, false) => format!("{letter}**({value})"),
        }
    }

    /// Returns `true` if the language has this name for itself.
    fn is_word(self, name: &str) -> bool {
        let words = match self {
            Self::C => C_WORDS,
            Self::Python => PYTHON_WORDS,
            Self::Rust => RUST_WORDS,
            Self::Fortran => FORTRAN_WORDS,
        };
        words.split(' ').any(|word| word == name)
    }

    /// Returns `true` if no variable may have this name.
    fn is_reserved(self, name: &str) -> bool {
        FUNCTIONS.contains(&name) || self.is_word(name)
    }

    /// A canonical form of a name, equal for names that the language does not distinguish.
    fn folded(self, name: &str) -> String {
        if self == Self::Fortran { name.to_lowercase() } else { name.to_owned() }
    }
}

/// Names of variables in a program, each used once.
pub(crate) struct FreeNames {
    language: Language,
    taken: Vec<String>,
}

impl FreeNames {
    pub(crate) fn new(language: Language) -> Self {
        Self { language, taken: vec![] }
    }

    /// The name, or the name with underscores if the language reserves it or another variable has it.
    pub(crate) fn free(&mut self, name: &str) -> String {
        let language = self.language;
        self.first_free(name, |name| language.is_reserved(name))
    }

    /// The free name for a function that the program defines.
    pub(crate) fn free_function(&mut self, name: &str) -> String {
        let language = self.language;
        self.first_free(name, |name| language.is_word(name))
    }

    fn first_free(&mut self, name: &str, is_refused: impl Fn(&str) -> bool) -> String {
        let mut name = name.to_owned();
        let mut folded = self.language.folded(&name);
        while is_refused(&folded) || self.taken.contains(&folded) {
            name.push('_');
            folded.push('_');
        }
        self.taken.push(folded);
        name
    }
}

/// Functions that are defined or called.
const FUNCTIONS: &[&str] =
    &["frequency", "period", "displacement", "sqrt", "sin", "cos", "abs", "fabs", "pow"];

// Keywords, and macros of math.h and of the compilers.
const C_WORDS: &str = "auto break case char const continue default do double else enum extern float for goto if inline int long \
    register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while \
    FP_ILOGB0 FP_ILOGBNAN FP_INFINITE FP_NAN FP_NORMAL FP_SUBNORMAL FP_ZERO HUGE_VAL HUGE_VALF HUGE_VALL INFINITY MATH_ERREXCEPT \
    MATH_ERRNO M_1_PI M_2_PI M_2_SQRTPI M_E M_LN10 M_LN2 M_LOG10E M_LOG2E M_PI M_PI_2 M_PI_4 M_SQRT1_2 M_SQRT2 NAN \
    linux math_errhandling unix";
const PYTHON_WORDS: &str = "False None True and as assert async await break class continue def del elif else except finally for \
    from global if import in is lambda nonlocal not or pass raise return try while with yield";
// Keywords, and variants of the prelude, which no variable shadows.
const RUST_WORDS: &str = "Self abstract as async await become box break const continue crate do dyn else enum extern false final \
    fn for gen if impl in let loop macro match mod move mut override priv pub ref return self static struct super trait true try \
    type typeof unsafe unsized use virtual where while yield f64 None Some Ok Err";
const FORTRAN_WORDS: &str = "real64 result oscillator slow_flow";
