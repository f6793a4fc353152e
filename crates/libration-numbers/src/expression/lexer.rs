//! Text to lexemes: numbers, names with their primes, signs and brackets, each with its position.
//!
//! # Method
//! LaTeX and Leibniz's derivatives become the same lexemes as primes and operators, so that one grammar suffices (`parser.rs`). A name before a
//! bracket is a factor only if it is a variable, that is, has primes somewhere in the text. The argument of a function without brackets is a
//! number and the names immediately after it, if nothing follows that could belong to the argument. Other ambiguous text is rejected, with both
//! interpretations in the message.

mod derivative;
mod index;
mod tex;

use super::error::{Fault, ParseError};
use super::letters::{dotted, greek_name, primes, subscript, superscript};
use super::{Symbol, decimal};
use crate::algebra::Rational;
use derivative::FractionNotation;
pub(super) use index::IndexRange;

/// Maximum length of a formula or of equations, in bytes.
pub const LONGEST_TEXT: usize = 10_000;
/// Largest number of primes after a name; a larger one is taken for a typing error.
const MOST_PRIMES: u8 = 3;

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    Number(Rational),
    Name(Symbol),
    /// One of `+ - * / ^ ( ) { } = ;`.
    Sign(char),
    /// `\frac`, before two groups in braces.
    Fraction,
    /// An exponent in raised digits, with its sign.
    Raised {
        digits: Rational,
        negative: bool,
    },
    /// The range of an index, after a comma.
    Range(IndexRange),
    End,
}

/// A token and its position.
#[derive(Clone, Debug)]
pub(super) struct Lexeme {
    pub(super) token: Token,
    pub(super) start: usize,
    /// `true` if a space stands before it.
    pub(super) spaced: bool,
}

/// The lexemes of a text, including the end.
pub(super) struct Lexemes {
    pub(super) lexemes: Vec<Lexeme>,
    /// `true` if the text has notations that are not used for output: commands of LaTeX, derivatives as quotients.
    pub(super) free: bool,
}

pub(super) fn lexemes(text: &str) -> Result<Lexemes, ParseError> {
    if text.len() > LONGEST_TEXT {
        let fault = Fault::TooLong { length: text.len(), limit: LONGEST_TEXT };
        return Err(ParseError::new("", 0, fault));
    }
    let mut lexer = Lexer { text, at: 0, free: false, open: vec![], after_extremum: false };
    let mut lexemes = Vec::new();
    loop {
        let spaced = lexer.skip_spaces();
        let start = lexer.at;
        let token = lexer.token().map_err(|fault| ParseError::new(text, start, fault))?;
        let end = token == Token::End;
        lexemes.push(Lexeme { token, start, spaced });
        if end {
            return Ok(Lexemes { lexemes, free: lexer.free });
        }
    }
}

struct Lexer<'a> {
    text: &'a str,
    at: usize,
    free: bool,
    /// One entry per open bracket: `true` if it holds the two arguments of max or min.
    open: Vec<bool>,
    /// `true` if the last lexeme was max or min.
    after_extremum: bool,
}

