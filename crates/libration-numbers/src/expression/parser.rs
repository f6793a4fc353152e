//! Lexemes to tree, by recursive descent.
//!
//! ```text
//! sum      ::=  term ( ( + | - ) term )*
//! term     ::=  ( + | - )* product
//! product  ::=  factor ( * factor | / factor | power )*       two powers side by side are multiplied
//! factor   ::=  ( + | - )* power
//! power    ::=  primary ( ^ factor | raised digits )?         so that 2^3^2 = 2^9 and -x^2 = -(x^2)
//! primary  ::=  number deg? | name | max ( sum , sum ) | min ( sum , sum ) | function ( sum ) | function argument | ( sum ) | { sum } | \frac { sum } { sum }
//! argument ::=  number? name+                                 where nothing follows that may belong to it
//! ```
//!
//! A name before a bracket is a factor if it is a variable, that is, has primes somewhere in the text.

mod names;

use std::str::FromStr;

use super::error::{Fault, ParseError};
use super::lexer::{IndexRange, Lexeme, Lexemes, Token, lexemes};
use super::members::members_named;
use super::{Expression, Symbol};
use crate::algebra::Rational;

/// Maximum nesting depth of brackets, powers and signs.
pub const DEEPEST_NESTING: usize = 100;
/// Maximum depth of a tree; a sum of n terms has depth n.
pub const DEEPEST_TREE: usize = 400;

/// Reads a formula.
///
/// # Errors
/// Text that does not follow the grammar or is ambiguous, that is longer than [`LONGEST_TEXT`], or nested deeper than [`DEEPEST_NESTING`] or
/// [`DEEPEST_TREE`].
///
/// [`LONGEST_TEXT`]: super::LONGEST_TEXT
impl FromStr for Expression {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<Self, ParseError> {
        let mut parser = Parser::new(text)?;
        let tree = parser.formula()?;
        match parser.peek() {
            Token::End => Ok(members_named(&tree)),
            Token::Sign(sign @ ('=' | ';')) => Err(parser.fault(Fault::NotAnEquation(*sign))),
            _ => Err(parser.unexpected()),
        }
    }
}

/// A tree and the number of its levels.
struct Node {
    tree: Expression,
    levels: usize,
}

impl Node {
    fn leaf(tree: Expression) -> Self {
        Self { tree, levels: 1 }
    }
}

type BinaryConstructor = fn(Box<Expression>, Box<Expression>) -> Expression;

pub(super) struct Parser<'a> {
    text: &'a str,
    lexemes: Vec<Lexeme>,
    next: usize,
    nesting: usize,
    /// `true` if the text used a notation that is not used for output.
    free: bool,
}

impl<'a> Parser<'a> {
    pub(super) fn new(text: &'a str) -> Result<Self, ParseError> {
        let Lexemes { lexemes, free } = lexemes(text)?;
        Ok(Self { text, lexemes, next: 0, nesting: 0, free })
    }

    /// Returns `true` if the text read so far uses a notation that is not used for output.
    pub(super) fn is_free(&self) -> bool {
        self.free
    }

    /// A formula, up to the first lexeme that cannot belong to it.
    pub(super) fn formula(&mut self) -> Result<Expression, ParseError> {
        if self.lexemes.len() == 1 {
            return Err(self.fault(Fault::Empty));
        }
        Ok(self.sum()?.tree)
    }

    pub(super) fn peek(&self) -> &Token {
        &self.lexemes[self.next].token
    }

    /// Consumes the sign if it is next, and returns `true` if it was.
    pub(super) fn take(&mut self, sign: char) -> bool {
        let is_next = *self.peek() == Token::Sign(sign);
        self.next += usize::from(is_next);
        is_next
    }

    pub(super) fn fault(&self, fault: Fault) -> ParseError {
        self.fault_at(self.next, fault)
    }

    fn fault_at(&self, lexeme: usize, fault: Fault) -> ParseError {
        ParseError::new(self.text, self.lexemes[lexeme].start, fault)
    }

    /// The range of an index, consumed if it is next.
    pub(super) fn take_range(&mut self) -> Option<IndexRange> {
        let Token::Range(range) = self.peek() else { return None };
        let range = range.clone();
        self.next += 1;
        Some(range)
    }

    /// The error for a lexeme that cannot follow.
    pub(super) fn unexpected(&self) -> ParseError {
        self.fault(Fault::Unexpected { found: self.next_in_words() })
    }

