//! What a document prints, read from text: formulas and equations of numbers, names, + − * / ^, functions and
//! parentheses.

use crate::algebra::{Function, Rational};
use crate::expression::{Expression, Symbol};

use super::evaluate::{number, written};

/// The formulas of a statement; an equation is the list of its sides.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Printed {
    equations: Vec<Vec<Expression>>,
}

impl Printed {
    pub(super) fn read(texts: &[&str]) -> Option<Self> {
        let sides = |text: &&str| text.split('=').map(formula).collect::<Option<Vec<_>>>();
        Some(Self { equations: texts.iter().map(sides).collect::<Option<Vec<_>>>()? })
    }

    /// The last side of an equation: what the quantity on the left is said to be.
    pub(super) fn formula(&self, equation: usize) -> Option<&Expression> {
        self.equations.get(equation)?.last()
    }

    /// The first side of an equation.
    pub(super) fn left(&self, equation: usize) -> Option<&Expression> {
        self.equations.get(equation)?.first()
    }

    /// All sides of an equation.
    pub(super) fn sides(&self, equation: usize) -> Option<&[Expression]> {
        self.equations.get(equation).map(Vec::as_slice)
    }

    /// The first side less the last: zero where the equation holds.
    pub(super) fn residual(&self, equation: usize) -> Option<Expression> {
        let (left, right) = (self.left(equation)?.clone(), self.formula(equation)?.clone());
        Some(Expression::Subtract(Box::new(left), Box::new(right)))
    }

    /// The formula of an equation as a number.
    pub(super) fn number(&self, equation: usize) -> Option<Rational> {
        number(self.formula(equation)?)
    }

    /// The formula that stands last.
    pub(super) fn last(&self) -> Option<&Expression> {
        self.equations.last()?.last()
    }

    /// Equations read as values of names, such as `B1 = C1 = 0` or `A1 = -A3 = 1`; `None` when one is none.
    pub(super) fn assignments(&self) -> Option<Vec<(String, Rational)>> {
        let values = self.equations.iter().map(|sides| values_of_names(sides));
        Some(values.collect::<Option<Vec<_>>>()?.concat())
    }

    /// The equations that are values of names.
    pub(super) fn gauge(&self) -> Vec<(String, Rational)> {
        self.equations.iter().filter_map(|sides| values_of_names(sides)).flatten().collect()
    }
}

/// The names of an equation with their values.
fn values_of_names(sides: &[Expression]) -> Option<Vec<(String, Rational)>> {
    let (value, names) = sides.split_last()?;
    let value = number(value)?;
    let named = |side: &Expression| match side {
        Expression::Symbol(symbol) => Some((written(symbol), value.clone())),
        Expression::Negate(inner) => match inner.as_ref() {
            Expression::Symbol(symbol) => Some((written(symbol), -value.clone())),
            _ => None,
        },
        _ => None,
    };
    names.iter().map(named).collect()
}

/// The formula of a text; `None` when it is none.
fn formula(text: &str) -> Option<Expression> {
    let mut reader = Reader { rest: text.trim() };
    let sum = reader.sum()?;
    reader.rest.is_empty().then_some(sum)
}

struct Reader<'a> {
    rest: &'a str,
}

impl<'a> Reader<'a> {
    fn takes(&mut self, sign: char) -> bool {
        let found = self.rest.strip_prefix(sign).map(str::trim_start);
        self.rest = found.unwrap_or(self.rest);
        found.is_some()
    }

    fn take_while(&mut self, fits: impl Fn(char) -> bool) -> &'a str {
        let end = self.rest.find(|letter| !fits(letter)).unwrap_or(self.rest.len());
        let (taken, rest) = self.rest.split_at(end);
        self.rest = rest.trim_start();
        taken
    }

    fn sum(&mut self) -> Option<Expression> {
        let mut sum =
            if self.takes('-') { Expression::Negate(Box::new(self.product()?)) } else { self.product()? };
        loop {
            if self.takes('+') {
                sum = Expression::Add(Box::new(sum), Box::new(self.product()?));
            } else if self.takes('-') {
                sum = Expression::Subtract(Box::new(sum), Box::new(self.product()?));
            } else {
                return Some(sum);
            }
        }
    }

    fn product(&mut self) -> Option<Expression> {
        let mut product = self.power()?;
        loop {
            if self.takes('*') {
                product = Expression::Multiply(Box::new(product), Box::new(self.power()?));
            } else if self.takes('/') {
                product = Expression::Divide(Box::new(product), Box::new(self.power()?));
            } else {
                return Some(product);
            }
        }
    }

    fn power(&mut self) -> Option<Expression> {
        let base = self.atom()?;
        if !self.takes('^') {
            return Some(base);
        }
        Some(Expression::Power(Box::new(base), Box::new(self.power()?)))
    }

    fn atom(&mut self) -> Option<Expression> {
        if self.takes('(') {
            let inner = self.sum()?;
            return self.takes(')').then_some(inner);
        }
        if self.rest.starts_with(|letter: char| letter.is_ascii_digit()) {
            let digits = self.take_while(|letter| letter.is_ascii_digit());
            return digits.parse::<Rational>().ok().map(Expression::Number);
        }
        self.name()
    }

    fn name(&mut self) -> Option<Expression> {
        let name = self.take_while(|letter| letter.is_ascii_alphanumeric());
        if name.is_empty() {
            return None;
        }
        if name == "pi" {
            return Some(Expression::Pi);
        }
        if let Some(function) = Function::by_name(name) {
            let argument = self.rest.starts_with('(').then(|| self.atom())??;
            return Some(Expression::Call(function, Box::new(argument)));
        }
        let primes = u8::try_from(self.take_while(|letter| letter == '\'').len()).ok()?;
        Some(Expression::Symbol(Symbol { name: name.to_owned(), primes }))
    }
}