impl<'a> Lexer<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    /// Consumes the next character if the test accepts it.
    fn take_if(&mut self, accepts: impl FnOnce(char) -> bool) -> Option<char> {
        let next = self.peek().filter(|&c| accepts(c))?;
        self.at += next.len_utf8();
        Some(next)
    }

    fn take_while(&mut self, accepts: impl Fn(char) -> bool) -> &'a str {
        let start = self.at;
        while self.take_if(&accepts).is_some() {}
        &self.text[start..self.at]
    }

    fn skip_spaces(&mut self) -> bool {
        let start = self.at;
        while !self.take_while(char::is_whitespace).is_empty() || self.skip_command() {}
        self.at > start
    }

    fn token(&mut self) -> Result<Token, Fault> {
        let Some(next) = self.peek() else { return Ok(Token::End) };
        let after_extremum = std::mem::take(&mut self.after_extremum);
        if next.is_ascii_digit() || next == '.' {
            return self.number();
        }
        if next == '\\' {
            return self.command();
        }
        if let Some(derivative) = (next == 'd').then(|| self.derivative(&FractionNotation::Slash)).flatten() {
            return derivative;
        }
        if superscript(next).is_some() || next == '⁻' {
            return self.raised();
        }
        if self.take_if(|c| c == '√').is_some() {
            return Ok(Token::Name(Symbol::plain("sqrt")));
        }
        if let Some(range) = self.range() {
            return Ok(Token::Range(range));
        }
        if next == ',' && self.open.last() == Some(&true) {
            self.at += 1;
            return Ok(Token::Sign(','));
        }
        if let Some(sign) = sign(next) {
            match sign {
                '(' => self.open.push(after_extremum),
                ')' => self.open.truncate(self.open.len().saturating_sub(1)),
                _ => {}
            }
            self.at += next.len_utf8();
            let doubled = sign == '*' && self.take_if(|c| c == '*').is_some();
            return Ok(Token::Sign(if doubled { '^' } else { sign }));
        }
        self.name(next).unwrap_or_else(|| Err(unknown(next)))
    }

    fn number(&mut self) -> Result<Token, Fault> {
        let whole = self.take_while(|c| c.is_ascii_digit());
        let point = self.take_if(|c| c == '.').is_some();
        let fraction = if point { self.take_while(|c| c.is_ascii_digit()) } else { "" };
        if whole.is_empty() && fraction.is_empty() {
            return Err(unknown('.'));
        }
        let exponent = self.exponent()? - i64::try_from(fraction.len()).unwrap_or(i64::MAX);
        decimal::from_digits(&format!("{whole}{fraction}"), exponent)
            .map(Token::Number)
            .ok_or(Fault::NumberTooLong { limit: decimal::LONGEST })
    }

    /// The power of ten after a number, zero if there is none.
    fn exponent(&mut self) -> Result<i64, Fault> {
        let rest = &self.text[self.at..];
        let Some(after) = rest.strip_prefix(['e', 'E']) else { return Ok(0) };
        let sign = usize::from(after.starts_with(['+', '-']));
        let length = after[sign..].bytes().take_while(u8::is_ascii_digit).count();
        if length == 0 {
            return Ok(0);
        }
        self.at += 1 + sign + length;
        let exponent = after[..sign + length].parse::<i32>().map(i64::from);
        exponent.map_err(|_| Fault::NumberTooLong { limit: decimal::LONGEST })
    }

    fn raised(&mut self) -> Result<Token, Fault> {
        let negative = self.take_if(|c| c == '⁻').is_some();
        let digits: String =
            self.take_while(|c| superscript(c).is_some()).chars().filter_map(superscript).collect();
        if digits.is_empty() {
            return Err(unknown('⁻'));
        }
        decimal::from_digits(&digits, 0)
            .map(|digits| Token::Raised { digits, negative })
            .ok_or(Fault::NumberTooLong { limit: decimal::LONGEST })
    }

    /// A name and its primes; `None` if the character does not begin a name. A Greek letter with the digits after it is a separate name: ω0t is
    /// the product of ω0 and t.
    fn name(&mut self, first: char) -> Option<Result<Token, Fault>> {
        let (mut name, dots) = beginning(first)?;
        self.at += first.len_utf8();
        let primes = dots.saturating_add(self.rest_of_name(&mut name, first.is_ascii_alphabetic()));
        Some(if primes > MOST_PRIMES {
            Err(Fault::TooManyPrimes)
        } else {
            self.after_extremum = is_extremum(&name);
            Ok(Token::Name(Symbol { name, primes }))
        })
    }

    /// Appends the letters and digits of the rest of a name; returns the number of its dots and primes.
    fn rest_of_name(&mut self, name: &mut String, word: bool) -> u8 {
        let (mut count, mut index) = (0_u8, false);
        loop {
            let letters = word || index;
            let belongs = |c: char| (letters && c.is_ascii_alphabetic()) || c.is_ascii_digit() || c == '_';
            if let Some(braces) = self.index_in_braces() {
                name.push_str(&braces);
            } else if let Some(c) = self.take_if(belongs) {
                index |= c == '_';
                name.push(c);
            } else if let Some(c) = self.take_if(|c| subscript(c).is_some()) {
                name.extend(subscript(c));
            } else if let Some(mark) = self.take_if(is_dots) {
                count = count.saturating_add(primes(mark).unwrap_or(0));
            } else {
                break;
            }
        }
        if let Some(index) = self.index_in_brackets(name) {
            name.push_str(&index);
        }
        let marks = self.take_while(|c| primes(c).is_some()).chars().filter_map(primes);
        marks.fold(count, u8::saturating_add)
    }
}

/// Returns `true` for functions of two arguments, which are not used for output.
pub(super) fn is_extremum(name: &str) -> bool {
    matches!(name, "max" | "min")
}

/// Beginning of a name, and the number of dots above it.
fn beginning(first: char) -> Option<(String, u8)> {
    match first {
        _ if first.is_ascii_alphabetic() => Some((first.to_string(), 0)),
        _ => {
            let dotted = dotted(first).map(|(letter, dots)| (letter.to_string(), dots));
            dotted.or_else(|| greek_name(first).map(|name| (name.to_owned(), 0)))
        }
    }
}

/// Returns `true` for one or two dots above the preceding letter.
fn is_dots(c: char) -> bool {
    ('\u{307}'..='\u{308}').contains(&c)
}

/// The sign that a character denotes.
fn sign(c: char) -> Option<char> {
    match c {
        '+' | '-' | '*' | '/' | '^' | '(' | ')' | '{' | '}' | '=' | ';' => Some(c),
        '−' | '–' => Some('-'),
        '·' | '⋅' | '∙' | '×' | '∗' => Some('*'),
        '÷' | '⁄' | '∕' => Some('/'),
        _ => None,
    }
}

fn unknown(character: char) -> Fault {
    let hint = match character {
        ',' => "write decimals with a point, and one equation after another with ;",
        '.' => "write numbers as 0.5, products with *",
        '[' | ']' => "write brackets as ( and )",
        '|' => "write abs(x) for the absolute value",
        '\'' | '′' => "a prime must directly follow a name, as in x'",
        '½' | '¼' | '¾' => "write fractions as 1/2",
        '∂' | '∫' | '∑' => "write derivatives with primes, as in x''",
        '<' | '>' | '!' | '≠' | '≤' | '≥' => "write an equation with =",
        '⁻' => "a raised minus must precede raised digits, as in x⁻²",
        _ => "write numbers, names of Latin or Greek letters, + - * / ^ and brackets",
    };
    Fault::UnknownCharacter { found: character, hint }
}