    fn next_in_words(&self) -> String {
        match self.peek() {
            Token::Number(_) => "a number".to_owned(),
            Token::Name(symbol) => format!("`{symbol}`"),
            Token::Sign(sign) => format!("`{sign}`"),
            Token::Raised { .. } => "a raised number".to_owned(),
            Token::Fraction => "\\frac".to_owned(),
            Token::Range(range) => format!("`, {} = …`", range.letter),
            Token::End => "the end".to_owned(),
        }
    }

    fn sum(&mut self) -> Result<Node, ParseError> {
        let mut left = self.signed(Self::product)?;
        loop {
            let join: BinaryConstructor = if self.take('+') {
                Expression::Add
            } else if self.take('-') {
                Expression::Subtract
            } else {
                return Ok(left);
            };
            let right = self.signed(Self::product)?;
            left = self.joined(join, left, right)?;
        }
    }

    /// An operand with the signs before it.
    fn signed(&mut self, operand: fn(&mut Self) -> Result<Node, ParseError>) -> Result<Node, ParseError> {
        let mut minuses = 0;
        loop {
            if self.take('-') {
                minuses += 1;
            } else if !self.take('+') {
                break;
            }
        }
        if minuses > DEEPEST_NESTING {
            return Err(self.fault(Fault::TooDeep { limit: DEEPEST_NESTING }));
        }
        let mut node = operand(self)?;
        for _ in 0..minuses {
            node = self.grown(node.levels, Expression::Negate(Box::new(node.tree)))?;
        }
        Ok(node)
    }

    fn product(&mut self) -> Result<Node, ParseError> {
        let mut left = self.factor()?;
        let mut divided = false;
        loop {
            if self.take('*') {
                divided = false;
                let right = self.factor()?;
                left = self.joined(Expression::Multiply, left, right)?;
            } else if self.take('/') {
                divided = true;
                let right = self.factor()?;
                left = self.joined(Expression::Divide, left, right)?;
            } else if self.begins_factor() {
                self.refuse_ambiguous_product(divided)?;
                let right = self.power()?;
                left = self.joined(Expression::Multiply, left, right)?;
            } else {
                return Ok(left);
            }
        }
    }

    fn begins_factor(&self) -> bool {
        matches!(self.peek(), Token::Number(_) | Token::Name(_) | Token::Fraction | Token::Sign('(' | '{'))
    }

    /// Rejects a factor that needs a multiplication sign here.
    fn refuse_ambiguous_product(&self, divided: bool) -> Result<(), ParseError> {
        let last = &self.lexemes[self.next - 1].token;
        let before = self.next.checked_sub(2).map(|i| &self.lexemes[i].token);
        let bare_exponent = matches!(last, Token::Number(_) | Token::Name(_))
            && matches!(before, Some(Token::Sign('^' | '-')))
            && self.in_exponent(self.next - 1);
        let glued_name = matches!(self.peek(), Token::Name(_)) && !self.lexemes[self.next].spaced;
        if matches!(self.peek(), Token::Number(_)) {
            return Err(self.fault(Fault::NumberAfterFactor));
        }
        if divided {
            return Err(self.fault(Fault::AmbiguousDivision));
        }
        if bare_exponent && glued_name {
            return Err(self.fault(Fault::AmbiguousPower));
        }
        Ok(())
    }

    /// Returns `true` if only signs stand between a `^` and this lexeme.
    fn in_exponent(&self, lexeme: usize) -> bool {
        let before = self.lexemes[..lexeme].iter().rev();
        let mut before = before.skip_while(|earlier| matches!(earlier.token, Token::Sign('+' | '-')));
        before.next().is_some_and(|earlier| earlier.token == Token::Sign('^'))
    }

    fn factor(&mut self) -> Result<Node, ParseError> {
        self.signed(Self::power)
    }

    fn power(&mut self) -> Result<Node, ParseError> {
        let start = self.next;
        let base = self.primary()?;
        let power = if let Token::Raised { digits, negative } = self.peek().clone() {
            self.next += 1;
            let exponent = Node::leaf(Expression::Number(digits));
            let exponent = if negative {
                self.grown(exponent.levels, Expression::Negate(Box::new(exponent.tree)))?
            } else {
                exponent
            };
            self.joined(Expression::Power, base, exponent)?
        } else if *self.peek() == Token::Sign('^') {
            if base.tree == Expression::symbol("e") {
                return Err(self.fault_at(start, Fault::EulersNumber));
            }
            self.next += 1;
            let exponent = self.nested(Self::factor)?;
            self.joined(Expression::Power, base, exponent)?
        } else {
            return Ok(base);
        };
        match self.peek() {
            Token::Sign('^') | Token::Raised { .. } => Err(self.fault(Fault::PowerOfPower)),
            _ => Ok(power),
        }
    }

