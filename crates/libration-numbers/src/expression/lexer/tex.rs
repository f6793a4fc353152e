//! Commands of LaTeX in formulas: `\ddot{x}`, `\theta`, `\frac{a}{b}`, `\sin`, `\cdot`.

use super::derivative::FractionNotation;
use super::{Fault, Lexer, Symbol, Token};
use crate::algebra::Function;
use crate::expression::letters::is_greek;

/// Commands that denote only a space, or the size of a bracket.
const SPACES: &[&str] = &[
    "left",
    "right",
    "big",
    "Big",
    "bigl",
    "bigr",
    "quad",
    "qquad",
    "displaystyle",
    ",",
    ";",
    ":",
    "!",
    " ",
];

impl Lexer<'_> {
    /// Skips such a command if it is next.
    pub(super) fn skip_command(&mut self) -> bool {
        let Some(rest) = self.rest().strip_prefix('\\') else { return false };
        let word = word(rest);
        let command = if word.is_empty() {
            rest.chars().next().and_then(|sign| SPACES.iter().find(|space| space.starts_with(sign)))
        } else {
            SPACES.iter().find(|space| **space == word)
        };
        if let Some(space) = command {
            self.at += 1 + space.len();
            self.free = true;
        }
        command.is_some()
    }

    /// The token of the command at this position.
    pub(super) fn command(&mut self) -> Result<Token, Fault> {
        self.free = true;
        let word = word(&self.rest()[1..]);
        if let "frac" | "dfrac" | "tfrac" = word {
            if let Some(derivative) = self.derivative(&FractionNotation::Command(word)) {
                return derivative;
            }
            self.at += 1 + word.len();
            return Ok(Token::Fraction);
        }
        self.at += 1 + word.len();
        match word {
            "dot" => self.dotted(1),
            "ddot" => self.dotted(2),
            "dddot" => self.dotted(3),
            "cdot" | "times" | "ast" => Ok(Token::Sign('*')),
            "div" => Ok(Token::Sign('/')),
            "mathrm" | "operatorname" | "text" => self.upright(),
            _ => match letter(word) {
                Some(name) => self.with_index_and_primes(name, 0),
                None if is_function(word) => Ok(Token::Name(Symbol::plain(word))),
                None => Err(Fault::UnknownCommand { command: crate::quantity::excerpt(word) }),
            },
        }
    }

    /// The variable below dots, with or without braces.
    fn dotted(&mut self, dots: u8) -> Result<Token, Fault> {
        self.skip_spaces();
        let braces = self.take_if(|c| c == '{').is_some();
        self.skip_spaces();
        let name = self.bare_name().ok_or(Fault::DotsAboveNothing)?;
        let Token::Name(symbol) = self.with_index_and_primes(name, dots)? else {
            return Err(Fault::DotsAboveNothing);
        };
        self.skip_spaces();
        if braces && self.take_if(|c| c == '}').is_none() {
            return Err(Fault::DotsAboveNothing);
        }
        self.with_index_and_primes(symbol.name, symbol.primes)
    }

    /// A word in braces.
    fn upright(&mut self) -> Result<Token, Fault> {
        let rest = self.rest();
        let inside = rest.strip_prefix('{').and_then(|rest| rest.split_once('}')).map(|(inside, _)| inside);
        let name = inside.filter(|inside| inside.starts_with(|c: char| c.is_ascii_alphabetic()));
        let name = name.filter(|name| name.bytes().all(|byte| byte.is_ascii_alphanumeric()));
        let name = name.ok_or(Fault::WordWithoutBraces)?.to_owned();
        self.at += name.len() + 2;
        self.with_index_and_primes(name, 0)
    }

    /// The letter, Greek letter or letter command at this position.
    pub(super) fn bare_name(&mut self) -> Option<String> {
        if let Some(rest) = self.rest().strip_prefix('\\') {
            let word = word(rest);
            let name = letter(word)?;
            self.at += 1 + word.len();
            return Some(name);
        }
        let first = self.peek()?;
        let (mut name, dots) = super::beginning(first).filter(|(_, dots)| *dots == 0)?;
        self.at += first.len_utf8();
        if first.is_ascii_alphabetic() {
            name.push_str(self.take_while(|c| c.is_ascii_alphabetic()));
        }
        (dots == 0).then_some(name)
    }

    /// The name with its index and the primes after it.
    pub(super) fn with_index_and_primes(&mut self, mut name: String, dots: u8) -> Result<Token, Fault> {
        let primes = dots.saturating_add(self.rest_of_name(&mut name, false));
        if primes > super::MOST_PRIMES {
            Err(Fault::TooManyPrimes)
        } else {
            Ok(Token::Name(Symbol { name, primes }))
        }
    }

    /// An index in braces, as in `_{1}` or `_{max}`, without the braces.
    pub(super) fn index_in_braces(&mut self) -> Option<String> {
        let inside = self.rest().strip_prefix("_{")?.split_once('}')?.0;
        let index = inside.bytes().all(|byte| byte.is_ascii_alphanumeric()) && !inside.is_empty();
        let inside = index.then(|| inside.to_owned())?;
        self.at += inside.len() + 3;
        self.free = true;
        Some(format!("_{inside}"))
    }
}

/// The leading letters of a text.
fn word(text: &str) -> &str {
    let end = text.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(text.len());
    &text[..end]
}

/// The name of the Greek letter for a command.
fn letter(command: &str) -> Option<String> {
    let name = match command {
        "varepsilon" => "epsilon",
        "vartheta" => "theta",
        "varphi" => "phi",
        other => other,
    };
    is_greek(name).then(|| name.to_owned())
}

fn is_function(word: &str) -> bool {
    let is_named =
        Function::ALL.into_iter().any(|function| function.word() == word || function.name() == word);
    is_named || matches!(word, "arcsin" | "arccos" | "arctan" | "log")
}
