//! Derivatives in Leibniz's notation: `d2x/dt2`, `d^2x/dt^2`, `d²x/dt²`, `dx/dt`, `\frac{d^2 x}{dt^2}`.

use super::{Fault, Lexer, Symbol, Token};
use crate::expression::letters::superscript;

/// Notation of a fraction.
pub(super) enum FractionNotation<'a> {
    Slash,
    /// `\frac` or a similar command, followed by two groups in braces.
    Command(&'a str),
}

impl Lexer<'_> {
    /// The derivative with respect to t that begins here; `None`, with nothing consumed, if there is none.
    pub(super) fn derivative(&mut self, fraction: &FractionNotation<'_>) -> Option<Result<Token, Fault>> {
        let start = self.at;
        let token = self.quotient_of_differentials(fraction);
        match token {
            Some(_) => self.free = true,
            None => self.at = start,
        }
        token.map(Ok)
    }

    fn quotient_of_differentials(&mut self, fraction: &FractionNotation<'_>) -> Option<Token> {
        let (before, between, after) = match fraction {
            FractionNotation::Slash => (String::new(), &["/"][..], None),
            FractionNotation::Command(word) => (format!("\\{word}{{"), &["}", "{"][..], Some("}")),
        };
        self.literal(&before)?;
        self.differential()?;
        let order = self.order()?;
        self.blanks();
        let mut name = self.bare_name().filter(|name| name != "dt")?;
        if self.rest_of_name(&mut name, false) > 0 {
            return None;
        }
        self.blanks();
        for sign in between {
            self.literal(sign)?;
            self.blanks();
        }
        self.differential()?;
        self.literal("t")?;
        if self.order()? != order {
            return None;
        }
        match after {
            Some(brace) => self.literal(brace)?,
            // Text that continues here is another name or number.
            None if self.peek().is_some_and(|c| c.is_ascii_alphanumeric() || c == '_') => return None,
            None => {}
        }
        Some(Token::Name(Symbol { name, primes: order }))
    }

    fn literal(&mut self, text: &str) -> Option<()> {
        let is_present = self.rest().starts_with(text);
        self.at += if is_present { text.len() } else { 0 };
        is_present.then_some(())
    }

    fn blanks(&mut self) {
        self.take_while(char::is_whitespace);
    }

    fn differential(&mut self) -> Option<()> {
        self.literal("\\mathrm{d}").or_else(|| self.literal("d"))
    }

    /// Order of the derivative, 1 if none is written.
    fn order(&mut self) -> Option<u8> {
        if let Some(digit) = self.take_if(|c| superscript(c).is_some()).and_then(superscript) {
            return order(digit);
        }
        let raised = self.literal("^").is_some();
        let braces = raised && self.literal("{").is_some();
        match self.take_if(|c| c.is_ascii_digit()) {
            None if raised => None,
            None => Some(1),
            Some(_) if braces && self.literal("}").is_none() => None,
            Some(digit) => order(digit),
        }
    }
}

fn order(digit: char) -> Option<u8> {
    digit.to_digit(10).and_then(|order| u8::try_from(order).ok()).filter(|order| (2..=3).contains(order))
}