    fn primary(&mut self) -> Result<Node, ParseError> {
        match self.peek().clone() {
            Token::Number(value) => {
                self.next += 1;
                if self.take_degrees() {
                    self.degrees(&value)
                } else {
                    Ok(Node::leaf(Expression::Number(value)))
                }
            }
            Token::Name(symbol) => self.named(symbol),
            Token::Sign('(') => self.bracketed(')'),
            Token::Sign('{') => self.bracketed('}'),
            Token::Fraction => self.fraction(),
            Token::Sign(_) | Token::Raised { .. } | Token::Range(_) | Token::End => {
                Err(self.fault(Fault::MissingOperand { found: self.next_in_words() }))
            }
        }
    }

    /// Consumes `deg` directly after the number that was read, and returns `true` if it was there.
    fn take_degrees(&mut self) -> bool {
        let Lexeme { token, spaced, .. } = &self.lexemes[self.next];
        let is_next = !spaced && matches!(token, Token::Name(Symbol { name, primes: 0 }) if name == "deg");
        self.next += usize::from(is_next);
        self.free |= is_next;
        is_next
    }

    /// A number of degrees, in radians.
    fn degrees(&self, value: &Rational) -> Result<Node, ParseError> {
        let half_turns = value.checked_div(&Rational::from(180)).unwrap_or_else(|| value.clone());
        self.joined(
            Expression::Multiply,
            Node::leaf(Expression::Number(half_turns)),
            Node::leaf(Expression::Pi),
        )
    }

    /// The formula up to this closing bracket.
    fn bracketed(&mut self, close: char) -> Result<Node, ParseError> {
        let open = self.next;
        self.next += 1;
        self.free |= close == '}';
        let inside = self.nested(Self::sum)?;
        if self.take(close) {
            return Ok(inside);
        }
        let unclosed = if close == ')' { Fault::Unclosed } else { Fault::UnclosedBrace };
        match self.peek() {
            Token::End | Token::Sign('=' | ';') => Err(self.fault_at(open, unclosed)),
            _ => Err(self.unexpected()),
        }
    }

    /// A fraction in LaTeX notation.
    fn fraction(&mut self) -> Result<Node, ParseError> {
        let start = self.next;
        self.next += 1;
        let group = |parser: &mut Self| match parser.peek() {
            Token::Sign('{') => parser.bracketed('}'),
            _ => Err(parser.fault_at(start, Fault::FractionWithoutBraces)),
        };
        let (above, below) = (group(self)?, group(self)?);
        self.joined(Expression::Divide, above, below)
    }

    /// The text from one lexeme up to another.
    fn between(&self, from: usize, to: usize) -> &'a str {
        let end = self.lexemes.get(to).map_or(self.text.len(), |lexeme| lexeme.start);
        self.text[self.lexemes[from].start..end].trim()
    }

    /// A part that is one level deeper, if the limit allows it.
    fn nested(&mut self, part: fn(&mut Self) -> Result<Node, ParseError>) -> Result<Node, ParseError> {
        if self.nesting == DEEPEST_NESTING {
            return Err(self.fault(Fault::TooDeep { limit: DEEPEST_NESTING }));
        }
        self.nesting += 1;
        let node = part(self)?;
        self.nesting -= 1;
        Ok(node)
    }

    fn joined(&self, join: BinaryConstructor, left: Node, right: Node) -> Result<Node, ParseError> {
        let levels = left.levels.max(right.levels);
        self.grown(levels, join(Box::new(left.tree), Box::new(right.tree)))
    }

    /// A tree with this number of levels below it, if the limit allows it.
    fn grown(&self, levels: usize, tree: Expression) -> Result<Node, ParseError> {
        if levels == DEEPEST_TREE {
            return Err(self.fault(Fault::TooDeep { limit: DEEPEST_TREE }));
        }
        Ok(Node { tree, levels: levels + 1 })
    }
}
