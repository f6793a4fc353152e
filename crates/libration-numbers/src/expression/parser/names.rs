//! Meaning of a name: a function (with or without brackets), the larger or smaller of two formulas, π, or a symbol.

use super::super::error::{Fault, ParseError};
use super::super::lexer::{Lexeme, Token, is_extremum};
use super::super::simplify::{difference, quotient, sum};
use super::super::{Expression, Function, Symbol};
use super::{Node, Parser};
use crate::quantity::excerpt;

impl Parser<'_> {
    /// A function with its argument in brackets, π, or a symbol.
    pub(super) fn named(&mut self, symbol: Symbol) -> Result<Node, ParseError> {
        let name = self.next;
        self.next += 1;
        let bracket = *self.peek() == Token::Sign('(');
        if symbol.primes == 0 {
            if let Some(function) = function(&symbol.name) {
                self.free |= symbol.name == LOGARITHM;
                let argument = match self.peek() {
                    Token::Sign('(') => self.bracketed(')')?,
                    Token::Sign('{') => self.bracketed('}')?,
                    _ => self.bare_argument(function, name)?,
                };
                return self.grown(argument.levels, Expression::Call(function, Box::new(argument.tree)));
            }
            if symbol.name == "pi" {
                return Ok(Node::leaf(Expression::Pi));
            }
        }
        if bracket && symbol.primes == 0 && is_extremum(&symbol.name) && !self.is_variable(&symbol.name) {
            return self.extremum(if symbol.name == "max" { sum } else { difference });
        }
        if bracket {
            self.before_bracket(&symbol).map_err(|fault| self.fault_at(name, fault))?;
        }
        Ok(Node::leaf(Expression::Symbol(symbol)))
    }

    /// The larger or the smaller of two formulas, (a + b ± |a − b|)/2.
    fn extremum(&mut self, join: fn(Expression, Expression) -> Expression) -> Result<Node, ParseError> {
        let open = self.next;
        self.next += 1;
        let one = self.nested(Self::sum)?;
        if !self.take(',') {
            return Err(self.fault_at(open, Fault::OneArgument));
        }
        let other = self.nested(Self::sum)?;
        if !self.take(')') {
            return Err(self.fault_at(open, Fault::Unclosed));
        }
        self.free = true;
        // Zero becomes the second operand, so that the result contains |x| for the formula x itself.
        let [a, b] = if one.tree.is_zero() { [&other, &one] } else { [&one, &other] }
            .map(|operand| operand.tree.clone());
        let distance = Expression::Call(Function::Abs, Box::new(difference(a.clone(), b.clone())));
        let tree = quotient(join(sum(a, b), distance), Expression::from(2));
        let mut node = Node { tree, levels: one.levels.max(other.levels) };
        for _ in 0..4 {
            node = self.grown(node.levels, node.tree)?;
        }
        Ok(node)
    }

    /// Consumes a `(t)` after a variable; other brackets remain as factors.
    fn before_bracket(&mut self, symbol: &Symbol) -> Result<(), Fault> {
        let argument = self.lexemes.get(self.next + 1..self.next + 3);
        let of_time =
            argument.is_some_and(|argument| is_time(&argument[0]) && argument[1].token == Token::Sign(')'));
        let name = symbol.to_string();
        match (self.is_variable(&symbol.name), of_time) {
            (true, true) => self.next += 3,
            (true, false) if self.may_be_another_time() => return Err(Fault::AtAnotherTime(name)),
            (true, false) if self.in_exponent(self.next - 1) => return Err(Fault::AmbiguousPower),
            (true, false) => {}
            (false, true) => return Err(Fault::OfTime(name)),
            (false, false) => return Err(Fault::UnknownFunction { name }),
        }
        self.free = true;
        Ok(())
    }

    /// Returns `true` if a name has primes anywhere in the text.
    fn is_variable(&self, name: &str) -> bool {
        let primed = |lexeme: &Lexeme| matches!(&lexeme.token, Token::Name(other) if other.primes > 0 && other.name == name);
        self.lexemes.iter().any(primed)
    }

    /// Returns `true` if the bracket that opens next contains t, or only a number or a parameter.
    fn may_be_another_time(&self) -> bool {
        if let Some([_, inside, close, ..]) = self.lexemes.get(self.next..)
            && close.token == Token::Sign(')')
        {
            let is_variable = matches!(&inside.token, Token::Name(symbol) if self.is_variable(&symbol.name));
            return !is_variable;
        }
        let mut open = 0_usize;
        for lexeme in &self.lexemes[self.next..] {
            match lexeme.token {
                Token::Sign('(') => open += 1,
                Token::Sign(')') => open -= 1,
                _ if is_time(lexeme) => return true,
                _ => {}
            }
            if open == 0 {
                break;
            }
        }
        false
    }

    /// The argument of a function without brackets: a number and names side by side, up to the first lexeme that cannot belong to it.
    fn bare_argument(&mut self, function: Function, name: usize) -> Result<Node, ParseError> {
        let start = self.next;
        if function == Function::Sqrt || !self.begins_bare_argument() {
            return Err(self.fault_at(name, Fault::WithoutBrackets(function.name())));
        }
        let after_number = matches!(self.peek(), Token::Number(_));
        let mut argument = self.primary()?;
        while self.continues_bare_argument(after_number && self.next == start + 1) {
            let factor = self.primary()?;
            argument = self.joined(Expression::Multiply, argument, factor)?;
        }
        if let Some(last) = self.may_belong_to_argument() {
            let (argument, rest) = (self.between(start, self.next), self.between(self.next, last + 1));
            let gap = if self.lexemes[self.next].spaced { " " } else { "" };
            let (argument, rest) = (excerpt(argument), format!("{gap}{}", excerpt(rest)));
            return Err(
                self.fault_at(name, Fault::AmbiguousArgument { function: function.name(), argument, rest })
            );
        }
        self.free = true;
        Ok(argument)
    }

    fn begins_bare_argument(&self) -> bool {
        match self.peek() {
            Token::Number(_) | Token::Fraction => true,
            Token::Name(symbol) => function_of(symbol).is_none(),
            _ => false,
        }
    }

    /// Returns `true` if the next name is part of the argument: directly after the last name, or after a number at the beginning.
    fn continues_bare_argument(&self, after_number: bool) -> bool {
        let lexeme = &self.lexemes[self.next];
        let is_name = matches!(&lexeme.token, Token::Name(symbol) if function_of(symbol).is_none());
        is_name && (after_number || !lexeme.spaced)
    }

    /// The last lexeme of the following part, if that part could belong to an argument without brackets.
    fn may_belong_to_argument(&self) -> Option<usize> {
        let function_at = |index: usize| matches!(&self.lexemes[index].token, Token::Name(symbol) if function_of(symbol).is_some());
        match self.peek() {
            Token::Sign('*') if function_at(self.next + 1) => None,
            Token::Sign('*' | '/' | '^') => Some(self.next + 1),
            Token::Name(_) if function_at(self.next) => None,
            Token::Name(_)
            | Token::Number(_)
            | Token::Raised { .. }
            | Token::Fraction
            | Token::Sign('(' | '{') => Some(self.next),
            _ => None,
        }
    }
}

fn is_time(lexeme: &Lexeme) -> bool {
    matches!(&lexeme.token, Token::Name(symbol) if symbol.name == "t" && symbol.primes == 0)
}

/// The function that a name without primes denotes.
fn function_of(symbol: &Symbol) -> Option<Function> {
    function(&symbol.name).filter(|_| symbol.primes == 0)
}

/// The name of the natural logarithm in most programming languages. Its interpretation is reported, since some authors use it for the decimal
/// one.
const LOGARITHM: &str = "log";

/// The function with this name, or with this word in output.
fn function(name: &str) -> Option<Function> {
    if name == LOGARITHM {
        return Some(Function::Ln);
    }
    Function::by_name(name).or_else(|| Function::ALL.into_iter().find(|function| function.word() == name))
}
