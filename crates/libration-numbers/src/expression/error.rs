//! Errors in the text of a formula, and their positions.

use std::fmt;

/// Reason why a text is not a formula, and the position in it.
///
/// The message has three lines: the error with a remedy, the text around the error, and a caret below its position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParseError {
    /// The error.
    pub fault: Fault,
    /// Bytes of the text before the error.
    pub byte: usize,
    /// The position in characters, counted from 1.
    pub column: usize,
    /// The text around the error.
    excerpt: String,
    /// Columns of the excerpt before the error.
    indent: usize,
}

/// Error in a formula, with a remedy.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// Empty text.
    #[error("the formula is empty: write one such as x'' + sin(x) = 0")]
    Empty,
    /// A text longer than the limit.
    #[error("the text has {length} bytes: give at most {limit}")]
    TooLong {
        /// Length of the text in bytes.
        length: usize,
        /// Largest length in bytes.
        limit: usize,
    },
    /// Brackets, signs, powers or sums nested deeper than the limit.
    #[error(
        "the formula is nested more than {limit} levels deep, each sign, bracket and summand of a sum \
         being a level: split it by brackets, as in (a + b + …) + (c + d + …)"
    )]
    TooDeep {
        /// Levels allowed.
        limit: usize,
    },
    /// One argument where two are required.
    #[error("max and min take two formulas: write max(x, 0)")]
    OneArgument,
    /// A number with too many digits or too large an exponent.
    #[error("the number is too long: give at most {limit} digits and a power of ten of at most {limit}")]
    NumberTooLong {
        /// Digits allowed.
        limit: usize,
    },
    /// A character without a meaning in formulas.
    #[error("`{}` is not understood: {hint}", found.escape_debug())]
    UnknownCharacter {
        /// The character.
        found: char,
        /// The remedy.
        hint: &'static str,
    },
    /// Other text where a number, a name or a bracket is expected.
    #[error("expected a number, a name or (, found {found}")]
    MissingOperand {
        /// The text found.
        found: String,
    },
    /// Other text where an operator or the end is expected.
    #[error("{found} cannot follow here: write an operator before it, or leave it out")]
    Unexpected {
        /// The text found.
        found: String,
    },
    /// A bracket that is not closed.
    #[error("this bracket is not closed: add the matching )")]
    Unclosed,
    /// A brace that is not closed.
    #[error("this brace is not closed: add the matching }}")]
    UnclosedBrace,
    /// A function without its argument in brackets.
    #[error("the argument of {0} must be in brackets: write {0}(x), or {0}(x)^2 for its square")]
    WithoutBrackets(&'static str),
    /// sin x^2.
    #[error(
        "`{function} {argument}{rest}` may be {function}({argument}{rest}) or {function}({argument}){rest}: write the one that is meant"
    )]
    AmbiguousArgument {
        /// The function.
        function: &'static str,
        /// The part that certainly belongs to the argument.
        argument: String,
        /// The part that may belong to the argument.
        rest: String,
    },
    /// `\foo`.
    #[error(
        "the command \\{command} of LaTeX is not known here: known are \\frac, \\dot, \\ddot, \\cdot, \\sqrt, Greek letters and functions such as \\sin"
    )]
    UnknownCommand {
        /// The command.
        command: String,
    },
    /// `\frac12`.
    #[error("a fraction needs two groups in braces: write \\frac{{a}}{{b}}, or a/b")]
    FractionWithoutBraces,
    /// `\ddot{2}`.
    #[error("dots belong above one variable: write \\ddot{{x}}, \\dot{{\\theta}} or x''")]
    DotsAboveNothing,
    /// `\mathrm 2`.
    #[error("a word in upright letters belongs in braces: write \\mathrm{{max}}, or max")]
    WordWithoutBraces,
    /// A name before a bracket that is not a function.
    #[error(
        "`{name}(` is not a known function: write {name}*( for a product; the functions are {}",
        functions()
    )]
    UnknownFunction {
        /// The name.
        name: String,
    },
    /// x(t).
    #[error("variables are written without their argument: write {0} instead of {0}(t)")]
    OfTime(String),
    /// x(t - 1).
    #[error(
        "`{0}(…)` may be {0} at another time, which no equation here can have, or a product: write {0}*(…) for a product"
    )]
    AtAnotherTime(String),
    /// e^x.
    #[error("e may be Euler's number or a parameter: write exp(x), or choose another name")]
    EulersNumber,
    /// 1/2x.
    #[error("an implied product after a division is ambiguous: write (1/2)*x or 1/(2*x)")]
    AmbiguousDivision,
    /// 2^3x.
    #[error("an implied product after a power is ambiguous: write 2^3*x or 2^(3*x)")]
    AmbiguousPower,
    /// x²^3.
    #[error("a power of a power written with ² is ambiguous: write (x^2)^3 or x^(2^3)")]
    PowerOfPower,
    /// A number directly after a possible factor.
    #[error("a number cannot follow here without a sign: write a*2 for a product, a^2 for a power")]
    NumberAfterFactor,
    /// More than three primes.
    #[error("too many primes: write at most x'''")]
    TooManyPrimes,
    /// = or ; in a formula.
    #[error("`{0}` is not allowed in a formula: give a formula, not an equation")]
    NotAnEquation(char),
}

fn functions() -> String {
    super::Function::ALL.map(super::Function::name).join(", ")
}

impl ParseError {
    /// Number of characters shown on either side of the error.
    const SHOWN: usize = 30;

    pub(super) fn new(text: &str, byte: usize, fault: Fault) -> Self {
        let (before, after) = text.split_at(byte);
        let column = before.chars().count() + 1;
        let skipped = (column - 1).saturating_sub(Self::SHOWN);
        let lead: String = before.chars().skip(skipped).map(visible).collect();
        let tail: String = after.chars().take(Self::SHOWN).map(visible).collect();
        let (cut_before, cut_after) = (
            if skipped > 0 { "…" } else { "" },
            if after.chars().nth(Self::SHOWN).is_some() { "…" } else { "" },
        );
        let indent = cut_before.chars().count() + lead.chars().filter(|&c| !is_combining(c)).count();
        Self { fault, byte, column, excerpt: format!("{cut_before}{lead}{tail}{cut_after}"), indent }
    }
}

fn visible(c: char) -> char {
    if c.is_control() { ' ' } else { c }
}

/// Returns `true` for the dots that stand above the preceding letter.
fn is_combining(c: char) -> bool {
    ('\u{300}'..'\u{370}').contains(&c)
}

impl std::error::Error for ParseError {}

impl fmt::Display for ParseError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { fault, column, excerpt, indent, .. } = self;
        write!(formatter, "at character {column}: {fault}\n  {excerpt}\n  {:indent$}^", "")
    }
}
