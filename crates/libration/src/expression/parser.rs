//! Lexemes to tree, by recursive descent.
//!
//! ```text
//! sum      ::=  term ( ( + | - ) term )*
//! term     ::=  ( + | - )* product
//! product  ::=  factor ( * factor | / factor | power )*       two powers side by side are multiplied
//! factor   ::=  ( + | - )* power
//! power    ::=  primary ( ^ factor | raised digits )?         so that 2^3^2 = 2^9 and -x^2 = -(x^2)
//! primary  ::=  number | name | function ( sum ) | ( sum )
//! ```

use std::str::FromStr;

use super::error::{Fault, ParseError};
use super::lexer::{Lexeme, Token, lexemes};
use super::{Expression, Function, Symbol};

/// The most levels that brackets, powers and signs may be nested.
pub const DEEPEST_NESTING: usize = 100;
/// The most levels of a tree; a sum of n terms has n.
pub const DEEPEST_TREE: usize = 400;

/// Reads a formula.
///
/// # Errors
/// Text that does not follow the grammar or may be read in two ways, that is longer than [`LONGEST_TEXT`], or nested
/// deeper than [`DEEPEST_NESTING`] or [`DEEPEST_TREE`].
///
/// [`LONGEST_TEXT`]: super::LONGEST_TEXT
impl FromStr for Expression {
    type Err = ParseError;

    fn from_str(text: &str) -> Result<Self, ParseError> {
        let mut parser = Parser::new(text)?;
        let tree = parser.formula()?;
        match parser.peek() {
            Token::End => Ok(tree),
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

type Pair = fn(Box<Expression>, Box<Expression>) -> Expression;

pub(super) struct Parser<'a> {
    text: &'a str,
    lexemes: Vec<Lexeme>,
    next: usize,
    nesting: usize,
}

impl<'a> Parser<'a> {
    pub(super) fn new(text: &'a str) -> Result<Self, ParseError> {
        Ok(Self { text, lexemes: lexemes(text)?, next: 0, nesting: 0 })
    }

    /// A formula, up to what cannot belong to it.
    pub(super) fn formula(&mut self) -> Result<Expression, ParseError> {
        if self.lexemes.len() == 1 {
            return Err(self.fault(Fault::Empty));
        }
        Ok(self.sum()?.tree)
    }

    pub(super) fn peek(&self) -> &Token {
        &self.lexemes[self.next].token
    }

    /// Whether the sign stands next; then it is taken.
    pub(super) fn take(&mut self, sign: char) -> bool {
        let found = *self.peek() == Token::Sign(sign);
        self.next += usize::from(found);
        found
    }

    pub(super) fn fault(&self, fault: Fault) -> ParseError {
        self.fault_at(self.next, fault)
    }

    fn fault_at(&self, lexeme: usize, fault: Fault) -> ParseError {
        ParseError::new(self.text, self.lexemes[lexeme].start, fault)
    }

    /// What is said of a lexeme that cannot follow.
    pub(super) fn unexpected(&self) -> ParseError {
        self.fault(Fault::Unexpected { found: self.found() })
    }

    fn found(&self) -> String {
        match self.peek() {
            Token::Number(_) => "a number".to_owned(),
            Token::Name(symbol) => format!("`{symbol}`"),
            Token::Sign(sign) => format!("`{sign}`"),
            Token::Raised { .. } => "a raised number".to_owned(),
            Token::End => "the end".to_owned(),
        }
    }

    fn sum(&mut self) -> Result<Node, ParseError> {
        let mut left = self.signed(Self::product)?;
        loop {
            let join: Pair = if self.take('+') {
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

    /// Signs, and what they belong to.
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
        matches!(self.peek(), Token::Number(_) | Token::Name(_) | Token::Sign('('))
    }

    /// Whether a factor may stand here without a sign of multiplication.
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

    /// Whether only signs stand between a `^` and this lexeme.
    fn in_exponent(&self, lexeme: usize) -> bool {
        let before = self.lexemes[..lexeme].iter().rev();
        let mut before = before.skip_while(|it| matches!(it.token, Token::Sign('+' | '-')));
        before.next().is_some_and(|it| it.token == Token::Sign('^'))
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
                Ok(Node::leaf(Expression::Number(value)))
            }
            Token::Name(symbol) => self.named(symbol),
            Token::Sign('(') => self.bracketed(),
            Token::Sign(_) | Token::Raised { .. } | Token::End => {
                Err(self.fault(Fault::MissingOperand { found: self.found() }))
            }
        }
    }

    fn bracketed(&mut self) -> Result<Node, ParseError> {
        let open = self.next;
        self.next += 1;
        let inside = self.nested(Self::sum)?;
        if self.take(')') {
            return Ok(inside);
        }
        match self.peek() {
            Token::End | Token::Sign('=' | ';') => Err(self.fault_at(open, Fault::Unclosed)),
            _ => Err(self.unexpected()),
        }
    }

    /// A function of what stands in brackets, π, or a symbol.
    fn named(&mut self, symbol: Symbol) -> Result<Node, ParseError> {
        let name = self.next;
        self.next += 1;
        let bracket = *self.peek() == Token::Sign('(');
        if symbol.primes == 0 {
            if let Some(function) = function(&symbol.name) {
                return if bracket {
                    let argument = self.bracketed()?;
                    self.grown(argument.levels, Expression::Call(function, Box::new(argument.tree)))
                } else {
                    Err(self.fault_at(name, Fault::WithoutBrackets(function.name())))
                };
            }
            match symbol.name.as_str() {
                "pi" => return Ok(Node::leaf(Expression::Pi)),
                "log" => return Err(self.fault_at(name, Fault::WhichLogarithm)),
                _ => {}
            }
        }
        if bracket {
            return Err(self.fault_at(name, self.no_function(&symbol)));
        }
        Ok(Node::leaf(Expression::Symbol(symbol)))
    }

    /// What is said of a name before a bracket.
    fn no_function(&self, symbol: &Symbol) -> Fault {
        let time = Token::Name(Symbol { name: "t".to_owned(), primes: 0 });
        let argument = self.lexemes.get(self.next + 1..self.next + 3);
        let of_time = argument.is_some_and(|it| it[0].token == time && it[1].token == Token::Sign(')'));
        let name = symbol.to_string();
        if of_time { Fault::OfTime(name) } else { Fault::UnknownFunction { name } }
    }

    /// One level further down, if there may be one.
    fn nested(&mut self, part: fn(&mut Self) -> Result<Node, ParseError>) -> Result<Node, ParseError> {
        if self.nesting == DEEPEST_NESTING {
            return Err(self.fault(Fault::TooDeep { limit: DEEPEST_NESTING }));
        }
        self.nesting += 1;
        let node = part(self)?;
        self.nesting -= 1;
        Ok(node)
    }

    fn joined(&self, join: Pair, left: Node, right: Node) -> Result<Node, ParseError> {
        let levels = left.levels.max(right.levels);
        self.grown(levels, join(Box::new(left.tree), Box::new(right.tree)))
    }

    /// A tree above others of so many levels, if it is not too deep.
    fn grown(&self, levels: usize, tree: Expression) -> Result<Node, ParseError> {
        if levels == DEEPEST_TREE {
            return Err(self.fault(Fault::TooDeep { limit: DEEPEST_TREE }));
        }
        Ok(Node { tree, levels: levels + 1 })
    }
}

/// The function of a name, or of the word that it is printed with.
fn function(name: &str) -> Option<Function> {
    Function::by_name(name).or_else(|| Function::ALL.into_iter().find(|function| function.word() == name))
}
